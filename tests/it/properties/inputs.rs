//! Random balls, states and laws. Zero and tiny numbers come often: there the branches are.

use glam::DVec3;
use proptest::prelude::*;
use proptest::sample::select;

use masse::physics::ball::{Ball, State};
use masse::physics::laws::Check;
use masse::physics::laws::ball_ball::{BallBallLaw, Friction, Mathavan2014, PeerCap};
use masse::physics::laws::coursework::Coursework;
use masse::physics::laws::cushion::CushionLaw;
use masse::physics::laws::motion::MotionLaw;
use masse::physics::laws::restitution::{NoseFriction, Restitution};
use masse::physics::laws::slate::SlateLaw;

/// A number between -`most` and `most`, often zero, often tiny.
pub fn component(most: f64) -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -most..most,
        2 => Just(0.0),
        1 => (-16.0..0.0, any::<bool>()).prop_map(move |(power, minus)| {
            let value = most * libm::pow(10.0, power);
            if minus { -value } else { value }
        }),
    ]
}

/// A number between 0 and `most`, often one of the ends.
pub fn share(most: f64) -> impl Strategy<Value = f64> {
    prop_oneof![6 => 0.0..most, 1 => Just(0.0), 1 => Just(most)]
}

/// A ball of 10 mg to 10 t and 1 cm to 10 cm, mostly with spin.
pub fn ball() -> impl Strategy<Value = Ball> {
    (-5.0..4.0, 0.01..0.1, prop::bool::weighted(0.9)).prop_map(|(power, radius, spins)| Ball {
        mass: libm::pow(10.0, power),
        radius,
        spins,
    })
}

/// A ball on the slate with up to 20 m/s and 500 rad/s on each axis.
pub fn state() -> impl Strategy<Value = State> {
    let spin = (component(500.0), component(500.0), component(500.0));
    (component(20.0), component(20.0), spin).prop_map(|(x, z, (w_x, w_y, w_z))| State {
        velocity: DVec3::new(x, 0.0, z),
        angular_velocity: DVec3::new(w_x, w_y, w_z),
        ..State::default()
    })
}

/// A ball with its state: none of the spin a ball cannot have.
pub fn ball_and_state() -> impl Strategy<Value = (Ball, State)> {
    (ball(), state()).prop_map(|(ball, mut state)| {
        state.position = DVec3::Y * ball.radius;
        if !ball.spins {
            state.angular_velocity = DVec3::ZERO;
        }
        (ball, state)
    })
}

/// A horizontal unit vector, often along an axis.
pub fn horizontal() -> impl Strategy<Value = DVec3> {
    prop_oneof![
        3 => (-3.2..3.2_f64).prop_map(|a| DVec3::new(libm::cos(a), 0.0, libm::sin(a))),
        1 => select(vec![DVec3::X, -DVec3::X, DVec3::Z, -DVec3::Z]),
    ]
}

/// Every ball-ball law, with its own and with any allowed parameters.
pub fn ball_ball_law() -> impl Strategy<Value = BallBallLaw> {
    let friction = prop_oneof![
        share(2.0).prop_map(Friction::Constant),
        (share(1.0), share(1.0), share(10.0)).prop_map(|(a, b, c)| Friction::Marlow { a, b, c }),
    ];
    (
        select(BallBallLaw::all()),
        any::<bool>(),
        share(1.0),
        friction,
        share(2.0),
    )
        .prop_map(|(mut law, vary, restitution, friction, cloth)| {
            match &mut law {
                _ if !vary => {}
                BallBallLaw::Frictionless(law) => law.restitution = restitution,
                BallBallLaw::Frictional(law) | BallBallLaw::PeerCap(PeerCap(law)) => {
                    law.restitution = restitution;
                    law.friction = friction;
                }
                BallBallLaw::Mathavan2014(law) => {
                    *law = Mathavan2014 {
                        restitution,
                        friction,
                        sliding: cloth,
                    };
                }
            }
            allowed(law)
        })
}

/// Any restitution of a cushion.
fn restitution() -> impl Strategy<Value = Restitution> {
    prop_oneof![
        3 => share(1.0).prop_map(Restitution::Constant),
        1 => (share(2.0), -10.0..10.0_f64, share(1.0)).prop_map(|(at_rest, fall, floor)| {
            Restitution::Linear { at_rest, fall, floor }
        }),
        1 => Just(Restitution::HAN),
    ]
}

/// Any friction of a cushion.
fn nose_friction() -> impl Strategy<Value = NoseFriction> {
    prop_oneof![
        3 => share(2.0).prop_map(NoseFriction::Constant),
        1 => (share(2.0), -2.0..2.0_f64).prop_map(|(head_on, fall)| NoseFriction::ByAngle { head_on, fall }),
        1 => Just(NoseFriction::HAN),
    ]
}

/// Every cushion law, with its own and with any allowed parameters.
pub fn cushion_law() -> impl Strategy<Value = CushionLaw> {
    let numbers = (restitution(), nose_friction(), share(2.0), 1.01..1.99_f64);
    (select(CushionLaw::all()), any::<bool>(), numbers).prop_map(
        |(mut law, vary, (restitution, friction, plain, frequency_ratio))| {
            match &mut law {
                _ if !vary => {}
                CushionLaw::Mirror(law) => law.restitution = restitution,
                CushionLaw::Han2005(law) => {
                    law.restitution = restitution;
                    law.friction = friction;
                }
                CushionLaw::Impulse(law) => {
                    law.restitution = restitution;
                    law.friction = friction;
                }
                CushionLaw::Mathavan2010(law) => {
                    law.restitution = restitution;
                    law.friction = friction;
                    law.sliding = plain;
                }
                CushionLaw::Stronge2018(law) => {
                    law.restitution = restitution;
                    law.friction = plain;
                    law.frequency_ratio = frequency_ratio;
                }
            }
            allowed(law)
        },
    )
}

/// Every motion law, with its own and with other allowed parameters.
pub fn motion_law() -> impl Strategy<Value = MotionLaw> {
    let cloth = (share(0.5), share(0.05), share(20.0), 1.0..20.0);
    (select(MotionLaw::all()), any::<bool>(), cloth).prop_map(
        |(mut law, vary, (sliding, rolling, spin_deceleration, gravity))| {
            match &mut law {
                _ if !vary => {}
                MotionLaw::Frictionless | MotionLaw::Coursework(_) => {}
                MotionLaw::Inclined(incline) => {
                    (incline.x, incline.z) = (sliding * gravity, -rolling * gravity);
                }
                MotionLaw::Coulomb(cloth) => {
                    cloth.sliding = sliding;
                    cloth.rolling = rolling;
                    cloth.spin_deceleration = spin_deceleration;
                    cloth.gravity = gravity;
                }
            }
            allowed(law)
        },
    )
}

/// The coursework friction with any allowed parameters.
pub fn coursework() -> impl Strategy<Value = Coursework> {
    (
        share(60.0),
        share(60.0),
        share(60.0),
        share(60.0),
        component(10.0),
        share(1.0),
    )
        .prop_map(|(drag, spin_drag, coupling, push, english, rest_below)| {
            allowed(Coursework {
                drag,
                spin_drag,
                coupling,
                push,
                english,
                rest_below,
            })
        })
}

/// Every slate law, with its own and with any allowed parameters.
pub fn slate_law() -> impl Strategy<Value = SlateLaw> {
    (select(SlateLaw::all()), any::<bool>(), share(2.0)).prop_map(|(mut law, vary, mu)| {
        match &mut law {
            _ if !vary => {}
            SlateLaw::Held => {}
            SlateLaw::Rubbed { friction } => *friction = mu,
            SlateLaw::Bouncing(bouncing) => bouncing.friction = mu,
        }
        allowed(law)
    })
}

/// The law itself: a random parameter out of the law's own range would prove nothing.
fn allowed<L: Check>(law: L) -> L {
    for parameter in law.parameters() {
        assert!(parameter.is_allowed(), "{parameter:?}");
    }
    law
}
