//! A rectangular table with six pockets, from the numbers a table maker uses.

use glam::DVec2;

use crate::physics::laws::{Check, Parameter};
use crate::physics::table::{Arc, Cushion, Line, Nose, Pocket, Table};

/// One kind of pocket mouth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mouth {
    /// Width between the points where facings and noses would meet, m.
    pub width: f64,
    /// Angle between nose line and facing in rad: 142° at a corner, 104° at a side (WPA).
    pub cut_angle: f64,
    /// Radius in plan of the rounding between nose and facing, m.
    pub jaw_radius: f64,
    /// Radius of the hole in the slate, m.
    pub hole_radius: f64,
    /// Distance from the line across the mouth to the edge of the hole, m.
    pub shelf: f64,
}

impl Mouth {
    /// Length of nose and of facing that the rounding takes away, m.
    fn trim(&self) -> f64 {
        self.jaw_radius * libm::tan(0.5 * (std::f64::consts::PI - self.cut_angle))
    }
}

/// Least length of a facing in m behind a jaw that reaches back farther than the cushion.
const THROAT: f64 = 0.005;

/// The measures of a table with six pockets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PocketedTable {
    /// Length of the playing surface, m.
    pub length: f64,
    /// Width of the playing surface, m.
    pub width: f64,
    /// Height of the nose above the slate, m.
    pub nose_height: f64,
    /// Depth of the cushions from nose to rail, m: how far the facings reach back.
    pub cushion_depth: f64,
    /// The corner pockets.
    pub corner: Mouth,
    /// The side pockets.
    pub side: Mouth,
}

impl PocketedTable {
    /// Noses, jaws, facings and holes in plan.
    #[must_use]
    pub fn build(&self) -> Table {
        let (x, z) = (0.5 * self.length, 0.5 * self.width);
        let corner = self.corner.width * std::f64::consts::FRAC_1_SQRT_2;
        let side = 0.5 * self.side.width;
        let mut cushions = Vec::with_capacity(42);
        for across in [-1.0, 1.0] {
            for along in [-1.0, 1.0] {
                let outward = DVec2::new(0.0, across);
                self.nose(
                    &mut cushions,
                    (DVec2::new(along * (x - corner), across * z), &self.corner),
                    (DVec2::new(along * side, across * z), &self.side),
                    outward,
                );
            }
        }
        for along in [-1.0, 1.0] {
            self.nose(
                &mut cushions,
                (DVec2::new(along * x, -(z - corner)), &self.corner),
                (DVec2::new(along * x, z - corner), &self.corner),
                DVec2::new(along, 0.0),
            );
        }
        // A ball that comes back out of a pocket can meet the back ends of the facings.
        let half = DVec2::new(x, z);
        let ends: Vec<DVec2> = cushions
            .iter()
            .filter_map(|cushion| match cushion {
                Cushion::Line(line) if line.to.abs().cmpgt(half).any() => Some(line.to),
                _ => None,
            })
            .collect();
        cushions.extend(ends.into_iter().map(|center| {
            Cushion::Arc(Arc {
                center,
                radius: 0.0,
            })
        }));
        Table {
            length: self.length,
            width: self.width,
            nose_height: self.nose_height,
            nose: Nose::Round { radius: 0.0 },
            cushions,
            pockets: self.pockets(x, z),
        }
    }

    /// One nose line between two mouths, with jaw and facing at both ends.
    fn nose(
        &self,
        cushions: &mut Vec<Cushion>,
        (from, from_mouth): (DVec2, &Mouth),
        (to, to_mouth): (DVec2, &Mouth),
        outward: DVec2,
    ) {
        let along = (to - from).normalize();
        let from_trim = from_mouth.trim();
        let to_trim = to_mouth.trim();
        cushions.push(Cushion::Line(Line {
            from: from + from_trim * along,
            to: to - to_trim * along,
        }));
        for (point, mouth, trim, end) in [
            (from, from_mouth, from_trim, -along),
            (to, to_mouth, to_trim, along),
        ] {
            // The facing turns away from the nose line by the supplement of the cut angle.
            let turn = std::f64::consts::PI - mouth.cut_angle;
            let facing = libm::cos(turn) * end + libm::sin(turn) * outward;
            cushions.push(Cushion::Arc(Arc {
                center: point - trim * end + mouth.jaw_radius * outward,
                radius: mouth.jaw_radius,
            }));
            cushions.push(Cushion::Line(Line {
                from: point + trim * facing,
                to: point + (self.cushion_depth / libm::sin(turn)).max(trim + THROAT) * facing,
            }));
        }
    }

    fn pockets(&self, x: f64, z: f64) -> Vec<Pocket> {
        let corner_depth = self.corner.hole_radius + self.corner.shelf - 0.5 * self.corner.width;
        let corner = corner_depth * std::f64::consts::FRAC_1_SQRT_2;
        let side = self.side.hole_radius + self.side.shelf;
        let mut pockets = Vec::with_capacity(6);
        for (along, end) in [(-1.0, "head"), (0.0, "side"), (1.0, "foot")] {
            for (across, hand) in [(-1.0, "left"), (1.0, "right")] {
                let (center, mouth) = if along == 0.0 {
                    (DVec2::new(0.0, across * (z + side)), &self.side)
                } else {
                    (
                        DVec2::new(along * (x + corner), across * (z + corner)),
                        &self.corner,
                    )
                };
                pockets.push(Pocket {
                    name: format!("{end} {hand}"),
                    center,
                    radius: mouth.hole_radius,
                    depth: 0.08,
                });
            }
        }
        pockets
    }
}

impl Check for PocketedTable {
    fn parameters(&self) -> Vec<Parameter> {
        let mut parameters = vec![
            Parameter::new("length", self.length, 0.5, 20.0).basis("m; 9 ft pool 2.54, WPA"),
            Parameter::new("width", self.width, 0.25, 10.0).basis("m; 9 ft pool 1.27, WPA"),
            Parameter::new("nose_height", self.nose_height, 1e-3, 0.5)
                .basis("m; 62.5 to 64.5 % of the diameter of a ball, WPA"),
            Parameter::new("cushion_depth", self.cushion_depth, 1e-3, 0.5)
                .basis("m; 0.0476 to 0.0508, WPA"),
        ];
        let measures = [
            ("corner", &self.corner, "m; 0.114 to 0.118, WPA", 95.0),
            ("side", &self.side, "m; 0.127 to 0.131, WPA", 90.0),
        ];
        for (name, mouth, width, least) in measures {
            // As it was written: degrees that went to radians and back lose their last digit.
            let angle = (1e9 * mouth.cut_angle.to_degrees()).round() / 1e9;
            let of_mouth = [
                Parameter::new("width", mouth.width, 0.02, 0.5).basis(width),
                Parameter::new("cut_angle_deg", angle, least, 170.0)
                    .basis("°; corner 141 to 143, side 103 to 105, WPA"),
                Parameter::new("jaw_radius", mouth.jaw_radius, 0.0, 0.5).basis("m"),
                Parameter::new("hole_radius", mouth.hole_radius, 0.01, 0.5)
                    .basis("m; 0.070 at a corner, 0.076 at a side, Alciatore, TP 3.6 and 3.5"),
                Parameter::new("shelf", mouth.shelf, 0.0, 0.2)
                    .basis("m; corner 0.025 to 0.057, side 0 to 0.0095, WPA"),
            ];
            parameters.extend(of_mouth.map(|parameter| parameter.within(name)));
        }
        // What the mouths and their jaws leave of the noses.
        let corner = self.corner.width * std::f64::consts::FRAC_1_SQRT_2 + self.corner.trim();
        let long = 0.5 * (self.length - self.side.width) - self.side.trim() - corner;
        let short = self.width - 2.0 * corner;
        for (name, left) in [
            ("nose beside the side pocket", long),
            ("nose across", short),
        ] {
            parameters
                .push(Parameter::new(name, left, 0.01, 20.0).basis("m left between two pockets"));
        }
        parameters
    }
}
