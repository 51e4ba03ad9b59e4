//! What can be heard: tip, ball on ball, cushion, pocket, with loudness and pitch from the impulse; balls that roll, each
//! from where it is; what becomes of them in the pockets; and the buttons of the panels.
//!
//! The sounds are synthesised when the program starts. Without a sound device nothing is heard and nothing piles up:
//! every voice ends by its own clock, whether anybody played it or not.

mod click;
mod gully;
mod lost;
mod rolling;
mod synthesis;

use std::time::Duration;

use bevy::audio::{AudioPlayer, AudioSource, PlaybackSettings, SpatialListener, SpatialScale};
use bevy::prelude::*;
use glam::DVec3;

use crate::game::settings::Settings;
use crate::game::view::FirstEye;
use crate::game::volume::SoundKind;
use crate::physics::record::{Event, EventKind};
use crate::sim::messages::{Pocketed, Struck, Touched};
use crate::window::WindowSystems;
use synthesis::{HARDNESSES, Sound};

/// Impulse in N s, of a pool ball at about 6 m/s, that sounds as loud as can be.
const LOUDEST: f64 = 1.0;
/// Impulse in N s below which nothing is heard.
const QUIETEST: f64 = 5e-4;
/// Loudness grows with this power of the impulse: the ear hears ratios.
const LOUDNESS: f64 = 0.6;
/// Mass in kg taken for a ball that drops into a pocket at some speed.
const DROPPED: f64 = 0.17;
/// Loudness left for other voices at the same moment.
const HEADROOM: f32 = 0.5;
/// Voices that may start in one frame, the loudest first; a break has many more hits.
const STARTS: usize = 8;
/// Voices at the same time.
const VOICES: usize = 32;
/// Distance between the ears in m.
const EARS: f32 = 0.2;
/// Makes the room small enough that distance only turns the sound to the left or right, not down.
const ROOM: f32 = 0.1;

/// The sounds, each at several hardnesses of the hit.
#[derive(Resource, Default)]
struct Sounds {
    handles: Vec<(Sound, [Handle<AudioSource>; HARDNESSES])>,
}

/// A sound being played.
#[derive(Component)]
struct Voice {
    until: Duration,
}

/// A hit that may be heard.
struct Hit {
    sound: Sound,
    /// Momentum passed on, N s.
    impulse: f64,
    at: DVec3,
    time: f64,
}

pub(super) use lost::layer as log_layer;

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Sounds>()
        .add_systems(Startup, synthesise)
        .add_observer(give_ears)
        .add_plugins((click::plugin, gully::plugin, lost::plugin, rolling::plugin))
        .add_systems(
            RunFixedMainLoop,
            (end, hear).chain().in_set(WindowSystems::Present),
        );
}

/// Makes the sounds. Without audio in the app there is nowhere to put them.
fn synthesise(mut sounds: ResMut<Sounds>, sources: Option<ResMut<Assets<AudioSource>>>) -> Result {
    let Some(mut sources) = sources else {
        return Ok(());
    };
    for sound in Sound::ALL {
        let mut handles: [Handle<AudioSource>; HARDNESSES] = default();
        for (hardness, handle) in handles.iter_mut().enumerate() {
            let bytes = synthesis::wav(sound, hardness)?.into();
            *handle = sources.add(AudioSource { bytes });
        }
        sounds.handles.push((sound, handles));
    }
    Ok(())
}

/// The player hears from where the camera is.
fn give_ears(camera: On<Add, FirstEye>, mut commands: Commands) {
    commands
        .entity(camera.entity)
        .insert(SpatialListener::new(EARS));
}

/// Removes voices that are over.
fn end(mut commands: Commands, voices: Query<(Entity, &Voice)>, time: Res<Time<Real>>) {
    for (entity, voice) in &voices {
        if voice.until < time.elapsed() {
            commands.entity(entity).despawn();
        }
    }
}

/// Starts a voice for the loudest hits since the last frame.
#[expect(
    clippy::too_many_arguments,
    reason = "one reader for each kind of message"
)]
fn hear(
    mut commands: Commands,
    mut struck: MessageReader<Struck>,
    mut touched: MessageReader<Touched>,
    mut pocketed: MessageReader<Pocketed>,
    sounds: Res<Sounds>,
    settings: Res<Settings>,
    time: Res<Time<Real>>,
    voices: Query<(), With<Voice>>,
) {
    let struck = struck.read().map(|message| message.0);
    let touched = touched.read().map(|message| message.0);
    let pocketed = pocketed.read().map(|message| message.0);
    let mut hits: Vec<Hit> = struck
        .chain(touched)
        .chain(pocketed)
        .filter_map(|event| hit(&event))
        .filter(|hit| hit.impulse > QUIETEST)
        .filter(|hit| settings.volume.audible(kind(hit.sound)) > 0.0)
        .collect();
    hits.sort_by(|a, b| b.impulse.total_cmp(&a.impulse));
    let free = VOICES.saturating_sub(voices.iter().len());
    for hit in hits.iter().take(STARTS.min(free)) {
        let Some((_, handles)) = sounds.handles.iter().find(|(sound, _)| *sound == hit.sound)
        else {
            continue;
        };
        let (loudness, hardness, pitch) = character(hit);
        let level = settings.volume.audible(kind(hit.sound));
        commands.spawn((
            AudioPlayer(handles[hardness].clone()),
            PlaybackSettings::ONCE
                .with_volume(bevy::audio::Volume::Linear(HEADROOM * level * loudness))
                .with_speed(pitch)
                .with_spatial(true)
                .with_spatial_scale(SpatialScale::new(ROOM)),
            Transform::from_translation(hit.at.as_vec3()),
            Voice {
                until: time.elapsed() + 2 * synthesis::LENGTH,
            },
        ));
    }
}

/// Which level of the player a sound has.
fn kind(sound: Sound) -> SoundKind {
    match sound {
        Sound::Tip => SoundKind::Cue,
        Sound::Balls => SoundKind::Balls,
        Sound::Cushion => SoundKind::Cushions,
        Sound::Pocket => SoundKind::Pockets,
        Sound::Click => SoundKind::Interface,
    }
}

/// What is heard of an event.
fn hit(event: &Event) -> Option<Hit> {
    let before = event.first.before;
    let (sound, impulse) = match event.kind {
        EventKind::Strike { .. } => (Sound::Tip, event.impulse),
        EventKind::BallBall => (Sound::Balls, event.impulse),
        EventKind::Cushion { .. } | EventKind::Slate | EventKind::OffTable => {
            (Sound::Cushion, event.impulse)
        }
        EventKind::Pocketed { .. } => (Sound::Pocket, DROPPED * (0.3 + before.velocity.length())),
        EventKind::Rim { .. } => (Sound::Pocket, event.impulse),
        EventKind::Motion { .. } => return None,
    };
    Some(Hit {
        sound,
        impulse,
        at: before.position,
        time: event.time,
    })
}

/// Loudness from 0 to 1, hardness of the sound, and pitch about 1. Two hits are never quite alike.
#[expect(
    clippy::cast_possible_truncation,
    reason = "sound begins here: f32 is what the mixer takes"
)]
fn character(hit: &Hit) -> (f32, usize, f32) {
    let force = (hit.impulse / LOUDEST).min(1.0);
    let loudness = libm::pow(force, LOUDNESS);
    let hardness = match force {
        force if force < 0.05 => 0,
        force if force < 0.3 => 1,
        _ => 2,
    };
    let chance = (hit.time * 7919.0 + hit.at.x * 104_729.0).rem_euclid(1.0);
    let pitch = 0.92 + 0.12 * loudness + 0.06 * (chance - 0.5);
    (loudness as f32, hardness, pitch as f32)
}

#[cfg(test)]
mod tests {
    use bevy::time::TimeUpdateStrategy;

    use super::*;
    use crate::physics::ball::State;
    use crate::physics::record::Participant;

    /// Without a device nothing ever says that a sound is over.
    #[test]
    fn voices_are_few_and_end_whether_anybody_plays_them_or_not() {
        let mut app = App::new();
        app.add_plugins(MinimalPlugins)
            .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_millis(
                16,
            )))
            .insert_resource(Assets::<AudioSource>::default())
            .init_resource::<Sounds>()
            .init_resource::<Settings>()
            .add_message::<Struck>()
            .add_message::<Touched>()
            .add_message::<Pocketed>()
            .add_systems(Startup, synthesise)
            .add_systems(Update, (end, hear).chain());
        let voices = |app: &mut App| {
            let world = app.world_mut();
            world.query::<&Voice>().iter(world).count()
        };
        app.update();
        let lies = State::at_rest(DVec3::ZERO);
        let ball = Participant {
            ball: 0,
            before: lies,
            after: lies,
        };
        for frame in 0..100 {
            for hit in 1..20_u8 {
                app.world_mut().write_message(Touched(Event {
                    time: f64::from(frame),
                    kind: EventKind::BallBall,
                    first: ball,
                    second: None,
                    impulse: 0.01 * f64::from(hit),
                }));
            }
            app.update();
            let heard = voices(&mut app);
            assert!((1..=VOICES).contains(&heard), "{heard} voices");
        }
        for _ in 0..300 {
            app.update();
        }
        assert_eq!(voices(&mut app), 0);
    }

    fn of(sound: Sound, impulse: f64) -> (f32, usize, f32) {
        character(&Hit {
            sound,
            impulse,
            at: DVec3::ZERO,
            time: 0.0,
        })
    }

    #[test]
    fn a_harder_hit_is_louder_harder_and_higher() {
        let mut last = of(Sound::Balls, QUIETEST);
        assert!(last.0 < 0.02);
        for impulse in [0.005, 0.02, 0.08, 0.3, 1.0] {
            let now = of(Sound::Balls, impulse);
            assert!(
                now.0 > last.0 && now.1 >= last.1 && now.2 > last.2,
                "{impulse}"
            );
            last = now;
        }
        assert_eq!(last.0, 1.0);
        // Ten times the impulse is four times as loud: twelve decibels.
        let ratio = of(Sound::Balls, 0.5).0 / of(Sound::Balls, 0.05).0;
        assert!((20.0 * libm::log10f(ratio) - 12.0).abs() < 0.1);
    }
}
