//! Where the player looks from.

use bevy::prelude::*;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(Startup, |mut commands: Commands| {
        commands.spawn((
            Camera3d::default(),
            Transform::from_xyz(-2.0, 1.5, 0.0).looking_at(Vec3::ZERO, Vec3::Y),
        ));
    });
}
