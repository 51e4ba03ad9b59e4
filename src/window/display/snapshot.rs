//! A picture of a scene without a window: for tests, and for whoever wants one.

use std::sync::{Arc, Mutex};

use bevy::app::PluginsState;
use bevy::camera::RenderTarget;
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy::render::render_resource::TextureFormat;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};

use crate::game::settings::Settings;
use crate::game::view::{CameraInput, CameraMode, View};
use crate::physics::scene::Scene;
use crate::sim::playfield::lay_out;
use crate::window::display::{NoDisplay, off_screen};

/// A picture with the camera it was taken with.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Red, green, blue, alpha of every pixel, row by row from the top; sRGB.
    pub pixels: Vec<u8>,
    clip_from_world: Mat4,
}

impl Picture {
    /// The pixel that shows a point of the world, if it lies within the picture. What stands in front of it is not asked.
    #[must_use]
    pub fn pixel_of(&self, point: DVec3) -> Option<(u32, u32)> {
        let clip = self.clip_from_world * point.as_vec3().extend(1.0);
        let place = 0.5 + 0.5 * Vec2::new(clip.x, -clip.y) / clip.w;
        let inside = clip.w > 0.0 && place.min_element() >= 0.0 && place.max_element() < 1.0;
        inside.then(|| {
            let at = place * Vec2::new(self.width as f32, self.height as f32);
            (at.x as u32, at.y as u32)
        })
    }

    /// Red, green and blue of a pixel.
    #[must_use]
    pub fn colour(&self, (x, y): (u32, u32)) -> [u8; 3] {
        let first = 4 * (y * self.width + x) as usize;
        [0, 1, 2].map(|channel| self.pixels[first + channel])
    }
}

/// Frames after which every pipeline is there and a picture has come back from the graphics card.
pub(super) const PATIENCE: u32 = 60;

/// Frames after which there is something to see.
pub(super) const WARM: u32 = 3;

/// An app with this scene on its table, whose cameras draw into an image of this size. It has not drawn yet.
pub(super) fn set_up(
    scene: &Scene,
    (width, height): (u32, u32),
) -> Result<(App, Handle<Image>), NoDisplay> {
    let mut app = off_screen()?;
    let image = Image::new_target_texture(width, height, TextureFormat::Rgba8UnormSrgb, None);
    let target = app.world_mut().resource_mut::<Assets<Image>>().add(image);
    let to_target = target.clone();
    app.add_observer(move |added: On<Add, Camera3d>, mut commands: Commands| {
        commands
            .entity(added.entity)
            .insert(RenderTarget::Image(to_target.clone().into()));
    });
    lay_out(app.world_mut(), scene);
    while app.plugins_state() == PluginsState::Adding {
        bevy::tasks::tick_global_task_pools_on_main_thread();
    }
    app.finish();
    app.cleanup();
    Ok((app, target))
}

/// Draws a scene once, with nothing moving, from one of the views after this input.
///
/// # Errors
/// [`NoDisplay`] if there is no graphics adapter.
pub fn picture(
    scene: &Scene,
    (width, height): (u32, u32),
    camera: CameraMode,
    input: &[CameraInput],
) -> Result<Picture, NoDisplay> {
    picture_with(scene, (width, height), camera, input, &Settings::default())
}

/// The same with these settings: how fine, which table, which cloth.
///
/// # Errors
/// [`NoDisplay`] if there is no graphics adapter.
pub fn picture_with(
    scene: &Scene,
    (width, height): (u32, u32),
    camera: CameraMode,
    input: &[CameraInput],
    settings: &Settings,
) -> Result<Picture, NoDisplay> {
    let (mut app, target) = set_up(scene, (width, height))?;
    app.insert_resource(settings.clone());
    // However long drawing takes, no time goes by on the table.
    app.world_mut().resource_mut::<Time<Virtual>>().pause();
    app.world_mut().resource_mut::<View>().camera = camera;
    app.world_mut().write_message_batch(input.iter().copied());
    for _ in 0..WARM {
        app.update();
    }

    let taken: Arc<Mutex<Option<Image>>> = Arc::default();
    let keep = taken.clone();
    app.world_mut().spawn(Screenshot::image(target)).observe(
        move |captured: On<ScreenshotCaptured>| {
            if let Ok(mut taken) = keep.lock() {
                *taken = Some(captured.image.clone());
            }
        },
    );
    for _ in 0..PATIENCE {
        app.update();
        let image = taken.lock().ok().and_then(|mut taken| taken.take());
        if let Some(pixels) = image.and_then(|image| image.data) {
            return Ok(Picture {
                width,
                height,
                pixels,
                clip_from_world: clip_from_world(app.world_mut()),
            });
        }
    }
    Err(NoDisplay::Adapter)
}

fn clip_from_world(world: &mut World) -> Mat4 {
    let mut cameras = world.query::<(&Camera, &GlobalTransform)>();
    cameras
        .iter(world)
        .next()
        .map_or(Mat4::IDENTITY, |(camera, place)| {
            camera.clip_from_view() * place.to_matrix().inverse()
        })
}
