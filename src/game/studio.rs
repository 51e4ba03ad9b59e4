//! Building a layout on the table: balls come and go, and are put exactly where they should be. Every step can be undone
//! and done again.

use bevy::prelude::*;
use glam::DVec2;

use crate::game::aim::Aim;
use crate::game::equip::equip;
use crate::game::practice::{Practice, obey, take_up};
use crate::game::turns::Turns;
use crate::game::{placing, snap};
use crate::physics::equipment::BallSet;
use crate::physics::scene::Scene;
use crate::sim::SimSystems;
use crate::sim::clock::Clock;
use crate::sim::messages::LoadScene;
use crate::sim::playfield::{BallQuery, Playfield, snapshot};

/// What is asked of the layout. Ignored while balls move and in a match.
#[derive(Message, Clone, Debug, PartialEq)]
pub enum StudioCommand {
    /// A ball with this name comes to the free spot nearest to the middle. Ignored if there is one with that name.
    Add(String),
    /// A ball is taken away. The ball that is to be struck stays, and so does the last one.
    Remove(usize),
    /// A ball is put so that it touches another.
    FreezeToBall(usize, usize),
    /// A ball is put so that it touches the nearest rail.
    FreezeToRail(usize),
    /// A ball is put on the nearest crossing of the lines through diamonds.
    ToDiamond(usize),
    /// Another ball is the one to strike.
    StrikeBall(usize),
}

pub(super) fn plugin(app: &mut App) {
    app.add_message::<StudioCommand>().add_systems(
        FixedUpdate,
        build
            .run_if(on_message::<StudioCommand>)
            .after(obey)
            .after(equip)
            .before(take_up)
            .before(SimSystems::Strike),
    );
}

/// Does what is asked. The table is laid out again, so that nothing of the last shot is left over.
#[expect(
    clippy::too_many_arguments,
    reason = "the table, the match, the wishes"
)]
fn build(
    mut commands: MessageReader<StudioCommand>,
    mut practice: ResMut<Practice>,
    mut aim: ResMut<Aim>,
    mut load: MessageWriter<LoadScene>,
    turns: Res<Turns>,
    clock: Res<Clock>,
    playfield: Res<Playfield>,
    balls: BallQuery,
) {
    let mut scene = snapshot(&playfield, &balls);
    let before = (scene.clone(), *aim);
    for command in commands.read() {
        if clock.moving || turns.is_on() {
            continue;
        }
        match command {
            StudioCommand::Add(name) => {
                if let Some(ball) = add(&mut scene, name) {
                    practice.chosen = Some(ball);
                }
            }
            StudioCommand::Remove(ball) => {
                if remove(&mut scene, *ball, aim.ball) {
                    aim.ball -= usize::from(*ball < aim.ball);
                    practice.chosen = None;
                }
            }
            StudioCommand::StrikeBall(ball) => {
                let in_play =
                    |placed: &crate::physics::scene::SceneBall| placed.state.motion.in_play();
                if scene.balls.get(*ball).is_some_and(in_play) {
                    aim.ball = *ball;
                }
            }
            StudioCommand::FreezeToBall(ball, other) => {
                move_to(&mut scene, *ball, |scene| {
                    snap::to_ball(scene, *ball, *other)
                });
            }
            StudioCommand::FreezeToRail(ball) => {
                move_to(&mut scene, *ball, |scene| snap::to_rail(scene, *ball));
            }
            StudioCommand::ToDiamond(ball) => {
                move_to(&mut scene, *ball, |scene| snap::to_diamond(scene, *ball));
            }
        }
    }
    if scene == before.0 {
        return;
    }
    practice.history.laid(before.0, before.1);
    practice.is_aimed = true;
    load.write(LoadScene(scene));
}

fn move_to(scene: &mut Scene, ball: usize, spot: impl Fn(&Scene) -> Option<DVec2>) {
    if let Some(spot) = spot(scene) {
        placing::place(scene, ball, spot);
    }
}

/// Adds a ball and says which it is.
fn add(scene: &mut Scene, name: &str) -> Option<usize> {
    let name = name.trim();
    if name.is_empty() || scene.ball_named(name).is_some() {
        return None;
    }
    let kind = BallSet::in_scene(scene).unwrap_or_default().named(name);
    let ball = scene.place(name, kind, 0.0, 0.0);
    if placing::place(scene, ball, DVec2::ZERO) {
        Some(ball)
    } else {
        scene.balls.pop();
        None
    }
}

fn remove(scene: &mut Scene, ball: usize, struck: usize) -> bool {
    let can = ball < scene.balls.len() && ball != struck && scene.balls.len() > 1;
    if can {
        scene.balls.remove(ball);
    }
    can
}
