//! What the referee says, as notices; and a cue ball in hand is taken up at once.

use bevy::prelude::*;

use crate::game::equip::Told;
use crate::game::practice::Practice;
use crate::game::saying::Saying;
use crate::game::turns::{TurnNews, Turns};

/// Tells what became of strokes and commands.
pub(super) fn speak(
    mut news: MessageReader<TurnNews>,
    turns: Res<Turns>,
    mut practice: ResMut<Practice>,
    mut told: MessageWriter<Told>,
) {
    let mut tell = |english: String, is_failure: bool| {
        told.write(Told {
            text: Saying::from(english),
            is_failure,
        });
    };
    for news in news.read() {
        match news {
            TurnNews::Begun => {}
            TurnNews::Judged => {
                if let (Some((_, verdict)), Some(game)) = (turns.said(), turns.game()) {
                    let table = game.table();
                    let players = &game.setup().players;
                    let names: Vec<String> = players.iter().map(|p| p.name.clone()).collect();
                    let fouls = verdict.fouls.iter().map(|foul| foul.sentence(&table));
                    let fouls: Vec<String> = fouls.collect();
                    if !fouls.is_empty() {
                        tell(fouls.join("\n"), true);
                    }
                    let notes = verdict.notes.iter();
                    let notes: Vec<String> =
                        notes.map(|note| note.sentence(&table, &names)).collect();
                    if !notes.is_empty() {
                        tell(notes.join("\n"), false);
                    }
                    if let Some(over) = &verdict.next.standing.over {
                        tell(over.sentence(&table, &names), false);
                    }
                }
            }
            TurnNews::Chosen { player, choice } => {
                let name = turns
                    .game()
                    .and_then(|game| game.setup().players.get(*player))
                    .map_or("", |player| player.name.as_str());
                tell(format!("{name}: {}", choice.label()), false);
            }
            TurnNews::Refused(refused) => tell(refused.to_string(), true),
            TurnNews::Failed(why) | TurnNews::PutAside(why) => tell(why.clone(), true),
            TurnNews::NotSaved(error) => tell(error.to_string(), true),
        }
        let in_hand = turns
            .game()
            .filter(|_| turns.may_strike())
            .is_some_and(|game| game.targets().in_hand.is_some());
        if matches!(
            news,
            TurnNews::Begun | TurnNews::Judged | TurnNews::Chosen { .. }
        ) {
            practice.placing = in_hand;
        }
    }
}
