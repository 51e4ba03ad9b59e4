//! Practice on an open table: rack again, retry the last shot, place balls by hand.

use bevy::prelude::*;

pub(super) fn plugin(_app: &mut App) {}
