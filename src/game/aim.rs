//! The shot the player is preparing.

use bevy::prelude::*;

use crate::physics::cue::Shot;

/// The stroke as it stands: what the cue shows, what the preview plays and what a strike will do.
#[derive(Resource, Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    /// Index of the ball to strike.
    pub ball: usize,
    /// The stroke.
    pub shot: Shot,
    /// The elevation in rad that the player wishes. That of the shot is higher where the cue has no room, see
    /// [`lift`](crate::game::lift).
    pub wish: f64,
    /// How far the cue is drawn back, 0 to 1 of a full backstroke: what the picture shows.
    pub draw_back: f64,
}

/// The player asks for the stroke as it is aimed: the cue swings, then strikes.
#[derive(Message, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Swing;

impl Aim {
    /// Fastest stroke a player can ask for, m/s.
    pub const TOP_SPEED: f64 = 10.0;
    /// Largest offset from the centre a player can ask for, R.
    pub const TOP_OFFSET: f64 = 0.6;
    /// Steepest cue a player can ask for, rad.
    pub const TOP_ELEVATION: f64 = 1.4;

    /// The heading in degrees, from 0 up to 360.
    #[must_use]
    pub fn heading_deg(&self) -> f64 {
        let degrees = self.shot.heading.to_degrees().rem_euclid(360.0);
        // The remainder of a tiny negative angle rounds to the divisor itself; adding zero turns −0 into 0.
        if degrees >= 360.0 { 0.0 } else { degrees + 0.0 }
    }

    /// Turns the cue by this many degrees, counter-clockwise seen from above.
    pub fn turn_deg(&mut self, by: f64) {
        self.set_heading(self.shot.heading + by.to_radians());
    }

    /// Aims along this heading in rad; kept between −π and π.
    pub fn set_heading(&mut self, heading: f64) {
        use std::f64::consts::{PI, TAU};
        if heading.is_finite() {
            self.shot.heading = if (-PI..=PI).contains(&heading) {
                heading
            } else {
                (heading + PI).rem_euclid(TAU) - PI
            };
        }
    }

    /// Asks for this speed in m/s, within what a player can do.
    pub fn set_speed(&mut self, speed: f64) {
        if speed.is_finite() {
            self.shot.speed = speed.clamp(0.0, Self::TOP_SPEED);
        }
    }

    /// Raises the butt of the cue to this angle in rad, within what a player can do.
    pub fn set_elevation(&mut self, elevation: f64) {
        if elevation.is_finite() {
            self.wish = elevation.clamp(0.0, Self::TOP_ELEVATION);
            self.shot.elevation = self.wish;
        }
    }

    /// Puts the tip at this offset in R; a point beyond the reach of a player is drawn to its edge.
    pub fn set_tip(&mut self, side: f64, height: f64) {
        if !(side.is_finite() && height.is_finite()) {
            return;
        }
        let offset = (side * side + height * height).sqrt();
        let scale = if offset > Self::TOP_OFFSET {
            Self::TOP_OFFSET / offset
        } else {
            1.0
        };
        self.shot.side = side * scale;
        self.shot.height = height * scale;
    }
}

impl Default for Aim {
    fn default() -> Self {
        Self {
            ball: 0,
            shot: Shot::default(),
            wish: 0.0,
            draw_back: 0.0,
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Aim>().add_message::<Swing>();
}
