//! Two systems that touch the same data must have an order: an ambiguity in any schedule is an error.

use bevy::ecs::schedule::{LogLevel, ScheduleBuildSettings, Schedules};
use bevy::prelude::*;
use masse::game::GamePlugin;
use masse::physics::laws::Laws;
use masse::physics::scene::Scene;
use masse::physics::table::Preset;
use masse::sim::{SimPlugin, playfield};

/// Makes every schedule of the app refuse to be built with an ambiguity.
pub fn forbid_ambiguities(app: &mut App) {
    let mut schedules = app.world_mut().resource_mut::<Schedules>();
    for (_, schedule) in schedules.iter_mut() {
        schedule.set_build_settings(ScheduleBuildSettings {
            ambiguity_detection: LogLevel::Error,
            ..default()
        });
    }
}

fn headless() -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, SimPlugin, GamePlugin));
    app
}

#[test]
fn headless_app_has_no_ambiguity_in_any_schedule() {
    let mut app = headless();
    forbid_ambiguities(&mut app);
    app.finish();
    app.cleanup();
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    scene.place("cue", masse::physics::ball::Ball::POOL, 0.0, 0.0);
    scene.balls[0].state.velocity.x = 1.0;
    playfield::lay_out(app.world_mut(), &scene);
    for _ in 0..5 {
        app.update();
        app.world_mut().run_schedule(FixedUpdate);
    }
}

#[test]
#[should_panic(expected = "mbigu")]
fn an_unordered_pair_is_caught() {
    fn faster(mut clock: ResMut<masse::sim::clock::Clock>) {
        clock.tick *= 0.5;
    }
    fn slower(mut clock: ResMut<masse::sim::clock::Clock>) {
        clock.tick *= 2.0;
    }
    let mut app = headless();
    app.add_systems(FixedUpdate, (faster, slower));
    forbid_ambiguities(&mut app);
    app.world_mut().run_schedule(FixedUpdate);
}
