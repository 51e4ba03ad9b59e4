//! Keys and pointer become aim, camera input, strokes and practice commands.
//!
//! Keys are left alone while somebody types into a panel, and a drag that begins on a panel never reaches the table.

mod drag;
mod keys;
mod motion;
mod place;
mod replay;
mod stroke;
mod table;
mod view;

use bevy::prelude::*;
use bevy_egui::input::{EguiWantsInput, egui_wants_any_keyboard_input};
use leafwing_input_manager::prelude::ActionState;

use crate::game::lift;
use crate::game::turns::may_strike;
use crate::sim::stepped::crowd::is_crowd;
use crate::window::WindowSystems;
use crate::window::action::Action;

/// What the player holds down.
type Actions<'w, 's> = Single<'w, 's, &'static ActionState<Action>>;

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<drag::Grip>()
        .init_resource::<motion::Motion>()
        .init_resource::<stroke::Cueing>()
        .init_resource::<keys::HeldKey>()
        .init_resource::<place::Wish>()
        .add_systems(
            PreUpdate,
            (
                (
                    (
                        replay::command,
                        table::command,
                        table::put_down,
                        keys::aim.run_if(may_strike),
                        place::by_keys,
                        stroke::ask
                            .run_if(not_stroking.and_then(not(replay::is_on)))
                            .run_if(may_strike),
                    )
                        .chain()
                        .run_if(not(is_crowd)),
                    view::switch,
                )
                    .chain()
                    .run_if(not(egui_wants_any_keyboard_input)),
                motion::follow,
                drag::grip,
                drag::look,
                view::fast_forward,
                // A crowd is watched, not played.
                (
                    drag::wheel,
                    drag::aim.run_if(may_strike),
                    drag::place,
                    lift::raise,
                    stroke::by_hand,
                    stroke::swing,
                )
                    .chain()
                    .run_if(not(is_crowd)),
            )
                .chain()
                .in_set(WindowSystems::Input),
        );
}

fn not_stroking(cueing: Res<stroke::Cueing>) -> bool {
    cueing.is_idle()
}

/// Whether the pointer belongs to a panel.
fn on_panel(egui: &EguiWantsInput) -> bool {
    egui.wants_any_pointer_input()
}

/// How much finer than usual the player wants to be: 1, 0.1, 0.01 or 0.001.
fn fineness(actions: &ActionState<Action>) -> f64 {
    let factor = |action, factor| {
        if actions.pressed(&action) {
            factor
        } else {
            1.0
        }
    };
    factor(Action::Fine, 0.1) * factor(Action::VeryFine, 0.01)
}
