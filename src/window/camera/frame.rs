//! The part of the picture that the panels leave free, and the lens that puts what is looked at there.

use bevy::camera::SubCameraView;
use bevy::prelude::*;

/// The whole picture: places in it are shares of its width and height, from the upper left corner.
pub(super) const WHOLE: Rect = Rect {
    min: Vec2::ZERO,
    max: Vec2::ONE,
};

/// Seconds in which the view comes within 1/e of the room that a panel has left.
const GIVE_WAY: f32 = 0.16;

/// If what is left shows the table smaller than this share of its size in the whole picture, the panels stay over it.
const LEAST: f32 = 0.3;

/// What a frame depends on.
#[derive(Clone, Debug, Default, PartialEq)]
struct Sight {
    covered: Vec<Rect>,
    size: Vec2,
    shape: Vec2,
}

/// Where in the picture of one camera a table is shown whole.
#[derive(Debug)]
pub(super) struct Framing {
    sight: Sight,
    goal: Rect,
    shown: Rect,
}

impl Default for Framing {
    fn default() -> Self {
        Self {
            sight: Sight::default(),
            goal: WHOLE,
            shown: WHOLE,
        }
    }
}

impl Framing {
    /// The frame `dt` s after the last: in a picture of this size, partly covered, for something of this shape. It moves
    /// when a panel opens or closes.
    pub fn advance(&mut self, covered: Vec<Rect>, size: Vec2, shape: Vec2, dt: f32) -> Rect {
        // Panels that have been there from the start have nothing to give way to.
        let at_once = self.sight.covered.is_empty() || self.sight.size != size;
        let sight = Sight {
            covered,
            size,
            shape,
        };
        if sight != self.sight {
            self.goal = frame(&sight);
            self.sight = sight;
            if at_once {
                self.shown = self.goal;
            }
        }
        let share = 1.0 - libm::expf(-dt / GIVE_WAY);
        let next = Rect {
            min: self.shown.min.lerp(self.goal.min, share),
            max: self.shown.max.lerp(self.goal.max, share),
        };
        let apart = (next.min - self.goal.min).abs() + (next.max - self.goal.max).abs();
        self.shown = if apart.max_element() < 1e-4 {
            self.goal
        } else {
            next
        };
        self.shown
    }
}

/// The largest place for the shape that no panel covers, as near to the middle as may be.
fn frame(sight: &Sight) -> Rect {
    let Sight {
        covered,
        size,
        shape,
    } = sight;
    let scale = |free: Vec2| (free * *size / *shape).min_element();
    let covered: Vec<Rect> = covered
        .iter()
        .map(|panel| panel.intersect(WHOLE))
        .filter(|panel| !panel.is_empty())
        .collect();
    let mut best = (WHOLE, LEAST * scale(Vec2::ONE));
    let mut is_found = false;
    let sides = |axis: usize| {
        let mut sides: Vec<f32> = covered
            .iter()
            .flat_map(|panel| [panel.min[axis], panel.max[axis]])
            .chain([0.0, 1.0])
            .collect();
        sides.sort_by(f32::total_cmp);
        sides.dedup();
        sides
    };
    let (across, down) = (sides(0), sides(1));
    for (i, left) in across.iter().enumerate() {
        for right in &across[i + 1..] {
            for (j, top) in down.iter().enumerate() {
                for bottom in &down[j + 1..] {
                    let free = Rect::new(*left, *top, *right, *bottom);
                    let size = scale(free.size());
                    let area = |rect: Rect| rect.width() * rect.height();
                    let is_better = size > 1.001 * best.1
                        || (size > 0.999 * best.1 && is_found && area(free) > area(best.0));
                    if is_better && covered.iter().all(|panel| panel.intersect(free).is_empty()) {
                        best = (free, size);
                        is_found = true;
                    }
                }
            }
        }
    }
    let (free, size_there) = best;
    if !is_found {
        return WHOLE;
    }
    let taken = (size_there * *shape / *size).min(free.size());
    let middle = Vec2::splat(0.5).clamp(free.min + 0.5 * taken, free.max - 0.5 * taken);
    Rect::from_center_size(middle, taken)
}

/// The vertical field of view in rad, and the part of what it sees, with which a picture of this size shows in `frame` what
/// an eye with the field of view `fov` sees, and around the frame what lies around that.
pub(super) fn lens(frame: Rect, fov: f32, size: Vec2) -> (f32, Option<SubCameraView>) {
    if frame == WHOLE {
        return (fov, None);
    }
    let middle = frame.center();
    // The smallest symmetrical view around the middle of the frame that holds the picture, in pictures.
    let times = 2.0 * middle.max(Vec2::ONE - middle).max_element();
    let half = libm::tanf(0.5 * fov) * times / frame.height();
    // Pixels are too coarse for a view that moves smoothly.
    let fine = (FINE * size).max(Vec2::ONE);
    let part = SubCameraView {
        full_size: (times * fine).as_uvec2(),
        offset: (0.5 * times - middle) * fine,
        size: fine.as_uvec2(),
    };
    (2.0 * libm::atanf(half), Some(part))
}

/// Steps in a pixel.
const FINE: f32 = 64.0;

#[cfg(test)]
mod tests {
    use bevy::camera::CameraProjection;

    use super::*;

    const TABLE: Vec2 = Vec2::new(3.0, 1.75);

    fn framed(covered: &[Rect], size: Vec2) -> Rect {
        Framing::default().advance(covered.to_vec(), size, TABLE, f32::INFINITY)
    }

    #[test]
    fn a_table_lies_where_no_panel_is_as_large_as_may_be() {
        let size = Vec2::new(1280.0, 720.0);
        let panel = Rect::new(0.76, 0.0, 1.0, 0.9);
        let line = Rect::new(0.0, 0.96, 0.4, 1.0);
        let corner = Rect::new(0.0, 0.0, 0.15, 0.05);
        let frame = framed(&[panel, line, corner], size);
        for covered in [panel, line, corner] {
            assert!(frame.intersect(covered).is_empty(), "{frame:?} {covered:?}");
        }
        let aspect = frame.width() * size.x / (frame.height() * size.y);
        assert!((aspect - TABLE.x / TABLE.y).abs() < 1e-4, "{aspect}");
        assert!((frame.width() - 0.76).abs() < 1e-4, "{frame:?}");
        // There is room above and below: it stays in the middle.
        assert!((frame.center().y - 0.5).abs() < 1e-4, "{frame:?}");
    }

    #[test]
    fn what_leaves_next_to_nothing_is_looked_past() {
        let size = Vec2::new(640.0, 400.0);
        assert_eq!(framed(&[Rect::new(0.1, 0.0, 1.0, 1.0)], size), WHOLE);
        assert_eq!(framed(&[WHOLE], size), WHOLE);
        let beyond = Rect::new(1.0, 0.0, 1.5, 1.0);
        let alone = framed(&[], size);
        assert_eq!(framed(&[beyond], size), alone);
        assert!((alone.center() - 0.5).abs().max_element() < 1e-6);
    }

    #[test]
    fn the_view_gives_way_bit_by_bit_and_arrives() {
        let size = Vec2::new(900.0, 600.0);
        let button = vec![Rect::new(0.9, 0.0, 1.0, 0.04)];
        let panel = vec![Rect::new(0.6, 0.0, 1.0, 1.0)];
        let mut framing = Framing::default();
        let before = framing.advance(button, size, TABLE, 0.016);
        let first = framing.advance(panel.clone(), size, TABLE, 0.016);
        assert!(first != before && first.max.x > 0.9, "{first:?}");
        let mut last = first;
        for _ in 0..200 {
            last = framing.advance(panel.clone(), size, TABLE, 0.016);
        }
        assert_eq!(last, framed(&panel, size));
    }

    #[test]
    fn a_lens_shows_in_the_frame_what_the_eye_sees() {
        let size = Vec2::new(640.0, 400.0);
        let frame = Rect::new(0.05, 0.2, 0.5, 0.7);
        let (fov, part) = lens(frame, 0.4, size);
        let part = part.expect("the frame is not the whole picture");
        let wide = PerspectiveProjection {
            fov,
            aspect_ratio: size.x / size.y,
            ..default()
        };
        let shown = wide.get_clip_from_view_for_sub(&part);
        let whole = wide.get_clip_from_view();
        let half = libm::tanf(0.2);
        let aspect = frame.width() * size.x / (frame.height() * size.y);
        for (x, y) in [(0.0, 0.0), (1.0, 1.0), (-1.0, 0.5), (0.3, -1.0)] {
            let point = Vec3::new(x * half * aspect, y * half, -1.0);
            let place = shown.project_point3(point);
            let wanted = frame.center() + 0.5 * frame.size() * Vec2::new(x, -y);
            let at = 0.5 + 0.5 * Vec2::new(place.x, -place.y);
            assert!(at.distance(wanted) < 1e-4, "{at} {wanted}");
        }
        // What is drawn at the edges is not left out as out of sight.
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            let seen = shown.inverse().project_point3(Vec3::new(x, y, 0.5));
            let place = whole.project_point3(seen);
            assert!(place.x.abs() < 1.0001 && place.y.abs() < 1.0001, "{place}");
        }
        assert_eq!(lens(WHOLE, 0.4, size), (0.4, None));
    }
}
