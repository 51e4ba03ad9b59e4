//! What a player can go back to: the table before every shot, and before balls were moved by hand.

use crate::game::aim::Aim;
use crate::physics::cue::Shot;
use crate::physics::scene::Scene;

/// Steps kept; the oldest is forgotten first.
const LIMIT: usize = 1000;

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

    /// Takes back the last step.
    pub fn undo(&mut self) -> Option<Past> {
        let past = self.steps.pop()?;
        if matches!(past.step, Step::Shot(_)) {
            let earlier = |past: &&Past| matches!(past.step, Step::Shot(_));
            if let Some(shot) = self.steps.iter().rev().find(earlier) {
                self.last_shot = Some(shot.clone());
            }
        }
        Some(past)
    }

    /// Goes back to just before the last shot; asking again gives the same.
    pub fn retry(&mut self) -> Option<Past> {
        let shot = self.last_shot.clone()?;
        if let Some(at) = self.steps.iter().rposition(|past| past.step == shot.step) {
            self.steps.truncate(at);
        }
        Some(shot)
    }

    fn push(&mut self, past: Past) {
        if self.steps.len() == LIMIT {
            self.steps.remove(0);
        }
        self.steps.push(past);
    }
}
