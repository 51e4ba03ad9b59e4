//! What is played on and with: presets, tables, and how the table looks.

use bevy::prelude::*;
use bevy_egui::egui;

use super::rows;
use crate::game::equip::{ChoosePreset, PresetInUse};
use crate::game::practice::PracticeCommand;
use crate::game::settings::{ClothColour, Settings, TableStyle, Wood};
use crate::physics::table::Preset;
use crate::scenarios::preset;
use crate::sim::playfield::Playfield;
use crate::window::language::Language;
use crate::window::page::{AddPages, Open, Page, PageId};

pub(super) fn plugin(app: &mut App) {
    app.add_page(
        Page {
            id: PageId::EQUIPMENT,
            title: "equipment-title",
            place: Some((PageId::MAIN, 20)),
        },
        show,
    );
}

#[expect(clippy::too_many_arguments, reason = "everything that can be chosen")]
fn show(
    InMut(ui): InMut<egui::Ui>,
    language: Res<Language>,
    playfield: Res<Playfield>,
    in_use: Res<PresetInUse>,
    mut settings: ResMut<Settings>,
    mut open: ResMut<Open>,
    mut choose: MessageWriter<ChoosePreset>,
    mut commands: MessageWriter<PracticeCommand>,
) {
    rows::heading(ui, language.text("equipment-presets"));
    ui.label(language.text("equipment-presets-hint"));
    ui.horizontal_wrapped(|ui| {
        for asset in preset::BUILT_IN {
            let chosen = in_use.0.as_deref() == Some(asset.name);
            let key = format!("preset-{}", asset.name.replace('_', "-"));
            let name = language.find(&key).unwrap_or(asset.name);
            if ui.selectable_label(chosen, name).clicked() {
                choose.write(ChoosePreset(asset.name.to_owned()));
                open.close();
            }
        }
    });
    rows::heading(ui, language.text("equipment-tables"));
    ui.horizontal_wrapped(|ui| {
        for table in &Preset::NAMED {
            let chosen = table.table() == playfield.table;
            if ui
                .selectable_label(chosen, language.text(table_key(table)))
                .clicked()
            {
                commands.write(PracticeCommand::Table(*table));
                open.close();
            }
        }
    });
    rows::heading(ui, language.text("equipment-look"));
    look(ui, &language, settings.reborrow());
}

/// How the table looks: its style, its cloth, its wood. A style brings its own wood, which can be changed.
pub(super) fn look(ui: &mut egui::Ui, language: &Language, mut settings: Mut<Settings>) {
    let mut wish = (settings.table, settings.cloth, settings.wood);
    let styles = TableStyle::ALL.map(|style| (style, language.text(style_key(style)).to_owned()));
    rows::choice(ui, language.text("equipment-style"), &mut wish.0, styles);
    let cloths = ClothColour::ALL.map(|cloth| (cloth, language.text(cloth_key(cloth)).to_owned()));
    rows::choice(ui, language.text("equipment-cloth"), &mut wish.1, cloths);
    let woods = Wood::ALL.map(|wood| (wood, language.text(wood_key(wood)).to_owned()));
    rows::choice(ui, language.text("equipment-wood"), &mut wish.2, woods);
    if wish.0 != settings.table {
        wish.2 = wish.0.wood();
    }
    if wish != (settings.table, settings.cloth, settings.wood) {
        (settings.table, settings.cloth, settings.wood) = wish;
    }
}

fn style_key(style: TableStyle) -> &'static str {
    match style {
        TableStyle::Classic => "table-style-classic",
        TableStyle::Modern => "table-style-modern",
        TableStyle::BarBox => "table-style-bar-box",
    }
}

fn cloth_key(cloth: ClothColour) -> &'static str {
    match cloth {
        ClothColour::Tournament => "cloth-tournament",
        ClothColour::Green => "cloth-green",
        ClothColour::Blue => "cloth-blue",
        ClothColour::Burgundy => "cloth-burgundy",
        ClothColour::Grey => "cloth-grey",
        ClothColour::Red => "cloth-red",
        ClothColour::Camel => "cloth-camel",
    }
}

fn wood_key(wood: Wood) -> &'static str {
    match wood {
        Wood::Mahogany => "wood-mahogany",
        Wood::Oak => "wood-oak",
        Wood::Ebony => "wood-ebony",
    }
}

fn table_key(table: &Preset) -> &'static str {
    match table {
        Preset::NineFoot => "table-nine-foot",
        Preset::EightFoot => "table-eight-foot",
        Preset::SevenFoot => "table-seven-foot",
        Preset::Snooker => "table-snooker",
        Preset::Carom => "table-carom",
        Preset::Box { .. } => "table-box",
    }
}
