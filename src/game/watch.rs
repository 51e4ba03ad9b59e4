//! Looking at a crowd: how its balls are coloured, and which one is watched.

use bevy::prelude::*;
use glam::DVec3;

use crate::sim::SimSystems;
use crate::sim::messages::LoadScene;

/// What the colour of a ball tells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colouring {
    /// How fast it is.
    #[default]
    Speed,
    /// How fast it spins.
    Spin,
    /// Its number, in the colours of pool.
    Number,
}

/// What is looked at in a crowd.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Watch {
    /// What the colours tell.
    pub colouring: Colouring,
    /// The ball that is watched, by its number in the scene.
    pub chosen: Option<usize>,
    /// Whether the camera follows it.
    pub follow: bool,
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Watch>().add_systems(
        FixedUpdate,
        forget
            .before(SimSystems::Strike)
            .run_if(on_message::<LoadScene>),
    );
}

/// The ball that was watched is not in another scene.
fn forget(mut watch: ResMut<Watch>) {
    watch.chosen = None;
}

/// The first ball that a ray from `origin` along the unit vector `direction` meets: of balls of this radius in m, each
/// with its number and its centre.
#[must_use]
pub fn met_by_ray(
    origin: DVec3,
    direction: DVec3,
    radius: f64,
    balls: impl Iterator<Item = (usize, DVec3)>,
) -> Option<usize> {
    let depth = |center: DVec3| {
        let to = center - origin;
        let along = to.dot(direction);
        let aside = radius * radius - (to - along * direction).length_squared();
        (aside >= 0.0 && along > 0.0).then(|| along - aside.sqrt())
    };
    balls
        .filter_map(|(number, center)| Some((depth(center)?, number)))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, number)| number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_ball_on_the_ray_is_met_and_none_beside_or_behind() {
        let balls = [
            (7, DVec3::new(3.0, 0.0, 0.0)),
            (8, DVec3::new(1.0, 0.0, 0.9)),
            (9, DVec3::new(-1.0, 0.0, 0.0)),
            (4, DVec3::new(9.0, 0.0, 0.0)),
        ];
        let met = |z: f64, radius| {
            let origin = DVec3::new(0.0, 0.0, z);
            met_by_ray(origin, DVec3::X, radius, balls.into_iter())
        };
        assert_eq!(met(0.0, 0.5), Some(7));
        assert_eq!(met(0.0, 0.95), Some(8));
        assert_eq!(met(0.6, 0.5), Some(8));
        assert_eq!(met(2.0, 0.5), None);
    }
}
