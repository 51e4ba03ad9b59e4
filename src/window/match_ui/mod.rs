//! A match on the screen: how it is begun, the score, what the referee says, calls, choices and the cue ball in hand.
//!
//! Rules and turns know nothing of this: it reads [`Turns`](crate::game::turns::Turns) and writes
//! [`TurnCommand`](crate::game::turns::TurnCommand).

mod area;
mod call;
mod new_match;
mod report;
mod score;
mod speaker;

use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;
use bevy_egui::input::egui_wants_any_keyboard_input;

use crate::window::WindowSystems;
use crate::window::page::Screen;

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<call::Pointing>()
        .add_plugins((new_match::plugin, report::plugin))
        .add_systems(
            PreUpdate,
            (
                call::point.in_set(WindowSystems::Input),
                // The cue has been turned by then.
                call::by_key
                    .run_if(in_state(Screen::Table))
                    .run_if(not(egui_wants_any_keyboard_input))
                    .after(WindowSystems::Input)
                    .before(WindowSystems::Scenes),
            ),
        )
        .add_systems(FixedPostUpdate, speaker::speak)
        .add_systems(
            RunFixedMainLoop,
            (area::draw, call::mark)
                .chain()
                .in_set(WindowSystems::Present),
        )
        .add_systems(
            EguiPrimaryContextPass,
            score::show.in_set(WindowSystems::Match),
        );
}
