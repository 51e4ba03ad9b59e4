//! The views, what the player has set in each, and the way from one to the other.

use bevy::prelude::*;

use crate::game::view::{CameraInput, CameraMode};
use crate::window::camera::frame::{Framing, WHOLE};
use crate::window::camera::pose::Pose;

/// What a mode comes to on this table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Seat {
    /// Behind the cue, along the aim.
    BehindCue,
    /// From above, the whole table.
    Overhead,
    /// Freely around a point of the table.
    Orbit,
    /// Beside a ball, moving with it; where its centre is, if it is there.
    Follow(Option<Vec3>),
    /// Where a scene wants it.
    Fixed(Pose),
}

/// Seconds in which a change of mode comes within 1/e of its goal.
const EASE: f32 = 0.16;

/// Seconds in which the view comes within 1/e of a ball that has come to rest elsewhere.
const CATCH_UP: f32 = 0.25;

/// Seconds in which the view comes within 1/e of a ball that it follows.
const CLING: f32 = 0.06;

/// Wood around the playing surface that an overhead view shows, m.
const MARGIN: f32 = 0.24;

/// What the views depend on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surroundings {
    /// Centre of the ball to strike, while it waits to be struck.
    pub ball: Option<Vec3>,
    /// Unit vector of the aim.
    pub forward: Vec3,
    /// Length and width of the playing surface, m.
    pub table: Vec2,
    /// Width of the picture over its height.
    pub aspect: f32,
    /// Where in the picture the panels leave room for a view of the whole table.
    pub frame: Rect,
    /// Whether the balls are a crowd: its tables have any size.
    pub is_crowd: bool,
    /// The ball that the camera is to follow.
    pub watched: Option<Vec3>,
}

/// What the player has set in each view of one camera, and the way from the last view.
#[derive(Component, Debug)]
pub(super) struct Rig {
    /// Where in the picture the table is shown.
    pub framing: Framing,
    behind_distance: f32,
    behind_pitch: f32,
    overhead_zoom: f32,
    overhead_shift: Vec2,
    orbit_target: Vec3,
    orbit_yaw: f32,
    orbit_pitch: f32,
    orbit_distance: f32,
    /// How the view beside a ball is turned from behind the cue, how far down it looks, how far off it is.
    follow_yaw: f32,
    follow_pitch: f32,
    follow_distance: f32,
    /// The ball that is followed, as the camera sees it.
    followed: Option<Vec3>,
    /// The ball as the camera follows it.
    anchor: Option<Vec3>,
    /// The mode on the screen.
    mode: CameraMode,
    /// Where the camera was when the mode changed, and how much of that is left.
    from: Option<(Pose, f32)>,
    shown: Option<Pose>,
    /// How large the table is beside a nine-foot one; 1 for every table that is played on.
    scale: f32,
}

impl Default for Rig {
    fn default() -> Self {
        Self {
            framing: Framing::default(),
            behind_distance: 0.95,
            behind_pitch: 0.36,
            overhead_zoom: 1.0,
            overhead_shift: Vec2::ZERO,
            orbit_target: Vec3::new(0.0, 0.0, 0.05),
            orbit_yaw: 0.5,
            orbit_pitch: 0.62,
            orbit_distance: 2.7,
            follow_yaw: 0.6,
            follow_pitch: 0.5,
            follow_distance: 0.8,
            followed: None,
            anchor: None,
            mode: CameraMode::default(),
            from: None,
            shown: None,
            scale: 1.0,
        }
    }
}

impl Rig {
    /// Takes up the size of the table: what the player has set stays as it is beside it, and another one is in the middle.
    pub fn suit(&mut self, around: &Surroundings) {
        let scale = if around.is_crowd {
            (around.table.max_element() / 2.54).clamp(0.01, 1e4)
        } else {
            1.0
        };
        if scale == self.scale {
            return;
        }
        let change = scale / self.scale;
        self.scale = scale;
        self.orbit_distance *= change;
        self.orbit_target = Self::default().orbit_target * scale;
        self.overhead_shift = Vec2::ZERO;
    }

    /// Between which distances there may be anything to see, m.
    pub fn depths(&self) -> (f32, f32) {
        (0.02 * self.scale.min(1.0), 60.0 * self.scale.max(1.0))
    }

    /// Takes what the player asks for in the present mode.
    pub fn steer(&mut self, seat: Seat, input: &CameraInput) {
        let closer = libm::expf(-input.zoom.clamp(-3.0, 3.0));
        match seat {
            Seat::Fixed(_) => {}
            Seat::Follow(_) => {
                self.follow_distance = (self.follow_distance * closer).clamp(0.2, 4.0);
                self.follow_yaw =
                    (self.follow_yaw + input.orbit.x).rem_euclid(std::f32::consts::TAU);
                self.follow_pitch = (self.follow_pitch + input.orbit.y).clamp(0.06, 1.5);
            }
            Seat::BehindCue => {
                self.behind_distance = (self.behind_distance * closer).clamp(0.25, 3.0);
                self.behind_pitch = (self.behind_pitch + input.orbit.y).clamp(0.08, 1.3);
            }
            Seat::Overhead => {
                self.overhead_zoom =
                    (self.overhead_zoom * closer).clamp(0.15 / self.scale.max(1.0), 1.5);
                self.overhead_shift += input.pan;
            }
            Seat::Orbit => {
                self.orbit_distance = (self.orbit_distance * closer)
                    .clamp(0.2_f32.min(0.2 * self.scale), 8.0 * self.scale.max(1.0));
                self.orbit_yaw = (self.orbit_yaw + input.orbit.x).rem_euclid(std::f32::consts::TAU);
                self.orbit_pitch = (self.orbit_pitch + input.orbit.y).clamp(0.06, 1.55);
                let away = Quat::from_rotation_y(self.orbit_yaw);
                self.orbit_target += away * Vec3::new(input.pan.x, 0.0, -input.pan.y);
                let most = 20.0 * self.scale.max(1.0);
                self.orbit_target = self.orbit_target.clamp_length_max(most);
            }
        }
    }

    /// The pose of the next frame, `dt` s after the last; after infinite time everything has come to rest.
    pub fn advance(
        &mut self,
        (mode, seat): (CameraMode, Seat),
        around: &Surroundings,
        dt: f32,
    ) -> Pose {
        if let Seat::Follow(Some(ball)) = seat {
            let share = 1.0 - libm::expf(-dt / CLING);
            self.followed = Some(self.followed.unwrap_or(ball).lerp(ball, share));
        }
        if let Some(ball) = around.ball {
            let share = 1.0 - libm::expf(-dt / CATCH_UP);
            let anchor = self.anchor.unwrap_or(ball).lerp(ball, share);
            // Placing a ball by hand should not make the view swim.
            self.anchor = Some(if anchor.distance(ball) < 1e-4 {
                ball
            } else {
                anchor
            });
        }
        if let Some(ball) = around.watched {
            let share = 1.0 - libm::expf(-dt / EASE);
            self.orbit_target = self.orbit_target.lerp(ball, share);
            let shift = overhead_shift_to(around, ball);
            self.overhead_shift = self.overhead_shift.lerp(shift, share);
        }
        if mode != self.mode {
            self.from = self.shown.map(|pose| (pose, 1.0));
            self.mode = mode;
        }
        let mut goal = self.goal(seat, around);
        goal.frame = if seat == Seat::Overhead {
            around.frame
        } else {
            // Beside the panels, as large as ever.
            let aside = around.frame.center().x - 0.5;
            Rect::from_center_size(Vec2::new(0.5 + aside, 0.5), WHOLE.size())
        };
        if let Some((_, left)) = &mut self.from {
            *left *= libm::expf(-dt / EASE);
            if *left < 1e-3 {
                self.from = None;
            }
        }
        let pose = match &self.from {
            Some((from, left)) => goal.towards(from, smooth(*left)),
            None => goal,
        };
        self.shown = Some(pose);
        pose
    }

    /// Where a mode wants the camera.
    fn goal(&self, seat: Seat, around: &Surroundings) -> Pose {
        match seat {
            Seat::Fixed(pose) => pose,
            Seat::Follow(_) => {
                let ball = self.followed.or(self.anchor).unwrap_or_default();
                let (sin, cos) = libm::sincosf(self.follow_pitch);
                let away = Quat::from_rotation_y(self.follow_yaw) * -around.forward;
                let eye = ball + self.follow_distance * (sin * Vec3::Y + cos * away);
                Pose::looking_at(eye, ball, Vec3::Y, 0.75)
            }
            Seat::BehindCue => {
                let anchor = self
                    .anchor
                    .unwrap_or(Vec3::new(-0.25 * around.table.x, 0.03, 0.0));
                let (sin, cos) = libm::sincosf(self.behind_pitch);
                let eye = anchor + self.behind_distance * (sin * Vec3::Y - cos * around.forward);
                let target = anchor + 0.55 * self.behind_distance * around.forward;
                Pose::looking_at(eye, target, Vec3::Y, 0.80)
            }
            Seat::Overhead => {
                let fov: f32 = 0.40;
                let size = overhead(around.table, around.aspect);
                let reach = 2.0 * libm::tanf(0.5 * fov);
                let aspect = around.aspect * around.frame.width() / around.frame.height();
                let height = (size.y / reach).max(size.x / (reach * aspect)) * self.overhead_zoom;
                let (right, up) = self::upright(around.aspect < 1.0);
                let target = self.overhead_shift.x * right + self.overhead_shift.y * up;
                Pose::looking_at(target + height * Vec3::Y, target, up, fov)
            }
            Seat::Orbit => {
                let (sin, cos) = libm::sincosf(self.orbit_pitch);
                let out = Quat::from_rotation_y(self.orbit_yaw) * Vec3::new(0.0, sin, cos);
                let eye = self.orbit_target + self.orbit_distance * out;
                Pose::looking_at(
                    eye.with_y(eye.y.max(0.06 * self.scale.min(1.0))),
                    self.orbit_target,
                    Vec3::Y,
                    0.75,
                )
            }
        }
    }
}

/// Width and height in m of what an overhead view shows of a table of this size. A tall picture turns it upright, the foot
/// up.
pub(super) fn overhead(table: Vec2, aspect: f32) -> Vec2 {
    let size = table + 2.0 * MARGIN * (table.y / 1.27).clamp(0.2, 1.0);
    if aspect < 1.0 { size.yx() } else { size }
}

/// The shift that brings a point of the table to the middle of an overhead view.
fn overhead_shift_to(around: &Surroundings, point: Vec3) -> Vec2 {
    let (right, up) = upright(around.aspect < 1.0);
    Vec2::new(point.dot(right), point.dot(up))
}

/// What is right and up in an overhead view of a table that lies, or stands upright.
fn upright(upright: bool) -> (Vec3, Vec3) {
    if upright {
        (Vec3::Z, Vec3::X)
    } else {
        (Vec3::X, Vec3::NEG_Z)
    }
}

fn smooth(t: f32) -> f32 {
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    const BEHIND: (CameraMode, Seat) = (CameraMode::BehindCue, Seat::BehindCue);
    const OVERHEAD: (CameraMode, Seat) = (CameraMode::Overhead, Seat::Overhead);

    fn around(aspect: f32) -> Surroundings {
        Surroundings {
            ball: Some(Vec3::new(-0.6, 0.03, 0.1)),
            forward: Vec3::X,
            table: Vec2::new(2.54, 1.27),
            aspect,
            frame: WHOLE,
            is_crowd: false,
            watched: None,
        }
    }

    /// Where a point of the world lies in the picture, −1 to 1 both ways.
    fn seen(pose: &Pose, aspect: f32, point: Vec3) -> Vec2 {
        let local = pose.rotation.inverse() * (point - pose.eye);
        let half = libm::tanf(0.5 * pose.fov);
        Vec2::new(
            local.x / (-local.z * half * aspect),
            local.y / (-local.z * half),
        )
    }

    #[test]
    fn overhead_shows_the_whole_table_in_any_window() {
        for aspect in [0.4, 0.7, 1.0, 1.33, 1.78, 3.5] {
            let pose = Rig::default().advance(OVERHEAD, &around(aspect), 0.0);
            for (x, z) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
                let corner = Vec3::new(1.27 * x, 0.04, 0.635 * z);
                let place = seen(&pose, aspect, corner).abs();
                assert!(place.max_element() < 1.0, "{aspect}: {corner} at {place}");
            }
        }
    }

    #[test]
    fn behind_the_cue_the_ball_is_in_the_middle_and_the_aim_points_up() {
        let around = around(1.78);
        let pose = Rig::default().advance(BEHIND, &around, 0.0);
        let ball = around.ball.expect("there is a ball");
        let near = seen(&pose, around.aspect, ball);
        let far = seen(&pose, around.aspect, ball + 0.5 * around.forward);
        assert!(near.x.abs() < 1e-5 && far.x.abs() < 1e-5);
        assert!(far.y > near.y && near.y > -1.0);
    }

    #[test]
    fn a_table_of_another_size_is_in_the_middle() {
        let (mut rig, mut around) = (Rig::default(), around(1.78));
        (rig.overhead_shift, around.table, around.is_crowd) = (Vec2::X, 9.0 * around.table, true);
        rig.suit(&around);
        assert_eq!(rig.overhead_shift, Vec2::ZERO);
    }

    #[test]
    fn without_motion_a_change_arrives_at_once() {
        let around = around(1.78);
        let mut rig = Rig::default();
        rig.advance(BEHIND, &around, f32::INFINITY);
        let goal = Rig::default().advance(OVERHEAD, &around, 0.0);
        assert_eq!(rig.advance(OVERHEAD, &around, f32::INFINITY), goal);
        let elsewhere = Surroundings {
            ball: Some(Vec3::new(0.8, 0.03, -0.4)),
            ..around
        };
        let mut fresh = Rig::default();
        let goal = fresh.advance(BEHIND, &elsewhere, 0.0);
        assert_eq!(rig.advance(BEHIND, &elsewhere, f32::INFINITY), goal);
    }

    #[test]
    fn a_change_of_mode_is_eased_and_arrives() {
        let around = around(1.78);
        let mut rig = Rig::default();
        let start = rig.advance(BEHIND, &around, 0.0);
        let goal = Rig::default().advance(OVERHEAD, &around, 0.0);
        let first = rig.advance(OVERHEAD, &around, 0.016);
        assert!(first.eye.distance(start.eye) < 0.25 * goal.eye.distance(start.eye));
        let mut last = first;
        for _ in 0..120 {
            last = rig.advance(OVERHEAD, &around, 0.016);
        }
        assert_eq!(last, goal);
    }

    #[test]
    fn a_ball_that_is_followed_stays_in_the_middle_wherever_it_goes() {
        let around = around(1.78);
        let mut rig = Rig::default();
        let mut at = Vec3::new(-0.6, 0.03, 0.1);
        for _ in 0..100 {
            at.x += 0.01;
            let seat = Seat::Follow(Some(at));
            let pose = rig.advance((CameraMode::Follow, seat), &around, 0.016);
            // It lags by no more than its way in a few frames.
            let middle = seen(&pose, around.aspect, at);
            assert!(middle.length() < 0.2, "{middle} at {at}");
        }
        // A ball that is gone is looked at where it was.
        let seat = Seat::Follow(None);
        let pose = rig.advance((CameraMode::Follow, seat), &around, 1.0);
        assert!(seen(&pose, around.aspect, at).length() < 0.2);
    }
}
