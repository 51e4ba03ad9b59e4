//! The import table. An import only ever points down.

use std::collections::BTreeSet;

use super::tokens::{WrittenPath, paths, tokens};
use super::{Finding, Source, assert_none, module_of, root, sources};

/// Every room and the rooms it may import. A new room needs a row here.
const ROOMS: [(&str, &[&str]); 7] = [
    ("physics", &[]),
    ("kept", &[]),
    ("sim", &["physics"]),
    ("scenarios", &["kept", "physics", "sim"]),
    ("report", &["kept", "physics", "sim"]),
    ("game", &["kept", "physics", "sim"]),
    (
        "window",
        &["kept", "physics", "sim", "scenarios", "report", "game"],
    ),
];

/// What lies above all rooms: it may import every room, and no room may import it.
const ROOF: [&str; 3] = ["lib", "main", "cli"];

/// The only crates that the pure layer may name.
const PURE_CRATES: [&str; 6] = ["glam", "libm", "rand", "rand_chacha", "serde", "thiserror"];

/// Parts of Bevy that draw or sound, or open a window.
const WINDOW_BEVY: [&str; 18] = [
    "anti_alias",
    "audio",
    "camera",
    "core_pipeline",
    "gizmos",
    "gizmos_render",
    "image",
    "light",
    "mesh",
    "pbr",
    "post_process",
    "render",
    "sprite",
    "sprite_render",
    "text",
    "ui",
    "window",
    "winit",
];

/// The children of `window` that their siblings may import: words that all of them share.
const SHARED_CHILDREN: [&str; 3] = ["action", "language", "page"];

/// The crates that the manifest lists.
struct Crates {
    all: BTreeSet<String>,
    /// Those that only the feature `window` brings.
    optional: BTreeSet<String>,
}

impl Crates {
    fn read(manifest: &str) -> Self {
        let mut crates = Self {
            all: BTreeSet::new(),
            optional: BTreeSet::new(),
        };
        let section = manifest
            .split("\n[dependencies]\n")
            .nth(1)
            .unwrap_or_default();
        let section = section.split("\n[").next().unwrap_or_default();
        for line in section.lines() {
            let Some((name, value)) = line.split_once('=') else {
                continue;
            };
            let name = name.trim().replace('-', "_");
            if value.contains("optional = true") {
                crates.optional.insert(name.clone());
            }
            crates.all.insert(name);
        }
        crates
    }
}

fn allowed_rooms(room: &str) -> Option<&'static [&'static str]> {
    ROOMS
        .iter()
        .find(|(name, _)| *name == room)
        .map(|(_, allowed)| *allowed)
}

/// The path from the root of the crate, if it is one inside the crate.
fn absolute(path: &WrittenPath, module: &[String]) -> Option<Vec<String>> {
    let mut at: Vec<String> = module.iter().chain(&path.inside).cloned().collect();
    let mut rest = path.segments.as_slice();
    match rest.first()?.as_str() {
        "crate" | "masse" => return Some(rest[1..].to_vec()),
        "self" => rest = &rest[1..],
        "super" => {
            while rest.first().is_some_and(|segment| segment == "super") {
                at.pop();
                rest = &rest[1..];
            }
        }
        _ => return None,
    }
    at.extend_from_slice(rest);
    Some(at)
}

fn violations(sources: &[Source], crates: &Crates) -> Vec<Finding> {
    let children: BTreeSet<String> = sources
        .iter()
        .map(|source| module_of(&source.path))
        .filter(|module| module.len() > 1 && module[0] == "window")
        .map(|module| module[1].clone())
        .collect();
    let mut findings = Vec::new();
    for source in sources {
        let module = module_of(&source.path);
        let room = module.first().map_or("", String::as_str);
        if ROOF.contains(&room) {
            continue;
        }
        let mut find = |line: usize, what: String| {
            findings.push(Finding {
                path: source.path.clone(),
                line,
                what,
            });
        };
        let Some(allowed) = allowed_rooms(room) else {
            find(1, format!("`{room}` is no room of the import table"));
            continue;
        };
        for path in paths(&tokens(&source.text)) {
            let written = path.segments.join("::");
            let what = match absolute(&path, &module) {
                Some(at) => forbidden_room(room, allowed, &at)
                    .or_else(|| forbidden_sibling(&module, &at, &children)),
                None => forbidden_crate(room, &path.segments, crates),
            };
            if let Some(what) = what {
                find(path.line, format!("`{written}`: {what}"));
            }
        }
    }
    findings
}

fn forbidden_room(room: &str, allowed: &[&str], at: &[String]) -> Option<String> {
    let target = at.first()?.as_str();
    let known = ROOF.contains(&target) || allowed_rooms(target).is_some();
    (known && target != room && !allowed.contains(&target)).then(|| {
        let list = if allowed.is_empty() {
            "no other room".to_owned()
        } else {
            allowed.join(", ")
        };
        format!("`{room}` may not import `{target}`, only {list}")
    })
}

fn forbidden_sibling(
    module: &[String],
    at: &[String],
    children: &BTreeSet<String>,
) -> Option<String> {
    let (own, other) = (module.get(1)?, at.get(1)?);
    let siblings = module[0] == "window" && at[0] == "window" && children.contains(other);
    (siblings && own != other && !SHARED_CHILDREN.contains(&other.as_str())).then(|| {
        format!("`window::{own}` may not import `window::{other}`; they meet in `sim` and `game`")
    })
}

fn forbidden_crate(room: &str, segments: &[String], crates: &Crates) -> Option<String> {
    let name = segments.first()?.as_str();
    if room == "physics" && crates.all.contains(name) && !PURE_CRATES.contains(&name) {
        return Some(format!("`physics` may not name the crate `{name}`"));
    }
    if room == "window" {
        return None;
    }
    if crates.optional.contains(name) {
        return Some(format!("only `window` may name the crate `{name}`"));
    }
    let part = segments.get(1)?.as_str();
    (name == "bevy" && WINDOW_BEVY.contains(&part))
        .then(|| format!("only `window` may use what draws or sounds: `bevy::{part}`"))
}

fn manifest() -> Crates {
    let text = std::fs::read_to_string(root().join("Cargo.toml")).expect("there is a manifest");
    Crates::read(&text)
}

#[test]
fn every_import_points_down() {
    let sources = sources("src");
    assert!(
        sources.len() > 40,
        "only {} files were found",
        sources.len()
    );
    assert_none(&violations(&sources, &manifest()));
}

#[test]
fn the_manifest_is_read() {
    let crates = manifest();
    for name in PURE_CRATES.into_iter().chain(["bevy", "bevy_egui"]) {
        assert!(crates.all.contains(name), "{name}");
    }
    assert!(crates.optional.contains("bevy_egui") && !crates.optional.contains("bevy"));
    assert!(
        !crates.all.contains("proptest"),
        "a dev-dependency is no dependency"
    );
}

/// What the check says of these files, as `path:line`.
fn caught(files: &[(&str, &str)]) -> Vec<String> {
    let sources: Vec<Source> = files
        .iter()
        .map(|(path, text)| Source::new(path, text))
        .collect();
    violations(&sources, &manifest())
        .iter()
        .map(|finding| format!("{}:{}", finding.path, finding.line))
        .collect()
}

#[test]
fn planted_violations_are_caught_with_their_line() {
    let cases = [
        ("src/physics/ball.rs", "\nuse crate::sim::SimPlugin;", 2),
        (
            "src/physics/laws/mod.rs",
            "use crate::{physics::ball, game::aim};",
            1,
        ),
        (
            "src/physics/laws/mod.rs",
            "fn f() {\n    super::super::sim::f();\n}",
            2,
        ),
        (
            "src/physics/ball.rs",
            "mod inner {\n use super::super::super::sim::X;\n}",
            2,
        ),
        ("src/physics/ball.rs", "use bevy::prelude::*;", 1),
        (
            "src/physics/ball.rs",
            "fn f() { bevy::log::info!(\"\"); }",
            1,
        ),
        (
            "src/sim/clock.rs",
            "\n\nuse crate::{\n    physics::ball::Ball,\n    game::aim::Aim,\n};",
            5,
        ),
        ("src/sim/clock.rs", "use crate::window::action;", 1),
        ("src/sim/clock.rs", "use crate::cli::Arguments;", 1),
        ("src/sim/clock.rs", "use bevy_egui::egui;", 1),
        (
            "src/sim/clock.rs",
            "use bevy::{prelude::*, pbr::StandardMaterial};",
            1,
        ),
        ("src/game/aim.rs", "use crate::report::table;", 1),
        ("src/report/mod.rs", "use crate::game;", 1),
        ("src/gadgets/mod.rs", "", 1),
    ];
    for (path, text, line) in cases {
        assert_eq!(
            caught(&[(path, text)]),
            [format!("{path}:{line}")],
            "{text}"
        );
    }
}

#[test]
fn children_of_the_window_may_not_import_each_other() {
    let hud = ("src/window/hud.rs", "");
    let action = ("src/window/action.rs", "");
    for text in [
        "use crate::window::hud::X;",
        "use super::super::hud::X;",
        "use crate::window::{hud};",
    ] {
        let lamp = ("src/window/render/lamp.rs", text);
        assert_eq!(
            caught(&[hud, lamp]),
            ["src/window/render/lamp.rs:1"],
            "{text}"
        );
    }
    let fine = "use crate::window::action::A; use super::cloth; use crate::window::WindowSystems;\n\
                use crate::window::render::felt; use crate::game::aim::Aim; use bevy_egui::egui;";
    let lamp = ("src/window/render/lamp.rs", fine);
    let parent = (
        "src/window/mod.rs",
        "mod hud; use hud::X; use self::hud::Y; use crate::window::hud::Z;",
    );
    assert_eq!(caught(&[hud, action, lamp, parent]), Vec::<String>::new());
}

#[test]
fn what_is_allowed_passes() {
    let files = [
        (
            "src/physics/ball.rs",
            "use glam::DVec3; use super::laws; use std::fmt; use crate::physics::cue;",
        ),
        (
            "src/physics/cue.rs",
            "// use crate::sim;\n/* crate::game::x */ const S: &str = \"crate::window::y\";",
        ),
        (
            "src/sim/mod.rs",
            "use bevy::prelude::*; use crate::physics::ball::Ball; use crate::sim::clock;",
        ),
        (
            "src/game/aim.rs",
            "use crate::{physics, sim::{clock, messages::Strike}}; use bevy::ecs::x;",
        ),
        ("src/main.rs", "use masse::window::X; use clap::Parser;"),
        (
            "src/cli/run.rs",
            "use crate::game::x; use crate::report::y;",
        ),
    ];
    assert_eq!(caught(&files), Vec::<String>::new());
}
