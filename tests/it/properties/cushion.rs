//! Impacts of a ball and a cushion.

use proptest::prelude::*;

use masse::physics::ball::Ball;
use masse::physics::laws::cushion::CushionContact;
use masse::physics::table::Nose;

use super::inputs::{ball_and_state, cushion_law, horizontal, share};
use super::{assert_no_gain, cases};
use crate::frames::{distance, mirrored, mirrored_vector, size};

/// A contact whose nose stands between the slate and the top of the ball, or out of its reach.
fn contact(ball: &Ball) -> impl Strategy<Value = CushionContact> + use<> {
    let nose_height = prop_oneof![
        6 => 0.5..1.6_f64, 1 => Just(1.0), 1 => Just(1.28), 1 => 0.0..3.0_f64,
    ];
    let radius = ball.radius;
    (
        horizontal(),
        nose_height,
        prop::option::weighted(0.2, share(1.0)),
    )
        .prop_map(move |(normal, height, restitution)| CushionContact {
            normal,
            nose_height: height * radius,
            nose: Nose::Wall,
            restitution,
        })
}

fn case() -> impl Strategy<Value = ((Ball, masse::physics::ball::State), CushionContact)> {
    ball_and_state().prop_flat_map(|(ball, state)| (Just((ball, state)), contact(&ball)))
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn energy_never_rises(law in cushion_law(), ((ball, state), contact) in case()) {
        let after = law.rebound(&ball, &state, &contact);
        prop_assert!(after.state.is_finite() && after.impulse.is_finite() && after.impulse >= 0.0);
        assert_no_gain(ball.kinetic_energy(&state), ball.kinetic_energy(&after.state));
    }

    #[test]
    fn the_ball_leaves_the_cushion(law in cushion_law(), ((ball, state), contact) in case()) {
        let after = law.rebound(&ball, &state, &contact).state;
        let outward = after.velocity.dot(contact.normal);
        prop_assert!(outward >= -1e-15 * size(&state, ball.radius), "{outward:e} m/s outward");
        prop_assert_eq!(after.velocity.y, 0.0);
        prop_assert_eq!(after.position, state.position);
    }

    #[test]
    fn mirror_images_mirror(law in cushion_law(), ((ball, state), contact) in case()) {
        let after = law.rebound(&ball, &state, &contact).state;
        let flipped = CushionContact { normal: mirrored_vector(contact.normal), ..contact };
        let image = law.rebound(&ball, &mirrored(&state), &flipped).state;
        let apart = distance(&image, &mirrored(&after), ball.radius);
        prop_assert!(apart <= 1e-13 * size(&state, ball.radius), "{apart:e} apart");
    }
}
