//! A picture of two halves: the second camera comes and goes, and each draws into its half.

use bevy::camera::{RenderTarget, Viewport};
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;

use super::eye;
use crate::game::view::{Beside, FirstEye, View};
use crate::sim::playfield::Playfield;

/// Pixels between the halves.
const GAP: u32 = 4;

/// The camera that draws the other half.
#[derive(Component)]
pub(super) struct SecondEye;

/// Opens and closes the second eye: the first time it comes to be, from then on it sleeps while it is not wanted.
pub(super) fn open(
    mut commands: Commands,
    view: Res<View>,
    playfield: Res<Playfield>,
    first: Single<(Option<&RenderTarget>, &Camera), With<FirstEye>>,
    mut second: Query<&mut Camera, (With<SecondEye>, Without<FirstEye>)>,
) {
    // A crowd is too much to be drawn twice.
    let wanted = view.beside != Beside::Nothing && !playfield.solver.is_crowd();
    match second.single_mut() {
        Err(_) if wanted => {
            let (target, camera) = *first;
            let mut second = commands.spawn((
                eye("second camera"),
                SecondEye,
                Camera {
                    order: camera.order + 1,
                    ..default()
                },
            ));
            if let Some(target) = target {
                second.insert(target.clone());
            }
        }
        Ok(mut eye) if eye.is_active != wanted => eye.is_active = wanted,
        _ => {}
    }
}

/// Gives each eye its half: side by side in a wide picture, one above the other in a tall one.
pub(super) fn share(
    mut first: Single<&mut Camera, (With<FirstEye>, Without<SecondEye>)>,
    mut second: Query<&mut Camera, With<SecondEye>>,
) {
    let awake = second.single_mut().ok().filter(|eye| eye.is_active);
    let Some(mut other) = awake else {
        if first.viewport.is_some() {
            first.viewport = None;
        }
        return;
    };
    let Some(size) = first.physical_target_size() else {
        return;
    };
    let [left, right] = halves(size);
    for (camera, (position, size)) in [(&mut **first, left), (&mut *other, right)] {
        let now = camera.viewport.as_ref();
        let same =
            now.is_some_and(|now| (now.physical_position, now.physical_size) == (position, size));
        if !same {
            camera.viewport = Some(Viewport {
                physical_position: position,
                physical_size: size,
                ..default()
            });
        }
    }
}

/// Corner and size of both halves in pixels.
fn halves(size: UVec2) -> [(UVec2, UVec2); 2] {
    let is_wide = size.x >= size.y;
    let long = if is_wide { size.x } else { size.y };
    let each = (long.saturating_sub(GAP) / 2).max(1);
    let from = long.saturating_sub(each);
    let (shape, second) = if is_wide {
        (UVec2::new(each, size.y), UVec2::new(from, 0))
    } else {
        (UVec2::new(size.x, each), UVec2::new(0, from))
    };
    let shape = shape.max(UVec2::ONE);
    [(UVec2::ZERO, shape), (second, shape)]
}

/// Which half the pointer is over.
#[derive(SystemParam)]
pub(super) struct Under<'w, 's> {
    windows: Query<'w, 's, &'static Window, With<PrimaryWindow>>,
    second: Query<'w, 's, &'static Camera, With<SecondEye>>,
}

impl Under<'_, '_> {
    /// Whether it is over that of the second eye.
    pub(super) fn is_second(&self) -> bool {
        let at = self.windows.single().ok().and_then(Window::cursor_position);
        let half = self.second.single().ok().filter(|eye| eye.is_active);
        let half = half.and_then(Camera::logical_viewport_rect);
        at.zip(half).is_some_and(|(at, half)| half.contains(at))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_halves_are_alike_lie_within_the_picture_and_do_not_meet() {
        for (x, y) in [
            (1280, 720),
            (1281, 720),
            (400, 900),
            (401, 901),
            (2, 2),
            (1, 1),
        ] {
            let size = UVec2::new(x, y);
            let [(a, shape), (b, other)] = halves(size);
            assert_eq!(shape, other);
            assert_eq!(a, UVec2::ZERO);
            assert!(
                (b + other).cmple(size).all() || size.max_element() < 6,
                "{size}"
            );
            if size.min_element() > 100 {
                let apart = b.max_element() - shape[usize::from(x < y)];
                assert!((GAP..=GAP + 1).contains(&apart), "{size}: {apart}");
            }
        }
    }
}
