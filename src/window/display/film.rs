//! A shot frame by frame, without a window: for whoever makes a video of it.

use std::sync::mpsc;

use bevy::prelude::*;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use bevy::time::TimeUpdateStrategy;
use thiserror::Error;

use crate::game::aim::Aim;
use crate::game::replay::{Playback, Replay};
use crate::game::settings::{Quality, Settings};
use crate::game::twin::{self, Twin, TwinLaws};
use crate::game::view::{Beside, CameraMode, SceneCameras, View};
use crate::physics::record::Record;
use crate::physics::scene::Scene;
use crate::sim::clock::Clock;
use crate::sim::play::play;
use crate::sim::recorder::Recorder;
use crate::window::display::NoDisplay;
use crate::window::display::snapshot::{PATIENCE, WARM, set_up};

/// How long the last picture stays, s: balls that were potted last are seen to fall.
const TAIL: f64 = 0.5;

/// What is filmed, and how.
#[derive(Clone, Debug)]
pub struct Film<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// What happens in it.
    pub record: &'a Record,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// Frames in a second of the film.
    pub fps: f64,
    /// How many times slower than life.
    pub slow: f64,
    /// The first and the last time of the shot, s; the last is the end if there is none.
    pub span: (f64, Option<f64>),
    /// From where it is seen.
    pub camera: CameraMode,
    /// The cameras of the scene.
    pub cameras: SceneCameras,
    /// What stands beside it.
    pub beside: Beside,
    /// Whether the paths are drawn.
    pub trails: bool,
    /// How much work a frame may be.
    pub quality: Quality,
}

/// Why there is no film.
#[derive(Debug, Error)]
pub enum FilmError {
    /// Nothing to draw with.
    #[error(transparent)]
    NoDisplay(#[from] NoDisplay),
    /// The other laws cannot play the shot.
    #[error("the other laws cannot play this: {0}")]
    Twin(String),
    /// A frame did not come back.
    #[error("the graphics driver gave back {got} of {of} frames")]
    Lost {
        /// Frames that came.
        got: u32,
        /// Frames that should have come.
        of: u32,
    },
    /// A frame could not be kept.
    #[error("{0}")]
    Kept(std::io::Error),
}

impl Film<'_> {
    /// Seconds of the shot from one frame to the next.
    fn step(&self) -> f64 {
        1.0 / (self.fps * self.slow)
    }

    /// What the other laws make of the shot, if they are wanted.
    fn twin(&self) -> Result<Option<Record>, FilmError> {
        if self.beside != Beside::Laws {
            return Ok(None);
        }
        let scene = twin::twin_of(self.scene, &self.record.events);
        play(&scene)
            .map(Some)
            .map_err(|error| FilmError::Twin(error.to_string()))
    }

    /// Draws every frame and hands it over, in order: its number from 1, how many there are, and its pixels, sRGB with
    /// alpha, row by row from the top.
    ///
    /// # Errors
    /// [`FilmError`], also if `keep` fails: nothing more is drawn then.
    pub fn take(
        &self,
        mut keep: impl FnMut(u32, u32, Vec<u8>) -> std::io::Result<()>,
    ) -> Result<u32, FilmError> {
        let twin = self.twin()?;
        let twin_end = twin.as_ref().map_or(0.0, |record| record.end_time);
        let end = self
            .span
            .1
            .unwrap_or(self.record.end_time.max(twin_end) + TAIL);
        let seconds = (end - self.span.0).max(0.0);
        let frames = (seconds / self.step() + 1e-9).floor().clamp(0.0, 1e6) as u32 + 1;
        let (mut app, target) = self.ready(twin)?;

        let (sender, receiver) = mpsc::channel();
        let mut kept = 0;
        let mut keep_next = |kept: &mut u32, pixels| {
            *kept += 1;
            keep(*kept, frames, pixels).map_err(FilmError::Kept)
        };
        for frame in 0..frames {
            self.turn_to(&mut app, self.span.0 + f64::from(frame) * self.step());
            let sender = sender.clone();
            let taken = move |captured: On<ScreenshotCaptured>| {
                // Nobody listens any more once the film has failed.
                let _ = sender.send(captured.image.data.clone().unwrap_or_default());
            };
            let screenshot = Screenshot::image(target.clone());
            app.world_mut().spawn(screenshot).observe(taken);
            app.update();
            // Frames come back some frames later, in order.
            for pixels in receiver.try_iter() {
                keep_next(&mut kept, pixels)?;
            }
        }
        let mut patience = 0;
        while kept < frames && patience < PATIENCE {
            app.update();
            for pixels in receiver.try_iter() {
                keep_next(&mut kept, pixels)?;
            }
            patience += 1;
        }
        if kept < frames {
            return Err(FilmError::Lost {
                got: kept,
                of: frames,
            });
        }
        Ok(frames)
    }

    /// An app that shows the first frame.
    fn ready(&self, twin: Option<Record>) -> Result<(App, Handle<Image>), NoDisplay> {
        // Nothing moves on the table by itself: the balls go where the record has them.
        let mut still = self.scene.clone();
        still.shot = None;
        for (ball, path) in still.balls.iter_mut().zip(&self.record.paths) {
            let held = &mut ball.state;
            if let Some(first) = path.first() {
                held.position = first.piece.start.position;
            }
            held.velocity = bevy::math::DVec3::ZERO;
            held.angular_velocity = bevy::math::DVec3::ZERO;
        }
        let (mut app, target) = set_up(&still, self.size)?;
        let world = app.world_mut();
        // Two ticks a frame, so that a frame shows the state at its own time and none between two.
        let tick = 0.5 * self.step();
        world.insert_resource(TimeUpdateStrategy::FixedTimesteps(2));
        let longest = std::time::Duration::from_secs_f64(4.0 * self.step());
        world.resource_mut::<Time<Virtual>>().set_max_delta(longest);
        world.resource_mut::<Settings>().quality = self.quality;
        *world.resource_mut::<View>() = View {
            camera: self.camera,
            beside: self.beside,
            guides: false,
            preview: false,
            trails: self.trails,
        };
        *world.resource_mut::<SceneCameras>() = self.cameras.clone();
        if let Some(record) = twin {
            let mut twin = world.resource_mut::<Twin>();
            twin.laws = TwinLaws::beside(&self.scene.laws);
            twin.record = Some(record);
        }
        for _ in 0..WARM {
            let world = app.world_mut();
            world.resource_mut::<Clock>().tick = tick;
            if let Some(planned) = self.scene.shot {
                *world.resource_mut::<Aim>() = Aim {
                    ball: planned.ball,
                    shot: planned.shot,
                    wish: planned.shot.elevation,
                    draw_back: 0.0,
                };
            }
            app.update();
        }
        app.world_mut().resource_mut::<Replay>().0 = Some(Playback {
            record: self.record.clone(),
            time: self.span.0,
            rate: 1.0,
            playing: false,
            looping: false,
        });
        Ok((app, target))
    }

    /// Turns the replay to a time, and draws the paths up to it.
    fn turn_to(&self, app: &mut App, time: f64) {
        let world = app.world_mut();
        if let Some(playback) = &mut world.resource_mut::<Replay>().0 {
            playback.time = time;
        }
        if self.trails {
            let mut recorder = world.resource_mut::<Recorder>();
            for (ball, trail) in recorder.trails.iter_mut().enumerate() {
                trail.push((time, self.record.state_at(ball, time)));
            }
        }
    }
}
