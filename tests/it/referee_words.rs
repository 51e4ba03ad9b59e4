//! What the referee says is said in every language: fouls, notes, ends, choices, refusals. Each list goes from variant to
//! variant with a `match`, so that a new one cannot be forgotten here.

use masse::game::matches::{Hindrance, NoPlace, Refused};
use masse::game::players::Level;
use masse::game::rules::{Call, Choice, Foul, Game, Note, Over, Reason, wording};
use masse::game::saying::{Saying, Value};
use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::scene::{Rack, Scene, SceneError};
use masse::physics::table::Preset;
use masse::window::language::{LANGUAGES, Language};

/// Everything from the first to the last.
fn all<T: Clone>(first: T, next: impl Fn(&T) -> Option<T>) -> Vec<T> {
    std::iter::successors(Some(first), next).collect()
}

fn fouls() -> Vec<Foul> {
    use Foul as F;
    all(F::Scratch { pocket: 0 }, |foul| {
        Some(match foul {
            F::Scratch { pocket: 0 } => F::Scratch { pocket: 99 },
            F::Scratch { .. } => F::CueBallOff,
            F::CueBallOff => F::NoContact,
            F::NoContact => F::WrongBall { hit: 1, on: vec![] },
            F::WrongBall { on, .. } if on.is_empty() => F::WrongBall {
                hit: 999,
                on: vec![3],
            },
            F::WrongBall { on, .. } if on.len() == 1 => F::WrongBall {
                hit: 0,
                on: vec![3, 1, 2],
            },
            F::WrongBall { .. } => F::NoCushion,
            F::NoCushion => F::BallOff { ball: 2 },
            F::BallOff { .. } => F::BehindString { hit: 2 },
            F::BehindString { .. } => F::WeakBreak {
                driven: 1,
                needed: 4,
            },
            F::WeakBreak { driven: 1, .. } => F::WeakBreak {
                driven: 3,
                needed: 4,
            },
            F::WeakBreak { .. } => F::PottedNotOn { ball: 1 },
            F::PottedNotOn { .. } => F::Together { one: 1, other: 2 },
            F::Together { .. } => F::Jump { over: 1 },
            F::Jump { .. } => F::Push { ball: 1 },
            F::Push { .. } => F::SnookeredBehindFreeBall { ball: 1 },
            F::SnookeredBehindFreeBall { .. } => F::WrongCueBall { struck: 1 },
            F::WrongCueBall { .. } => F::IntoFrozen { ball: 1 },
            F::IntoFrozen { .. } => return None,
        })
    })
}

fn notes() -> Vec<Note> {
    use Note as N;
    let solids = |player, solids| N::Group { player, solids };
    all(solids(0, true), |note| {
        Some(match note {
            N::Group { solids: true, .. } => solids(1, false),
            N::Group { .. } => N::TwoFouls { player: 0 },
            N::TwoFouls { .. } => N::ThreeFoulPenalty {
                player: 0,
                points: 1,
            },
            N::ThreeFoulPenalty { points: 1, .. } => N::ThreeFoulPenalty {
                player: 1,
                points: 15,
            },
            N::ThreeFoulPenalty { .. } => N::IllegalBreak { driven: 1 },
            N::IllegalBreak { driven: 1 } => N::IllegalBreak { driven: 0 },
            N::IllegalBreak { .. } => N::ThreePointBreak { points: 1 },
            N::ThreePointBreak { points: 1 } => N::ThreePointBreak { points: 2 },
            N::ThreePointBreak { .. } => N::StalemateWarning,
            N::StalemateWarning => N::Stalemate,
            N::Stalemate => N::NotCalled { balls: vec![1] },
            N::NotCalled { balls } if balls.len() == 1 => N::NotCalled { balls: vec![1, 2] },
            N::NotCalled { .. } => N::Safety,
            N::Safety => N::PenaltyPoints { points: 1 },
            N::PenaltyPoints { points: 1 } => N::PenaltyPoints { points: 7 },
            N::PenaltyPoints { .. } => N::Miss { in_a_row: 1 },
            N::Miss { in_a_row: 1 } => N::Miss { in_a_row: 2 },
            N::Miss { .. } => N::FreeBall,
            N::FreeBall => N::RespottedBlack,
            N::RespottedBlack => N::PutBack { ball: 1 },
            N::PutBack { .. } => N::Rerack,
            N::Rerack => N::EqualisingInning { player: 0 },
            N::EqualisingInning { .. } => return None,
        })
    })
}

fn ends() -> Vec<Over> {
    use Reason as R;
    let reasons = all(R::WinningBall { ball: 1 }, |reason| {
        Some(match reason {
            R::WinningBall { .. } => R::LosingBall { ball: 1 },
            R::LosingBall { .. } => R::ThreeFouls,
            R::ThreeFouls => R::ThreeMisses,
            R::ThreeMisses => R::Points { needed: 1 },
            R::Points { needed: 1 } => R::Points { needed: 50 },
            R::Points { .. } => R::Innings { played: 1 },
            R::Innings { played: 1 } => R::Innings { played: 20 },
            R::Innings { .. } => R::LastBall,
            R::LastBall => R::Conceded,
            R::Conceded => return None,
        })
    });
    let both = |reason| [None, Some(0), Some(1)].map(|winner| Over { winner, reason });
    reasons.into_iter().flat_map(both).collect()
}

fn choices() -> Vec<Choice> {
    use Choice as C;
    all(C::Accept, |choice| {
        Some(match choice {
            C::Accept => C::InHand,
            C::InHand => C::Break,
            C::Break => C::TheyBreak,
            C::TheyBreak => C::HandBack,
            C::HandBack => C::PutBack,
            C::PutBack => C::Spot,
            C::Spot => C::GoFirst,
            C::GoFirst => C::GoSecond,
            C::GoSecond => return None,
        })
    })
}

fn refusals() -> Vec<Refused> {
    use {Hindrance as H, Refused as R};
    let not_now = |now| R::NotNow { what: "this", now };
    let (x, z) = (0.0, 0.0);
    all(not_now(H::ToChoose), |refused| {
        Some(match refused {
            R::NotNow { now, .. } => match now {
                H::ToChoose => not_now(H::ToPlay),
                H::ToPlay => not_now(H::RackOver),
                H::RackOver => not_now(H::MatchOver),
                H::MatchOver => not_now(H::NotInHand),
                H::NotInHand => not_now(H::NotTheCueBall),
                H::NotTheCueBall => not_now(H::NotAgreed),
                H::NotAgreed => not_now(H::NoPractice),
                H::NoPractice => not_now(H::NotTheirTurn),
                H::NotTheirTurn => not_now(H::NoMatch),
                H::NoMatch => not_now(H::MatchOn),
                H::MatchOn => R::Place {
                    x,
                    z,
                    why: NoPlace::Outside,
                },
            },
            R::Place {
                why: NoPlace::Outside,
                ..
            } => R::Place {
                x,
                z,
                why: NoPlace::NoRoom,
            },
            R::Place { .. } => R::Call { call: Call::Safety },
            R::Call { .. } => R::Choice {
                choice: Choice::Spot,
            },
            R::Choice { .. } => R::TooFar {
                asked: 1,
                played: 0,
            },
            R::TooFar { .. } => R::Players {
                game: "8-ball",
                given: 1,
                least: 2,
                most: 2,
            },
            R::Players { .. } => R::NoSuchPlayer {
                field: "first",
                player: 3,
                count: 2,
            },
            R::NoSuchPlayer { .. } => R::NoRace,
            R::NoRace => R::Table {
                game: "8-ball",
                pockets: 0,
                with: "with",
            },
            R::Table { .. } => R::Scene(SceneError::NoBalls),
            R::Scene(_) => R::Record { given: 1, count: 2 },
            R::Record { .. } => R::Thought { seconds: -1.0 },
            R::Thought { .. } => return None,
        })
    })
}

/// Scenes with every kind of ball there is a name for.
fn scenes() -> Vec<Scene> {
    [Preset::NineFoot, Preset::Snooker, Preset::Carom]
        .into_iter()
        .zip([Rack::EightBall, Rack::Snooker, Rack::ThreeCushion])
        .map(|(table, rack)| {
            let mut scene = Scene::new(table.table(), Laws::default());
            rack.place(&mut scene, Ball::POOL, 0.0, 1);
            scene
        })
        .collect()
}

#[test]
fn every_sentence_of_the_referee_is_said_in_every_language_with_the_same_english() {
    let names = ["Ada".to_owned(), String::new()];
    let mut sayings: Vec<Saying> = Vec::new();
    for scene in scenes() {
        let balls = scene.balls.len() + 1;
        sayings.extend((0..balls).map(|ball| wording::ball(&scene, ball)));
        let alone = (0..scene.balls.len()).map(|ball| wording::ball_alone(&scene, ball));
        // A number that stands alone needs no words.
        sayings.extend(alone.filter(|name| name.english.parse::<u8>().is_err()));
        sayings.extend((0..=scene.table.pockets.len()).map(|hole| wording::pocket(&scene, hole)));
        sayings.extend(fouls().iter().map(|foul| foul.saying(&scene)));
        sayings.extend(notes().iter().map(|note| note.saying(&scene, &names)));
        sayings.extend(ends().iter().map(|over| over.saying(&scene, &names)));
    }
    sayings.extend(fouls().iter().map(Foul::rule));
    sayings.extend(choices().into_iter().map(Choice::saying));
    sayings.extend(refusals().iter().map(Refused::saying));
    sayings.extend(Game::all().iter().map(wording::title));
    sayings.extend(Level::ALL.map(|level| Saying::new(level.key, &[], level.about)));
    assert!(sayings.len() > 150, "only {}", sayings.len());
    let english = Language::of_code("en");
    for saying in &sayings {
        assert_eq!(english.say(saying), saying.english, "{}", saying.key);
        for language in LANGUAGES {
            let spoken = Language::of_code(language.code);
            assert!(spoken.knows(saying), "{}: {saying:?}", language.code);
            let said = spoken.say(saying);
            let begins = said.chars().next().is_some_and(char::is_alphanumeric);
            assert!(begins && !said.contains('{'), "{said}");
        }
    }
}

#[test]
fn what_a_language_lacks_is_missed() {
    let german = Language::of_code("de");
    let scene = &scenes()[0];
    let foul = Foul::WrongBall {
        hit: 9,
        on: vec![2, 1, 3],
    };
    let saying = foul.saying(scene);
    assert_eq!(
        german.say(&saying),
        "Falsche Kugel zuerst: die Weiße traf zuerst die 9, an der Reihe war die 1, die 2 oder die 3."
            .replace("die 9", &format!("die {}", scene.balls[9].name))
            .replace("die 1, die 2 oder die 3", &{
                let on = wording::any_of(scene, &[2, 1, 3]).english();
                on.replace("the ", "die ").replace(" or ", " oder ")
            })
    );
    let unknown = Saying::of(
        "foul-push",
        vec![("ball", Value::from(Saying::new("ball-of-glass", &[], "it")))],
        "Push: {ball}",
    );
    assert!(!german.knows(&unknown));
    assert!(german.say(&unknown).contains(": it "));
    let lines = Saying::lines([Choice::Accept.saying(), Choice::InHand.saying()]);
    let said = german.say(&lines.expect("two"));
    assert_eq!(
        said,
        "Weiterspielen, wie es liegt\nWeiße in die Hand nehmen"
    );
    let french = Language::of_code("fr");
    let one = Note::NotCalled { balls: vec![1] }.saying(scene, &[]);
    assert!(
        french.say(&one).contains("est tombée"),
        "{}",
        french.say(&one)
    );
}
