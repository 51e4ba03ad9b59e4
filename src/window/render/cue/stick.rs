//! The stick as two solids, one for each finish: tip, ferrule, shaft, joint, forearm with points, wrap, butt, bumper. It is
//! the cone that must not pass through anything, from the apex of the tip at the origin along −x.

use std::f64::consts::TAU;

use bevy::math::DVec3;
use bevy::prelude::*;

use crate::physics::cue::Cue;
use crate::window::render::solid::Solid;

/// Faces around the stick: the edges of eight points fall between two of them.
const SIDES: u32 = 48;

/// How the stick is finished.
pub(super) struct Stick {
    /// Wood and metal under lacquer.
    pub polished: Solid,
    /// Leather, linen, rubber.
    pub matt: Solid,
}

const MAPLE: Color = Color::srgb(0.79, 0.62, 0.41);
const ROSEWOOD: Color = Color::srgb(0.26, 0.085, 0.05);
const EBONY: Color = Color::srgb(0.045, 0.04, 0.042);
const IVORY: Color = Color::srgb(0.88, 0.85, 0.76);
const BRASS: Color = Color::srgb(0.72, 0.55, 0.25);
const TEAL: Color = Color::srgb(0.05, 0.33, 0.36);
const CHALK: Color = Color::srgb(0.13, 0.33, 0.52);
const LEATHER: Color = Color::srgb(0.34, 0.20, 0.11);
const LINEN: Color = Color::srgb(0.10, 0.10, 0.115);
const RUBBER: Color = Color::srgb(0.03, 0.03, 0.03);

/// Lengths along the stick from the tip, as shares of it.
const JOINT: f64 = 0.505;
const FOREARM: f64 = 0.516;
const WRAP: f64 = 0.722;
const SLEEVE: f64 = 0.925;
const CAP: f64 = 0.979;

/// The same in m: the leather, and where the ferrule ends.
const TIP: f64 = 0.007;
const FERRULE: f64 = 0.029;

/// The stick of a cue.
pub(super) fn stick(cue: &Cue) -> Stick {
    let make = Turner {
        length: cue.stick.length,
        thin: 0.5 * cue.stick.tip_width,
        thick: 0.5 * cue.stick.butt_width,
    };
    let new = || Solid::new(DVec3::X, 0.1);
    let (mut polished, mut matt) = (new(), new());
    make.dome(&mut matt, cue.tip_radius);
    let long = make.length;
    let wood = &mut polished;
    make.rings(wood, &[(TIP, IVORY), (FERRULE, MAPLE)], JOINT * long, 0.05);
    let joint = [
        (JOINT, BRASS),
        (JOINT + 0.004, EBONY),
        (FOREARM - 0.003, IVORY),
        (FOREARM - 0.0015, EBONY),
    ];
    make.rings(
        wood,
        &joint.map(|(at, colour)| (at * long, colour)),
        FOREARM * long,
        0.0,
    );
    make.points(wood);
    let sleeve = [
        (SLEEVE, BRASS),
        (SLEEVE + 0.002, EBONY),
        (SLEEVE + 0.008, IVORY),
        (SLEEVE + 0.009, ROSEWOOD),
        (CAP - 0.012, IVORY),
        (CAP - 0.011, EBONY),
        (CAP - 0.004, BRASS),
    ];
    make.rings(
        wood,
        &sleeve.map(|(at, colour)| (at * long, colour)),
        CAP * long,
        0.04,
    );
    make.wrap(&mut matt);
    make.bumper(&mut matt);
    Stick { polished, matt }
}

/// The cone that everything is turned on.
struct Turner {
    length: f64,
    thin: f64,
    thick: f64,
}

impl Turner {
    /// How thick half the stick is at a length.
    fn radius(&self, along: f64) -> f64 {
        self.thin + (self.thick - self.thin) * (along / self.length).clamp(0.0, 1.0)
    }

    /// A point of the surface and the way out of it there.
    fn at(&self, side: u32, along: f64) -> (DVec3, DVec3) {
        round(side, along, self.radius(along))
    }

    /// A face of one side between two lengths, each given on both edges of the side.
    fn face(&self, solid: &mut Solid, side: u32, from: [f64; 2], to: [f64; 2]) {
        let row = |at: [f64; 2]| [self.at(side, at[0]), self.at(side + 1, at[1])];
        solid.band(&row(from), &row(to));
    }

    /// Rings one after the other, each from its length on; the last one ends at `end`. The grain makes one side lighter
    /// than the next by this share.
    fn rings(&self, solid: &mut Solid, rings: &[(f64, Color)], end: f64, grain: f64) {
        for (i, (from, colour)) in rings.iter().enumerate() {
            let to = rings.get(i + 1).map_or(end, |next| next.0);
            for side in 0..SIDES {
                solid.dye(*colour, 1.0 + grain * speck(side, i as u32));
                self.face(solid, side, [*from; 2], [to; 2]);
            }
        }
    }

    /// The tip: leather, rounded, with chalk on it.
    fn dome(&self, solid: &mut Solid, curvature: f64) {
        let curvature = curvature.max(1.05 * self.thin);
        let sag = |radius: f64| curvature - (curvature * curvature - radius * radius).sqrt();
        let steps = [0.0, 0.4, 0.7, 0.9, 1.0].map(|share| share * self.thin);
        for pair in steps.windows(2) {
            for side in 0..SIDES {
                solid.dye(CHALK, 1.0 + 0.18 * speck(side, (1e5 * pair[1]) as u32));
                let row = |radius: f64| {
                    [side, side + 1].map(|side| {
                        let (at, out) = round(side, sag(radius), radius);
                        (at, (curvature * DVec3::X + radius * out).normalize())
                    })
                };
                solid.band(&row(pair[0]), &row(pair[1]));
            }
        }
        self.rings(solid, &[(sag(self.thin), LEATHER)], TIP, 0.1);
    }

    /// Dark wood that runs into light wood: four long points with two veneers, four short ones between them.
    fn points(&self, solid: &mut Solid) {
        let (from, to) = (FOREARM * self.length, WRAP * self.length);
        let deep = to - from;
        let half = f64::from(SIDES / 8);
        // How far from the wrap the edge of the points is.
        let reach = |side: u32| {
            let place = f64::from(side % (SIDES / 4));
            let long = 1.0 - (place - half).abs() / half;
            let short = 1.0 - place.min(2.0 * half - place) / (0.7 * half);
            deep * (0.86 * long).max(0.48 * short).max(0.0)
        };
        let bands = [
            (EBONY, 0.0),
            (IVORY, 0.016),
            (TEAL, 0.040),
            (MAPLE, f64::INFINITY),
        ];
        for side in 0..SIDES {
            let mut edge = [to; 2];
            for (i, (colour, veneer)) in bands.into_iter().enumerate() {
                let next = [side, side + 1].map(|side| (to - reach(side) - veneer).max(from));
                solid.dye(colour, 1.0 + 0.05 * speck(side, 40 + i as u32));
                self.face(solid, side, next, edge);
                edge = next;
            }
        }
    }

    /// Linen wound around: dark, flecked with light.
    fn wrap(&self, solid: &mut Solid) {
        let (from, to) = (WRAP * self.length, SLEEVE * self.length);
        let turns = 96;
        let at = |turn: u32| from + (to - from) * f64::from(turn) / f64::from(turns);
        for turn in 0..turns {
            for side in (0..SIDES).step_by(3) {
                let fleck = speck(side, turn);
                let light = if fleck > 0.72 {
                    3.2
                } else {
                    1.0 + 0.25 * fleck
                };
                solid.dye(LINEN, light);
                let row = |along: f64| [self.at(side, along), self.at(side + 3, along)];
                solid.band(&row(at(turn)), &row(at(turn + 1)));
            }
        }
    }

    /// The end of the butt: rubber with a rounded edge.
    fn bumper(&self, solid: &mut Solid) {
        solid.dye(RUBBER, 1.0);
        let (from, edge) = (CAP * self.length, self.length - 0.004);
        let rows = [
            (from, self.radius(from), 0.0),
            (edge, self.radius(edge), 0.0),
            (self.length, 0.75 * self.thick, 0.7),
            (self.length, 0.0, 1.0),
        ];
        for pair in rows.windows(2) {
            for side in 0..SIDES {
                let row = |(along, radius, back): (f64, f64, f64)| {
                    [side, side + 1].map(|side| {
                        let (at, out) = round(side, along, radius);
                        (at, (out * (1.0 - back) - back * DVec3::X).normalize())
                    })
                };
                solid.band(&row(pair[0]), &row(pair[1]));
            }
        }
    }
}

/// A point this far along and this far from the middle, and the way out.
fn round(side: u32, along: f64, radius: f64) -> (DVec3, DVec3) {
    let angle = TAU * f64::from(side) / f64::from(SIDES);
    let out = DVec3::new(0.0, libm::cos(angle), libm::sin(angle));
    (radius * out - along * DVec3::X, out)
}

/// Something from −1 to 1, the same every time.
fn speck(side: u32, place: u32) -> f64 {
    let mut mix = side.wrapping_mul(0x9e37_79b9) ^ place.wrapping_mul(0x85eb_ca6b);
    mix = (mix ^ (mix >> 15)).wrapping_mul(0x2c1b_3c6d);
    mix ^= mix >> 13;
    f64::from(mix & 0xffff) / 32_767.5 - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stick_is_the_cone_of_its_cue_and_ends_where_it_ends() {
        let cue = Cue::default();
        let Stick { polished, matt } = stick(&cue);
        let slope = 0.5 * (cue.stick.butt_width - cue.stick.tip_width) / cue.stick.length;
        let (mut first, mut last) = (f64::INFINITY, 0.0_f64);
        for [x, y, z] in polished.points().chain(matt.points()) {
            let (along, away) = (-f64::from(x), libm::hypot(f64::from(y), f64::from(z)));
            first = first.min(along);
            last = last.max(along);
            let most = 0.5 * cue.stick.tip_width + slope * along + 1e-6;
            assert!(away <= most, "{along}: {away} is more than {most}");
        }
        assert!(first.abs() < 1e-7 && (last - cue.stick.length).abs() < 1e-6);
    }
}
