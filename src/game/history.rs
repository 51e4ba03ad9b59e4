//! What a player can go back to: the table before every shot, and before balls were moved by hand.

use crate::game::aim::Aim;
use crate::physics::cue::Shot;
use crate::physics::scene::Scene;

/// Balls in all steps that are kept; the oldest step is forgotten first. A table of sixteen balls never comes near: these are
/// a hundred thousand steps. A crowd does.
const MOST_BALLS: usize = 1_600_000;

/// What the player did to the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Struck: the how-manieth shot since the program started.
    Shot(u64),
    /// Put this ball down by hand, perhaps in many small moves.
    Placed(usize),
    /// Laid out another table.
    Laid,
}

/// The table and the aim just before a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Past {
    /// The step.
    pub step: Step,
    /// The table before it.
    pub scene: Scene,
    /// The aim before it; before a shot, the shot.
    pub aim: Aim,
}

/// The steps so far, oldest first, and the last shot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    steps: Vec<Past>,
    /// What was undone, the last first to come back: the table and the aim after each step.
    undone: Vec<Past>,
    last_shot: Option<Past>,
    shots: u64,
}

impl History {
    /// How many steps can be undone.
    #[must_use]
    pub fn len(&self) -> usize {
        self.steps.len()
    }

    /// Whether nothing can be undone.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    /// Whether there is a shot to retry.
    #[must_use]
    pub fn has_shot(&self) -> bool {
        self.last_shot.is_some()
    }

    /// The stroke of the last shot.
    #[must_use]
    pub fn last_shot(&self) -> Option<Shot> {
        self.last_shot.as_ref().map(|past| past.aim.shot)
    }

    /// Keeps the table before a shot.
    pub fn shot(&mut self, scene: Scene, aim: Aim) {
        self.shots += 1;
        let past = Past {
            step: Step::Shot(self.shots),
            scene,
            aim,
        };
        self.last_shot = Some(past.clone());
        self.push(past);
    }

    /// Keeps the table before a new one is laid out.
    pub fn laid(&mut self, scene: Scene, aim: Aim) {
        self.push(Past {
            step: Step::Laid,
            scene,
            aim,
        });
    }

    /// Keeps the table before a ball is put down; further moves of the same ball belong to the same step.
    pub fn placed(&mut self, ball: usize, scene: &Scene, aim: Aim) {
        let step = Step::Placed(ball);
        if self.steps.last().is_none_or(|past| past.step != step) {
            self.push(Past {
                step,
                scene: scene.clone(),
                aim,
            });
        }
    }

    /// How many steps can be done again.
    #[must_use]
    pub fn undone(&self) -> usize {
        self.undone.len()
    }

    /// Takes back the last step; the present table and aim can be come back to.
    pub fn undo(&mut self, scene: &Scene, aim: Aim) -> Option<Past> {
        let past = self.steps.pop()?;
        if matches!(past.step, Step::Shot(_)) {
            let earlier = |past: &&Past| matches!(past.step, Step::Shot(_));
            if let Some(shot) = self.steps.iter().rev().find(earlier) {
                self.last_shot = Some(shot.clone());
            }
        }
        self.undone.push(Past {
            step: past.step,
            scene: scene.clone(),
            aim,
        });
        Some(past)
    }

    /// Does again what was undone last; the present table and aim are what it can be undone to.
    pub fn redo(&mut self, scene: &Scene, aim: Aim) -> Option<Past> {
        let next = self.undone.pop()?;
        let past = Past {
            step: next.step,
            scene: scene.clone(),
            aim,
        };
        if matches!(past.step, Step::Shot(_)) {
            self.last_shot = Some(past.clone());
        }
        self.keep(past);
        Some(next)
    }

    /// Goes back to just before the last shot; asking again gives the same.
    pub fn retry(&mut self) -> Option<Past> {
        let shot = self.last_shot.clone()?;
        if let Some(at) = self.steps.iter().rposition(|past| past.step == shot.step) {
            self.steps.truncate(at);
        }
        self.undone.clear();
        Some(shot)
    }

    /// Something new: what was undone before is gone.
    fn push(&mut self, past: Past) {
        self.undone.clear();
        self.keep(past);
    }

    fn keep(&mut self, past: Past) {
        self.steps.push(past);
        let balls =
            |steps: &[Past]| -> usize { steps.iter().map(|past| past.scene.balls.len()).sum() };
        while self.steps.len() > 1 && balls(&self.steps) > MOST_BALLS {
            self.steps.remove(0);
        }
    }
}
