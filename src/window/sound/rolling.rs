//! Balls that roll over the cloth: a few voices that go on and on, each where one of the fastest balls is, as loud as that
//! ball is fast.

use bevy::audio::{
    AudioPlayer, AudioSinkPlayback, AudioSource, PlaybackSettings, SpatialAudioSink, SpatialScale,
    Volume,
};
use bevy::ecs::message::MessageUpdateSystems;
use bevy::prelude::*;

use super::synthesis;
use crate::game::settings::Settings;
use crate::game::volume::SoundKind;
use crate::physics::ball::Motion;
use crate::sim::clock::Clock;
use crate::sim::components::{MotionKind, Position, Velocity};
use crate::sim::stepped::crowd::is_crowd;

/// Balls that are heard at the same time.
const VOICES: usize = 4;
/// Speed in m/s from which rolling grows no louder.
const FASTEST: f64 = 4.0;
/// Speed in m/s below which nothing is heard.
const SLOWEST: f64 = 0.02;
/// Loudness beside the hits.
const LOUDNESS: f64 = 0.14;

/// A voice of rolling, and the ball that it follows.
#[derive(Component, Default)]
struct Rolling(Option<Entity>);

pub(super) fn plugin(app: &mut App) {
    app.add_systems(Startup, begin.after(super::synthesise))
        .add_systems(
            First,
            follow.run_if(not(is_crowd)).after(MessageUpdateSystems),
        );
}

/// Starts the voices, silent. Without a device they wait for ever and cost nothing.
pub(super) fn begin(
    mut commands: Commands,
    sources: Option<ResMut<Assets<AudioSource>>>,
) -> Result {
    if let Some(mut sources) = sources {
        let bytes = synthesis::rolling()?.into();
        let source = sources.add(AudioSource { bytes });
        for voice in 0..VOICES {
            // Each begins elsewhere in the same sound, so that they do not sing in unison.
            let start = synthesis::ROLLING.mul_f64(voice as f64 / VOICES as f64);
            commands.spawn((
                Rolling::default(),
                AudioPlayer(source.clone()),
                PlaybackSettings::LOOP
                    .with_volume(Volume::Linear(0.0))
                    .with_start_position(start)
                    .with_spatial(true)
                    .with_spatial_scale(SpatialScale::new(super::ROOM)),
                Transform::default(),
            ));
        }
    }
    Ok(())
}

/// Gives the fastest balls a voice each, and makes it as loud and as high as the ball is fast.
fn follow(
    clock: Res<Clock>,
    settings: Res<Settings>,
    balls: Query<(Entity, &Position, &Velocity, &MotionKind)>,
    mut voices: Query<(&mut Rolling, &mut Transform, Option<&mut SpatialAudioSink>)>,
) {
    let mut rolling: Vec<(Entity, Vec3, f64)> = balls
        .iter()
        .filter(|(.., motion)| matches!(motion.0, Motion::Sliding | Motion::Rolling))
        .map(|(ball, position, velocity, _)| (ball, position.0.as_vec3(), velocity.0.length()))
        .filter(|(.., speed)| clock.moving && *speed > SLOWEST)
        .collect();
    rolling.sort_by(|a, b| b.2.total_cmp(&a.2));
    rolling.truncate(VOICES);
    let heard: Vec<Option<Entity>> = voices.iter().map(|(voice, ..)| voice.0).collect();
    let level = f64::from(settings.volume.audible(SoundKind::Rolling));
    // Balls that have no voice yet get those whose ball is silent.
    let mut waiting = rolling
        .iter()
        .filter(|(ball, ..)| !heard.contains(&Some(*ball)));
    for (mut voice, mut place, sink) in &mut voices {
        let known = |one: &&(Entity, Vec3, f64)| Some(one.0) == voice.0;
        let ball = rolling.iter().find(known).or_else(|| waiting.next());
        voice.0 = ball.map(|ball| ball.0);
        let (loudness, pitch) = ball.map_or((0.0, 1.0), |ball| character(ball.2));
        if let Some(ball) = ball {
            place.translation = ball.1;
        }
        if let Some(mut sink) = sink {
            sink.set_volume(Volume::Linear((level * loudness) as f32));
            sink.set_speed(pitch as f32);
        }
    }
}

/// Loudness and pitch of a ball at this speed in m/s.
fn character(speed: f64) -> (f64, f64) {
    let share = (speed / FASTEST).min(1.0);
    (LOUDNESS * share.sqrt(), 0.7 + 0.6 * share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bevy::math::DVec3;

    #[test]
    fn a_faster_ball_is_louder_and_higher_and_a_still_one_is_silent() {
        assert_eq!(character(0.0).0, 0.0);
        let (slow, fast) = (character(0.5), character(3.0));
        assert!(slow.0 < fast.0 && slow.1 < fast.1);
        assert_eq!(character(9.0), character(FASTEST));
    }

    #[test]
    fn the_fastest_balls_have_the_voices_and_keep_them() {
        let mut app = App::new();
        app.init_resource::<Settings>()
            .insert_resource(Clock {
                moving: true,
                ..Clock::default()
            })
            .add_systems(Update, follow);
        for _ in 0..VOICES {
            app.world_mut()
                .spawn((Rolling::default(), Transform::default()));
        }
        let mut ball = |speed: f64| {
            app.world_mut()
                .spawn((
                    Position(DVec3::new(speed, 0.03, 0.0)),
                    Velocity(DVec3::X * speed),
                    MotionKind(Motion::Rolling),
                ))
                .id()
        };
        let balls = [0.5, 3.0, 0.0, 1.0, 2.0, 4.0].map(&mut ball);
        let heard = |app: &mut App| -> Vec<Option<Entity>> {
            let mut voices = app.world_mut().query::<&Rolling>();
            voices.iter(app.world()).map(|voice| voice.0).collect()
        };
        app.update();
        let first = heard(&mut app);
        for loud in [1, 3, 4, 5] {
            assert!(first.contains(&Some(balls[loud])), "{loud}");
        }
        // One stops, another takes its voice; the others keep theirs.
        app.world_mut()
            .entity_mut(balls[5])
            .insert(Velocity(DVec3::ZERO));
        app.update();
        for (before, after) in first.iter().zip(heard(&mut app)) {
            let gone = *before == Some(balls[5]);
            assert_eq!(after, if gone { Some(balls[0]) } else { *before });
        }
    }
}
