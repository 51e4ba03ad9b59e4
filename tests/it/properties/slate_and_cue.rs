//! Impacts with the slate, and strokes of the cue.

use proptest::prelude::*;

use masse::physics::ball::{Ball, State};
use masse::physics::cue::{Cue, Shot};
use masse::physics::laws::Check;
use masse::physics::laws::cue_ball::strike;
use masse::physics::laws::slate::SlateLaw;

use super::inputs::{ball, ball_and_state, component, share, slate_law};
use super::{assert_no_gain, cases};
use crate::frames::{distance, mirrored, size};

fn cue() -> impl Strategy<Value = Cue> {
    (1e-2..10.0_f64, share(1.0), share(0.1), share(0.99)).prop_map(
        |(mass, tip_restitution, end_mass, miscue_offset)| Cue {
            mass,
            tip_restitution,
            end_mass,
            miscue_offset,
            ..Cue::default()
        },
    )
}

fn shot() -> impl Strategy<Value = Shot> {
    // Just below the largest allowed offset, which rounding of the two parts would pass.
    let tip = (share(0.99 - 1e-12), -3.2..3.2_f64);
    (-7.0..7.0_f64, share(1.56), tip, share(100.0)).prop_map(
        |(heading, elevation, (offset, clock), speed)| Shot {
            heading,
            elevation,
            side: offset * libm::cos(clock),
            height: offset * libm::sin(clock),
            speed,
        },
    )
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn the_slate_makes_no_energy(law in slate_law(), (ball, state) in ball_and_state(), down in component(20.0)) {
        let mut state = state;
        state.velocity.y = -down;
        let after = law.land(&ball, &state);
        prop_assert!(after.is_finite());
        let up = match &law {
            SlateLaw::Bouncing(slate) => {
                let up = if down > 0.0 { slate.restitution * down } else { -down };
                if up > slate.settle { up } else { 0.0 }
            }
            SlateLaw::Held | SlateLaw::Rubbed { .. } => 0.0,
        };
        prop_assert_eq!(after.velocity.y, up);
        prop_assert_eq!(after.angular_velocity.y, state.angular_velocity.y);
        assert_no_gain(ball.kinetic_energy(&state), ball.kinetic_energy(&after));
        let image = law.land(&ball, &mirrored(&state));
        prop_assert!(distance(&image, &mirrored(&after), ball.radius) <= 1e-13 * size(&state, ball.radius));
        // No force at the lowest point changes 5 v + 2 R ω × ŷ.
        let invariant = |state: &State| {
            5.0 * glam::DVec3::new(state.velocity.x, 0.0, state.velocity.z)
                + 2.0 * ball.radius * state.angular_velocity.cross(glam::DVec3::Y)
        };
        let drift = (invariant(&after) - invariant(&state)).length();
        prop_assert!(drift <= 1e-14 * (1.0 + size(&state, ball.radius)) * 5.0, "{drift:e} m/s");
    }

    #[test]
    fn a_stroke_gives_no_more_than_the_cue_has(
        cue in cue(), slate in slate_law(), ball in ball(), shot in shot(),
    ) {
        for parameter in cue.parameters().into_iter().chain(shot.parameters()) {
            prop_assert!(parameter.is_allowed(), "{parameter:?}");
        }
        let rest = State::at_rest(glam::DVec3::Y * ball.radius);
        let struck = strike(&cue, &slate, &ball, &rest, &shot);
        prop_assert!(struck.state.is_finite() && struck.impulse.is_finite() && struck.impulse >= 0.0);
        prop_assert_eq!(struck.miscue, shot.offset() > cue.miscue_offset);
        assert_no_gain(0.5 * cue.mass * shot.speed * shot.speed, ball.kinetic_energy(&struck.state));
        prop_assert!(ball.spins || struck.state.angular_velocity == glam::DVec3::ZERO);
    }

    #[test]
    fn a_stroke_in_a_mirror(cue in cue(), slate in slate_law(), ball in ball(), shot in shot()) {
        let rest = State::at_rest(glam::DVec3::Y * ball.radius);
        let state = strike(&cue, &slate, &ball, &rest, &shot).state;
        let flipped = Shot { heading: -shot.heading, side: -shot.side, ..shot };
        let image = strike(&cue, &slate, &ball, &rest, &flipped).state;
        let apart = distance(&image, &mirrored(&state), ball.radius);
        prop_assert!(apart <= 1e-13 * size(&state, ball.radius), "{apart:e} apart");
    }
}

#[test]
fn a_stroke_of_a_pool_cue_is_what_players_know() {
    // A sanity line beside the random ones: a 2 m/s stroke of a 20 oz cue sends a pool ball off at 2.7 m/s.
    let rest = State::at_rest(glam::DVec3::ZERO);
    let shot = Shot::default();
    for slate in masse::physics::laws::slate::SlateLaw::all() {
        let speed = strike(&Cue::default(), &slate, &Ball::POOL, &rest, &shot)
            .state
            .velocity
            .x;
        assert!((2.6..2.7).contains(&speed), "{speed} m/s");
    }
}
