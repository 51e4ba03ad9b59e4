//! Contacts between balls, cell by cell.

use bevy::prelude::*;

use crate::sim::stepped::bodies::Bodies;
use crate::sim::stepped::contacts::Contacts;
use crate::sim::stepped::grid::Grid;

/// Finds the first contact of every pair of balls that share a cell.
pub(super) fn collide_balls(grid: Res<Grid>, bodies: Res<Bodies>, mut contacts: ResMut<Contacts>) {
    grid.pairs(&bodies, |first, second| {
        contacts.find_pair(&bodies, first, second, 0.0);
    });
    for ball in 0..bodies.all.len() {
        contacts.find_change(&bodies, ball);
    }
}
