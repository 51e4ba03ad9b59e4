//! Impacts of two balls.

use glam::DVec3;
use proptest::prelude::*;

use masse::physics::ball::{Ball, State};
use masse::physics::laws::ball_ball::{BallBallLaw, PairContact};

use super::inputs::{ball_and_state, ball_ball_law, horizontal, share};
use super::{assert_no_gain, cases};
use crate::frames::{distance, mirrored, mirrored_vector, size};

fn contact() -> impl Strategy<Value = PairContact> {
    (horizontal(), prop::option::weighted(0.2, share(1.0))).prop_map(|(normal, restitution)| {
        PairContact {
            normal,
            on_slate: true,
            restitution,
        }
    })
}

fn momentum(first: (&Ball, &State), second: (&Ball, &State)) -> DVec3 {
    first.0.mass * first.1.velocity + second.0.mass * second.1.velocity
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn energy_never_rises(law in ball_ball_law(), a in ball_and_state(), b in ball_and_state(), contact in contact()) {
        let before = a.0.kinetic_energy(&a.1) + b.0.kinetic_energy(&b.1);
        let after = law.collide((&a.0, &a.1), (&b.0, &b.1), &contact);
        prop_assert!(after.first.is_finite() && after.second.is_finite());
        prop_assert!(after.impulse.is_finite() && after.impulse >= 0.0);
        assert_no_gain(before, a.0.kinetic_energy(&after.first) + b.0.kinetic_energy(&after.second));
    }

    #[test]
    fn momentum_is_kept(law in ball_ball_law(), a in ball_and_state(), b in ball_and_state(), contact in contact()) {
        // The cloth under pressed balls takes momentum.
        if matches!(law, BallBallLaw::Mathavan2014(_)) {
            return Ok(());
        }
        let after = law.collide((&a.0, &a.1), (&b.0, &b.1), &contact);
        let before = momentum((&a.0, &a.1), (&b.0, &b.1));
        let lost = momentum((&a.0, &after.first), (&b.0, &after.second)) - before;
        let scale = a.0.mass * (a.1.velocity.length() + after.first.velocity.length())
            + b.0.mass * (b.1.velocity.length() + after.second.velocity.length());
        prop_assert!(lost.length() <= 1e-14 * scale, "{:e} of {:e} kg m/s is lost", lost.length(), scale);
    }

    #[test]
    fn the_balls_part_with_the_restitution_asked_for(
        law in ball_ball_law(), a in ball_and_state(), b in ball_and_state(), contact in contact(),
    ) {
        // Energetic restitution is that of speeds only where nothing but the balls works on them.
        if matches!(law, BallBallLaw::Mathavan2014(_)) {
            return Ok(());
        }
        let closing = (a.1.velocity - b.1.velocity).dot(contact.normal);
        let after = law.collide((&a.0, &a.1), (&b.0, &b.1), &contact);
        let parting = (after.second.velocity - after.first.velocity).dot(contact.normal);
        let scale = a.1.velocity.length() + b.1.velocity.length() + after.first.velocity.length()
            + after.second.velocity.length();
        let expected = if closing > 0.0 {
            contact.restitution.unwrap_or(law.restitution(closing)) * closing
        } else {
            -closing
        };
        prop_assert!((parting - expected).abs() <= 1e-13 * scale, "{parting:e} m/s, expected {expected:e} m/s");
    }

    #[test]
    fn mirror_images_mirror(law in ball_ball_law(), a in ball_and_state(), b in ball_and_state(), contact in contact()) {
        let after = law.collide((&a.0, &a.1), (&b.0, &b.1), &contact);
        let flipped = PairContact { normal: mirrored_vector(contact.normal), ..contact };
        let image = law.collide((&a.0, &mirrored(&a.1)), (&b.0, &mirrored(&b.1)), &flipped);
        let allowed = 1e-13 * (size(&a.1, a.0.radius) + size(&b.1, b.0.radius));
        prop_assert!(distance(&image.first, &mirrored(&after.first), a.0.radius) <= allowed);
        prop_assert!(distance(&image.second, &mirrored(&after.second), b.0.radius) <= allowed);
    }

    #[test]
    fn a_contact_has_a_normal_wherever_the_balls_are(a in ball_and_state(), b in ball_and_state(), apart in share(0.1)) {
        let mut second = b.1;
        second.position = a.1.position + DVec3::X * apart;
        let contact = PairContact::between(&a.1, &second);
        prop_assert!((contact.normal.length() - 1.0).abs() <= 1e-15 && contact.normal.y == 0.0);
    }
}
