//! Contacts with cushions and pockets, only in the cells that hold any.

use bevy::prelude::*;
use glam::DVec2;

use crate::physics::contact::Track;
use crate::physics::table::{Line, Table};
use crate::sim::playfield::Playfield;
use crate::sim::stepped::bodies::Bodies;
use crate::sim::stepped::contacts::Contacts;
use crate::sim::stepped::grid::Grid;

/// Finds the first contact of every moving ball with each cushion and pocket of its cells.
pub(super) fn collide_cushions(
    grid: Res<Grid>,
    bodies: Res<Bodies>,
    mut contacts: ResMut<Contacts>,
    playfield: Res<Playfield>,
) {
    for ball in 0..bodies.all.len() {
        find(&grid, &bodies, &mut contacts, &playfield, ball, 0.0);
    }
}

/// Finds the contacts of one ball from this time of the tick on.
pub(super) fn find(
    grid: &Grid,
    bodies: &Bodies,
    contacts: &mut Contacts,
    playfield: &Playfield,
    ball: usize,
    time: f64,
) {
    let table = &playfield.table;
    let body = &bodies.all[ball];
    if !body.translates() {
        return;
    }
    if body.flies() {
        contacts.find_ground(bodies, playfield, ball, time);
    }
    grid.cushions(table, &body.cells, |cushion| {
        contacts.find_cushion(bodies, table, ball, cushion, time);
    });
    grid.pockets(table, &body.cells, |pocket| {
        contacts.find_pocket(bodies, playfield, ball, pocket, time);
    });
}

/// The coursework's test, without a contact time: a ball that reaches over a rail and moves outwards meets it now. A rail
/// along the edge of the table reaches outwards to infinity, so that no speed escapes.
pub(super) fn beyond(table: &Table, line: &Line, track: &Track, radius: f64) -> Option<f64> {
    let along = (line.to - line.from).normalize();
    let middle = 0.5 * (line.from + line.to);
    let mut inward = along.perp();
    if inward.dot(-middle) < 0.0 {
        inward = -inward;
    }
    let position = DVec2::new(track.position.x, track.position.z);
    let velocity = DVec2::new(track.velocity.x, track.velocity.z);
    let depth = radius - (position - line.from).dot(inward);
    let place = (position - line.from).dot(along);
    let length = (line.to - line.from).length();
    let half = 0.5 * DVec2::new(table.length, table.width);
    let is_rail = (middle.abs() - half).abs().min_element() < 1e-9;
    let deep_enough = depth >= 0.0 && (is_rail || depth <= 2.0 * radius);
    let beside =
        (0.0..=length).contains(&place) || (is_rail && (position.abs() - half).min_element() > 0.0);
    (deep_enough && beside && velocity.dot(inward) < 0.0).then_some(0.0)
}
