//! What can be changed while a crowd runs: count, restitution, friction, tilt, tick.

use std::ops::RangeInclusive;

use bevy::prelude::*;
use bevy_egui::egui;

use crate::game::saying::Saying;
use crate::game::scatter::scattered;
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::{BallBallLaw, Friction, Frictional, Frictionless, PeerCap};
use crate::physics::laws::cushion::CushionLaw;
use crate::physics::laws::motion::{Cloth, Incline, MotionLaw};
use crate::physics::laws::restitution::Restitution;
use crate::physics::scene::{Scene, Solver};
use crate::sim::clock::Clock;
use crate::sim::components::{
    AngularVelocity, Mass, MotionKind, Position, Radius, Velocity, ball_and_state,
};
use crate::sim::playfield::Playfield;
use crate::sim::recorder::Recorder;
use crate::window::crowd::numbers;
use crate::window::crowd::scenes::Loading;
use crate::window::language::Language;

/// Balls up to which the laws change while a dial is still being turned: every change sorts the crowd anew.
const AT_ONCE: usize = 20_000;

/// The greatest tilt, degrees.
const STEEPEST: f64 = 30.0;

/// A number that can be turned.
struct Dial {
    /// The key of its name.
    label: &'static str,
    range: RangeInclusive<f64>,
    decimals: usize,
    /// Whether equal ways are equal ratios.
    ratios: bool,
    suffix: &'static str,
    /// Whether it counts while it is still being turned, or only when it is let go of.
    at_once: bool,
}

impl Dial {
    /// A share from zero up.
    fn share(label: &'static str, most: f64, at_once: bool) -> Self {
        Self {
            label,
            range: 0.0..=most,
            decimals: if most < 1.0 { 4 } else { 3 },
            ratios: false,
            suffix: "",
            at_once,
        }
    }

    /// Lays it out, and tells its new value.
    fn show(self, ui: &mut egui::Ui, language: &Language, value: f64) -> Option<f64> {
        let id = ui.id().with(self.label);
        let mut shown = ui.data(|data| data.get_temp(id)).unwrap_or(value);
        ui.label(language.text(self.label));
        ui.spacing_mut().slider_width = 110.0;
        let slider = egui::Slider::new(&mut shown, self.range)
            .clamping(egui::SliderClamping::Edits)
            .update_while_editing(false)
            .logarithmic(self.ratios)
            .max_decimals(self.decimals)
            .suffix(self.suffix);
        let response = ui.add(slider);
        ui.end_row();
        if response.dragged() && !self.at_once {
            ui.data_mut(|data| data.insert_temp(id, shown));
            return None;
        }
        ui.data_mut(|data| data.remove::<f64>(id));
        ((response.drag_stopped() || response.changed()) && shown != value).then_some(shown)
    }
}

/// Lays out the dials. Whether the kind of motion of every ball has to be told anew is returned.
pub(super) fn show(
    ui: &mut egui::Ui,
    playfield: &mut ResMut<Playfield>,
    clock: &mut ResMut<Clock>,
    loading: &mut Loading,
    recorder: &Recorder,
    language: &Language,
    (count, spins): (usize, bool),
) -> bool {
    let at_once = count <= AT_ONCE;
    let mut laws = playfield.laws;
    let mut cloth = !matches!(
        laws.motion,
        MotionLaw::Frictionless | MotionLaw::Inclined(_)
    );
    egui::Grid::new("dials").num_columns(2).show(ui, |ui| {
        if let Some(before) = recorder
            .before
            .as_ref()
            .filter(|scene| scene.shot.is_none())
        {
            let dial = Dial {
                label: "crowd-balls",
                range: 100.0..=1e6,
                decimals: 0,
                ratios: true,
                suffix: "",
                at_once: false,
            };
            if let Some(wish) = dial.show(ui, language, count as f64) {
                again(loading, before, playfield, wish as usize);
            }
        }
        balls(ui, language, &mut laws, at_once, spins);
        tilt(ui, language, &mut laws.motion, at_once);
        if let Some(wish) = rate(ui, language, playfield) {
            set_tick(playfield, clock, wish);
        }
    });
    if ui
        .checkbox(&mut cloth, language.text("crowd-cloth"))
        .changed()
    {
        laws.motion = if cloth {
            MotionLaw::Coulomb(Cloth::default())
        } else {
            MotionLaw::Frictionless
        };
    }
    if let MotionLaw::Inclined(_) = laws.motion {
        ui.label(egui::RichText::new(language.text("crowd-tilted")).weak());
    }
    if let MotionLaw::Coulomb(cloth) = &mut laws.motion {
        egui::Grid::new("cloth").num_columns(2).show(ui, |ui| {
            for (label, value, most) in [
                ("crowd-sliding", &mut cloth.sliding, 1.0),
                ("crowd-rolling", &mut cloth.rolling, 0.1),
            ] {
                if let Some(wish) = Dial::share(label, most, at_once).show(ui, language, *value) {
                    *value = wish;
                }
            }
        });
    }
    if laws == playfield.laws {
        return false;
    }
    let other = std::mem::discriminant(&laws.motion);
    let is_other = other != std::mem::discriminant(&playfield.laws.motion);
    playfield.laws = laws;
    is_other
}

/// How far the table is tilted, along and across, in degrees.
fn tilt(ui: &mut egui::Ui, language: &Language, motion: &mut MotionLaw, at_once: bool) {
    let weight = gravity();
    let slope =
        [motion.pull().x, motion.pull().z].map(|pull| libm::asin(pull / weight).to_degrees());
    for (axis, label) in [(0, "crowd-tilt-along"), (1, "crowd-tilt-across")] {
        let dial = Dial {
            label,
            range: -STEEPEST..=STEEPEST,
            decimals: 1,
            ratios: false,
            suffix: "°",
            at_once,
        };
        if let Some(wish) = dial.show(ui, language, slope[axis]) {
            let mut slope = slope;
            slope[axis] = wish;
            set_tilt(motion, slope);
        }
    }
}

/// Gravity in m/s²: that of a level table, as a tilted one has only its part along the slate.
fn gravity() -> f64 {
    Cloth::default().gravity
}

/// Tilts the table; a tilted one has no cloth, and a level one stays as it is.
fn set_tilt(motion: &mut MotionLaw, slope: [f64; 2]) {
    let [x, z] = slope.map(|angle| gravity() * libm::sin(angle.to_radians()));
    if x != 0.0 || z != 0.0 {
        *motion = MotionLaw::Inclined(Incline { x, z });
    } else if let MotionLaw::Inclined(_) = motion {
        *motion = MotionLaw::Frictionless;
    }
}

/// So many balls as the scene began with, in the background.
fn again(loading: &mut Loading, before: &Scene, playfield: &Playfield, count: usize) {
    let like = Scene {
        laws: playfield.laws,
        solver: playfield.solver,
        ..before.clone()
    };
    loading.begin(numbers::large(count as f64), move || {
        scattered(&like, count, 1).ok_or_else(|| {
            let english = format!("{count} balls have no room here.");
            Saying::new("crowd-no-room", &[("count", &count.to_string())], english)
        })
    });
}

fn balls(ui: &mut egui::Ui, language: &Language, laws: &mut Laws, at_once: bool, spins: bool) {
    let restitution = laws.ball_ball.restitution(0.0);
    if let Some(wish) =
        Dial::share("crowd-restitution", 1.0, at_once).show(ui, language, restitution)
    {
        set_restitution(&mut laws.ball_ball, wish);
    }
    if let CushionLaw::Mirror(mirror) = &mut laws.cushion
        && let Restitution::Constant(value) = &mut mirror.restitution
        && let Some(wish) =
            Dial::share("crowd-cushion-restitution", 1.0, at_once).show(ui, language, *value)
    {
        *value = wish;
    }
    if spins {
        let present = friction(&laws.ball_ball);
        if let Some(wish) = Dial::share("crowd-friction", 0.5, at_once).show(ui, language, present)
        {
            set_friction(&mut laws.ball_ball, wish);
        }
    }
}

fn set_restitution(law: &mut BallBallLaw, value: f64) {
    match law {
        BallBallLaw::Frictionless(law) => law.restitution = value,
        BallBallLaw::Frictional(law) | BallBallLaw::PeerCap(PeerCap(law)) => {
            law.restitution = value;
        }
        BallBallLaw::Mathavan2014(law) => law.restitution = value,
    }
}

/// Friction between balls that hardly slip.
fn friction(law: &BallBallLaw) -> f64 {
    match law {
        BallBallLaw::Frictionless(_) => 0.0,
        BallBallLaw::Frictional(law) | BallBallLaw::PeerCap(PeerCap(law)) => {
            law.friction.coefficient(0.0)
        }
        BallBallLaw::Mathavan2014(law) => law.friction.coefficient(0.0),
    }
}

/// The same friction at every speed; without any the law that knows none.
fn set_friction(law: &mut BallBallLaw, value: f64) {
    let friction = Friction::Constant(value);
    let restitution = law.restitution(0.0);
    match law {
        _ if value == 0.0 => *law = BallBallLaw::Frictionless(Frictionless { restitution }),
        BallBallLaw::Frictionless(_) => {
            *law = BallBallLaw::Frictional(Frictional {
                restitution,
                friction,
            });
        }
        BallBallLaw::Frictional(law) | BallBallLaw::PeerCap(PeerCap(law)) => {
            law.friction = friction;
        }
        BallBallLaw::Mathavan2014(law) => law.friction = friction,
    }
}

fn rate(ui: &mut egui::Ui, language: &Language, playfield: &Playfield) -> Option<f64> {
    let Solver::Stepped(stepped) = playfield.solver else {
        return None;
    };
    let dial = Dial {
        label: "crowd-ticks",
        range: 30.0..=2000.0,
        decimals: 1,
        ratios: true,
        suffix: " /s",
        at_once: false,
    };
    dial.show(ui, language, 1.0 / stepped.tick)
}

/// Another length of the tick; the time of the clock goes on.
fn set_tick(playfield: &mut Playfield, clock: &mut Clock, rate: f64) {
    if let Solver::Stepped(stepped) = &mut playfield.solver {
        stepped.tick = 1.0 / rate;
        clock.ticks = (clock.time() * rate).round() as u64;
        clock.tick = stepped.tick;
    }
}

/// Tells the kind of motion of every ball anew: under another law the same speed is another motion.
pub(super) fn classify(
    playfield: Res<Playfield>,
    mut clock: ResMut<Clock>,
    mut balls: Query<(
        &Position,
        &Velocity,
        Option<&AngularVelocity>,
        &Mass,
        &Radius,
        &mut MotionKind,
    )>,
) {
    for (position, velocity, spin, mass, radius, mut motion) in &mut balls {
        let (ball, state) = ball_and_state(position, velocity, spin, mass, radius, &motion);
        motion.0 = playfield.laws.motion.classify(&ball, state).motion;
        clock.moving |= !motion.0.is_still();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn friction_goes_from_law_to_law_and_keeps_the_restitution() {
        for mut law in BallBallLaw::all() {
            set_restitution(&mut law, 0.7);
            set_friction(&mut law, 0.2);
            assert_eq!((friction(&law), law.restitution(0.0)), (0.2, 0.7));
            set_friction(&mut law, 0.0);
            assert_eq!((friction(&law), law.restitution(0.0)), (0.0, 0.7));
            assert!(matches!(law, BallBallLaw::Frictionless(_)));
        }
    }

    #[test]
    fn a_tilted_table_has_no_cloth_and_a_level_one_keeps_its_own() {
        let cloth = MotionLaw::Coulomb(Cloth::default());
        let mut motion = cloth;
        set_tilt(&mut motion, [0.0, 0.0]);
        assert_eq!(motion, cloth);
        set_tilt(&mut motion, [-STEEPEST, 5.0]);
        let pull = motion.pull();
        assert!((pull.x + 0.5 * gravity()).abs() < 1e-12, "{pull}");
        assert!((pull.z - 0.855).abs() < 1e-3, "{pull}");
        set_tilt(&mut motion, [0.0, 0.0]);
        assert_eq!(motion, MotionLaw::Frictionless);
    }

    #[test]
    fn another_tick_keeps_the_time() {
        let mut playfield = Playfield {
            solver: Solver::Stepped(crate::physics::scene::Stepped::default()),
            ..default()
        };
        let mut clock = Clock::new(&playfield.solver);
        clock.ticks = 600;
        set_tick(&mut playfield, &mut clock, 1000.0);
        assert!((clock.time() - 5.0).abs() < 1e-9);
        assert_eq!(clock.ticks, 5000);
        assert_eq!(Clock::new(&playfield.solver).tick, clock.tick);
    }
}
