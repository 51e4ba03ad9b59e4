//! What becomes of a ball in a pocket: on tables with a gully it runs back below the table, in a pocket of leather it
//! knocks against those that lie there.

use std::time::Duration;

use bevy::audio::{AudioPlayer, AudioSource, PlaybackSettings, SpatialScale, Volume};
use bevy::prelude::*;

use super::synthesis::{self, Sound};
use super::{Sounds, Voice};
use crate::game::settings::{Settings, TableStyle};
use crate::game::volume::SoundKind;
use crate::physics::record::EventKind;
use crate::sim::messages::{LoadScene, Pocketed};
use crate::window::WindowSystems;

/// Loudness of the run and of the knock beside the sounds of the table.
const RUN: f32 = 0.20;
const KNOCK: f32 = 0.10;
/// Seconds of falling before a ball meets those that lie in its pocket.
const FALL: Duration = Duration::from_millis(170);

/// The sound of a ball coming back.
#[derive(Resource, Default)]
struct Gully(Handle<AudioSource>);

/// Balls that fall: in which pocket, where, until when.
#[derive(Resource, Default)]
struct Falling {
    due: Vec<(Duration, Vec3)>,
    /// How many balls lie in each pocket.
    lying: Vec<usize>,
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Gully>()
        .init_resource::<Falling>()
        .add_systems(Startup, begin.after(super::rolling::begin))
        .add_systems(
            RunFixedMainLoop,
            (empty, fall, knock).chain().in_set(WindowSystems::Present),
        );
}

fn begin(mut gully: ResMut<Gully>, sources: Option<ResMut<Assets<AudioSource>>>) -> Result {
    if let Some(mut sources) = sources {
        let bytes = synthesis::ball_return()?.into();
        gully.0 = sources.add(AudioSource { bytes });
    }
    Ok(())
}

/// A table that is laid out anew has empty pockets.
fn empty(mut scenes: MessageReader<LoadScene>, mut falling: ResMut<Falling>) {
    if scenes.read().count() > 0 {
        falling.lying.clear();
        falling.due.clear();
    }
}

/// A ball goes into a pocket.
fn fall(
    mut commands: Commands,
    mut pocketed: MessageReader<Pocketed>,
    mut falling: ResMut<Falling>,
    settings: Res<Settings>,
    gully: Res<Gully>,
    time: Res<Time<Real>>,
) {
    let level = settings.volume.audible(SoundKind::Pockets);
    for Pocketed(event) in pocketed.read() {
        let EventKind::Pocketed { pocket, .. } = event.kind else {
            continue;
        };
        let place = event.first.before.position.as_vec3();
        if settings.table == TableStyle::Classic {
            if falling.drops_on_another(pocket) {
                falling.due.push((time.elapsed() + FALL, place));
            }
            continue;
        }
        if level > 0.0 {
            commands.spawn(voice(
                &gully.0,
                RUN * level,
                place,
                time.elapsed() + synthesis::RETURN,
            ));
        }
    }
}

impl Falling {
    /// Counts a ball in a pocket; whether another lies there already.
    fn drops_on_another(&mut self, pocket: usize) -> bool {
        if self.lying.len() <= pocket {
            self.lying.resize(pocket + 1, 0);
        }
        self.lying[pocket] += 1;
        self.lying[pocket] > 1
    }
}

/// A ball meets another in its pocket.
fn knock(
    mut commands: Commands,
    mut falling: ResMut<Falling>,
    sounds: Res<Sounds>,
    settings: Res<Settings>,
    time: Res<Time<Real>>,
) {
    let now = time.elapsed();
    if falling.due.iter().all(|(due, _)| *due > now) {
        return;
    }
    let level = settings.volume.audible(SoundKind::Pockets);
    let knock = sounds.handles.iter().find(|(one, _)| *one == Sound::Balls);
    falling.due.retain(|(due, place)| {
        let meets = *due <= now;
        if let Some((_, [softest, ..])) = knock.filter(|_| meets && level > 0.0) {
            let until = now + 2 * synthesis::LENGTH;
            commands.spawn(voice(softest, KNOCK * level, *place, until));
        }
        !meets
    });
}

fn voice(source: &Handle<AudioSource>, loudness: f32, at: Vec3, until: Duration) -> impl Bundle {
    (
        AudioPlayer(source.clone()),
        PlaybackSettings::ONCE
            .with_volume(Volume::Linear(loudness))
            .with_spatial(true)
            .with_spatial_scale(SpatialScale::new(super::ROOM)),
        Transform::from_translation(at),
        Voice { until },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_second_ball_in_a_pocket_meets_another() {
        let mut falling = Falling::default();
        assert!(!falling.drops_on_another(3));
        assert!(!falling.drops_on_another(0));
        assert!(falling.drops_on_another(3));
    }
}
