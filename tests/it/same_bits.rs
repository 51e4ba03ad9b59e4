//! The same bits: one number a built-in scene and solver, whoever computes it - on 1, 2 or 8 threads, in frames of any
//! length, built for debugging or for release, on any platform, after saving and loading.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

use masse::physics::ball::{Motion, State};
use masse::physics::exact::{Engine, Limits, Recorder, Saved, solve};
use masse::physics::record::Record;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::scenarios::library;
use masse::sim::saved::{SavedTable, restore, save};
use masse::sim::stepped::crowd::Crowd;
use masse::sim::stepping::{headless_app, states, step, try_run_to_rest};

/// Longest stretch of a scene that counts, s; of a crowd, ticks.
const LONGEST: f64 = 10.0;
const CROWD_TICKS: u32 = 60;

/// A number over all bits that go in: FNV-1a.
struct Bits(u64);

impl Bits {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn word(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    fn number(&mut self, number: f64) {
        self.word(number.to_bits());
    }

    fn text(&mut self, text: &str) {
        text.bytes().for_each(|byte| self.word(u64::from(byte)));
    }

    fn state(&mut self, state: &State) {
        for vector in [state.position, state.velocity, state.angular_velocity] {
            vector
                .to_array()
                .into_iter()
                .for_each(|number| self.number(number));
        }
        let motion: Motion = state.motion;
        self.text(&format!("{motion:?}"));
    }
}

fn of_record(record: &Record) -> u64 {
    let mut bits = Bits::new();
    for event in &record.events {
        bits.number(event.time);
        bits.text(&format!("{:?}", event.kind));
        bits.number(event.impulse);
        for one in event.participants() {
            bits.word(one.ball as u64);
            bits.state(&one.before);
            bits.state(&one.after);
        }
    }
    for state in &record.end {
        bits.state(state);
    }
    bits.number(record.end_time);
    bits.0
}

fn of_states(states: &[State]) -> u64 {
    let mut bits = Bits::new();
    for state in states {
        bits.state(state);
    }
    bits.0
}

fn crowd(scene: &Scene, threads: usize) -> u64 {
    let mut app = headless_app(scene);
    app.world_mut().resource_mut::<Crowd>().threads = Some(threads);
    step(&mut app, CROWD_TICKS);
    of_states(&states(&mut app))
}

/// Every built-in scene by every solver that can play it.
fn scenes() -> Vec<(String, Scene)> {
    let mut scenes = Vec::new();
    for built_in in library::BUILT_IN {
        let mut scene = built_in
            .scenario()
            .unwrap_or_else(|error| panic!("{error}"))
            .scene;
        scene.time_limit = scene.time_limit.min(LONGEST);
        let own = scene.solver;
        let stepped = match own {
            Solver::Exact => Solver::Stepped(Stepped::default()),
            stepped @ Solver::Stepped(_) => stepped,
        };
        let few = !own.is_crowd();
        for (name, solver) in [("exact", Solver::Exact), ("stepped", stepped)] {
            scene.solver = solver;
            if scene.check().is_ok() && (few || name == "stepped") {
                scenes.push((format!("{} {name}", built_in.name), scene.clone()));
            }
        }
    }
    scenes
}

fn bits_of(name: &str, scene: &Scene) -> u64 {
    if scene.solver.is_crowd() {
        return crowd(scene, 1);
    }
    match scene.solver {
        Solver::Exact => of_record(
            &solve(scene, Limits::default()).unwrap_or_else(|error| panic!("{name}: {error}")),
        ),
        Solver::Stepped(_) => {
            let played = try_run_to_rest(scene);
            of_record(
                &played
                    .unwrap_or_else(|failed| panic!("{name}: {failed:?}"))
                    .0,
            )
        }
    }
}

fn file() -> PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/same_bits.txt")
}

const LEGITIMATE: &str = "\
    Bits may change when a law, a solver, a preset or the scene itself was changed on purpose; say so in the commit, and run\n\
    MASSE_UPDATE_BITS=1 cargo test --release same_bits\n\
    which writes tests/data/same_bits.txt anew. They must not change from one platform, build, number of threads or frame\n\
    rate to another: that is a fault to be found, and no reason to update.";

#[test]
fn every_scene_has_the_bits_on_file() {
    let found: BTreeMap<String, u64> = scenes()
        .into_iter()
        .map(|(name, scene)| (name.clone(), bits_of(&name, &scene)))
        .collect();
    if std::env::var_os("MASSE_UPDATE_BITS").is_some() {
        let mut text = String::new();
        for (name, bits) in &found {
            let _ = writeln!(text, "{name} {bits:016x}");
        }
        std::fs::write(file(), text).expect("the file can be written");
    }
    let text = std::fs::read_to_string(file()).unwrap_or_default();
    let on_file: BTreeMap<&str, &str> = text
        .lines()
        .filter_map(|line| line.rsplit_once(' '))
        .collect();
    let mut wrong = Vec::new();
    for (name, bits) in &found {
        let bits = format!("{bits:016x}");
        match on_file.get(name.as_str()) {
            Some(known) if *known == bits => {}
            Some(known) => wrong.push(format!("{name}: {bits}, on file {known}")),
            None => wrong.push(format!(
                "{name}: {bits}, not on file: a new scene is a reason to update"
            )),
        }
    }
    for name in on_file.keys().filter(|name| !found.contains_key(**name)) {
        wrong.push(format!("{name}: on file, but there is no such scene"));
    }
    assert!(wrong.is_empty(), "\n{}\n{LEGITIMATE}", wrong.join("\n"));
}

#[test]
fn threads_change_no_bit() {
    let scenes = scenes();
    let alone: Vec<u64> = scenes
        .iter()
        .map(|(name, scene)| bits_of(name, scene))
        .collect();
    for threads in [1, 2, 8] {
        // A crowd takes so many threads; the others are played on so many at once.
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads");
        let together: Vec<u64> = pool.install(|| {
            use rayon::prelude::*;
            scenes
                .par_iter()
                .map(|(name, scene)| {
                    if scene.solver.is_crowd() {
                        crowd(scene, threads)
                    } else {
                        bits_of(name, scene)
                    }
                })
                .collect()
        });
        for (((name, _), alone), together) in scenes.iter().zip(&alone).zip(together) {
            assert_eq!(
                *alone, together,
                "{name} on {threads} threads\n{LEGITIMATE}"
            );
        }
    }
}

/// Advances an engine to the end of its scene in frames, saved and restored in every one of them if asked.
fn in_frames(scene: &Scene, rate: f64, saved: bool) -> Vec<State> {
    let mut engine = Engine::new(scene, Limits::default()).expect("a sound scene");
    let mut recorder = Recorder::new(&engine);
    if let Some(planned) = &scene.shot {
        engine
            .strike(planned.ball, &scene.cue, &planned.shot, &mut recorder)
            .expect("a sound shot");
    }
    let frames = (rate * scene.time_limit.min(2.0)) as u32;
    for frame in 1..=frames {
        engine
            .advance(f64::from(frame) / rate, &mut recorder)
            .expect("a sound scene");
        if saved {
            let text = serde_json::to_string(&engine.save()).expect("finite");
            let back: Saved = serde_json::from_str(&text).expect("it was just written");
            engine = Engine::restore(scene, &back, Limits::default()).expect("it was just saved");
        }
    }
    let end = f64::from(frames) / rate;
    engine.advance(end, &mut recorder).expect("a sound scene");
    (0..engine.count()).map(|ball| engine.state(ball)).collect()
}

#[test]
fn frames_and_saving_change_no_bit_of_the_exact_solver() {
    for (name, scene) in scenes()
        .into_iter()
        .filter(|(_, scene)| scene.solver == Solver::Exact)
    {
        let expected = in_frames(&scene, 2.0, false);
        for (rate, saved) in [(24.0, false), (60.0, true), (1000.0, false)] {
            let states = in_frames(&scene, rate, saved);
            assert_eq!(
                of_states(&expected),
                of_states(&states),
                "{name} at {rate} Hz\n{LEGITIMATE}"
            );
        }
    }
}

#[test]
fn saving_changes_no_bit_of_the_live_table() {
    for (name, scene) in scenes()
        .into_iter()
        .filter(|(_, scene)| !scene.solver.is_crowd())
    {
        let mut straight = headless_app(&scene);
        step(&mut straight, 240);
        let mut app = headless_app(&scene);
        for ticks in [1, 30, 209] {
            step(&mut app, ticks);
            let text = serde_json::to_string(&save(app.world_mut())).expect("finite");
            let saved: SavedTable = serde_json::from_str(&text).expect("it was just written");
            app = headless_app(&scene);
            restore(app.world_mut(), &saved).unwrap_or_else(|error| panic!("{name}: {error}"));
        }
        assert_eq!(
            of_states(&states(&mut straight)),
            of_states(&states(&mut app)),
            "{name}, saved after 1, 31 and 240 ticks\n{LEGITIMATE}"
        );
    }
}
