//! How far the mouse went.

use bevy::prelude::*;
use bevy::window::CursorMoved;

use super::Actions;
use crate::window::action::Action;

/// Movement of the mouse in this frame in logical pixels, to the right and down.
#[derive(Resource, Debug, Default)]
pub(super) struct Motion(pub(super) Vec2);

/// Takes the way of the pointer. Where the pointer stands still, at the edge of the screen, the raw movement of the device
/// goes on; it is not the first choice because some devices and remote screens report none.
pub(super) fn follow(
    actions: Actions,
    mut cursor: MessageReader<CursorMoved>,
    mut motion: ResMut<Motion>,
) {
    let way: Vec2 = cursor.read().filter_map(|moved| moved.delta).sum();
    motion.0 = if way == Vec2::ZERO {
        actions.axis_pair(&Action::Move)
    } else {
        way
    };
}
