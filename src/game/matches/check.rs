//! Whether a match that was read from a file can be played.

use crate::game::matches::{Lie, Match, PlayedShot};
use crate::game::rules::{Call, GameState};

/// A field that is no good.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Problem {
    /// Path of the field.
    pub(super) field: String,
    /// Its value and what is wrong with it.
    pub(super) what: String,
}

impl Problem {
    fn new(field: impl Into<String>, what: impl ToString) -> Self {
        Self {
            field: field.into(),
            what: what.to_string(),
        }
    }
}

impl Match {
    /// Finds the first thing that makes the match unplayable.
    pub(super) fn check(&self) -> Result<(), Problem> {
        let players = self.setup.players.len();
        self.setup
            .check(&self.base.table)
            .map_err(|refused| Problem::new("setup", refused))?;
        let remembered = self.setup.game.rules().check(players);
        remembered.map_err(|what| Problem::new("setup.game", what))?;
        self.base
            .check()
            .map_err(|error| Problem::new("base", error))?;
        self.check_state("state", &self.state)?;
        self.check_lie("lie", &self.lie)?;
        self.check_call("call", self.call)?;
        for (index, shot) in self.shots.iter().enumerate() {
            self.check_shot(index, shot)?;
        }
        for (index, end) in self.ends.iter().enumerate() {
            let field = |name: &str| format!("ends[{index}].{name}");
            if end.rack > self.rack {
                let what = format!("{} is beyond rack {}", end.rack, self.rack);
                return Err(Problem::new(field("rack"), what));
            }
            if let Some(winner) = end.over.winner {
                below(&field("over.winner"), winner, players)?;
            }
        }
        Ok(())
    }

    fn check_state(&self, field: &str, state: &GameState) -> Result<(), Problem> {
        let players = self.setup.players.len();
        let standing = &state.standing;
        let at = |name: &str| format!("{field}.standing.{name}");
        let (is, agreed) = (state.game.rules().code(), self.setup.game.rules().code());
        if is.name != agreed.name {
            let what = format!("{} is not {}, the game of the match", is.name, agreed.name);
            return Err(Problem::new(format!("{field}.game"), what));
        }
        for (name, count) in [
            ("players", standing.players),
            ("scores", standing.scores.len()),
            ("fouls", standing.fouls.len()),
        ] {
            if count != players {
                let what = format!("{count}, the match has {players} players");
                return Err(Problem::new(at(name), what));
            }
        }
        below(&at("turn"), standing.turn, players)?;
        below(&at("breaker"), standing.breaker, players)?;
        if let Some(winner) = standing.over.and_then(|over| over.winner) {
            below(&at("over.winner"), winner, players)?;
        }
        state
            .game
            .rules()
            .check(players)
            .map_err(|what| Problem::new(format!("{field}.game"), what))
    }

    fn check_lie(&self, field: &str, lie: &Lie) -> Result<(), Problem> {
        let (given, count) = (lie.places.len(), self.base.balls.len());
        if given != count {
            let what = format!("{given} places, there are {count} balls");
            return Err(Problem::new(field, what));
        }
        lie.on(&self.base)
            .check()
            .map_err(|error| Problem::new(field, error))
    }

    fn check_call(&self, field: &str, call: Call) -> Result<(), Problem> {
        if let Some(ball) = call.ball() {
            below(&format!("{field}.ball"), ball, self.base.balls.len())?;
        }
        if let Call::Pot { pocket, .. } = call {
            let pockets = self.base.table.pockets.len();
            below(&format!("{field}.pocket"), pocket, pockets)?;
        }
        Ok(())
    }

    fn check_shot(&self, index: usize, shot: &PlayedShot) -> Result<(), Problem> {
        let field = |name: &str| format!("shots[{index}].{name}");
        self.check_state(&field("before"), &shot.before)?;
        self.check_lie(&field("lie"), &shot.lie)?;
        self.check_call(&field("call"), shot.call)?;
        below(&field("ball"), shot.ball, self.base.balls.len())?;
        shot.scene(&self.base)
            .check()
            .map_err(|error| Problem::new(field("shot"), error))?;
        if !(shot.thought.is_finite() && shot.thought >= 0.0) {
            let what = format!("{} is no time in s", shot.thought);
            return Err(Problem::new(field("thought"), what));
        }
        for &ball in shot.pocketed.iter().chain(&shot.made) {
            below(&field("pocketed"), ball, self.base.balls.len())?;
        }
        let (given, count) = (shot.points.len(), self.setup.players.len());
        if given != count {
            let what = format!("{given} numbers, the match has {count} players");
            return Err(Problem::new(field("points"), what));
        }
        Ok(())
    }
}

fn below(field: &str, value: usize, count: usize) -> Result<(), Problem> {
    if value < count {
        return Ok(());
    }
    Err(Problem::new(
        field,
        format!("{value} is out of range, there are {count}"),
    ))
}
