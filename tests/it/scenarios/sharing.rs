//! Shared texts come back bit for bit; damaged, cut and newer ones say what they are.

use super::{command_line, scenario};
use masse::scenarios::library;
use masse::scenarios::share::{self, ShareError};
use proptest::prelude::*;

fn bits(of: &masse::scenarios::file::Scenario) -> String {
    format!("{of:?}")
}

fn text() -> String {
    let scenario = library::open("masse").unwrap_or_else(|error| panic!("{error}"));
    share::write(&scenario).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_library_comes_back_bit_for_bit() {
    for built_in in library::BUILT_IN {
        let scenario = built_in
            .scenario()
            .unwrap_or_else(|error| panic!("{error}"));
        if scenario.scene.balls.len() > 16 {
            continue;
        }
        let text = share::write(&scenario).unwrap_or_else(|error| panic!("{error}"));
        assert!(
            text.starts_with("masse1:") && text.len() < 3000,
            "{} letters",
            text.len()
        );
        let again = share::read(&text).unwrap_or_else(|error| panic!("{}: {error}", built_in.name));
        let mut named = again;
        named.preset.clone_from(&scenario.preset);
        assert_eq!(bits(&scenario), bits(&named), "{}", built_in.name);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn any_scene_comes_back_bit_for_bit(
        x in -1.2..1.2f64, z in -0.55..0.55f64, heading in -400.0..400.0f64, side in -0.35..0.35f64,
        height in -0.35..0.35f64, speed in 0.0..20.0f64, spin in -1e3..1e3f64, title in proptest::collection::vec(any::<char>(), 0..40),
    ) {
        let mut scene = scenario(&format!(
            r#"(table: NineFoot, balls: [(name: "cue", position: ({x}, {z}), spin: (0, {spin}, 0))],
                shot: (ball: "cue", heading_deg: {heading}, side: {side}, height: {height}, speed: {speed}),
                expect: [Stays(ball: "cue")])"#
        ));
        scene.title = title.into_iter().collect();
        let text = share::write(&scene).expect("it can be written");
        prop_assert!(text.bytes().all(|b| b.is_ascii_alphanumeric() || b"-_:".contains(&b)));
        let again = share::read(&text).expect("it reads back");
        prop_assert_eq!(bits(&scene), bits(&again));
    }
}

#[test]
fn every_wrong_letter_is_noticed() {
    let text = text();
    let start = "masse1:".len();
    for at in start..text.len() {
        let old = text.as_bytes()[at];
        for new in [b'A', b'_', b'7', b'!'] {
            if new == old {
                continue;
            }
            let mut bytes = text.clone().into_bytes();
            bytes[at] = new;
            let damaged = String::from_utf8(bytes).expect("ASCII");
            let error = share::read(&damaged).expect_err(&damaged);
            assert!(
                matches!(
                    error,
                    ShareError::Damaged { .. } | ShareError::CutOff { .. }
                ),
                "{at}: {error}"
            );
        }
    }
}

#[test]
fn every_cut_says_that_it_is_one() {
    let text = text();
    for length in "masse1:".len()..text.len() {
        let error = share::read(&text[..length]).expect_err("cut").to_string();
        assert!(
            error.contains("cut off"),
            "{length} of {}: {error}",
            text.len()
        );
    }
    let longer = share::read(&format!("{text}AAAA"))
        .expect_err("longer")
        .to_string();
    assert!(
        longer.contains("damaged") && longer.contains("follow"),
        "{longer}"
    );
}

#[test]
fn newer_texts_say_so_and_breaks_in_lines_do_not_matter() {
    let text = text();
    let newer = text.replacen("masse1:", "masse2:", 1);
    let error = share::read(&newer).expect_err("newer").to_string();
    assert!(
        error.contains("version 2") && error.contains("reads version 1"),
        "{error}"
    );
    let far = text.replacen("masse1:", "masse99999999999:", 1);
    assert!(matches!(share::read(&far), Err(ShareError::Newer { .. })));
    assert!(share::read(&text.replacen("masse1:", "masse0:", 1)).is_err());
    let (head, tail) = text.split_at(60);
    let broken = format!("  {head}\r\n {tail}\n");
    assert!(share::read(&broken).is_ok());
    assert!(
        !share::is_shared("masse") && !share::is_shared("massex1:") && !share::is_shared("masse:")
    );
}

#[test]
fn every_command_that_takes_a_scene_takes_the_text() {
    let shared = command_line::masse(&["share", "stop-shot"]);
    assert_eq!(shared.status.code(), Some(0));
    let text = command_line::text(&shared.stdout).trim().to_owned();
    let run = command_line::masse(&["run", &text, "-q"]);
    assert_eq!(
        run.status.code(),
        Some(0),
        "{}",
        command_line::text(&run.stderr)
    );
    let out = command_line::file("share", "x", "").with_file_name("s.svg");
    let out = out.display().to_string();
    let drawn = command_line::masse(&["picture", &text, &out, "--before"]);
    assert_eq!(
        drawn.status.code(),
        Some(0),
        "{}",
        command_line::text(&drawn.stderr)
    );
    let sensitive = command_line::masse(&["sensitivity", &text]);
    assert_eq!(sensitive.status.code(), Some(0));
    let cut = command_line::masse(&["run", &text[..text.len() - 9]]);
    assert_eq!(cut.status.code(), Some(2));
    assert!(command_line::text(&cut.stderr).contains("cut off"));
}
