//! A number of a scene that a sweep varies, and the values it takes.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use thiserror::Error;

use crate::physics::scene::{Scene, SceneError};
use crate::scenarios::dial::Dial;
use crate::scenarios::file::{FieldError, LayoutError};
use crate::scenarios::preset::set_in_scene;
use crate::scenarios::search::normal;

/// A number of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Varied {
    /// Of the stroke: `heading`, `speed`, `side`, `height`, `elevation`.
    Stroke(Dial),
    /// Of one ball: `balls.NAME.x`, `z`, `mass`, `radius`.
    Ball(usize, BallNumber),
    /// Of the laws, the cue or the table, by its path: `laws.ball_ball.restitution`, `cue.mass`, `table.nose_height`.
    Path(String),
}

/// A number of a ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BallNumber {
    /// Place along the table, m.
    X,
    /// Place across the table, m.
    Z,
    /// Mass, kg.
    Mass,
    /// Radius, m. A ball on the slate stays on it.
    Radius,
}

impl BallNumber {
    /// Each with what the command line calls it.
    const ALL: [(&'static str, Self); 4] = [
        ("x", Self::X),
        ("z", Self::Z),
        ("mass", Self::Mass),
        ("radius", Self::Radius),
    ];
}

/// The values of an axis.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// These, one after the other.
    Listed(Vec<f64>),
    /// Anything between two ends, each value as likely as any other.
    Between(f64, f64),
    /// Normally distributed about a mean, with this standard deviation: what an unsteady hand does.
    About(f64, f64),
}

/// A number that varies.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// As it was written, and as its column is headed.
    pub name: String,
    /// Which number.
    pub what: Varied,
    /// Its values.
    pub values: Values,
}

/// Why an axis is no good.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum AxisError {
    /// No name, or no values.
    #[error(
        "{text}: a number and its values are needed: speed=1:7:100 (100 values), speed=1,2,4 (these), speed=1:7 (any between) \
         or speed=2+-0.1 (mean and standard deviation)"
    )]
    Spelling {
        /// What was written.
        text: String,
    },
    /// The number is not there.
    #[error("{name}: there is no such number; {parent} has {known}")]
    Unknown {
        /// What was asked for.
        name: String,
        /// The part of the name that is known.
        parent: String,
        /// What could follow.
        known: String,
    },
    /// The stroke of a scene without one.
    #[error("{name}: the scene has no shot")]
    NoShot {
        /// What was asked for.
        name: String,
    },
    /// The same number twice.
    #[error("{name}: is varied twice")]
    Twice {
        /// What was asked for.
        name: String,
    },
    /// Values at random where there is no number of shots.
    #[error(
        "{name}: values at random need a number of shots (--shots); a grid needs a count, such as {name}=1:7:100"
    )]
    NoCount {
        /// What was asked for.
        name: String,
    },
}

/// Most values of an axis: more are a slip of the pen.
const MOST: usize = 1_000_000;

impl Axis {
    /// Reads `NAME=FROM:TO:COUNT`, `NAME=FROM:TO`, `NAME=MEAN+-DEVIATION` or `NAME=VALUE,VALUE,...` for a scene. Units are those of
    /// scene files; angles of a stroke in degrees.
    ///
    /// # Errors
    /// [`AxisError`] with what is wrong, and with the names that there are.
    pub fn parse(text: &str, scene: &Scene) -> Result<Self, AxisError> {
        let spelling = || AxisError::Spelling {
            text: text.to_owned(),
        };
        let (name, values) = text.split_once('=').ok_or_else(spelling)?;
        let name = name.trim();
        Ok(Self {
            name: name.to_owned(),
            what: Varied::named(name, scene)?,
            values: Values::parse(values).ok_or_else(spelling)?,
        })
    }

    /// The values at the places of a grid.
    pub(super) fn count(&self) -> Option<usize> {
        match &self.values {
            Values::Listed(values) => Some(values.len()),
            Values::Between(..) | Values::About(..) => None,
        }
    }

    /// A value at random.
    pub(super) fn draw(&self, rng: &mut ChaCha8Rng) -> f64 {
        match &self.values {
            Values::Listed(values) => values[rng.random_range(0..values.len())],
            Values::Between(from, to) => from + (to - from) * rng.random::<f64>(),
            Values::About(mean, deviation) => mean + deviation * normal(rng),
        }
    }
}

impl Values {
    fn parse(text: &str) -> Option<Self> {
        let number = |text: &str| {
            let number = text.trim().parse::<f64>().ok();
            number.filter(|number| number.is_finite())
        };
        if let Some((mean, deviation)) = text.split_once("+-") {
            let deviation = number(deviation).filter(|deviation| *deviation >= 0.0)?;
            return Some(Self::About(number(mean)?, deviation));
        }
        let parts: Vec<&str> = text.split(':').collect();
        match *parts.as_slice() {
            [from, to] => Some(Self::Between(number(from)?, number(to)?)),
            [from, to, count] => {
                let (from, to) = (number(from)?, number(to)?);
                let count = count.trim().parse::<usize>().ok();
                let count = count.filter(|count| (1..=MOST).contains(count))?;
                // The last value is the end itself, whatever the steps round to.
                let steps = (count - 1).max(1) as f64;
                let value = |i: usize| match i {
                    0 => from,
                    _ if i + 1 == count => to,
                    _ => from + (to - from) * (i as f64 / steps),
                };
                Some(Self::Listed((0..count).map(value).collect()))
            }
            _ => text
                .split(',')
                .map(number)
                .collect::<Option<_>>()
                .map(Self::Listed),
        }
    }
}

impl Varied {
    fn named(name: &str, scene: &Scene) -> Result<Self, AxisError> {
        if let Some(dial) = Dial::ALL.into_iter().find(|dial| dial.name() == name) {
            return match scene.shot {
                Some(_) => Ok(Self::Stroke(dial)),
                None => Err(AxisError::NoShot {
                    name: name.to_owned(),
                }),
            };
        }
        if let Some(ball) = name.strip_prefix("balls.") {
            return Self::of_a_ball(name, ball, scene);
        }
        // Tried out once with the number that stands there, so that a slip is told before ten thousand shots are played.
        let found = Self::Path(name.to_owned());
        match set_in_scene(&mut scene.clone(), [(name, 0.5)].into_iter()) {
            Err(LayoutError::Field(FieldError::NoSuchNumber { parent, known, .. })) => {
                let top = parent == "set";
                Err(AxisError::Unknown {
                    name: name.to_owned(),
                    parent: if top { "a scene".to_owned() } else { parent },
                    known: if top {
                        let dials = Dial::ALL.map(Dial::name).join(", ");
                        format!("{dials}, balls.NAME.x, and in {known} the numbers of these")
                    } else {
                        known
                    },
                })
            }
            _ => Ok(found),
        }
    }

    fn of_a_ball(name: &str, ball: &str, scene: &Scene) -> Result<Self, AxisError> {
        let unknown = |parent: &str, known: Vec<&str>| AxisError::Unknown {
            name: name.to_owned(),
            parent: parent.to_owned(),
            known: known.join(", "),
        };
        let numbers = || BallNumber::ALL.iter().map(|(name, _)| *name).collect();
        let Some((ball, number)) = ball.rsplit_once('.') else {
            return Err(unknown("a ball", numbers()));
        };
        let Some(index) = scene.ball_named(ball) else {
            let names = scene.balls.iter().map(|ball| ball.name.as_str()).collect();
            return Err(unknown("`balls`", names));
        };
        let found = BallNumber::ALL.iter().find(|(name, _)| *name == number);
        let (_, number) = found.ok_or_else(|| unknown("a ball", numbers()))?;
        Ok(Self::Ball(index, *number))
    }
}

/// Gives these numbers these values in a scene.
pub(super) fn set<'a>(
    scene: &mut Scene,
    numbers: impl Iterator<Item = (&'a Varied, f64)> + Clone,
) -> Result<(), LayoutError> {
    for (what, value) in numbers.clone() {
        match what {
            Varied::Stroke(dial) => {
                if let Some(planned) = &mut scene.shot {
                    dial.set(&mut planned.shot, value);
                }
            }
            Varied::Ball(ball, number) => set_of_ball(scene, *ball, *number, value)?,
            Varied::Path(_) => {}
        }
    }
    let paths = numbers.filter_map(|(what, value)| match what {
        Varied::Path(path) => Some((path.as_str(), value)),
        Varied::Stroke(_) | Varied::Ball(..) => None,
    });
    if paths.clone().next().is_some() {
        set_in_scene(scene, paths)?;
    }
    Ok(())
}

fn set_of_ball(
    scene: &mut Scene,
    ball: usize,
    number: BallNumber,
    value: f64,
) -> Result<(), SceneError> {
    let Some(placed) = scene.balls.get_mut(ball) else {
        let count = scene.balls.len();
        return Err(SceneError::NoSuchBall { ball, count });
    };
    match number {
        BallNumber::X => placed.state.position.x = value,
        BallNumber::Z => placed.state.position.z = value,
        BallNumber::Mass => placed.ball.mass = value,
        BallNumber::Radius => {
            if placed.state.position.y == placed.ball.radius {
                placed.state.position.y = value;
            }
            placed.ball.radius = value;
        }
    }
    Ok(())
}
