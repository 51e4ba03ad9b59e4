//! What comes out of a tournament: win rates with their uncertainty.

use std::fmt::Write;

use serde::Serialize;

use crate::game::players::contest::{Rack, Tally};
use crate::game::players::level::Level;

/// Normal quantile of a confidence of 95 %.
const Z: f64 = 1.959_964;

/// What one level did in a pairing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Side {
    /// Its name.
    pub level: &'static str,
    /// Racks won.
    pub won: u32,
    /// What it did in all of them.
    #[serde(flatten)]
    pub did: Tally,
}

impl Side {
    fn new(level: &Level) -> Self {
        Self {
            level: level.name,
            won: 0,
            did: Tally::default(),
        }
    }

    fn per_stroke(&self, count: f64) -> f64 {
        count / f64::from(self.did.shots.max(1))
    }
}

/// Two levels and their racks.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pairing {
    /// The stronger and the weaker level.
    pub sides: [Side; 2],
    /// Racks nobody won.
    pub drawn: u32,
    /// Racks that did not come to an end.
    pub unfinished: u32,
}

impl Pairing {
    /// Before the first rack.
    #[must_use]
    pub fn new(strong: &Level, weak: &Level) -> Self {
        Self {
            sides: [Side::new(strong), Side::new(weak)],
            drawn: 0,
            unfinished: 0,
        }
    }

    /// Counts a rack.
    pub fn add(&mut self, rack: &Rack) {
        match rack.winner.and_then(|winner| self.sides.get_mut(winner)) {
            Some(side) => side.won += 1,
            None => self.drawn += 1,
        }
        for (side, tally) in self.sides.iter_mut().zip(&rack.tallies) {
            side.did.add(tally);
        }
    }

    /// Racks that somebody won.
    #[must_use]
    pub fn decided(&self) -> u32 {
        self.sides.iter().map(|side| side.won).sum()
    }

    /// Strokes of both.
    #[must_use]
    pub fn shots(&self) -> u32 {
        self.sides.iter().map(|side| side.did.shots).sum()
    }

    /// Share of racks that the stronger level won, and the ends of its interval of 95 % confidence (Wilson 1927).
    #[must_use]
    pub fn rate(&self) -> (f64, f64, f64) {
        wilson(self.sides[0].won, self.decided())
    }
}

/// A share and the ends of its interval of 95 % confidence (Wilson, J. Am. Stat. Assoc. 22 (1927) 209).
#[must_use]
pub fn wilson(won: u32, of: u32) -> (f64, f64, f64) {
    if of == 0 {
        return (0.5, 0.0, 1.0);
    }
    let (n, p) = (f64::from(of), f64::from(won) / f64::from(of));
    let scale = 1.0 + Z * Z / n;
    let middle = (p + Z * Z / (2.0 * n)) / scale;
    let half = Z / scale * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).sqrt();
    (p, (middle - half).max(0.0), (middle + half).min(1.0))
}

/// A tournament that is over.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Standings {
    /// The game.
    pub game: String,
    /// What was played with.
    pub preset: String,
    /// The seed.
    pub seed: u64,
    /// Every pairing.
    pub pairings: Vec<Pairing>,
}

impl Standings {
    /// Before the first pairing.
    #[must_use]
    pub fn new(game: &str, preset: &str, seed: u64) -> Self {
        Self {
            game: game.to_owned(),
            preset: preset.to_owned(),
            seed,
            pairings: Vec::new(),
        }
    }

    /// The tables to read.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = format!(
            "{}, preset {}, seed {}\n\n",
            self.game, self.preset, self.seed
        );
        text += "stronger   weaker      won  lost  drawn   win rate  95 % interval\n";
        for pairing in &self.pairings {
            let [strong, weak] = &pairing.sides;
            let (rate, low, high) = pairing.rate();
            let _ = writeln!(
                text,
                "{:<10} {:<10} {:>4} {:>5} {:>6} {:>8.1} %  {:.1} to {:.1} %",
                strong.level,
                weak.level,
                strong.won,
                weak.won,
                pairing.drawn,
                100.0 * rate,
                100.0 * low,
                100.0 * high
            );
        }
        text += "\nlevel      against    strokes     a stroke: pots  points  fouls   thought: shots a stroke  most\n";
        for pairing in &self.pairings {
            for (side, other) in [(0, 1), (1, 0)] {
                let (side, other) = (&pairing.sides[side], &pairing.sides[other]);
                let _ = writeln!(
                    text,
                    "{:<10} {:<10} {:>7} {:>18.3} {:>7.3} {:>6.3} {:>25.0} {:>5}",
                    side.level,
                    other.level,
                    side.did.shots,
                    side.per_stroke(f64::from(side.did.pots)),
                    side.per_stroke(f64::from(side.did.points)),
                    side.per_stroke(f64::from(side.did.fouls)),
                    side.per_stroke(side.did.trials as f64),
                    side.did.most_trials
                );
            }
        }
        let unfinished: u32 = self.pairings.iter().map(|pairing| pairing.unfinished).sum();
        if unfinished > 0 {
            let _ = write!(text, "\n{unfinished} racks did not come to an end.\n");
        }
        text
    }
}
