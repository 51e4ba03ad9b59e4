//! Who plays: named levels that differ in hand and in head.

use crate::game::players::noise::Noise;

/// What a player sees and thinks of. Every number counts something, none is a time: the same thoughts on every machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Skills {
    /// Most shots that are rehearsed in one thought.
    pub budget: u32,
    /// Pots that are looked at, the easiest first.
    pub pots: usize,
    /// Speeds of the cue in m/s that are tried.
    pub speeds: &'static [f64],
    /// Contacts of the tip that are tried, side and height in R.
    pub tips: &'static [(f64, f64)],
    /// Whether aim allows for throw and squirt.
    pub feels_throw: bool,
    /// Whether what comes after the shot counts.
    pub position: bool,
    /// Cushion banks that are looked at.
    pub banks: usize,
    /// Combinations that are looked at.
    pub combinations: usize,
    /// Cushions of a kick at a hidden ball.
    pub kick_cushions: u32,
    /// Whether the cue is raised to jump over, or bend around, what hides a ball.
    pub raises: bool,
    /// Balls that are looked at for a safety.
    pub safeties: usize,
    /// Places that are compared with the cue ball in hand.
    pub spots: usize,
    /// Shots that are rehearsed with the errors of the own hand before one is taken.
    pub finalists: usize,
    /// Rehearsals of each of them.
    pub samples: usize,
    /// Tables after the shot on which the next shot is planned too.
    pub ahead: usize,
    /// Share of pots that the player makes, by its own reckoning: what a turn at the table is worth.
    pub pot_rate: f64,
}

/// A computer opponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// Its name.
    pub name: &'static str,
    /// The key of what it is like, for the window to translate.
    pub key: &'static str,
    /// How it plays, in a sentence.
    pub about: &'static str,
    /// What the errors of `FastFiz` are multiplied with, see [`Noise`].
    pub noise: f64,
    /// How it thinks.
    pub skills: Skills,
}

const CENTER: [(f64, f64); 1] = [(0.0, 0.0)];

const LINE: [(f64, f64); 3] = [(0.0, 0.0), (0.0, 0.35), (0.0, -0.35)];

const CROSS: [(f64, f64); 7] = [
    (0.0, 0.0),
    (0.0, 0.2),
    (0.0, 0.38),
    (0.0, -0.2),
    (0.0, -0.38),
    (0.25, 0.1),
    (-0.25, 0.1),
];

const GRID: [(f64, f64); 11] = [
    (0.0, 0.0),
    (0.0, 0.2),
    (0.0, 0.4),
    (0.0, -0.2),
    (0.0, -0.4),
    (0.28, 0.2),
    (-0.28, 0.2),
    (0.28, -0.2),
    (-0.28, -0.2),
    (0.35, 0.0),
    (-0.35, 0.0),
];

impl Level {
    /// All levels, the weakest first.
    pub const ALL: [Self; 5] = [
        Self {
            name: "Pip",
            key: "level-pip",
            about: "Has held a cue twice. Sees straight pots only and thinks of nothing after them.",
            noise: 2.9,
            skills: Skills {
                budget: 200,
                pots: 4,
                speeds: &[2.2],
                tips: &CENTER,
                feels_throw: false,
                position: false,
                banks: 0,
                combinations: 0,
                kick_cushions: 1,
                raises: false,
                safeties: 0,
                spots: 1,
                finalists: 1,
                samples: 0,
                ahead: 0,
                pot_rate: 0.3,
            },
        },
        Self {
            name: "Bea",
            key: "level-bea",
            about: "Friday nights at the bar table. Knows follow and draw, and picks the shot that leaves another.",
            noise: 2.5,
            skills: Skills {
                budget: 400,
                pots: 4,
                speeds: &[1.2, 2.2],
                tips: &LINE,
                feels_throw: true,
                position: true,
                banks: 1,
                combinations: 0,
                kick_cushions: 1,
                raises: false,
                safeties: 0,
                spots: 2,
                finalists: 2,
                samples: 0,
                ahead: 0,
                pot_rate: 0.5,
            },
        },
        Self {
            name: "Lou",
            key: "level-lou",
            about: "League captain. Rehearses before shooting, banks when it must, and hides the cue ball when nothing goes.",
            noise: 1.5,
            skills: Skills {
                budget: 1200,
                pots: 5,
                speeds: &[0.9, 1.5, 2.4],
                tips: &LINE,
                feels_throw: true,
                position: true,
                banks: 2,
                combinations: 2,
                kick_cushions: 1,
                raises: false,
                safeties: 2,
                spots: 3,
                finalists: 5,
                samples: 10,
                ahead: 0,
                pot_rate: 0.65,
            },
        },
        Self {
            name: "Rosa",
            key: "level-rosa",
            about: "Lives on the road by her cue. English, safeties and percentages.",
            noise: 0.9,
            skills: Skills {
                budget: 2500,
                pots: 6,
                speeds: &[0.7, 1.1, 1.7, 2.6],
                tips: &CROSS,
                feels_throw: true,
                position: true,
                banks: 3,
                combinations: 3,
                kick_cushions: 2,
                raises: true,
                safeties: 3,
                spots: 4,
                finalists: 8,
                samples: 24,
                ahead: 0,
                pot_rate: 0.8,
            },
        },
        Self {
            name: "Maestra",
            key: "level-maestra",
            about: "The hand of a champion, and a plan for the ball after the next.",
            noise: 0.25,
            skills: Skills {
                budget: 8000,
                pots: 6,
                speeds: &[0.6, 0.95, 1.5, 2.3, 3.4],
                tips: &GRID,
                feels_throw: true,
                position: true,
                banks: 4,
                combinations: 4,
                kick_cushions: 2,
                raises: true,
                safeties: 4,
                spots: 6,
                finalists: 10,
                samples: 40,
                ahead: 16,
                pot_rate: 0.92,
            },
        },
    ];

    /// The level with this name, whatever the case of its letters.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let same = |level: &Self| level.name.eq_ignore_ascii_case(name);
        Self::ALL.into_iter().find(same)
    }

    /// The errors of its hand.
    #[must_use]
    pub fn hand(&self) -> Noise {
        Noise::times(self.noise)
    }
}
