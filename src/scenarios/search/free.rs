//! What may change in a search.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::physics::scene::Scene;
use crate::scenarios::dial::Dial;
use crate::scenarios::file::FieldError;

/// A number that may change, with the least and the greatest value that it may have.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Free {
    /// A number of the stroke, in its unit.
    Stroke(Dial, f64, f64),
    /// x of a ball, m.
    X(String, f64, f64),
    /// z of a ball, m.
    Z(String, f64, f64),
    /// The first ball touches the second, in this direction from it: degrees counter-clockwise seen from above from the x
    /// axis.
    Around(String, String, f64, f64),
}

/// A ball whose place follows from that of another.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Tie {
    /// The first ball has the x of the second and the opposite z.
    MirrorZ(String, String),
    /// The first ball has the z of the second and the opposite x.
    MirrorX(String, String),
    /// The first ball touches the second, in this direction in degrees.
    Touch(String, String, f64),
}

fn put(scene: &mut Scene, ball: &str, place: impl FnOnce(DVec2) -> DVec2) {
    if let Some(ball) = scene.ball_named(ball) {
        let position = &mut scene.balls[ball].state.position;
        let moved = place(DVec2::new(position.x, position.z));
        (position.x, position.z) = (moved.x, moved.y);
    }
}

fn at(scene: &Scene, ball: &str) -> DVec2 {
    scene.ball_named(ball).map_or(DVec2::ZERO, |ball| {
        let position = scene.balls[ball].state.position;
        DVec2::new(position.x, position.z)
    })
}

/// Puts a ball against another, in this direction.
fn touch(scene: &mut Scene, ball: &str, of: &str, degrees: f64) {
    let (Some(i), Some(j)) = (scene.ball_named(ball), scene.ball_named(of)) else {
        return;
    };
    let reach = scene.balls[i].ball.radius + scene.balls[j].ball.radius;
    let angle = degrees.to_radians();
    let way = DVec2::new(libm::cos(angle), -libm::sin(angle));
    let middle = at(scene, of);
    put(scene, ball, |_| middle + reach * way);
}

impl Free {
    /// The range.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        match self {
            Self::Stroke(_, least, most)
            | Self::X(_, least, most)
            | Self::Z(_, least, most)
            | Self::Around(_, _, least, most) => (*least, *most),
        }
    }

    /// Whether a ball is moved by it.
    #[must_use]
    pub fn moves_a_ball(&self) -> bool {
        !matches!(self, Self::Stroke(..))
    }

    /// What it is called, and its unit.
    #[must_use]
    pub fn label(&self) -> (String, &'static str) {
        match self {
            Self::Stroke(dial, ..) => (dial.name().to_owned(), dial.unit()),
            Self::X(ball, ..) => (format!("x of {ball}"), "m"),
            Self::Z(ball, ..) => (format!("z of {ball}"), "m"),
            Self::Around(ball, of, ..) => (format!("{ball} around {of}"), "degrees"),
        }
    }

    /// Gives it this value in a scene.
    pub fn set(&self, scene: &mut Scene, value: f64) {
        match self {
            Self::Stroke(dial, ..) => {
                if let Some(planned) = &mut scene.shot {
                    dial.set(&mut planned.shot, value);
                }
            }
            Self::X(ball, ..) => put(scene, ball, |at| DVec2::new(value, at.y)),
            Self::Z(ball, ..) => put(scene, ball, |at| DVec2::new(at.x, value)),
            Self::Around(ball, of, ..) => touch(scene, ball, of, value),
        }
    }

    fn check(&self, i: usize, scene: &Scene) -> Result<(), FieldError> {
        let (least, most) = self.range();
        let refuse = |value: String, problem: &str| {
            Err(FieldError::Untestable {
                field: format!("free[{i}]"),
                value,
                problem: problem.to_owned(),
            })
        };
        if !least.is_finite() || !most.is_finite() || least >= most {
            return refuse(
                format!("{least} to {most}"),
                "the first end must be below the second",
            );
        }
        let names: &[&String] = match self {
            Self::Stroke(..) if scene.shot.is_none() => {
                return refuse(format!("{self:?}"), "the scene has no shot");
            }
            Self::Stroke(dial, ..) => {
                let wide = scene.cue.miscue_offset.max(0.5);
                let (low, high) = match dial {
                    Dial::Heading => (-720.0, 720.0),
                    Dial::Speed => (0.0, 30.0),
                    Dial::Side | Dial::Height => (-wide, wide),
                    Dial::Elevation => (0.0, 89.0),
                };
                if least < low || most > high {
                    let unit = dial.unit();
                    return refuse(
                        format!("{least} to {most}"),
                        &format!("a {} lies between {low} and {high} {unit}", dial.name()),
                    );
                }
                &[]
            }
            Self::X(ball, ..) | Self::Z(ball, ..) => &[ball],
            Self::Around(ball, of, ..) => &[ball, of],
        };
        for name in names {
            if scene.ball_named(name).is_none() {
                return refuse(format!("`{name}`"), "there is no such ball");
            }
        }
        Ok(())
    }
}

impl Tie {
    fn pair(&self) -> (&str, &str) {
        match self {
            Self::MirrorZ(ball, of) | Self::MirrorX(ball, of) | Self::Touch(ball, of, _) => {
                (ball, of)
            }
        }
    }

    /// Puts the ball where it belongs.
    pub fn hold(&self, scene: &mut Scene) {
        let (ball, of) = self.pair();
        let other = at(scene, of);
        match self {
            Self::MirrorZ(..) => put(scene, ball, |_| DVec2::new(other.x, -other.y)),
            Self::MirrorX(..) => put(scene, ball, |_| DVec2::new(-other.x, other.y)),
            Self::Touch(_, _, degrees) => touch(scene, ball, of, *degrees),
        }
    }
}

/// Finds the first number that cannot be changed as the file says.
///
/// # Errors
/// [`FieldError`] with the field and the value.
pub(in crate::scenarios) fn check(
    scene: &Scene,
    free: &[Free],
    ties: &[Tie],
) -> Result<(), FieldError> {
    let mut numbered = free.iter().enumerate();
    numbered.try_for_each(|(i, free)| free.check(i, scene))?;
    for (i, tie) in ties.iter().enumerate() {
        let (ball, of) = tie.pair();
        for name in [ball, of] {
            if scene.ball_named(name).is_none() || ball == of {
                return Err(FieldError::Untestable {
                    field: format!("ties[{i}]"),
                    value: format!("`{name}`"),
                    problem: "two different balls of the scene are needed".to_owned(),
                });
            }
        }
    }
    Ok(())
}
