//! A window of one pixel, of none, minimised, and larger again, while balls roll and panels are open.

use bevy::prelude::*;
use bevy::window::{PrimaryWindow, WindowOccluded, WindowResized};
use masse::game::view::{Beside, CameraMode, View};
use masse::sim::stepping;
use masse::window::page::{Open, PageId, Pages};

use super::{frame, moves, strike, to_rest};
use crate::window::blind;

/// What a window may become: by hand, by a tiling window manager, minimised.
const SIZES: [(u32, u32); 8] = [
    (1, 1),
    (0, 0),
    (120, 90),
    (1, 2000),
    (4000, 1),
    (320, 240),
    (0, 300),
    (1280, 720),
];

/// The windowed program in a window that nobody sees.
fn app() -> (App, Entity) {
    let mut app = blind();
    let window = Window {
        resolution: (1280, 720).into(),
        ..default()
    };
    let window = app.world_mut().spawn((window, PrimaryWindow)).id();
    for _ in 0..4 {
        frame(&mut app, 1.0 / 60.0);
    }
    (app, window)
}

fn resize(app: &mut App, window: Entity, (width, height): (u32, u32)) {
    let world = app.world_mut();
    let mut held = world.get_mut::<Window>(window).expect("it is there");
    held.resolution.set_physical_resolution(width, height);
    let (width, height) = (held.width(), held.height());
    world.write_message(WindowResized {
        window,
        width,
        height,
    });
    let occluded = width.min(height) < 1.0;
    world.write_message(WindowOccluded { window, occluded });
    for _ in 0..3 {
        frame(app, 1.0 / 60.0);
    }
}

/// What every active camera sees with: its place, its projection and its part of the window.
fn eyes(app: &mut App) -> Vec<(Mat4, Mat4, Option<UVec2>)> {
    let world = app.world_mut();
    let mut cameras = world.query_filtered::<(&Camera, &GlobalTransform), With<Camera3d>>();
    let cameras = cameras.iter(world).filter(|(camera, _)| camera.is_active);
    cameras
        .map(|(camera, place)| {
            let part = camera.viewport.as_ref().map(|part| part.physical_size);
            (place.to_matrix(), camera.clip_from_view(), part)
        })
        .collect()
}

fn check(app: &mut App, size: (u32, u32), what: &str) {
    let eyes = eyes(app);
    assert!(!eyes.is_empty(), "{what}");
    for (place, lens, part) in eyes {
        assert!(
            place.is_finite() && lens.is_finite(),
            "{what}: {place} {lens}"
        );
        assert!(lens.determinant() != 0.0, "{what}: {lens}");
        // Of nothing there are no parts.
        let none = size.0 == 0 || size.1 == 0;
        let room = part.is_none_or(|part| part.min_element() > 0);
        assert!(none || room, "{what}: a part of the window of no size");
    }
}

#[test]
fn a_shot_rolls_on_while_the_window_becomes_anything() {
    let ends = |sizes: &[(u32, u32)]| {
        let (mut app, window) = app();
        let first = eyes(&mut app);
        strike(&mut app);
        frame(&mut app, 1.0 / 60.0);
        for size in sizes {
            assert!(moves(&app));
            resize(&mut app, window, *size);
            check(&mut app, *size, &format!("{size:?}"));
        }
        let end = to_rest(&mut app);
        resize(&mut app, window, (1280, 720));
        assert_eq!(first.len(), eyes(&mut app).len());
        end
    };
    assert_eq!(ends(&SIZES), ends(&[]));
}

#[test]
fn every_view_and_every_page_survives_a_window_of_no_size() {
    let (mut app, window) = app();
    let besides = [
        Beside::Nothing,
        Beside::Laws,
        Beside::Camera(CameraMode::Overhead),
    ];
    let cameras = [
        CameraMode::BehindCue,
        CameraMode::Overhead,
        CameraMode::Orbit,
    ];
    for beside in besides {
        for camera in cameras {
            let mut view = app.world_mut().resource_mut::<View>();
            (view.beside, view.camera) = (beside, camera);
            let what = |size| format!("{camera:?} {beside:?} {size:?}");
            for size in SIZES {
                resize(&mut app, window, size);
                check(&mut app, size, &what(size));
            }
            let whole = eyes(&mut app);
            resize(&mut app, window, (1280, 720));
            assert_eq!(eyes(&mut app).len(), whole.len());
        }
    }
    let ids: Vec<PageId> = [PageId::MAIN, PageId::SETTINGS]
        .into_iter()
        .flat_map(|id| {
            let below = app.world().resource::<Pages>().below(id);
            std::iter::once(id).chain(below.map(|page| page.id))
        })
        .collect();
    let lies = stepping::states(&mut app);
    for id in ids {
        app.world_mut().resource_mut::<Open>().go(id);
        for size in SIZES {
            resize(&mut app, window, size);
            assert_eq!(app.world().resource::<Open>().page(), Some(id), "{size:?}");
        }
        app.world_mut().resource_mut::<Open>().close();
        frame(&mut app, 1.0 / 60.0);
    }
    assert_eq!(stepping::states(&mut app), lies);
}
