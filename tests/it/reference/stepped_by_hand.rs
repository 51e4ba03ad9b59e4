//! The impact of Mathavan, Jackson & Parkin (2014) stepped as pooltool steps it: with its sign of spin in the slip at the
//! cloth it gives its table, with the right one our law.

use glam::DVec3;

use masse::physics::ball::{Ball, State};
use masse::physics::laws::ball_ball::{BallBallLaw, Friction, Mathavan2014, PairContact};

use super::state;
use super::tables::Tables;
use crate::frames::{distance, size};

const STEPS: f64 = 4000.0;

/// Equal balls; `sign` is that of the spin in the slip at the cloth, 1 for a point below the centre.
fn stepped(law: &Mathavan2014, ball: &Ball, states: [State; 2], sign: f64) -> [State; 2] {
    let [mut a, mut b] = states;
    let (m, r, up) = (ball.mass, ball.radius, DVec3::Y);
    let normal = (b.position - a.position).normalize();
    let slip = |a: &State, b: &State| {
        let relative = a.velocity - b.velocity;
        let spin = r * (a.angular_velocity + b.angular_velocity);
        relative - relative.dot(normal) * normal + spin.cross(normal)
    };
    let parting = |a: &State, b: &State| (b.velocity - a.velocity).dot(normal);
    let mu = law.friction.coefficient(slip(&a, &b).length());
    let mut speed = parting(&a, &b);
    let step = (1.0 + law.restitution) * m * speed.abs() / (2.0 * STEPS);
    let (mut work, mut goal) = (0.0, f64::INFINITY);
    while speed < 0.0 || work < goal {
        let rub = -mu * step * slip(&a, &b).normalize_or_zero();
        let push = |state: &mut State, side: f64, rub: DVec3| {
            let pressed = (-side * rub.y).max(0.0) * side.abs();
            let under = state.velocity - sign * r * state.angular_velocity.cross(up);
            let cloth = -law.sliding * pressed * under.normalize_or_zero();
            let level = side * (rub - rub.y * up - step * normal) + cloth;
            state.velocity += level / m;
            state.angular_velocity += 2.5 / (m * r) * (normal.cross(rub) - up.cross(cloth));
        };
        // Force on the first: `rub`, upwards or downwards; on the second the opposite.
        push(&mut a, 1.0, rub);
        push(&mut b, -1.0, rub);
        let after = parting(&a, &b);
        work += 0.5 * step * (speed + after).abs();
        if speed <= 0.0 && after > 0.0 && goal.is_infinite() {
            goal = (1.0 + law.restitution * law.restitution) * work;
        }
        speed = after;
    }
    [a, b]
}

#[test]
fn reference_mathavan_2014_with_their_sign_and_with_the_right_one() {
    let tables = Tables::load();
    let (p, mu, ball) = (
        &tables.ball_params,
        &tables.friction_alciatore,
        tables.ball(),
    );
    let law = Mathavan2014 {
        restitution: p.e_b,
        friction: Friction::Marlow {
            a: mu.a,
            b: mu.b,
            c: mu.c,
        },
        sliding: p.u_s,
    };
    assert_eq!(tables.ball_ball.len(), 40);
    for (i, row) in tables.ball_ball.iter().enumerate() {
        let before = [state(&row.ball1), state(&row.ball2)];
        let theirs = &row.out["frictional_mathavan_N100000"];
        let theirs = [state(&theirs.ball1), state(&theirs.ball2)];
        let contact = PairContact::between(&before[0], &before[1]);
        let after = BallBallLaw::Mathavan2014(law).collide(
            (&ball, &before[0]),
            (&ball, &before[1]),
            &contact,
        );
        let scale = size(&before[0], ball.radius) + size(&before[1], ball.radius);
        let apart = |one: [State; 2], two: [State; 2]| {
            distance(&one[0], &two[0], ball.radius).max(distance(&one[1], &two[1], ball.radius))
                / scale
        };
        // The stepping itself is out by the order of a step.
        let same = apart(stepped(&law, &ball, before, -1.0), theirs);
        assert!(
            same < 1e-3,
            "ball_ball[{i}]: {same:e} from theirs with their sign"
        );
        let ours = apart(
            stepped(&law, &ball, before, 1.0),
            [after.first, after.second],
        );
        assert!(
            ours < 1e-3,
            "ball_ball[{i}]: {ours:e} from ours with the right sign"
        );
        println!("{same:e} {ours:e}");
    }
}
