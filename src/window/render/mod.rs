//! The picture: table, balls, cue, lamp, guides.

use bevy::prelude::*;

pub(super) fn plugin(_app: &mut App) {}
