//! Everything that is said to people.

use masse::game::rules::{Choice, EightBall, Foul, Game, Note, Over, Reason};
use masse::physics::table::Preset;

use super::story::start;

#[test]
fn every_foul_is_explained_in_a_sentence_with_the_name_of_its_rule() {
    let (_, scene) = start(Game::EightBall(EightBall::default()), Preset::NineFoot);
    let ball = |name: &str| scene.ball_named(name).expect("the ball");
    let fouls = [
        (
            Foul::Scratch { pocket: 2 },
            "Cue ball pocketed: the cue ball fell into the side left pocket.",
        ),
        (
            Foul::CueBallOff,
            "Cue ball driven off the table: the cue ball left the table.",
        ),
        (
            Foul::NoContact,
            "No ball hit: the cue ball met no other ball.",
        ),
        (
            Foul::WrongBall {
                hit: ball("9"),
                on: vec![ball("2"), ball("1"), ball("3")],
            },
            "Wrong ball first: the cue ball met the 9 first, on was the 1, the 2 or the 3.",
        ),
        (
            Foul::NoCushion,
            "No cushion after contact: no ball was pocketed, and none reached a cushion after the contact.",
        ),
        (
            Foul::BallOff { ball: ball("4") },
            "Object ball driven off the table: the 4 left the table.",
        ),
        (
            Foul::BehindString { hit: ball("5") },
            "Bad play from behind the head string: from in hand behind the head string the cue ball met the 5 without crossing the string first.",
        ),
        (
            Foul::WeakBreak {
                driven: 2,
                needed: 4,
            },
            "Break requirements not met: no ball was pocketed and 2 balls reached a cushion, 4 were needed.",
        ),
        (
            Foul::PottedNotOn { ball: ball("6") },
            "Ball not on potted: the 6 was pocketed and was not on.",
        ),
        (
            Foul::Together {
                one: ball("1"),
                other: ball("2"),
            },
            "Two balls struck together: the cue ball met the 1 and the 2 at once, and they were not both on.",
        ),
        (
            Foul::Jump { over: ball("7") },
            "Jump shot: the cue ball passed over the 7.",
        ),
        (
            Foul::Push { ball: ball("1") },
            "Push stroke: the 1 touched the cue ball and was moved by the stroke.",
        ),
        (
            Foul::SnookeredBehindFreeBall { ball: ball("8") },
            "Snookered behind the free ball: the opponent was left snookered behind the free ball, the 8.",
        ),
        (
            Foul::WrongCueBall { struck: ball("3") },
            "Wrong cue ball: the cue struck the 3.",
        ),
        (
            Foul::IntoFrozen { ball: ball("3") },
            "Frozen ball shot into: the cue ball was shot into the 3, which was frozen to it.",
        ),
    ];
    for (foul, sentence) in fouls {
        assert_eq!(foul.sentence(&scene), sentence);
        // What points nowhere is still said, not a panic.
        assert!(Foul::Push { ball: 999 }.sentence(&scene).ends_with('.'));
        assert!(Foul::Scratch { pocket: 99 }.sentence(&scene).ends_with('.'));
    }
}

#[test]
fn notes_ends_and_choices_are_said_with_the_names_of_the_players() {
    let (_, scene) = start(Game::EightBall(EightBall::default()), Preset::NineFoot);
    let names = ["Ada".to_owned(), String::new()];
    let ball = |name: &str| scene.ball_named(name).expect("the ball");
    for (note, sentence) in [
        (
            Note::Group {
                player: 0,
                solids: true,
            },
            "Ada has the solids.",
        ),
        (
            Note::Group {
                player: 1,
                solids: false,
            },
            "Player 2 has the stripes.",
        ),
        (
            Note::PenaltyPoints { points: 4 },
            "4 points for the other side.",
        ),
        (
            Note::IllegalBreak { driven: 1 },
            "The break pocketed nothing and drove 1 ball to a cushion.",
        ),
        (
            Note::NotCalled {
                balls: vec![ball("3"), ball("1")],
            },
            "Not called: the 1 and the 3 fell; the turn passes.",
        ),
        (
            Note::Miss { in_a_row: 2 },
            "Foul and a miss, 2 in a row with a ball in full view.",
        ),
        (Note::Miss { in_a_row: 1 }, "Foul and a miss."),
        (Note::FreeBall, "Free ball."),
    ] {
        assert_eq!(note.sentence(&scene, &names), sentence);
    }
    let reason = Reason::WinningBall { ball: ball("8") };
    let won = Over {
        winner: Some(0),
        reason,
    };
    assert_eq!(
        won.sentence(&scene, &names),
        "Ada wins: the 8 was pocketed as it must be."
    );
    let drawn = Over {
        winner: None,
        reason: Reason::Points { needed: 40 },
    };
    assert_eq!(
        drawn.sentence(&scene, &names),
        "Nobody wins: 40 points were reached."
    );
    assert_ne!(Choice::Break.saying(), Choice::TheyBreak.saying());
}
