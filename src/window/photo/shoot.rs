//! Takes the picture: a second camera looks through the same lens onto a larger film, without panels.

use std::sync::Mutex;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use bevy::camera::RenderTarget;
use bevy::prelude::*;
use bevy::render::render_resource::TextureFormat;
use bevy::render::renderer::RenderDevice;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use bevy::tasks::IoTaskPool;
use bevy::window::PrimaryWindow;
use leafwing_input_manager::prelude::ActionState;

use crate::game::Keeping;
use crate::game::equip::Told;
use crate::game::saying::Saying;
use crate::game::view::FirstEye;
use crate::window::RenderQuality;
use crate::window::action::Action;
use crate::window::language::Language;
use crate::window::photo::{Photo, file, lens};

/// Frames after which everything is drawn.
const FRAMES: u32 = 4;

/// How long the end of the program waits for a picture that is being written.
const LONGEST: Duration = Duration::from_secs(20);

/// A picture is wanted.
#[derive(Message, Clone, Copy, Debug)]
pub(super) struct Shoot;

/// A picture being taken.
#[derive(Component)]
pub(super) struct Film {
    image: Handle<Image>,
    frames: u32,
}

/// What comes back from the tasks that write the files.
#[derive(Resource)]
struct Darkroom {
    to: Sender<Result<String, String>>,
    from: Mutex<Receiver<Result<String, String>>>,
    /// Pictures that are taken, and of which nothing has come back yet.
    developing: usize,
}

pub(super) fn plugin(app: &mut App) {
    let (to, from) = channel();
    app.add_message::<Shoot>()
        .insert_resource(Darkroom {
            to,
            from: Mutex::new(from),
            developing: 0,
        })
        .add_systems(
            Update,
            (press.run_if(super::is_on), load, wait, hear).chain(),
        )
        .add_systems(
            Last,
            // It changes nothing but what is told at the end: whatever runs beside it.
            finish
                .run_if(on_message::<AppExit>)
                .in_set(Keeping)
                .ambiguous_with_all(),
        );
}

/// The key that strikes takes the picture.
fn press(
    actions: Single<&ActionState<Action>>,
    egui: Res<bevy_egui::input::EguiWantsInput>,
    mut shoot: MessageWriter<Shoot>,
) {
    if actions.just_pressed(&Action::Strike) && !egui.wants_any_keyboard_input() {
        shoot.write(Shoot);
    }
}

/// Puts a film of the size that is wanted behind a second lens.
#[expect(clippy::too_many_arguments, reason = "everything a camera has")]
fn load(
    mut commands: Commands,
    mut wanted: MessageReader<Shoot>,
    mut photo: ResMut<Photo>,
    mut images: ResMut<Assets<Image>>,
    quality: Res<RenderQuality>,
    language: Res<Language>,
    device: Option<Res<RenderDevice>>,
    window: Query<&Window, With<PrimaryWindow>>,
    cameras: Query<(&GlobalTransform, &Projection), With<FirstEye>>,
    films: Query<(), With<Film>>,
) {
    if wanted.read().count() == 0 || !films.is_empty() {
        return;
    }
    let (Some(window), Some((place, projection))) = (window.iter().next(), cameras.iter().next())
    else {
        return;
    };
    let size = photo.lens.multiple.max(1) * window.physical_size().max(UVec2::ONE);
    let most = device.map_or(4096, |device| device.limits().max_texture_dimension_2d);
    if size.max_element() > most {
        let values = [
            ("width", size.x.into()),
            ("height", size.y.into()),
            ("most", most.into()),
        ];
        photo.news = Some((language.with("photo-too-large", &values), true));
        return;
    }
    let image = images.add(Image::new_target_texture(
        size.x,
        size.y,
        TextureFormat::Rgba8UnormSrgb,
        None,
    ));
    let mut camera = commands.spawn((
        Film {
            image: image.clone(),
            frames: 0,
        },
        Camera3d::default(),
        Camera {
            order: -1,
            ..default()
        },
        RenderTarget::Image(image.into()),
        projection.clone(),
        place.compute_transform(),
        lens::grading(&photo.lens),
    ));
    if let Some(mut depth) = lens::depth_of_field(&photo.lens, *quality) {
        // The same blur beside the same things.
        depth.max_circle_of_confusion_diameter *= photo.lens.multiple as f32;
        camera.insert((bevy::camera::Hdr, depth));
    }
    photo.news = Some((language.text("photo-developing").to_owned(), false));
}

/// Once everything is drawn, has the picture brought back, and takes the camera away.
fn wait(mut commands: Commands, mut films: Query<(Entity, &mut Film)>) {
    for (entity, mut film) in &mut films {
        film.frames += 1;
        if film.frames == FRAMES {
            commands
                .spawn(Screenshot::image(film.image.clone()))
                .observe(develop);
        }
        if film.frames > 2 * FRAMES {
            commands.entity(entity).despawn();
        }
    }
}

/// Writes the file, beside the game.
fn develop(captured: On<ScreenshotCaptured>, mut darkroom: ResMut<Darkroom>) {
    let (image, to) = (captured.image.clone(), darkroom.to.clone());
    darkroom.developing += 1;
    IoTaskPool::get()
        .spawn(async move {
            let size = (image.width(), image.height());
            let kept = file::folder()
                .and_then(|folder| file::keep(&folder, size, &image.data.unwrap_or_default()));
            // Nobody listens any more when the game has ended.
            let _ = to.send(match kept {
                Ok(path) => Ok(path.display().to_string()),
                Err(error) => Err(error.to_string()),
            });
        })
        .detach();
}

/// Tells where the picture is, or why it is not.
fn hear(mut darkroom: ResMut<Darkroom>, language: Res<Language>, mut photo: ResMut<Photo>) {
    let Darkroom {
        from, developing, ..
    } = darkroom.bypass_change_detection();
    let Ok(from) = from.get_mut() else {
        return;
    };
    while let Ok(kept) = from.try_recv() {
        *developing -= 1;
        photo.news = Some(match kept {
            Ok(file) => (
                language.with("photo-saved", &[("file", file.into())]),
                false,
            ),
            Err(reason) => (
                language.with("photo-failed", &[("reason", reason.into())]),
                true,
            ),
        });
    }
}

/// The program ends when every picture that was taken is kept, or cannot be.
fn finish(mut darkroom: ResMut<Darkroom>, mut told: MessageWriter<Told>) {
    let Darkroom {
        from, developing, ..
    } = &mut *darkroom;
    let Ok(from) = from.get_mut() else {
        return;
    };
    while *developing > 0 {
        let Ok(kept) = from.recv_timeout(LONGEST) else {
            return;
        };
        *developing -= 1;
        if let Err(reason) = kept {
            let english = format!("The picture could not be kept: {reason}");
            told.write(Told {
                text: Saying::new("photo-failed", &[("reason", &reason)], english),
                is_failure: true,
            });
        }
    }
}
