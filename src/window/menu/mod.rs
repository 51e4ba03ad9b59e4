//! The menu over the table: the pages that are hung up in [`page`](crate::window::page), laid out one at a time.
//!
//! Everything in it is reached with the pointer, with Tab or arrows and Enter, or with a gamepad.

mod equipment;
mod main_page;
mod new_game;
mod pad;
mod rows;
mod settings;

use bevy::prelude::*;
use bevy_egui::input::EguiWantsInput;
use bevy_egui::{EguiContext, EguiContexts, EguiPrimaryContextPass, PrimaryEguiContext, egui};
use leafwing_input_manager::prelude::ActionState;

use crate::game::settings::Settings;
use crate::window::WindowSystems;
use crate::window::action::Action;
use crate::window::language::{Language, letters};
use crate::window::page::{Open, Page, PageId, Pages, Screen, Show};

/// Width of a page in points.
const WIDTH: f32 = 520.0;
/// Height in points of what stands above and below a page.
const FRAME: f32 = 130.0;

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Laid>()
        .add_plugins((
            main_page::plugin,
            new_game::plugin,
            equipment::plugin,
            settings::plugin,
        ))
        .add_systems(OnEnter(Screen::Menu), pause)
        .add_systems(OnExit(Screen::Menu), go_on)
        .add_systems(
            PreUpdate,
            (pad::steer, close)
                .chain()
                .run_if(in_state(Screen::Menu).and_then(not(settings::is_asking)))
                .in_set(WindowSystems::Menu),
        )
        .add_systems(
            EguiPrimaryContextPass,
            (
                suit.before(WindowSystems::Ui),
                show.in_set(WindowSystems::Menu),
            ),
        );
}

/// Letters grow beyond their usual size only as long as the window holds so much beside them, in points.
const LEAST_WINDOW: egui::Vec2 = egui::vec2(480.0, 300.0);

/// Letters and panels as large as the player wants them and the window can hold, and as still.
fn suit(
    mut contexts: EguiContexts,
    settings: Res<Settings>,
    mut has_letters: Local<bool>,
) -> Result {
    let scales = Settings::SCALES;
    let scale = settings.scale.clamp(*scales.start(), *scales.end());
    let context = contexts.ctx_mut()?;
    if !std::mem::replace(&mut *has_letters, true) {
        context.set_fonts(letters::fonts());
    }
    let window = context.viewport_rect().size() * context.zoom_factor() / LEAST_WINDOW;
    context.set_zoom_factor(scale.min(window.min_elem().max(1.0)));
    let fading = if settings.reduced_motion {
        0.0
    } else {
        egui::Style::default().animation_time
    };
    if context.global_style().animation_time.to_bits() != fading.to_bits() {
        context.all_styles_mut(|style| style.animation_time = fading);
    }
    Ok(())
}

fn pause(settings: Res<Settings>, mut time: ResMut<Time<Virtual>>) {
    if settings.pause_in_menu {
        time.pause();
    }
}

fn go_on(mut time: ResMut<Time<Virtual>>) {
    time.unpause();
}

/// Back by one page.
fn close(
    actions: Single<&ActionState<Action>>,
    mut contexts: EguiContexts,
    egui: Res<EguiWantsInput>,
    mut open: ResMut<Open>,
) {
    let typing = contexts
        .ctx_mut()
        .is_ok_and(|context| context.text_edit_focused());
    if actions.just_pressed(&Action::Close) && !egui.is_popup_open() && !typing {
        open.back();
    }
}

/// What was laid out last: a page that opens gets the focus, and a widget that gets the focus is scrolled to.
#[derive(Resource, Default)]
struct Laid {
    page: Option<(PageId, usize)>,
    /// Whether nothing on the page has had the focus yet.
    wants_focus: bool,
    focus: Option<egui::Id>,
}

/// Lays out the page that is open.
fn show(world: &mut World) {
    let open = world.resource::<Open>();
    let at = open.page().map(|page| (page, open.depth()));
    let before = std::mem::replace(&mut world.resource_mut::<Laid>().page, at);
    let Some((id, depth)) = at else { return };
    let Some((page, show)) = world.resource::<Pages>().get(id) else {
        world.resource_mut::<Open>().back();
        return;
    };
    let mut contexts = world.query_filtered::<&mut EguiContext, With<PrimaryEguiContext>>();
    let Ok(context) = contexts
        .single_mut(world)
        .map(|mut context| context.get_mut().clone())
    else {
        return;
    };
    let mut laid = world.resource_mut::<Laid>();
    if before != at {
        laid.wants_focus = true;
        context.memory_mut(egui::Memory::stop_text_input);
    }
    // A page that has just been opened may take a frame until anything on it can have the focus.
    if laid.wants_focus {
        laid.wants_focus = context.memory(egui::Memory::focused).is_none();
        if laid.wants_focus {
            context.memory_mut(|memory| memory.move_focus(egui::FocusDirection::Next));
        }
    }
    egui::Modal::new(egui::Id::new("menu"))
        .backdrop_color(egui::Color32::from_black_alpha(110))
        .show(&context, |ui| frame(ui, world, &page, show, depth));
}

/// Heading, page, way back.
fn frame(ui: &mut egui::Ui, world: &mut World, page: &Page, show: Show, depth: usize) {
    let language = world.resource::<Language>().clone();
    let room = ui.ctx().content_rect().size();
    ui.set_width(WIDTH.min(room.x - 60.0));
    ui.vertical_centered(|ui| ui.heading(language.text(page.title)));
    ui.separator();
    egui::ScrollArea::vertical()
        .id_salt(page.id.0)
        .max_height(room.y - FRAME)
        // At once as high as it needs to be, not by and by.
        .min_scrolled_height(room.y - FRAME)
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            if let Err(error) = world.run_system_with(show, ui) {
                ui.label(error.to_string());
            }
            follow_focus(ui, &mut world.resource_mut::<Laid>());
        });
    // A click while a control is asked for is the answer: nothing else may be there to be clicked.
    if page.id == PageId::MAIN || settings::asks(world) {
        return;
    }
    ui.separator();
    ui.horizontal(|ui| {
        if ui.button(language.text("menu-back")).clicked() {
            world.resource_mut::<Open>().back();
        }
        if depth > 1 && ui.button(language.text("menu-resume")).clicked() {
            world.resource_mut::<Open>().close();
        }
    });
}

/// Scrolls to what has got the focus.
fn follow_focus(ui: &mut egui::Ui, laid: &mut Laid) {
    let focus = ui.memory(egui::Memory::focused);
    if focus == laid.focus {
        return;
    }
    laid.focus = focus;
    if let Some(response) = focus.and_then(|id| ui.ctx().read_response(id)) {
        ui.scroll_to_rect(response.rect.expand(12.0), None);
    }
}
