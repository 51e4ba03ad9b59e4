//! What a player chooses where the rules offer a choice.

use crate::game::players::chance::Eye;
use crate::game::players::level::Level;
use crate::game::players::worth::{Race, worth};
use crate::game::rules::{Choice, GameState};
use crate::physics::scene::Scene;

/// The best of the choices that are offered to the player at the table; `None` if there is nothing to choose. `before` is
/// the table before the last stroke.
#[must_use]
pub fn choose(state: &GameState, scene: &Scene, before: &Scene, level: &Level) -> Option<Choice> {
    let player = state.standing.turn;
    let eye = Eye::new(scene, state.cue_ball(scene), level.noise);
    let race = Race::new(level.skills.pot_rate);
    let mut best: Option<(f64, Choice)> = None;
    for choice in &state.standing.choices {
        let Some(verdict) = state.choose(scene, *choice) else {
            continue;
        };
        let table = verdict.table_chosen(scene, before);
        let value = worth(&race, &eye, &verdict.next, &table, player);
        if best.is_none_or(|(most, _)| value > most) {
            best = Some((value, *choice));
        }
    }
    best.map(|(_, choice)| choice)
}
