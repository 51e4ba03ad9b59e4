//! `masse rules`.

use masse::game::rules::Game;

use crate::cli::{err, masse, out, output};

#[test]
fn rules_lists_the_games_with_their_codes() {
    let list = output(masse().arg("rules"));
    assert_eq!(list.status.code(), Some(0), "{}", err(&list));
    let lines: Vec<String> = out(&list).lines().map(str::to_owned).collect();
    assert_eq!(lines.len(), Game::all().len());
    for (line, game) in lines.iter().zip(Game::all()) {
        let code = game.rules().code();
        assert!(
            line.starts_with(code.name) && line.ends_with(code.edition),
            "{line}"
        );
    }
}

#[test]
fn rules_of_a_game_prints_its_options_and_their_date() {
    let text = out(&output(masse().args(["rules", "8-ball"])));
    for part in [
        "23 June 2025",
        "eight_first_on_open",
        "Foul, NoScore or Legal",
        "players    2",
    ] {
        assert!(text.contains(part), "{part} is not in\n{text}");
    }
    let text = out(&output(masse().args(["rules", "9-ball"])));
    assert!(
        text.contains("players    2 to 8") && text.contains("three_point_break"),
        "{text}"
    );
}

#[test]
fn an_unknown_game_is_refused_with_those_that_there_are() {
    let unknown = output(masse().args(["rules", "croquet"]));
    assert_eq!(unknown.status.code(), Some(2));
    assert!(err(&unknown).contains("there is no game `croquet`; there are 8-ball, 9-ball"));
}
