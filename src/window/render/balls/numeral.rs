//! Numbers drawn from the outlines of a font.

use ab_glyph::{Font, FontRef, PxScale, ScaleFont, point};
use epaint_default_fonts::HACK_REGULAR;

/// A number as a square of coverage, 0 to 1.
pub(super) struct Numeral {
    coverage: Vec<f32>,
}

/// Texels along one side.
const SIDE: usize = 128;

impl Numeral {
    /// The number, centred, filling the square; 6 and 9 are underlined, as on real balls.
    pub fn new(number: u8) -> Self {
        let mut coverage = vec![0.0; SIDE * SIDE];
        if let Ok(font) = FontRef::try_from_slice(HACK_REGULAR) {
            let text = number.to_string();
            let height = if text.len() > 1 { 104.0 } else { 124.0 };
            // Two digits are set closer and narrower, to fill the circle.
            let width = if text.len() > 1 { 0.92 } else { 1.08 };
            let scale = PxScale {
                x: height * width,
                y: height,
            };
            let scaled = font.as_scaled(scale);
            let advance = |c: char| 0.94 * scaled.h_advance(font.glyph_id(c));
            let total: f32 = text.chars().map(advance).sum();
            let mut x = 0.5 * (SIDE as f32 - total);
            let digit_height = 0.73 * scaled.ascent();
            let underlined = matches!(number, 6 | 9);
            let lift = if underlined { 5.0 } else { 0.0 };
            let baseline = 0.5 * (SIDE as f32 + digit_height) - lift;
            for c in text.chars() {
                let glyph = font
                    .glyph_id(c)
                    .with_scale_and_position(scale, point(x, baseline));
                x += advance(c);
                draw(&font, glyph, &mut coverage);
            }
            if underlined {
                let base = (baseline + 7.0) as usize;
                for row in base..(base + 7).min(SIDE) {
                    coverage[row * SIDE + 40..row * SIDE + 88].fill(1.0);
                }
            }
        }
        Self { coverage }
    }

    /// Coverage at a place from −1 to 1, right and up.
    pub fn at(&self, right: f32, up: f32) -> f32 {
        let place = |v: f32| (0.5 + 0.5 * v) * SIDE as f32 - 0.5;
        let (x, y) = (place(right), place(-up));
        let (x0, y0) = (x.floor(), y.floor());
        let texel = |i: f32, j: f32| {
            let (x, y) = (x0 + i, y0 + j);
            let inside = 0.0..SIDE as f32;
            if inside.contains(&x) && inside.contains(&y) {
                self.coverage[y as usize * SIDE + x as usize]
            } else {
                0.0
            }
        };
        let (tx, ty) = (x - x0, y - y0);
        let top = texel(0.0, 0.0) * (1.0 - tx) + texel(1.0, 0.0) * tx;
        let bottom = texel(0.0, 1.0) * (1.0 - tx) + texel(1.0, 1.0) * tx;
        top * (1.0 - ty) + bottom * ty
    }
}

/// Adds a glyph, thickened to both sides: the font has one thin weight, balls carry a bold one.
fn draw(font: &FontRef, glyph: ab_glyph::Glyph, coverage: &mut [f32]) {
    let Some(outline) = font.outline_glyph(glyph) else {
        return;
    };
    let bounds = outline.px_bounds();
    let (left, top) = (bounds.min.x.round() as i64, bounds.min.y.round() as i64);
    outline.draw(|x, y, share| {
        for shift in [-3, -2, -1, 0, 1, 2, 3] {
            let (x, y) = (left + i64::from(x) + shift, top + i64::from(y));
            if (0..SIDE as i64).contains(&x) && (0..SIDE as i64).contains(&y) {
                let cell = &mut coverage[y as usize * SIDE + x as usize];
                *cell = cell.max(share).min(1.0);
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_is_drawn_and_no_two_are_alike() {
        let drawn: Vec<Numeral> = (1..=15).map(Numeral::new).collect();
        for (i, numeral) in drawn.iter().enumerate() {
            let ink: f32 = numeral.coverage.iter().sum();
            assert!(ink > 500.0, "{}: {ink}", i + 1);
            for other in &drawn[..i] {
                assert_ne!(numeral.coverage, other.coverage);
            }
        }
    }

    #[test]
    fn a_one_stands_upright() {
        let one = Numeral::new(1);
        assert!(one.at(0.0, 0.3) > 0.9, "the stem is in the middle");
        assert!(one.at(0.6, 0.0) < 0.1);
    }
}
