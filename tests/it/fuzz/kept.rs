//! Damaged saved matches, settings and shared texts: refused with what is wrong, or something that can be gone on with.

use std::sync::LazyLock;

use proptest::prelude::*;
use proptest::sample::select;

use masse::game::matches::{Phase, saved};
use masse::game::rules::Game;
use masse::game::settings::file::{self as settings_file, VERSION};
use masse::game::settings::{ClothColour, Settings};
use masse::physics::exact::{Limits, solve};
use masse::scenarios::{file, library, share};

use super::attack;
use super::texts::{assets, damage, damaged};
use crate::matches::{Hand, begin, headed};

/// Every game in its midst, as the text of its match without the first line.
static MATCHES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let games = ["8-ball", "9-ball", "14.1", "snooker", "three-cushion"];
    let played = games.iter().map(|name| {
        let mut game = begin(&Game::named(name).expect("a game"), 2, 3);
        let mut hand = Hand::new(3);
        for _ in 0..4 {
            hand.play(&mut game);
        }
        let text = saved::text(&game).expect("every number is finite");
        text.split_once('\n')
            .expect("two lines")
            .1
            .trim_end()
            .to_owned()
    });
    played.collect()
});

#[test]
fn damaged_matches_are_refused_or_played_on() {
    let inputs = (select(MATCHES.clone()), damage(), any::<bool>());
    attack(300, &inputs, |(body, damages, sealed)| {
        let text = if sealed {
            headed(&damaged(&body, &damages))
        } else {
            damaged(&headed(&body), &damages)
        };
        match saved::parse(&text, "mine.masse") {
            Err(error) if error.to_string().starts_with("mine.masse") => Ok(()),
            Err(error) => Err(format!("the message names no file: {error}")),
            Ok(mut game) => {
                let _ = game.statistics();
                if matches!(game.phase(), Phase::Play | Phase::Choose) {
                    let _ = Hand::new(1).play(&mut game);
                }
                Ok(())
            }
        }
    });
}

#[test]
fn damaged_settings_are_refused_or_within_their_ranges() {
    let mut settings = Settings {
        language: Some("fr".to_owned()),
        scale: 1.25,
        cloth: ClothColour::Burgundy,
        ..Settings::default()
    };
    let controls = vec!["Key KeyA".to_owned(), "Pad South".to_owned()];
    settings.bindings.insert("Strike".to_owned(), controls);
    let text = ron::to_string(&settings).expect("it can be written");
    assert!(text.contains(&format!("version:{VERSION}")));
    attack(2000, &damage(), |damages| {
        match settings_file::parse(&damaged(&text, &damages)) {
            Err(error) if error.to_string().is_empty() => Err("nothing is said".to_owned()),
            Err(_) => Ok(()),
            Ok(read) => {
                let again = ron::to_string(&read).map_err(|error| error.to_string())?;
                let back = settings_file::parse(&again).map_err(|error| error.to_string())?;
                if back == read {
                    Ok(())
                } else {
                    Err(format!("{read:?} comes back as {back:?}"))
                }
            }
        }
    });
}

#[test]
fn damaged_shared_texts_are_refused_or_whole() {
    let names = ["butterfly", "masse", "jump-shot", "stun-shot"];
    let texts: Vec<String> = names
        .iter()
        .map(|name| library::open(name).expect("a scene of the library"))
        .map(|scenario| share::write(&scenario).expect("it can be shared"))
        .collect();
    attack(1000, &(select(texts), damage()), |(text, damages)| {
        let damaged = damaged(&text, &damages);
        match share::read(&damaged) {
            Err(error) if error.to_string().is_empty() => Err("nothing is said".to_owned()),
            Err(_) => Ok(()),
            Ok(scenario) => scenario.scene.check().map_err(|error| error.to_string()),
        }
    });
}

/// Damage within, under a sum that fits: what another program, or somebody by hand, may have put together.
#[test]
fn shared_texts_of_damaged_scenes_are_refused_or_whole() {
    attack(
        300,
        &(select(assets("scenes")), damage()),
        |(text, damages)| {
            let inside = damaged(&text, &damages);
            match share::read(&share::seal(&inside).map_err(|error| error.to_string())?) {
                Err(error) if error.to_string().is_empty() => Err("nothing is said".to_owned()),
                Err(_) => Ok(()),
                Ok(scenario) => scenario.scene.check().map_err(|error| error.to_string()),
            }
        },
    );
}

/// What is read can be played, judged and searched, whatever stands in it.
#[test]
fn damaged_scenes_that_are_read_can_be_played_and_judged() {
    attack(
        300,
        &(select(assets("scenes")), damage()),
        |(text, damages)| {
            let Ok(scenario) = file::parse(&damaged(&text, &damages), "damaged") else {
                return Ok(());
            };
            let mut short = scenario.clone();
            short.scene = scenario.laid_out();
            short.scene.time_limit = short.scene.time_limit.min(3.0);
            if let Ok(record) = solve(&short.scene, Limits { events: 5000 }) {
                let told = short.judge(&record).len();
                if told != short.expect.len() {
                    return Err(format!(
                        "{told} of {} expectations are judged",
                        short.expect.len()
                    ));
                }
            }
            let text = file::write(&scenario).map_err(|error| error.to_string())?;
            let back = file::parse(&text, "damaged").map_err(|error| format!("{error}\n{text}"))?;
            if back == scenario {
                Ok(())
            } else {
                Err(format!(
                    "it is another one when written and read again:\n{text}"
                ))
            }
        },
    );
}
