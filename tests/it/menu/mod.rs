//! The menu and the settings, driven as a person drives them: with keys alone, with the pointer, with a gamepad.

mod halves;
mod match_page;
mod pad;
mod settings;
mod table;
mod tricks;

use bevy::input::ButtonState;
use bevy::input::keyboard::{Key, KeyboardInput, NativeKey};
use bevy::prelude::*;
use bevy_egui::egui::output::OutputEvent;
use bevy_egui::{EguiContext, EguiInput, EguiOutput, PrimaryEguiContext, egui};
use leafwing_input_manager::prelude::ActionState;
use masse::game::settings::Settings;
use masse::window::action::Action;
use masse::window::language::{LANGUAGES, Language};
use masse::window::page::{Open, PageId, Pages, Screen};

use super::window::blind;

/// The size of the screen that the panels are laid out on, in points.
const SIZE: egui::Vec2 = egui::vec2(1000.0, 640.0);

/// The windowed program, a few frames old.
fn app() -> App {
    let mut app = blind();
    // The camera, and with it the panels, come with the first frame.
    app.update();
    for _ in 0..3 {
        step(&mut app);
    }
    app
}

/// One frame.
fn step(app: &mut App) {
    for_input(app, |input| {
        input.screen_rect = Some(egui::Rect::from_min_size(egui::Pos2::ZERO, SIZE));
    });
    app.update();
}

/// Goes on until something holds.
fn until(app: &mut App, what: &str, holds: impl Fn(&mut App) -> bool) {
    for _ in 0..3000 {
        if holds(app) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(4));
        step(app);
    }
    panic!("it never happened: {what}");
}

/// Some frames in which what was laid out comes to be drawn.
fn settle(app: &mut App) {
    for _ in 0..6 {
        std::thread::sleep(std::time::Duration::from_millis(12));
        step(app);
    }
}

fn for_input(app: &mut App, mut change: impl FnMut(&mut egui::RawInput)) {
    let world = app.world_mut();
    let mut inputs = world.query_filtered::<&mut EguiInput, With<PrimaryEguiContext>>();
    change(&mut inputs.single_mut(world).expect("there is one context").0);
}

/// What the panels hear of a key.
fn panel_key(code: KeyCode) -> Option<egui::Key> {
    Some(match code {
        KeyCode::Tab => egui::Key::Tab,
        KeyCode::Enter => egui::Key::Enter,
        KeyCode::Escape => egui::Key::Escape,
        KeyCode::Space => egui::Key::Space,
        KeyCode::ArrowRight => egui::Key::ArrowRight,
        KeyCode::ArrowLeft => egui::Key::ArrowLeft,
        KeyCode::ArrowDown => egui::Key::ArrowDown,
        _ => return None,
    })
}

/// A key goes down or up, as the program and as the panels see it.
fn key(app: &mut App, code: KeyCode, state: ButtonState) {
    app.world_mut().write_message(KeyboardInput {
        key_code: code,
        logical_key: Key::Unidentified(NativeKey::Unidentified),
        state,
        text: None,
        repeat: false,
        window: Entity::PLACEHOLDER,
    });
    if let Some(key) = panel_key(code) {
        for_input(app, |input| {
            input.events.push(egui::Event::Key {
                key,
                physical_key: None,
                pressed: state == ButtonState::Pressed,
                repeat: false,
                modifiers: egui::Modifiers::NONE,
            });
        });
    }
    step(app);
}

/// Presses a key and lets it go.
fn press(app: &mut App, code: KeyCode) {
    key(app, code, ButtonState::Pressed);
    key(app, code, ButtonState::Released);
    step(app);
}

/// What the widget that got the focus last is called, if one got it in the last frame.
fn focused_now(app: &mut App) -> Option<String> {
    let world = app.world_mut();
    let mut outputs = world.query_filtered::<&EguiOutput, With<PrimaryEguiContext>>();
    let output = outputs.single(world).expect("there is one context");
    let events = output.platform_output.events.iter();
    events.rev().find_map(|event| match event {
        OutputEvent::FocusGained(info) => info.label.clone(),
        _ => None,
    })
}

/// Moves the focus with Tab until it is on what is called so; says whether it is.
fn tab_to(app: &mut App, name: &str) -> bool {
    for _ in 0..400 {
        key(app, KeyCode::Tab, ButtonState::Pressed);
        if focused_now(app).is_some_and(|label| label == name) {
            key(app, KeyCode::Tab, ButtonState::Released);
            return true;
        }
        key(app, KeyCode::Tab, ButtonState::Released);
    }
    false
}

/// Chooses what is called so with Tab and Enter.
fn choose(app: &mut App, name: &str) {
    assert!(tab_to(app, name), "{name} is not reached with Tab");
    press(app, KeyCode::Enter);
}

/// Where what has the focus lies.
fn focused_place(app: &mut App) -> egui::Rect {
    let world = app.world_mut();
    let mut contexts = world.query_filtered::<&mut EguiContext, With<PrimaryEguiContext>>();
    let mut context = contexts.single_mut(world).expect("there is one context");
    let context = context.get_mut();
    let id = context.memory(egui::Memory::focused);
    let response = id.and_then(|id| context.read_response(id));
    response.expect("something has the focus").rect
}

fn screen(app: &App) -> Screen {
    *app.world().resource::<State<Screen>>().get()
}

fn page(app: &App) -> Option<PageId> {
    app.world().resource::<Open>().page()
}

fn is_pressed(app: &mut App, action: Action) -> bool {
    let world = app.world_mut();
    let mut states = world.query::<&ActionState<Action>>();
    states.single(world).expect("one player").pressed(&action)
}

#[test]
fn every_page_is_laid_out_in_every_language_at_every_size() {
    let mut app = app();
    let ids: Vec<PageId> = [PageId::MAIN, PageId::SETTINGS]
        .into_iter()
        .flat_map(|id| {
            let below = app.world().resource::<Pages>().below(id);
            std::iter::once(id).chain(below.map(|page| page.id))
        })
        .collect();
    assert!(ids.len() > 8, "{ids:?}");
    for language in LANGUAGES {
        for scale in [0.75, 3.0] {
            let mut settings = app.world_mut().resource_mut::<Settings>();
            settings.language = Some(language.code.to_owned());
            settings.scale = scale;
            for id in &ids {
                app.world_mut().resource_mut::<Open>().go(*id);
                step(&mut app);
                step(&mut app);
                assert_eq!(page(&app), Some(*id), "{}", language.code);
                assert_eq!(screen(&app), Screen::Menu);
                app.world_mut().resource_mut::<Open>().close();
                step(&mut app);
            }
        }
        assert_eq!(app.world().resource::<Language>().code(), language.code);
    }
}
