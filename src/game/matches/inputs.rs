//! What players do to a match.

use glam::{DVec2, DVec3};

use crate::game::matches::{
    Hindrance, Lie, Match, NoPlace, Phase, PlayedShot, RackEnd, Refused, Setup, rack_seed,
};
use crate::game::placing;
use crate::game::rules::{Call, CallNeeded, Choice, Game, GameState, Over, Reason, Verdict};
use crate::physics::ball::State;
use crate::physics::cue::Shot;
use crate::physics::record::Record;
use crate::physics::scene::{PlannedShot, Scene};
use crate::physics::table::Table;

impl Setup {
    /// Whether players, race and table fit the game.
    ///
    /// # Errors
    /// [`Refused`] with the first thing that does not.
    pub fn check(&self, table: &Table) -> Result<(), Refused> {
        let rules = self.game.rules();
        let game = rules.code().name;
        let (given, range) = (self.players.len(), rules.players());
        if !range.contains(&given) {
            let (least, most) = (*range.start(), *range.end());
            return Err(Refused::Players {
                game,
                given,
                least,
                most,
            });
        }
        if self.first >= given {
            return Err(Refused::NoSuchPlayer {
                field: "first",
                player: self.first,
                count: given,
            });
        }
        if self.race == 0 {
            return Err(Refused::NoRace);
        }
        let pockets = table.pockets.len();
        if rules.has_pockets() != (pockets > 0) {
            let with = if rules.has_pockets() {
                "with"
            } else {
                "without"
            };
            return Err(Refused::Table {
                game,
                pockets,
                with,
            });
        }
        Ok(())
    }

    /// Whether shots may be taken back: where that is agreed on, and always in practice.
    #[must_use]
    pub fn may_undo(&self) -> bool {
        self.undo || matches!(self.game, Game::FreePractice(_))
    }
}

impl Match {
    /// Refuses what does not belong to the present phase.
    fn must_be(&self, phase: Phase, what: &'static str) -> Result<(), Refused> {
        let is = self.phase();
        if is == phase {
            return Ok(());
        }
        let now = match is {
            Phase::Choose => Hindrance::ToChoose,
            Phase::Play => Hindrance::ToPlay,
            Phase::RackOver => Hindrance::RackOver,
            Phase::Over { .. } => Hindrance::MatchOver,
        };
        Err(Refused::NotNow { what, now })
    }

    /// Puts down the cue ball that is in hand, at x, z in m.
    ///
    /// # Errors
    /// [`Refused`] if it is not in hand, or may not lie there.
    pub fn place(&mut self, at: DVec2) -> Result<(), Refused> {
        self.must_be(Phase::Play, "placing the cue ball")?;
        let Some(area) = self.state.standing.in_hand else {
            return Err(Refused::NotNow {
                what: "placing the cue ball",
                now: Hindrance::NotInHand,
            });
        };
        let (x, z) = (at.x, at.y);
        let refuse = |why| Err(Refused::Place { x, z, why });
        let mut table = self.table();
        let cue = self.state.cue_ball(&table);
        if !area.allows(at) {
            return refuse(NoPlace::Outside);
        }
        if !placing::is_free(&table, cue, at) {
            return refuse(NoPlace::NoRoom);
        }
        let height = table.balls[cue].ball.radius;
        table.balls[cue].state = State::at_rest(DVec3::new(x, height, z));
        table.check().map_err(Refused::Scene)?;
        self.lie = Lie::of(&table);
        Ok(())
    }

    /// Says what the next stroke is meant to do.
    ///
    /// # Errors
    /// [`Refused`] if that may not be called now.
    pub fn call(&mut self, call: Call) -> Result<(), Refused> {
        self.must_be(Phase::Play, "a call")?;
        let table = self.table();
        let on = self.targets();
        let in_play = |ball: usize| {
            let ball = table.balls.get(ball);
            ball.is_some_and(|ball| ball.state.motion.in_play())
        };
        let allowed = match call {
            Call::Nothing => true,
            Call::Pot { ball, pocket } => {
                in_play(ball) && ball != on.cue && pocket < table.table.pockets.len()
            }
            Call::Nominate { ball } => on.call_needed == CallNeeded::Ball && on.pot.contains(&ball),
            Call::Safety => on.may_call_safety,
            Call::PushOut => on.may_push_out,
        };
        if !allowed {
            return Err(Refused::Call { call });
        }
        self.call = call;
        Ok(())
    }

    /// Judges a stroke of the player at the table: `record` is what became of [`Match::scene_with`] this shot.
    ///
    /// # Errors
    /// [`Refused`] if no stroke is due, or shot, record or time are no good.
    pub fn played(
        &mut self,
        shot: Shot,
        record: &Record,
        thought: f64,
    ) -> Result<Verdict, Refused> {
        self.must_be(Phase::Play, "a stroke")?;
        if !(thought.is_finite() && thought >= 0.0) {
            return Err(Refused::Thought { seconds: thought });
        }
        let scene = self.scene_with(shot);
        scene.check().map_err(Refused::Scene)?;
        let (given, count) = (record.end.len(), scene.balls.len());
        if given != count || record.paths.len() != count {
            return Err(Refused::Record { given, count });
        }
        let verdict = self.state.judge(&scene, record, &self.call);
        let ball = self.state.cue_ball(&scene);
        self.shots.push(PlayedShot::new(
            self.rack,
            self.state.clone(),
            &scene,
            PlannedShot { ball, shot },
            self.call,
            thought,
            &verdict,
        ));
        self.lie = Lie::of(&verdict.table_after(&scene, record));
        self.go_on(&verdict);
        Ok(verdict)
    }

    /// Takes one of the choices offered.
    ///
    /// # Errors
    /// [`Refused`] if it was not offered.
    pub fn choose(&mut self, choice: Choice) -> Result<Verdict, Refused> {
        self.must_be(Phase::Choose, "a choice")?;
        let table = self.table();
        let Some(verdict) = self.state.choose(&table, choice) else {
            return Err(Refused::Choice { choice });
        };
        let last = self.shots.last_mut();
        let before = last.map_or_else(
            || table.clone(),
            |last| {
                last.chosen.push(choice);
                last.lie.on(&self.base)
            },
        );
        self.lie = Lie::of(&verdict.table_chosen(&table, &before));
        self.go_on(&verdict);
        Ok(verdict)
    }

    fn go_on(&mut self, verdict: &Verdict) {
        self.state = verdict.next.clone();
        self.call = Call::Nothing;
        if let Some(over) = self.state.standing.over {
            let rack = self.rack;
            self.ends.push(RackEnd { rack, over });
        }
    }

    /// The player at the table gives up the rack. With more than two players nobody wins it.
    ///
    /// # Errors
    /// [`Refused`] if the rack is over already.
    pub fn concede(&mut self) -> Result<(), Refused> {
        if !matches!(self.phase(), Phase::Play | Phase::Choose) {
            return Err(Refused::NotNow {
                what: "giving up",
                now: Hindrance::RackOver,
            });
        }
        let standing = &mut self.state.standing;
        let winner = (standing.players == 2).then(|| standing.next_player());
        standing.end(winner, Reason::Conceded);
        let over = Over {
            winner,
            reason: Reason::Conceded,
        };
        let rack = self.rack;
        self.ends.push(RackEnd { rack, over });
        Ok(())
    }

    /// Sets up the next rack.
    ///
    /// # Errors
    /// [`Refused`] if the rack is not over, or the match is.
    pub fn next_rack(&mut self) -> Result<(), Refused> {
        self.must_be(Phase::RackOver, "another rack")?;
        let breaker = self.next_breaker();
        self.rack += 1;
        let seed = rack_seed(self.setup.seed, self.rack);
        let game = self.setup.game.clone();
        let (state, scene) =
            GameState::start(game, self.setup.players.len(), breaker, &self.base, seed);
        self.lie = Lie::of(&scene);
        self.state = state;
        self.call = Call::Nothing;
        Ok(())
    }

    /// Takes back this many shots, with all that came of them.
    ///
    /// # Errors
    /// [`Refused`] if shots may not be taken back here, or fewer have been played.
    pub fn undo(&mut self, shots: usize) -> Result<(), Refused> {
        if !self.setup.may_undo() {
            return Err(Refused::NotNow {
                what: "taking back a shot",
                now: Hindrance::NotAgreed,
            });
        }
        let played = self.shots.len();
        let Some(keep) = played.checked_sub(shots) else {
            let asked = shots;
            return Err(Refused::TooFar { asked, played });
        };
        let Some(first) = self.shots.get(keep).cloned() else {
            return Ok(());
        };
        self.shots.truncate(keep);
        self.ends.retain(|end| end.rack < first.rack);
        self.rack = first.rack;
        self.state = first.before;
        self.lie = first.lie;
        self.call = Call::Nothing;
        Ok(())
    }

    /// Puts a ball down anywhere there is room for it, in practice, at x, z in m.
    ///
    /// # Errors
    /// [`Refused`] outside practice, for a ball that does not exist, and where there is no room.
    pub fn lay(&mut self, ball: usize, at: DVec2) -> Result<(), Refused> {
        self.must_be(Phase::Play, "moving balls")?;
        let (x, z) = (at.x, at.y);
        if !matches!(self.setup.game, Game::FreePractice(_)) {
            return Err(Refused::NotNow {
                what: "moving balls",
                now: Hindrance::NoPractice,
            });
        }
        let mut table: Scene = self.table();
        if !placing::is_free(&table, ball, at) {
            let why = NoPlace::NoRoom;
            return Err(Refused::Place { x, z, why });
        }
        let height = table.balls[ball].ball.radius;
        table.balls[ball].state = State::at_rest(DVec3::new(x, height, z));
        table.check().map_err(Refused::Scene)?;
        self.lie = Lie::of(&table);
        Ok(())
    }
}
