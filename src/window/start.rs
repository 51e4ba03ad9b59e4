//! How long the start takes, phase by phase, and how much memory the program then has: `masse play --time-start`.

use std::collections::BTreeMap;
use std::fs;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

use bevy::prelude::*;
use bevy::render::render_resource::PipelineCache;
use bevy::render::{Render, RenderApp, RenderSystems};

/// Frames with everything there that are drawn before the program ends.
const SETTLED: u32 = 5;

/// What the renderer has done: frames, and how many of the last ones lacked no shader.
#[derive(Resource, Clone, Default)]
struct Drawn {
    frames: Arc<AtomicU32>,
    whole: Arc<AtomicU32>,
}

/// The phases so far, each with the time since the program began.
#[derive(Resource)]
struct Phases {
    begun: Instant,
    list: Vec<(&'static str, Duration)>,
}

impl Phases {
    fn reached(&mut self, phase: &'static str) {
        if self.list.iter().all(|(known, _)| *known != phase) {
            self.list.push((phase, self.begun.elapsed()));
        }
    }
}

/// Times the start of this program, which began then; prints the phases when everything is there, and ends it.
pub(super) fn time(app: &mut App, begun: Instant) {
    let drawn = Drawn::default();
    app.insert_resource(Phases {
        begun,
        list: Vec::new(),
    })
    .insert_resource(drawn.clone())
    .add_systems(PreStartup, |mut phases: ResMut<Phases>| {
        phases.reached("adapter found, plugins built, window asked for");
    })
    .add_systems(PostStartup, |mut phases: ResMut<Phases>| {
        phases.reached("meshes and textures made");
    })
    .add_systems(Last, follow);
    app.world_mut()
        .resource_mut::<Phases>()
        .reached("app put together");
    if let Some(renderer) = app.get_sub_app_mut(RenderApp) {
        renderer
            .insert_resource(drawn)
            .add_systems(Render, count.in_set(RenderSystems::Cleanup));
    }
}

fn count(drawn: Res<Drawn>, pipelines: Res<PipelineCache>) {
    drawn.frames.fetch_add(1, Ordering::Relaxed);
    if pipelines.waiting_pipelines().next().is_none() {
        drawn.whole.fetch_add(1, Ordering::Relaxed);
    } else {
        drawn.whole.store(0, Ordering::Relaxed);
    }
}

/// Notes what has been reached; the table answers from the first frame that has been drawn on.
fn follow(drawn: Res<Drawn>, mut phases: ResMut<Phases>, mut exit: MessageWriter<AppExit>) {
    phases.reached("first frame of the table worked out: it answers");
    if drawn.frames.load(Ordering::Relaxed) > 0 {
        phases.reached("first frame drawn, as far as there are shaders");
    }
    if drawn.whole.load(Ordering::Relaxed) < SETTLED {
        return;
    }
    phases.reached("every shader compiled, five whole frames drawn");
    let mut before = 0.0;
    for (phase, at) in &phases.list {
        let at = at.as_secs_f64();
        println!("{at:7.3} s  +{:6.3}  {phase}", at - before);
        before = at;
    }
    tell_memory();
    exit.write(AppExit::Success);
}

/// Prints the resident memory, and whose it is as far as the system tells.
fn tell_memory() {
    let maps = fs::read_to_string("/proc/self/smaps").unwrap_or_default();
    let mut shares: BTreeMap<&str, u64> = BTreeMap::new();
    let mut owner = "";
    for line in maps.lines() {
        let mut words = line.split_whitespace();
        let first = words.next().unwrap_or_default();
        if first.contains('-') && !first.ends_with(':') {
            owner = of(words.nth(4).unwrap_or_default());
        } else if first == "Rss:" {
            let size = words.next().and_then(|size| size.parse::<u64>().ok());
            *shares.entry(owner).or_default() += size.unwrap_or(0);
        }
    }
    let all: u64 = shares.values().sum();
    println!("resident memory {} MiB", all / 1024);
    for (owner, size) in shares {
        println!("  {:5} MiB  {owner}", size / 1024);
    }
}

/// To whom a mapping of the process belongs.
fn of(path: &str) -> &'static str {
    let driver = [
        "vulkan", "LLVM", "gallium", "swrast", "libGL", "nvidia", "dri",
    ];
    if driver.iter().any(|name| path.contains(name)) {
        "files of the graphics driver"
    } else if path.contains("memfd") || path.contains("/dev/") {
        "buffers shared with the driver or the screen"
    } else if path == "[heap]" || path.is_empty() || path.contains("[anon") {
        "heap of the program and of the driver"
    } else {
        "the program, its libraries, stacks"
    }
}
