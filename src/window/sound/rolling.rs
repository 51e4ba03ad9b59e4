//! Balls that roll over the cloth: one sound that goes on and on, as loud as the fastest ball is fast.

use bevy::audio::{AudioPlayer, AudioSinkPlayback, AudioSource, PlaybackSettings, Volume};
use bevy::prelude::*;

use super::synthesis;
use crate::game::settings::Settings;
use crate::game::volume::SoundKind;
use crate::physics::ball::Motion;
use crate::sim::clock::Clock;
use crate::sim::components::{MotionKind, Velocity};
use crate::window::WindowSystems;

/// Speed in m/s from which rolling grows no louder.
const FASTEST: f64 = 4.0;
/// Loudness beside the hits.
const LOUDNESS: f64 = 0.16;

/// The one voice of rolling.
#[derive(Component)]
struct Rolling;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(Startup, begin.after(super::synthesise))
        .add_systems(RunFixedMainLoop, follow.in_set(WindowSystems::Present));
}

/// Starts the voice, silent. Without a device it waits for ever and costs nothing.
fn begin(mut commands: Commands, sources: Option<ResMut<Assets<AudioSource>>>) -> Result {
    if let Some(mut sources) = sources {
        let bytes = synthesis::rolling()?.into();
        commands.spawn((
            Rolling,
            AudioPlayer(sources.add(AudioSource { bytes })),
            PlaybackSettings::LOOP.with_volume(Volume::Linear(0.0)),
        ));
    }
    Ok(())
}

/// Makes it as loud and as high as the fastest ball on the cloth is fast.
fn follow(
    clock: Res<Clock>,
    settings: Res<Settings>,
    balls: Query<(&Velocity, &MotionKind)>,
    mut voices: Query<&mut AudioSink, With<Rolling>>,
) {
    let Ok(mut voice) = voices.single_mut() else {
        return;
    };
    let fastest = balls
        .iter()
        .filter(|(_, motion)| matches!(motion.0, Motion::Sliding | Motion::Rolling))
        .map(|(velocity, _)| velocity.0.length())
        .fold(0.0, f64::max);
    let level = f64::from(settings.volume.audible(SoundKind::Rolling));
    let (loudness, pitch) = if clock.moving {
        character(fastest)
    } else {
        (0.0, 1.0)
    };
    voice.set_volume(Volume::Linear((level * loudness) as f32));
    voice.set_speed(pitch as f32);
}

/// Loudness and pitch of a ball at this speed in m/s.
fn character(speed: f64) -> (f64, f64) {
    let share = (speed / FASTEST).min(1.0);
    (LOUDNESS * share.sqrt(), 0.7 + 0.6 * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_faster_ball_is_louder_and_higher_and_a_still_one_is_silent() {
        assert_eq!(character(0.0).0, 0.0);
        let (slow, fast) = (character(0.5), character(3.0));
        assert!(slow.0 < fast.0 && slow.1 < fast.1);
        assert_eq!(character(9.0), character(FASTEST));
    }
}
