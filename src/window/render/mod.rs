//! The picture: table, balls, cue, lamps, guides, trails. Everything is generated; nothing is loaded.

mod balls;
mod cue;
mod guides;
mod lines;
mod paint;
mod plan;
mod preview;
pub(super) mod quality;
mod room;
mod solid;
mod stage;
mod studio;
mod table;
mod trails;
mod twin;

use bevy::ecs::message::MessageUpdateSystems;
use bevy::prelude::*;

use crate::window::WindowSystems;
use quality::RenderQuality;

/// The order within [`WindowSystems::Present`].
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Drawing {
    /// The room and its lamps.
    Room,
    /// The table is rebuilt if it changed.
    Table,
    /// Balls are put where they are.
    Balls,
    /// Shaders are told what stands where.
    Stage,
    /// The cue stick.
    Cue,
    /// Aim line and ghost ball.
    Guides,
    /// Paths of the shot being aimed.
    Preview,
    /// Paths of the last shot.
    Trails,
}

pub(super) fn plugin(app: &mut App) {
    let order = || {
        (
            Drawing::Room,
            Drawing::Table,
            Drawing::Balls,
            Drawing::Stage,
            Drawing::Cue,
            Drawing::Guides,
            Drawing::Preview,
            Drawing::Trails,
        )
            .chain()
    };
    app.init_resource::<RenderQuality>()
        .add_systems(First, quality::follow.after(MessageUpdateSystems))
        .configure_sets(Startup, order())
        .configure_sets(RunFixedMainLoop, order().in_set(WindowSystems::Present))
        .configure_sets(Update, order())
        .add_plugins((
            lines::plugin,
            room::plugin,
            stage::plugin,
            table::plugin,
            balls::plugin,
            cue::plugin,
            guides::plugin,
            preview::plugin,
            trails::plugin,
            twin::plugin,
        ));
}
