//! The opening stroke, and strokes without a plan.

use std::cmp::Ordering;

use glam::DVec2;

use crate::game::players::idea::{Idea, Kind, Line, call_safety};
use crate::game::players::level::Skills;
use crate::game::players::plan::Plan;
use crate::game::players::sight::{Seen, Sight, angle};
use crate::game::rules::{Call, Game, On};
use crate::physics::cue::Shot;
use crate::physics::scene::Scene;

/// Places across the table from which a break is tried, in half widths.
const ACROSS: [f64; 5] = [0.0, 0.35, -0.35, 0.75, -0.75];

/// Offsets of the way of the cue ball from the ball it meets first, in radii of that ball.
const OFF_CENTER: [f64; 3] = [0.0, 0.25, -0.25];

/// Directions in which a stroke without a plan is tried.
const AROUND: u32 = 48;

/// Directions in which a push out is tried.
const PUSHED: u32 = 24;

/// Whether the balls are to be broken apart, and not left together for the other player to open.
#[must_use]
pub fn is_open(game: &Game) -> bool {
    matches!(
        game,
        Game::EightBall(_) | Game::NineBall(_) | Game::TenBall(_) | Game::FreePractice(_)
    )
}

/// Legal places for the cue ball near the front of the area where it may be put, the middle one first.
#[must_use]
pub fn places(scene: &Scene, on: &On, most: usize) -> Vec<DVec2> {
    let Some(area) = &on.in_hand else {
        return Vec::new();
    };
    let (least, greatest) = area.bounds();
    let head = scene.table.head_spot();
    let mut spots = Vec::new();
    for share in ACROSS {
        let wish = DVec2::new(
            head.x.clamp(least.x, greatest.x) - 1e-3,
            share * greatest.y.max(-least.y),
        );
        if let Some(spot) = area.place(scene, on.cue, wish)
            && spots
                .iter()
                .all(|other: &DVec2| other.distance(spot) > 0.01)
            && spots.len() < most
        {
            spots.push(spot);
        }
    }
    spots
}

/// Strokes at the ball of the rack that is nearest.
#[must_use]
pub fn ideas(scene: &Scene, on: &On, skills: &Skills) -> Vec<Idea> {
    let sight = Sight::of(scene);
    let lies = sight.ball(on.cue).map(|seen| seen.at);
    let mut from: Vec<Option<DVec2>> = places(scene, on, skills.spots.clamp(1, 3))
        .into_iter()
        .map(Some)
        .collect();
    if from.is_empty() {
        from.push(None);
    }
    let offsets = if skills.samples > 0 { 3 } else { 1 };
    let mut ideas = Vec::new();
    for spot in from {
        let Some(at) = spot.or(lies) else { continue };
        let nearest = sight
            .balls
            .iter()
            .filter(|seen| seen.ball != on.cue && on.first.contains(&seen.ball))
            .min_by(|a, b| {
                a.at.distance_squared(at)
                    .total_cmp(&b.at.distance_squared(at))
            });
        let Some(apex) = nearest else { continue };
        for off in OFF_CENTER.into_iter().take(offsets) {
            let across = (apex.at - at).normalize_or_zero().perp();
            let aim = apex.at + off * apex.radius * across;
            ideas.push(Idea {
                kind: Kind::Break,
                spot,
                call: Call::Nothing,
                line: Line::Along(angle(aim - at)),
                chance: 0.5,
            });
        }
    }
    ideas
}

/// Strokes in every direction.
#[must_use]
pub fn all_around(spot: Option<DVec2>, on: &On) -> Vec<Idea> {
    let Some(&ball) = on.first.first() else {
        return Vec::new();
    };
    (0..AROUND)
        .map(|i| Idea {
            kind: Kind::Safety,
            spot,
            call: call_safety(on, ball),
            line: Line::Along(std::f64::consts::TAU * f64::from(i) / f64::from(AROUND)),
            chance: 0.0,
        })
        .collect()
}

/// Push outs in every direction.
#[must_use]
pub fn push_outs() -> Vec<Idea> {
    (0..PUSHED)
        .map(|i| Idea {
            kind: Kind::PushOut,
            spot: None,
            call: Call::PushOut,
            line: Line::Along(std::f64::consts::TAU * f64::from(i) / f64::from(PUSHED)),
            chance: 0.2,
        })
        .collect()
}

/// A stroke straight at the nearest ball that may be met first, or at any.
#[must_use]
pub fn plain(scene: &Scene, on: &On, at: DVec2, spot: Option<DVec2>) -> Plan {
    let sight = Sight::of(scene);
    let far = |seen: &&Seen| (!on.first.contains(&seen.ball), seen.at.distance_squared(at));
    let nearest = sight
        .balls
        .iter()
        .filter(|seen| seen.ball != on.cue)
        .min_by(|a, b| far(a).partial_cmp(&far(b)).unwrap_or(Ordering::Equal));
    let heading = nearest.map_or(0.0, |seen| -angle(seen.at - at));
    let call = nearest.map_or(Call::Nothing, |seen| call_safety(on, seen.ball));
    Plan {
        kind: Kind::Safety,
        spot,
        call,
        shot: Shot {
            heading,
            ..Shot::default()
        },
        value: 0.0,
        chance: 0.0,
    }
}
