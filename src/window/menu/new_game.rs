//! Games to begin: racks to practise with, scenes, and what others add.

use bevy::prelude::*;
use bevy_egui::egui;

use super::rows;
use crate::game::equip::OpenScene;
use crate::game::practice::PracticeCommand;
use crate::physics::scene::Rack;
use crate::scenarios::library;
use crate::window::language::Language;
use crate::window::page::{AddPages, Mode, Modes, Open, Page, PageId};

/// What a player types.
#[derive(Resource, Debug, Default)]
struct Typed(String);

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Typed>().add_page(
        Page {
            id: PageId::NEW_GAME,
            title: "new-game-title",
            place: Some((PageId::MAIN, 10)),
        },
        show,
    );
    for (rack, title) in [
        (Rack::EightBall, "rack-eight-ball"),
        (Rack::NineBall, "rack-nine-ball"),
    ] {
        app.add_mode(
            Mode {
                group: "new-game-practice",
                title: title.to_owned(),
                name: String::new(),
                about: None,
            },
            move |mut commands: MessageWriter<PracticeCommand>| {
                commands.write(PracticeCommand::Rack(rack));
            },
        );
    }
    for scene in library::BUILT_IN {
        app.add_mode(
            Mode {
                group: "new-game-scenes",
                title: format!("scene-{}", scene.name),
                name: scene.title().unwrap_or_default(),
                about: None,
            },
            move |mut scenes: MessageWriter<OpenScene>| {
                scenes.write(OpenScene {
                    name: scene.name.to_owned(),
                    play: true,
                });
            },
        );
    }
}

fn show(
    InMut(ui): InMut<egui::Ui>,
    language: Res<Language>,
    modes: Res<Modes>,
    mut typed: ResMut<Typed>,
    mut open: ResMut<Open>,
    mut scenes: MessageWriter<OpenScene>,
    mut commands: Commands,
) {
    let mut group = "";
    for (mode, begin) in &modes.0 {
        if mode.group != group {
            group = mode.group;
            rows::heading(ui, language.text(group));
        }
        let name = language.find(&mode.title).unwrap_or(&mode.name);
        let mut button =
            ui.add(egui::Button::new(name).min_size(egui::vec2(ui.available_width(), 0.0)));
        if let Some(about) = mode.about {
            button = button.on_hover_text(language.text(about));
        }
        if button.clicked() {
            commands.run_system(*begin);
            open.close();
        }
    }
    rows::heading(ui, language.text("new-game-own"));
    ui.horizontal(|ui| {
        let field = egui::TextEdit::singleline(&mut typed.0)
            .hint_text(language.text("new-game-own-hint"))
            .desired_width(320.0);
        let entered = ui.add(field).lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
        let name = typed.0.trim();
        let load = egui::Button::new(language.text("load"));
        let load = ui.add_enabled(!name.is_empty(), load).clicked();
        if (load || entered) && !name.is_empty() {
            scenes.write(OpenScene {
                name: name.to_owned(),
                play: true,
            });
            open.close();
        }
    });
}
