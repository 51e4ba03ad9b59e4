//! `masse rules`.

use crate::cli::{CommandError, to_stdout};
use crate::game::rules::Game;

/// Lists the games, or prints the options of one and the code that they come from.
pub(super) fn rules(name: Option<&str>) -> Result<(), CommandError> {
    let Some(name) = name else {
        return list();
    };
    let Some(game) = Game::named(name) else {
        let known: Vec<&str> = Game::all()
            .iter()
            .map(|game| game.rules().code().name)
            .collect();
        return Err(CommandError::Usage(format!(
            "rules: there is no game `{name}`; there are {}",
            known.join(", ")
        )));
    };
    let (rules, code) = (game.rules(), game.rules().code());
    let players = rules.players();
    let settings = rules.settings();
    let width = |of: &dyn Fn(&crate::game::rules::Setting) -> usize| {
        settings.iter().map(of).max().unwrap_or(0)
    };
    let names = width(&|setting| setting.name.len());
    let values = width(&|setting| setting.value.len());
    to_stdout(|out| {
        writeln!(out, "{}", code.title)?;
        writeln!(out, "code       {}", code.edition)?;
        if players.start() == players.end() {
            writeln!(out, "players    {}", players.start())?;
        } else {
            writeln!(out, "players    {} to {}", players.start(), players.end())?;
        }
        writeln!(out, "equipment  {}", code.equipment)?;
        writeln!(out, "options")?;
        settings.iter().try_for_each(|setting| {
            writeln!(
                out,
                "  {:names$}  {:values$}  {}",
                setting.name, setting.value, setting.meaning
            )
        })
    })
}

fn list() -> Result<(), CommandError> {
    let games = Game::all();
    let codes: Vec<_> = games.iter().map(|game| game.rules().code()).collect();
    let names = codes.iter().map(|code| code.name.len()).max().unwrap_or(0);
    let titles = codes.iter().map(|code| code.title.len()).max().unwrap_or(0);
    to_stdout(|out| {
        codes.iter().try_for_each(|code| {
            writeln!(
                out,
                "{:names$}  {:titles$}  {}",
                code.name, code.title, code.edition
            )
        })
    })
}
