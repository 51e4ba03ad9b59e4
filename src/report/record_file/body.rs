//! What the lines of a record file say.

use std::collections::HashMap;

use serde::Serialize;
use serde_json::Value;

use crate::physics::ball::State;
use crate::physics::record::{Event, EventKind, Participant, PathPiece, Record};
use crate::physics::scene::{Scene, SceneBall};
use crate::report::record_file::fields::{Field, Problem, difference};
use crate::report::record_file::lines::{EventLine, Header, Last, PathLine};
use crate::report::record_file::{Expected, Recorded, Summary, paths};

/// Seconds by which a line may be earlier than the one before it: the rounding of a tick.
const ROUNDING: f64 = 1e-9;

/// The value as it would be written.
fn written(line: &impl Serialize) -> Result<Value, Problem> {
    serde_json::to_value(line).map_err(|error| Problem::new("line", error.to_string()))
}

/// Reads the first line; the record is still empty.
pub(super) fn header(value: &Value) -> Result<Recorded, Problem> {
    let line = Field::line(value);
    let (name, title) = (line.get("name")?.read()?, line.get("title")?.read()?);
    let parts = line.get("scene")?;
    let balls = parts.get("balls")?.items()?.map(|ball| {
        Ok(SceneBall {
            name: ball.get("name")?.read()?,
            ball: ball.get("ball")?.read()?,
            state: state(&ball.get("state")?)?,
        })
    });
    let scene = Scene {
        table: parts.get("table")?.read()?,
        laws: parts.get("laws")?.read()?,
        cue: parts.get("cue")?.read()?,
        balls: balls.collect::<Result<_, Problem>>()?,
        shot: parts.get("shot")?.read()?,
        solver: parts.get("solver")?.read()?,
        time_limit: parts.get("time_limit")?.read()?,
    };
    let recorded = Recorded {
        name,
        title,
        scene,
        record: Record::default(),
        expected: Vec::new(),
    };
    let again = Header::of(&recorded.name, &recorded.title, &recorded.scene);
    difference(value, &written(&again)?)?;
    Ok(recorded)
}

fn state(field: &Field) -> Result<State, Problem> {
    Ok(State {
        position: field.get("position")?.read()?,
        velocity: field.get("velocity")?.read()?,
        angular_velocity: field.get("angular_velocity")?.read()?,
        motion: field.get("motion")?.read()?,
    })
}

/// What follows the first line.
pub(super) struct Body<'s> {
    name: &'s str,
    title: &'s str,
    scene: &'s Scene,
    balls: HashMap<&'s str, usize>,
    pockets: HashMap<&'s str, usize>,
    events: Vec<Event>,
    told: HashMap<usize, Vec<PathPiece>>,
    /// What became of the expectations, as far as read.
    pub(super) expected: Vec<Expected>,
}

impl<'s> Body<'s> {
    pub(super) fn of(recorded: &'s Recorded) -> Self {
        let scene = &recorded.scene;
        let index = |(i, name)| (name, i);
        let balls = scene.balls.iter().map(|ball| ball.name.as_str());
        let pockets = scene
            .table
            .pockets
            .iter()
            .map(|pocket| pocket.name.as_str());
        Self {
            name: &recorded.name,
            title: &recorded.title,
            scene,
            balls: balls.enumerate().map(index).collect(),
            pockets: pockets.enumerate().map(index).collect(),
            events: Vec::new(),
            told: HashMap::new(),
            expected: Vec::new(),
        }
    }

    /// Takes one line; the last one gives the record.
    pub(super) fn line(&mut self, value: &Value) -> Result<Option<Record>, Problem> {
        if value.get("summary").is_some() {
            return self.end(value).map(Some);
        }
        if value.get("kind").is_some() {
            self.event(value)?;
        } else if value.get("path").is_some() {
            self.path(value)?;
        } else if value.get("expected").is_some() {
            let one: Expected = Field::line(value).read()?;
            difference(value, &written(&one)?)?;
            self.expected.push(one);
        } else {
            let what = "the line has neither this field nor `path`, `expected` or `summary`";
            return Err(Problem::new("kind", what));
        }
        Ok(None)
    }

    fn ball(&self, field: &Field) -> Result<usize, Problem> {
        let name: &str = field.read()?;
        let ball = self.balls.get(name).copied();
        ball.ok_or_else(|| field.problem(format!("there is no ball `{name}` in the scene")))
    }

    fn event(&mut self, value: &Value) -> Result<(), Problem> {
        let line = Field::line(value);
        let time = line.get("time")?;
        let event = Event {
            time: time.read()?,
            kind: self.kind(&line)?,
            first: self.participant(&line, 0)?,
            second: match line.get("who")?.items()?.count() {
                2 => Some(self.participant(&line, 1)?),
                _ => None,
            },
            impulse: line.get("impulse")?.read()?,
        };
        let earliest = self.events.last().map_or(0.0, |last| last.time);
        if event.time < earliest - ROUNDING {
            let what = format!(
                "{} s comes after {earliest} s; events stand in order of time",
                event.time
            );
            return Err(time.problem(what));
        }
        if event.second.is_some() != (event.kind == EventKind::BallBall) {
            return Err(line
                .get("who")?
                .problem("two balls meet in a `ball_ball`, one takes part in anything else"));
        }
        difference(value, &written(&EventLine::of(self.scene, &event))?)?;
        self.events.push(event);
        Ok(())
    }

    fn kind(&self, line: &Field) -> Result<EventKind, Problem> {
        let kind = line.get("kind")?;
        match kind.read()? {
            "strike" => Ok(EventKind::Strike {
                miscue: line.get("miscue")?.read()?,
            }),
            "ball_ball" => Ok(EventKind::BallBall),
            "slate" => Ok(EventKind::Slate),
            "off_table" => Ok(EventKind::OffTable),
            "rim" => Ok(EventKind::Rim {
                pocket: self.pocket(line)?,
            }),
            "cushion" => {
                let field = line.get("cushion")?;
                let (cushion, count) = (field.read()?, self.scene.table.cushions.len());
                if cushion >= count {
                    return Err(field.problem(format!(
                        "there is no cushion {cushion}, the table has {count}"
                    )));
                }
                Ok(EventKind::Cushion { cushion })
            }
            "pocketed" => Ok(EventKind::Pocketed {
                pocket: self.pocket(line)?,
            }),
            "motion" => Ok(EventKind::Motion {
                from: line.get("from")?.read()?,
                to: line.get("to")?.read()?,
            }),
            other => Err(kind.problem(format!(
                "`{other}` is not known, there are strike, ball_ball, cushion, slate, rim, pocketed, off_table and motion"
            ))),
        }
    }

    fn pocket(&self, line: &Field) -> Result<usize, Problem> {
        let field = line.get("pocket")?;
        let name: &str = field.read()?;
        self.pockets
            .get(name)
            .copied()
            .ok_or_else(|| field.problem(format!("there is no pocket `{name}` on the table")))
    }

    fn participant(&self, line: &Field, place: usize) -> Result<Participant, Problem> {
        let nth = |name: &str| -> Result<Field, Problem> {
            let list = line.get(name)?;
            let item = list.items()?.nth(place);
            item.ok_or_else(|| list.problem(format!("number {place} is missing")))
        };
        Ok(Participant {
            ball: self.ball(&nth("who")?)?,
            before: state(&nth("before")?)?,
            after: state(&nth("after")?)?,
        })
    }

    fn path(&mut self, value: &Value) -> Result<(), Problem> {
        let line = Field::line(value);
        let ball = self.ball(&line.get("path")?)?;
        let mut path: Vec<PathPiece> = Vec::new();
        for item in line.get("pieces")?.items()? {
            let (time, start) = (item.get("time")?, state(&item.get("state")?)?);
            let seconds: f64 = time.read()?;
            let earliest = path.last().map_or(0.0, |last| last.time);
            if seconds < earliest - ROUNDING {
                let what = format!("{seconds} s comes after {earliest} s");
                return Err(time.problem(what));
            }
            path.push(paths::piece(self.scene, ball, seconds, &start));
        }
        if path.is_empty() {
            return Err(Problem::new("pieces", "a path has one piece at least"));
        }
        let again = PathLine::of(self.scene, ball, &path);
        difference(value, &written(&again)?)?;
        if self.told.insert(ball, path).is_some() {
            return Err(Problem::new("path", "this path was told before"));
        }
        Ok(())
    }

    fn end(&mut self, value: &Value) -> Result<Record, Problem> {
        let summary = Field::line(value).get("summary")?;
        let end = summary.get("end")?.items()?.map(|end| state(&end));
        let mut record = Record {
            events: std::mem::take(&mut self.events),
            paths: Vec::new(),
            end: end.collect::<Result<_, Problem>>()?,
            end_time: summary.get("time")?.read()?,
            reason: summary.get("reason")?.read()?,
        };
        if record.end.len() != self.scene.balls.len() {
            let (found, count) = (record.end.len(), self.scene.balls.len());
            let what = format!("{found} balls, the scene has {count}");
            return Err(summary.get("end")?.problem(what));
        }
        let lines_of_paths = self.told.len();
        record.paths = paths::of_events(self.scene, &record.events);
        for (ball, path) in self.told.drain() {
            record.paths[ball] = path;
        }
        let again = Summary::of(self.name, self.title, self.scene, &record);
        difference(
            value,
            &written(&Last {
                summary: &again,
                paths: lines_of_paths,
            })?,
        )?;
        Ok(record)
    }
}
