//! What the referee says, as notices; and a cue ball in hand is taken up at once.

use bevy::prelude::*;

use crate::game::equip::Told;
use crate::game::matches::Match;
use crate::game::practice::Practice;
use crate::game::rules::Verdict;
use crate::game::saying::Saying;
use crate::game::turns::{TurnNews, Turns};

/// Tells what became of strokes and commands.
pub(super) fn speak(
    mut news: MessageReader<TurnNews>,
    turns: Res<Turns>,
    mut practice: ResMut<Practice>,
    mut told: MessageWriter<Told>,
) {
    for news in news.read() {
        for (text, is_failure) in said(news, &turns) {
            told.write(Told { text, is_failure });
        }
        // A break is played from where the ball lies unless somebody wants it elsewhere.
        let places = turns.game().is_some_and(|game| !game.targets().is_break);
        let in_hand = places && turns.places_cue_ball();
        if matches!(
            news,
            TurnNews::Begun | TurnNews::Judged | TurnNews::Chosen { .. }
        ) {
            practice.placing = in_hand;
        }
    }
}

/// The notices for a piece of news, each with whether it tells of a failure.
fn said(news: &TurnNews, turns: &Turns) -> Vec<(Saying, bool)> {
    let one = |saying: Saying, is_failure: bool| vec![(saying, is_failure)];
    match news {
        TurnNews::Begun => Vec::new(),
        TurnNews::Judged => match (turns.said(), turns.game()) {
            (Some((_, verdict)), Some(game)) => judged(verdict, game),
            _ => Vec::new(),
        },
        TurnNews::Chosen { player, choice } => {
            let players = turns.game().map(|game| &game.setup().players);
            let player = players.and_then(|players| players.get(*player));
            let name = player.map_or("", |player| player.name.as_str());
            let values = vec![("name", name.into()), ("choice", choice.saying().into())];
            one(
                Saying::of("match-chosen", values, "{name}: {choice}"),
                false,
            )
        }
        TurnNews::Refused(refused) => one(refused.saying(), true),
        TurnNews::Failed(why) => one(why.clone(), true),
        TurnNews::PutAside { kept, why } => {
            let values = vec![
                ("kept", kept.display().to_string().as_str().into()),
                ("reason", why.to_string().as_str().into()),
            ];
            let english = "An older save could not be replaced and is kept as {kept}. {reason}";
            one(Saying::of("notice-match-kept", values, english), true)
        }
        TurnNews::NotSaved(error) => {
            let values = vec![("reason", error.to_string().as_str().into())];
            let english = "The match could not be saved. It goes on, and is saved as soon as that is possible. {reason}";
            one(Saying::of("notice-match-unsaved", values, english), true)
        }
        TurnNews::SavedAgain => one(
            Saying::new("notice-match-saved-again", &[], "The match is saved again."),
            false,
        ),
    }
}

/// What the referee says: what was wrong, what is worth saying, how it ended.
fn judged(verdict: &Verdict, game: &Match) -> Vec<(Saying, bool)> {
    let table = game.table();
    let players = &game.setup().players;
    let names: Vec<String> = players.iter().map(|p| p.name.clone()).collect();
    let fouls = Saying::lines(verdict.fouls.iter().map(|foul| foul.saying(&table)));
    let notes = Saying::lines(verdict.notes.iter().map(|note| note.saying(&table, &names)));
    let over = verdict.next.standing.over;
    let over = over.map(|over| over.saying(&table, &names));
    let failure = fouls.map(|saying| (saying, true));
    let others = [notes, over].into_iter().flatten();
    failure
        .into_iter()
        .chain(others.map(|saying| (saying, false)))
        .collect()
}
