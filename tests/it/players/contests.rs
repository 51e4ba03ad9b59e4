//! Whole racks, computer against computer.

use masse::game::players::Level;
use masse::game::players::contest::{MOST_SHOTS, play_rack};
use masse::game::players::standings::{Pairing, wilson};
use masse::game::rules::{EightBall, Game};

use super::pool;

#[test]
fn every_rack_of_eight_ball_has_a_winner() {
    let game = Game::EightBall(EightBall::default());
    for (seed, pair) in (0..).zip(Level::ALL.windows(2)) {
        let mut pairing = Pairing::new(&pair[1], &pair[0]);
        for rack in 0..2 {
            let played = play_rack(
                &game,
                [&pair[1], &pair[0]],
                rack,
                &pool(),
                10 * seed + rack as u64,
            )
            .expect("an end");
            assert!(played.winner.is_some());
            let shots: u32 = played.tallies.iter().map(|tally| tally.shots).sum();
            assert!(shots > 1 && shots < MOST_SHOTS);
            for (tally, level) in played.tallies.iter().zip([&pair[1], &pair[0]]) {
                assert!(tally.most_trials <= level.skills.budget);
                assert!(tally.pots <= 15 && tally.fouls <= tally.shots);
            }
            pairing.add(&played);
        }
        assert_eq!(pairing.decided(), 2);
    }
}

#[test]
fn the_same_seed_plays_the_same_rack() {
    let game = Game::EightBall(EightBall::default());
    let levels = [&Level::ALL[1], &Level::ALL[0]];
    let once = play_rack(&game, levels, 0, &pool(), 4);
    assert_eq!(once, play_rack(&game, levels, 0, &pool(), 4));
    assert_ne!(once, play_rack(&game, levels, 0, &pool(), 5));
}

#[test]
fn intervals_are_wilsons() {
    // Computed by hand from Wilson's formula with z = 1.959964.
    let (rate, low, high) = wilson(65, 100);
    assert_eq!(rate, 0.65);
    assert!(
        (low - 0.552_5).abs() < 2e-4 && (high - 0.736_4).abs() < 2e-4,
        "{low} {high}"
    );
    let (_, low, high) = wilson(0, 10);
    assert!(low == 0.0 && (high - 0.277_5).abs() < 2e-4, "{high}");
    assert_eq!(wilson(0, 0), (0.5, 0.0, 1.0));
}
