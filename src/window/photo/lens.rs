//! The free camera: where it is, how it is turned, what is sharp.

use bevy::camera::Hdr;
use bevy::post_process::dof::{DepthOfField, DepthOfFieldMode};
use bevy::prelude::*;
use bevy::render::view::ColorGrading;
use bevy_egui::input::EguiWantsInput;
use leafwing_input_manager::prelude::ActionState;

use crate::game::view::FirstEye;
use crate::sim::components::Radius;
use crate::window::RenderQuality;
use crate::window::action::Action;
use crate::window::felt;
use crate::window::photo::Photo;
use crate::window::photo::shoot::Film;

/// Walking speed, m/s, and turning speed, rad/s.
const WALK: f32 = 0.6;
const TURN: f32 = 0.9;
/// Turn for a pixel of the pointer, rad.
const PER_PIXEL: f32 = 0.0022;

/// What the player has set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lens {
    /// Where the eye is; none until it has taken over from the camera of the game.
    pub eye: Option<Vec3>,
    /// Turn about the vertical, upwards, and about the line of sight, rad.
    pub yaw: f32,
    pub pitch: f32,
    pub roll: f32,
    /// Vertical field of view, rad.
    pub fov: f32,
    /// Whether what is in the middle is sharp.
    pub auto_focus: bool,
    /// Distance at which things are sharp, m.
    pub focus: f32,
    /// Aperture in f-stops; none makes everything sharp.
    pub stop: Option<f32>,
    /// Brighter by so many stops.
    pub exposure: f32,
    /// Size of the file beside the window.
    pub multiple: u32,
}

impl Default for Lens {
    fn default() -> Self {
        Self {
            eye: None,
            yaw: 0.0,
            pitch: 0.0,
            roll: 0.0,
            fov: 0.75,
            auto_focus: true,
            focus: 1.0,
            stop: Some(1.4),
            exposure: 0.0,
            multiple: 2,
        }
    }
}

impl Lens {
    fn rotation(&self) -> Quat {
        Quat::from_rotation_y(self.yaw)
            * Quat::from_rotation_x(self.pitch)
            * Quat::from_rotation_z(self.roll)
    }
}

/// Moves the camera by the actions that aim and look, which have nothing to aim at now.
pub(super) fn steer(
    actions: Single<&ActionState<Action>>,
    egui: Res<EguiWantsInput>,
    time: Res<Time<Real>>,
    mut photo: ResMut<Photo>,
) {
    let lens = &mut photo.lens;
    let Some(eye) = lens.eye else { return };
    if egui.wants_any_keyboard_input() {
        return;
    }
    let way = |less, more| {
        f32::from(u8::from(actions.pressed(&more))) - f32::from(u8::from(actions.pressed(&less)))
    };
    let fine = if actions.pressed(&Action::Fine) {
        0.15
    } else {
        1.0
    };
    let step = fine * felt(&time).as_secs_f32();
    lens.yaw -= TURN * step * way(Action::AimLeft, Action::AimRight);
    lens.yaw -= TURN * step * way(Action::LookLeft, Action::LookRight);
    lens.pitch += TURN * step * way(Action::PowerDown, Action::PowerUp);
    lens.pitch += TURN * step * way(Action::LookDown, Action::LookUp);
    lens.roll += TURN * step * way(Action::NextBallRight, Action::NextBallLeft);
    lens.fov *= 1.0 + step * way(Action::ZoomIn, Action::ZoomOut);
    let level = Quat::from_rotation_y(lens.yaw);
    let walk = level
        * Vec3::new(
            way(Action::SideLeft, Action::SideRight),
            0.0,
            way(Action::ElevationUp, Action::ElevationDown),
        )
        + Vec3::Y * way(Action::HeightDown, Action::HeightUp);
    let mut eye = eye + WALK * step * walk;
    if !egui.wants_any_pointer_input() {
        let moved = actions.axis_pair(&Action::Move);
        if actions.pressed(&Action::Drag) || actions.pressed(&Action::Look) {
            let per_pixel = fine * PER_PIXEL * lens.fov;
            lens.yaw += per_pixel * moved.x;
            lens.pitch += per_pixel * moved.y;
        }
        let wheel = actions.value(&Action::PowerWheel);
        eye += lens.rotation() * Vec3::NEG_Z * (0.08 * fine * wheel);
    }
    lens.pitch = lens.pitch.clamp(-1.55, 1.55);
    lens.fov = lens.fov.clamp(0.08, 1.9);
    // Not through the cloth, and not out of sight of the table.
    eye.y = eye.y.max(0.012);
    lens.eye = Some(eye.clamp_length_max(25.0));
}

/// Puts the camera where the lens is, and its film behind it.
pub(super) fn look(
    mut commands: Commands,
    mut photo: ResMut<Photo>,
    quality: Res<RenderQuality>,
    balls: Query<(&GlobalTransform, &Radius)>,
    mut cameras: Query<
        (Entity, &mut Transform, &mut Projection, &mut Camera),
        (With<FirstEye>, Without<Film>),
    >,
) {
    let lens = &mut photo.lens;
    for (entity, mut transform, mut projection, mut camera) in &mut cameras {
        let Projection::Perspective(perspective) = &mut *projection else {
            continue;
        };
        let eye = *lens.eye.get_or_insert_with(|| {
            let (yaw, pitch, _) = transform.rotation.to_euler(EulerRot::YXZ);
            // There are no panels any more to look past.
            let half = 1.0 / camera.clip_from_view().y_axis.y.max(1e-3);
            (lens.yaw, lens.pitch, lens.fov) = (yaw, pitch, 2.0 * libm::atanf(half));
            transform.translation
        });
        *transform = Transform::from_translation(eye).with_rotation(lens.rotation());
        perspective.fov = lens.fov;
        if camera.sub_camera_view.is_some() {
            camera.sub_camera_view = None;
        }
        if lens.auto_focus {
            let ray = Ray3d::new(eye, transform.forward());
            let spheres = balls
                .iter()
                .map(|(place, radius)| (place.translation(), radius.0 as f32));
            lens.focus = distance(ray, spheres);
        }
        let mut camera = commands.entity(entity);
        camera.insert(grading(lens));
        match depth_of_field(lens, *quality) {
            Some(depth) => camera.insert((Hdr, depth)),
            None => camera.remove::<DepthOfField>(),
        };
    }
}

/// Brightness of the whole picture, what shines by itself included.
pub(super) fn grading(lens: &Lens) -> ColorGrading {
    let mut grading = ColorGrading::default();
    grading.global.exposure = lens.exposure;
    grading
}

/// What is sharp and how blurred the rest is.
pub(super) fn depth_of_field(lens: &Lens, quality: RenderQuality) -> Option<DepthOfField> {
    lens.stop.map(|stop| DepthOfField {
        mode: if quality >= RenderQuality::High {
            DepthOfFieldMode::Bokeh
        } else {
            DepthOfFieldMode::Gaussian
        },
        focal_distance: lens.focus,
        aperture_f_stops: stop,
        max_circle_of_confusion_diameter: 72.0,
        max_depth: 30.0,
        ..default()
    })
}

/// Leaves the camera as the game knows it.
pub(super) fn put_away(camera: &mut EntityCommands, quality: RenderQuality) {
    if quality == RenderQuality::Low {
        camera.remove::<Hdr>();
    }
    camera
        .remove::<DepthOfField>()
        .insert(ColorGrading::default());
}

/// How far away what a ray meets first is: a ball, or the level of the cloth; in m.
fn distance(ray: Ray3d, balls: impl Iterator<Item = (Vec3, f32)>) -> f32 {
    let cloth = -ray.origin.y / ray.direction.y.min(-1e-4);
    balls
        .filter_map(|(center, radius)| {
            let way = center - ray.origin;
            let along = way.dot(*ray.direction);
            let depth = radius * radius - way.length_squared() + along * along;
            (depth > 0.0 && along > 0.0).then(|| along - depth.sqrt())
        })
        .fold(cloth, f32::min)
        .clamp(0.05, 30.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_in_the_middle_is_sharp() {
        let ray = Ray3d::new(
            Vec3::new(0.0, 0.3, 1.0),
            Dir3::new(Vec3::new(0.0, -0.3, -1.0)).expect("not zero"),
        );
        let cloth = distance(ray, std::iter::empty());
        assert!((cloth - Vec2::new(0.3, 1.0).length()).abs() < 1e-5);
        let ball = (Vec3::new(0.0, 0.15, 0.5), 0.03);
        assert!((distance(ray, [ball].into_iter()) - (0.5 * cloth - 0.03)).abs() < 1e-4);
        let beside = (Vec3::new(0.3, 0.15, 0.5), 0.03);
        assert_eq!(distance(ray, [beside].into_iter()), cloth);
    }

    #[test]
    fn a_closed_lens_blurs_nothing() {
        let lens = Lens {
            stop: None,
            ..Lens::default()
        };
        assert!(depth_of_field(&lens, RenderQuality::Ultra).is_none());
    }
}
