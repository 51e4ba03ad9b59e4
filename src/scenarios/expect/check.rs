//! Expectations that could never be tested are refused.

use crate::physics::laws::slate::SlateLaw;
use crate::physics::scene::Scene;
use crate::scenarios::expect::reading::Ends;
use crate::scenarios::expect::{Contact, Expectation, Moment, Spot};
use crate::scenarios::file::FieldError;

/// What an expectation can be wrong about.
pub(super) struct Checker<'s> {
    scene: &'s Scene,
    /// The expectation, such as `expect[2]`.
    parent: String,
}

/// What a check says.
pub(super) type Checked = Result<(), FieldError>;

/// Finds the first expectation that names what is not there, or that can never be tested.
///
/// # Errors
/// [`FieldError`] with the field, the value and what there is.
pub(in crate::scenarios) fn check(scene: &Scene, expect: &[Expectation]) -> Checked {
    for (i, one) in expect.iter().enumerate() {
        let checker = Checker {
            scene,
            parent: format!("expect[{i}]"),
        };
        one.kind().check(&checker)?;
    }
    let still = |ball: &crate::physics::scene::SceneBall| ball.state.motion.is_still();
    if !expect.is_empty() && scene.shot.is_none() && scene.balls.iter().all(still) {
        return Err(FieldError::Untestable {
            field: "expect".to_owned(),
            value: format!("{} expectations", expect.len()),
            problem: "nothing moves: the scene has no shot and every ball is at rest".to_owned(),
        });
    }
    if !expect.is_empty() && scene.solver.is_crowd() {
        return Err(FieldError::Untestable {
            field: "expect".to_owned(),
            value: format!("{} expectations", expect.len()),
            problem: "a crowd is counted and not recorded, so that nothing can be tested"
                .to_owned(),
        });
    }
    Ok(())
}

impl Checker<'_> {
    pub(super) fn refuse(
        &self,
        field: &str,
        value: impl ToString,
        problem: impl Into<String>,
    ) -> Checked {
        Err(FieldError::Untestable {
            field: format!("{}.{field}", self.parent),
            value: value.to_string(),
            problem: problem.into(),
        })
    }

    pub(super) fn ball(&self, field: &str, name: &str) -> Checked {
        match self.scene.ball_named(name) {
            Some(ball) if self.scene.balls[ball].state.motion.in_play() => Ok(()),
            Some(_) => self.refuse(field, format!("`{name}`"), "this ball is not in play"),
            None => {
                let known = self.scene.balls.iter().map(|ball| ball.name.as_str());
                let known = listed(known);
                self.refuse(
                    field,
                    format!("`{name}`"),
                    format!("there is no such ball, there are {known}"),
                )
            }
        }
    }

    pub(super) fn pair(&self, field: &str, a: &str, b: &str) -> Checked {
        self.ball(field, a)?;
        self.ball(field, b)?;
        if a == b {
            return self.refuse(field, format!("`{a}`"), "a ball does not meet itself");
        }
        Ok(())
    }

    pub(super) fn pocket(&self, field: &str, name: Option<&str>) -> Checked {
        let pockets = &self.scene.table.pockets;
        if pockets.is_empty() {
            return self.refuse(field, name.unwrap_or("any"), "the table has no pockets");
        }
        match name {
            Some(name) if !pockets.iter().any(|pocket| pocket.name == name) => {
                let known = listed(pockets.iter().map(|pocket| pocket.name.as_str()));
                self.refuse(
                    field,
                    format!("`{name}`"),
                    format!("there is no such pocket, there are {known}"),
                )
            }
            _ => Ok(()),
        }
    }

    pub(super) fn spot(&self, field: &str, spot: &Spot) -> Checked {
        if let Spot::Start(ball) = spot {
            self.ball(field, ball)?;
        }
        if !spot.on_table(self.scene) {
            let (length, width) = (self.scene.table.length, self.scene.table.width);
            return self.refuse(
                field,
                format!("{spot:?}"),
                format!("this place is not on the table of {length} m by {width} m"),
            );
        }
        Ok(())
    }

    pub(super) fn ends(&self, Ends(least, most): Ends) -> Checked {
        for (field, end) in [("least", least), ("most", most)] {
            if let Some(end) = end {
                self.finite(field, end)?;
            }
        }
        match (least, most) {
            (None, None) => self.refuse("least", "none", "one of `least` and `most` is needed"),
            (Some(least), Some(most)) if least > most => {
                self.refuse("least", least, format!("this is above `most`, {most}"))
            }
            _ => Ok(()),
        }
    }

    pub(super) fn finite(&self, field: &str, value: f64) -> Checked {
        if value.is_finite() {
            Ok(())
        } else {
            self.refuse(field, value, "a finite number is needed")
        }
    }

    pub(super) fn positive(&self, field: &str, value: f64) -> Checked {
        self.finite(field, value)?;
        if value > 0.0 {
            Ok(())
        } else {
            self.refuse(field, value, "this must be above 0, or it can never be met")
        }
    }

    /// Balls leave the slate only where it bounces.
    pub(super) fn flies(&self, field: &str, ball: &str) -> Checked {
        let bounces = matches!(self.scene.laws.slate, SlateLaw::Bouncing(_));
        let flies = |ball: &crate::physics::scene::SceneBall| ball.state.motion.flies();
        if bounces || self.scene.balls.iter().any(flies) {
            return Ok(());
        }
        self.refuse(
            field,
            format!("`{ball}`"),
            "no ball leaves the slate: `laws.slate` is not `Bouncing`",
        )
    }

    pub(super) fn contact(&self, field: &str, contact: &Contact) -> Checked {
        match contact {
            Contact::Hit(a, b) => self.pair(field, a, b),
            Contact::Rail(ball) | Contact::RailAt(ball, _) => {
                self.ball(field, ball)?;
                if self.scene.table.cushions.is_empty() {
                    return self.refuse(field, format!("`{ball}`"), "the table has no cushions");
                }
                Ok(())
            }
            Contact::Falls(ball) => {
                self.ball(field, ball)?;
                self.pocket(field, None)
            }
            Contact::FallsInto(ball, pocket) => {
                self.ball(field, ball)?;
                self.pocket(field, Some(pocket))
            }
            Contact::Lands(ball) | Contact::Leaves(ball) => {
                self.ball(field, ball)?;
                self.flies(field, ball)
            }
        }
    }

    pub(super) fn moment(&self, field: &str, moment: &Moment) -> Checked {
        match moment {
            Moment::Start | Moment::End => Ok(()),
            Moment::At(time) => {
                let limit = self.scene.time_limit;
                if (0.0..=limit).contains(time) {
                    Ok(())
                } else {
                    self.refuse(field, time, format!("a run is from 0 to {limit} s long"))
                }
            }
            Moment::Hit(a, b) | Moment::After(a, b) => self.pair(field, a, b),
            Moment::Rail(ball, number) | Moment::AfterRail(ball, number) => {
                if *number == 0 {
                    return self.refuse(field, number, "cushions are counted from 1");
                }
                self.contact(field, &Contact::Rail(ball.clone()))
            }
            Moment::Rolls(ball) | Moment::Rests(ball) => self.ball(field, ball),
            Moment::Falls(ball) => self.contact(field, &Contact::Falls(ball.clone())),
            Moment::Lands(ball) => self.contact(field, &Contact::Lands(ball.clone())),
        }
    }
}

/// Names in a row.
fn listed<'n>(names: impl Iterator<Item = &'n str>) -> String {
    const MOST: usize = 20;
    let names: Vec<&str> = names.collect();
    let shown: Vec<String> = names
        .iter()
        .take(MOST)
        .map(|name| format!("`{name}`"))
        .collect();
    match names.len() {
        0 => "none".to_owned(),
        count if count > MOST => format!("{} and {} more", shown.join(", "), count - MOST),
        _ => shown.join(", "),
    }
}
