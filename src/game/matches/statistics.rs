//! What the shots of a match add up to.

use crate::game::matches::{Match, PlayedShot};

/// The figures of one player.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Strokes.
    pub shots: u32,
    /// Balls potted as the rules ask.
    pub pots: u32,
    /// Strokes that were fouls.
    pub fouls: u32,
    /// Opening breaks.
    pub breaks: u32,
    /// Opening breaks that potted a ball.
    pub breaks_with_pot: u32,
    /// Points scored by own strokes, penalties for others not among them.
    pub points: i32,
    /// Longest run without missing: points where the game counts them, else balls.
    pub best_run: i32,
    /// Racks won.
    pub racks: u32,
    /// Seconds of thought, all shots together.
    pub thought: f64,
}

impl Statistics {
    /// Average seconds of thought; 0 without a shot.
    #[must_use]
    pub fn average_thought(&self) -> f64 {
        if self.shots == 0 {
            0.0
        } else {
            self.thought / f64::from(self.shots)
        }
    }

    fn count(&mut self, shot: &PlayedShot) {
        self.shots += 1;
        self.pots += shot.made.len() as u32;
        self.fouls += u32::from(!shot.fouls.is_empty());
        self.thought += shot.thought;
        if shot.before.standing.shots == 0 {
            self.breaks += 1;
            self.breaks_with_pot += u32::from(!shot.made.is_empty());
        }
        self.points += shot.points.get(shot.player()).copied().unwrap_or(0);
    }
}

/// What a shot adds to a run; 0 if it ends one.
fn worth(shot: &PlayedShot) -> i32 {
    if !shot.fouls.is_empty() {
        return 0;
    }
    if shot.before.game.rules().counts_points() {
        shot.points.get(shot.player()).copied().unwrap_or(0)
    } else {
        shot.made.len() as i32
    }
}

impl Match {
    /// The figures of every player.
    #[must_use]
    pub fn statistics(&self) -> Vec<Statistics> {
        let mut all = vec![Statistics::default(); self.setup.players.len()];
        let mut run = 0;
        let mut last: Option<(usize, u32)> = None;
        for shot in &self.shots {
            let player = shot.player();
            let Some(figures) = all.get_mut(player) else {
                continue;
            };
            figures.count(shot);
            let worth = worth(shot);
            let goes_on = worth > 0 && last == Some((player, shot.rack));
            run = if goes_on { run + worth } else { worth };
            last = (worth > 0).then_some((player, shot.rack));
            figures.best_run = figures.best_run.max(run);
        }
        for (figures, racks) in all.iter_mut().zip(self.racks_won()) {
            figures.racks = racks;
        }
        all
    }
}
