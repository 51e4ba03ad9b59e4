//! Every kind of damage to a saved match is reported with file, field and value; none is taken for a match.

use std::sync::LazyLock;

use masse::game::matches::saved::{check_replaceable, parse, text};
use masse::game::matches::{Match, SavedError};
use masse::game::rules::Game;
use proptest::prelude::*;

use super::{Hand, begin};

/// A match in its midst, and its text.
static MATCH: LazyLock<(Match, String)> = LazyLock::new(|| {
    let mut played = begin(&Game::named("snooker").expect("snooker"), 3, 2);
    let mut hand = Hand::new(2);
    for _ in 0..3 {
        hand.play(&mut played);
    }
    let text = text(&played).expect("every number is finite");
    (played, text)
});

/// The text with this in its match, and a first line that fits it.
fn changed(from: &str, to: &str) -> String {
    let (_, whole) = &*MATCH;
    let (_, body) = whole.split_once('\n').expect("two lines");
    assert!(body.contains(from), "{from} is not in the match");
    headed(&body.trim_end().replacen(from, to, 1))
}

/// A body under a first line that fits it, so that what is read is the body.
pub(crate) fn headed(body: &str) -> String {
    let (crc, bytes) = (crc32fast::hash(body.as_bytes()), body.len());
    format!(
        "{{\"format\":\"masse match\",\"version\":1,\"bytes\":{bytes},\"crc32\":\"{crc:08x}\"}}\n{body}\n"
    )
}

fn error(text: &str) -> String {
    let error = parse(text, "mine.masse")
        .expect_err("it is damaged")
        .to_string();
    assert!(error.starts_with("mine.masse:"), "{error}");
    error
}

#[test]
fn a_whole_file_is_read_to_the_last_bit() {
    let (played, text) = &*MATCH;
    assert_eq!(&parse(text, "mine.masse").expect("whole"), played);
    assert_eq!(changed("\"rack\":0", "\"rack\":0"), *text);
}

#[test]
fn a_field_that_is_no_good_is_named_with_its_value() {
    for (from, to, expected) in [
        ("\"race\":3", "\"race\":0", "setup: race: 0 racks"),
        (
            "\"race\":3",
            "\"race\":\"three\"",
            "setup.race: invalid type: string \"three\"",
        ),
        (
            "\"race\":3",
            "\"rice\":3",
            "setup.rice: unknown field `rice`",
        ),
        (
            "\"first\":0",
            "\"first\":5",
            "setup: first: there is no player number 5",
        ),
        ("\"turn\":", "\"turn\":9", "state.standing.turn"),
        (
            "\"breaker\":0",
            "\"breaker\":2",
            "state.standing.breaker: 2 is out of range",
        ),
        (
            "\"players\":2",
            "\"players\":3",
            "state.standing.players: 3, the match has 2",
        ),
        ("\"thought\":", "\"thought\":-", "shots[0].thought: -"),
        (
            "\"call\":\"Nothing\"",
            "\"call\":\"Nonsense\"",
            "call: unknown variant `Nonsense`",
        ),
        (
            "\"call\":\"Nothing\"",
            "\"call\":{\"Pot\":{\"ball\":77,\"pocket\":0}}",
            "ball: 77 is out of range",
        ),
        (
            "\"speed\":",
            "\"speed\":99999",
            "shots[0].shot: shot.speed: 99999",
        ),
        (
            "\"length\":3.569",
            "\"length\":-3.569",
            "base: table.length: -3.569",
        ),
        (
            "\"name\":\"yellow\"",
            "\"name\":\"green\"",
            "`green` is used twice",
        ),
        (
            "\"Snooker\"",
            "\"Croquet\"",
            "setup.game: unknown variant `Croquet`",
        ),
        (
            "\"on\":\"Red\"",
            "\"on\":{\"Sequence\":{\"value\":9}}",
            "9 is no colour",
        ),
    ] {
        let text = changed(from, to);
        let error = error(&text);
        assert!(error.contains(expected), "{from} -> {to}: {error}");
    }
}

#[test]
fn a_first_line_that_is_no_good_is_named_too() {
    let (_, text) = &*MATCH;
    for (from, to, expected) in [
        (
            "masse match",
            "other match",
            "format: `other match` is not `masse match`",
        ),
        ("\"version\":1", "\"version\":0", "version: 0"),
        (
            "\"version\":1",
            "\"version\":\"one\"",
            "version: invalid type",
        ),
        ("\"version\":1", "\"version\":2", "newer"),
        ("\"bytes\":", "\"bytes\":1", "bytes: 1"),
        ("\"crc32\":\"", "\"crc32\":\"0", "crc32: 0"),
    ] {
        let error = error(&text.replacen(from, to, 1));
        assert!(error.contains(expected), "{from} -> {to}: {error}");
    }
    assert!(error("").contains("mine.masse:1"));
    assert!(error("{}").contains("missing field `format`"));
}

#[test]
fn a_digit_that_is_still_a_digit_is_found_by_the_checksum() {
    let (_, text) = &*MATCH;
    let at = text.rfind("\"thought\":").expect("a shot") + 12;
    let mut bytes = text.clone().into_bytes();
    let digit = (at..bytes.len())
        .find(|&i| bytes[i].is_ascii_digit())
        .expect("a digit");
    bytes[digit] = if bytes[digit] == b'5' { b'6' } else { b'5' };
    let text = String::from_utf8(bytes).expect("still text");
    assert!(matches!(
        parse(&text, "mine.masse"),
        Err(SavedError::Damaged { field: "crc32", .. })
    ));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn no_damage_is_taken_for_a_match(at in 0.0..1.0_f64, with in any::<char>(), kind in 0..4_u8, length in 1..200_usize) {
        let (played, text) = &*MATCH;
        // Half of the damage goes to the first line.
        let reach = if kind % 2 == 0 { text.len() } else { 90 };
        let mut at = (at * reach as f64) as usize;
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        let mut end = (at + length).min(text.len());
        while !text.is_char_boundary(end) {
            end += 1;
        }
        let damaged = match kind {
            0 | 1 => format!("{}{with}{}", &text[..at], &text[end..]),
            2 => text[..at].to_owned(),
            _ => format!("{}{}{}", &text[..end], &text[at..end], &text[end..]),
        };
        match parse(&damaged, "mine.masse") {
            Ok(read) => prop_assert_eq!(&read, played),
            Err(error) => prop_assert!(error.to_string().starts_with("mine.masse"), "{}", error),
        }
        if let Ok(()) = check_replaceable(&damaged, "mine.masse") {
            prop_assert!(parse(&damaged, "mine.masse").is_ok(), "replaced though it cannot be read");
        }
    }
}
