//! The shape of `unit_laws.json`.

use std::collections::BTreeMap;

use glam::DVec2;
use serde::Deserialize;

use masse::physics::ball::Ball;
use masse::physics::laws::motion::{Cloth, MotionLaw};
use masse::physics::table::{Arc, Line};

use super::text;

#[derive(Deserialize)]
pub struct Tables {
    pub ball_params: BallParameters,
    pub friction_alciatore: Marlow,
    pub cushion_setup: CushionSetup,
    pub motion: Vec<MotionRow>,
    pub cushion: Vec<CushionRow>,
    pub ball_ball: Vec<PairRow>,
    pub ball_table: Vec<SlateRow>,
    pub strike: Vec<StrikeRow>,
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
pub struct BallParameters {
    pub m: f64,
    #[serde(rename = "R")]
    pub radius: f64,
    pub u_s: f64,
    pub u_r: f64,
    pub u_sp: f64,
    pub e_b: f64,
    pub e_t: f64,
    pub e_c: f64,
    pub f_c: f64,
    pub g: f64,
}

#[derive(Deserialize)]
pub struct Marlow {
    pub a: f64,
    pub b: f64,
    pub c: f64,
}

#[derive(Deserialize)]
pub struct CushionSetup {
    pub height: f64,
    pub circular: RoundSetup,
}

#[derive(Deserialize)]
pub struct RoundSetup {
    pub radius: f64,
}

impl CushionSetup {
    pub fn line() -> Line {
        Line {
            from: DVec2::NEG_X,
            to: DVec2::X,
        }
    }

    pub fn arc(&self) -> Arc {
        Arc {
            center: DVec2::ZERO,
            radius: self.circular.radius,
        }
    }
}

#[derive(Deserialize)]
pub struct MotionRow {
    pub s: u8,
    #[serde(rename = "in")]
    pub before: [f64; 9],
    pub t: f64,
    pub out: [f64; 9],
    pub s_out: u8,
    pub slide_time: f64,
    pub roll_time: f64,
    pub spin_time: f64,
}

#[derive(Deserialize)]
pub struct CushionRow {
    pub kind: String,
    #[serde(rename = "in")]
    pub before: [f64; 9],
    pub out: BTreeMap<String, [f64; 9]>,
}

#[derive(Deserialize)]
pub struct PairRow {
    pub ball1: [f64; 9],
    pub ball2: [f64; 9],
    pub out: BTreeMap<String, PairAfter>,
}

#[derive(Deserialize)]
pub struct PairAfter {
    pub ball1: [f64; 9],
    pub ball2: [f64; 9],
}

#[derive(Deserialize)]
pub struct SlateRow {
    #[serde(rename = "in")]
    pub before: [f64; 9],
    pub out: BTreeMap<String, SlateAfter>,
}

#[derive(Deserialize)]
pub struct SlateAfter {
    pub rvw: [f64; 9],
}

#[derive(Deserialize)]
pub struct StrikeRow {
    #[serde(rename = "V0")]
    pub speed: f64,
    pub phi: f64,
    pub theta: f64,
    pub a: f64,
    pub b: f64,
    #[serde(rename = "M")]
    pub mass: f64,
    pub end_mass: f64,
    pub v3d: [f64; 3],
    pub w: [f64; 3],
}

impl Tables {
    pub fn load() -> Self {
        serde_json::from_str(&text("unit_laws.json")).expect("the tables have this shape")
    }

    pub fn ball(&self) -> Ball {
        Ball {
            mass: self.ball_params.m,
            radius: self.ball_params.radius,
            spins: true,
        }
    }

    pub fn cloth(&self) -> MotionLaw {
        let p = &self.ball_params;
        MotionLaw::Coulomb(Cloth {
            sliding: p.u_s,
            rolling: p.u_r,
            spin_deceleration: 2.5 * p.u_sp * p.g / p.radius,
            gravity: p.g,
        })
    }
}
