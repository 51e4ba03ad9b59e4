//! What a referee says after a stroke, and what a player may choose then.

use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

use crate::game::rules::foul::Foul;
use crate::game::rules::spot::{self, Spotted, Spotter};
use crate::game::rules::{self, GameState};
use crate::physics::ball::{Motion, State};
use crate::physics::record::Record;
use crate::physics::scene::Scene;

/// What the player whose turn it is may choose before playing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Choice {
    /// Play, with everything where it lies.
    Accept,
    /// Take the cue ball in hand.
    InHand,
    /// Have the balls racked again and break.
    Break,
    /// Have the balls racked again and the other player break.
    TheyBreak,
    /// Have the other player play from here.
    HandBack,
    /// Have the balls put back to where they were before the stroke, and the other player play again.
    PutBack,
    /// Have the balls that touch the cue ball spotted.
    Spot,
    /// Go first, of two whose order the lot decided.
    GoFirst,
    /// Let the other player go first.
    GoSecond,
}

/// Why a rack, frame or game is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Reason {
    /// The ball that wins was pocketed as it must be.
    WinningBall {
        /// Index of the ball.
        ball: usize,
    },
    /// The ball that wins was pocketed, or lost, as it must not be.
    LosingBall {
        /// Index of the ball.
        ball: usize,
    },
    /// Three fouls in a row.
    ThreeFouls,
    /// Three misses in a row with a clear way to a ball that was on.
    ThreeMisses,
    /// The points agreed on were reached.
    Points {
        /// How many.
        needed: i32,
    },
    /// The innings agreed on were played.
    Innings {
        /// How many.
        played: u32,
    },
    /// The last ball is gone, and the greater score wins.
    LastBall,
    /// A player gave up.
    Conceded,
}

/// The end of a rack, frame or game.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Over {
    /// Who won; nobody if it is drawn, or where nobody wins.
    pub winner: Option<usize>,
    /// Why.
    pub reason: Reason,
}

/// What becomes of the table apart from what the stroke did and what is spotted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum TableChange {
    /// It is played on as it lies.
    #[default]
    Keep,
    /// All balls are racked again for a break, with the seed of the new state.
    Rerack,
    /// The balls go back to where they were before the stroke.
    PutBack,
}

/// Something worth saying that is no foul.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Note {
    /// A player has these balls from now on.
    Group {
        /// The player.
        player: usize,
        /// Solids, else stripes.
        solids: bool,
    },
    /// One more foul in a row loses.
    TwoFouls {
        /// The player.
        player: usize,
    },
    /// Three fouls in a row cost this many points.
    ThreeFoulPenalty {
        /// The player.
        player: usize,
        /// Points lost.
        points: i32,
    },
    /// The break reached its requirements in no way, without being a foul.
    IllegalBreak {
        /// Balls driven to cushions.
        driven: usize,
    },
    /// The break failed the rule of three points.
    ThreePointBreak {
        /// Points made.
        points: usize,
    },
    /// Nothing has fallen for so long that the rack will be broken again if that goes on.
    StalemateWarning,
    /// The balls are racked again because nobody makes progress.
    Stalemate,
    /// Balls fell that were not called: they stay down and the turn passes.
    NotCalled {
        /// The balls.
        balls: Vec<usize>,
    },
    /// A safety was called, so the turn passes.
    Safety,
    /// Points for the opponent.
    PenaltyPoints {
        /// How many.
        points: i32,
    },
    /// The striker missed what could have been hit.
    Miss {
        /// How many in a row with a clear way.
        in_a_row: u32,
    },
    /// The next player has a free ball.
    FreeBall,
    /// The scores are level: the black is spotted again.
    RespottedBlack,
    /// A ball that hung and fell by itself was put back.
    PutBack {
        /// The ball.
        ball: usize,
    },
    /// Fourteen balls are racked again and the run goes on.
    Rerack,
    /// The other player has a last inning to draw level.
    EqualisingInning {
        /// The player.
        player: usize,
    },
}

/// What a referee says after a stroke, or after a choice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Verdict {
    /// What was wrong; empty if nothing was.
    pub fouls: Vec<Foul>,
    /// Object balls in pockets by this stroke, as indices in the scene.
    pub pocketed: Vec<usize>,
    /// Of these, the ones that were potted as the rules ask: what a pot counts as in statistics.
    pub made: Vec<usize>,
    /// Balls that come back to the table, in order.
    pub spotted: Vec<Spotted>,
    /// What happens to the table besides.
    pub table: TableChange,
    /// Change of each player's score.
    pub points: Vec<i32>,
    /// Things worth saying.
    pub notes: Vec<Note>,
    /// Where the game stands now: who is at the table, what may be chosen, where the cue ball may go, whether it is over.
    pub next: GameState,
}

impl Verdict {
    /// Who is at the table now.
    #[must_use]
    pub fn next_player(&self) -> usize {
        self.next.standing.turn
    }

    /// Whether the stroke was a foul.
    #[must_use]
    pub fn is_foul(&self) -> bool {
        !self.fouls.is_empty()
    }

    /// The table to play on after the stroke that was judged: as it was left, with balls spotted and a cue ball in hand put
    /// down where it may lie.
    #[must_use]
    pub fn table_after(&self, before: &Scene, record: &Record) -> Scene {
        let mut left = spot::left_behind(before, &record.end);
        for &ball in &self.pocketed {
            left.balls[ball].state.motion = Motion::Pocketed;
        }
        self.table(left, before)
    }

    /// The table to play on after a choice: `lies` is the table as it lay, `before` as it was before the last stroke.
    #[must_use]
    pub fn table_chosen(&self, lies: &Scene, before: &Scene) -> Scene {
        self.table(lies.clone(), before)
    }

    fn table(&self, lies: Scene, before: &Scene) -> Scene {
        let mut scene = match self.table {
            TableChange::Keep => {
                let mut spotter = Spotter::new(lies);
                for spotted in &self.spotted {
                    spotter.put(spotted.ball, spotted.position);
                }
                spotter.into_scene()
            }
            TableChange::Rerack => rules::racked(
                before,
                self.next.game.rules().rack(),
                self.next.standing.seed,
            ),
            TableChange::PutBack => Scene {
                shot: None,
                ..before.clone()
            },
        };
        self.next.put_down(&mut scene);
        spot::make_playable(&mut scene);
        scene
    }
}

impl GameState {
    /// Puts a cue ball in hand down where it may lie: where it is, or where one begins.
    fn put_down(&self, scene: &mut Scene) {
        let Some(area) = self.standing.in_hand else {
            return;
        };
        let cue = self.cue_ball(scene);
        let state = scene.balls[cue].state;
        let here = DVec2::new(state.position.x, state.position.z);
        if state.motion.in_play() && area.is_legal(scene, cue, here) {
            return;
        }
        if let Some(spot) = area.start(scene, cue) {
            let height = scene.balls[cue].ball.radius;
            scene.balls[cue].state = State::at_rest(DVec3::new(spot.x, height, spot.y));
        }
    }
}
