//! Where a ball is, and past what it comes.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::scenarios::expect::check::{Checked, Checker};
use crate::scenarios::expect::kinds::Kind;
use crate::scenarios::expect::moment::{Moment, Spot};
use crate::scenarios::expect::phrase::{Phrase, Word, say};
use crate::scenarios::expect::reading::{Ends, Play, Reading};
use crate::scenarios::expect::standing::Progress;
use crate::scenarios::expect::tell;
use crate::scenarios::expect::trace::{self, place, plan};

/// The centre of the ball is near to a place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Near {
    /// The ball.
    pub ball: String,
    /// The place.
    pub at: Spot,
    /// Greatest distance in plan, m.
    pub within: f64,
    /// When; the end, if nothing is said.
    #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
    pub when: Moment,
}

impl Kind for Near {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.spot("at", &self.at)?;
        checker.positive("within", self.within)?;
        checker.moment("when", &self.when)
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.ball)?;
        let Some(state) = play.state(ball, &self.when) else {
            return Some(play.never(&self.when));
        };
        let mark = self.at.point(play.scene)?;
        let distance = plan(state.position).distance(mark);
        let mut reading = Reading::within(distance, "m away", Ends(None, Some(self.within)), 1.0);
        if !state.motion.in_play() {
            reading.miss = reading.miss.max(0.5);
        }
        Some(reading)
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.came(&self.when)
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-near", "{a} is within {within} m of {spot} at {when}",
            a: tell::ball(&self.ball), within: Word::Number(self.within),
            spot: tell::spot(&self.at), when: tell::moment(&self.when),
        )
    }
}

/// The centre of the ball is in a rectangle, x and z in m.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Inside {
    /// The ball.
    pub ball: String,
    /// The corner with the least x and z.
    pub least: (f64, f64),
    /// The corner with the greatest.
    pub most: (f64, f64),
    /// When; the end, if nothing is said.
    #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
    pub when: Moment,
}

impl Kind for Inside {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.moment("when", &self.when)?;
        checker.ends(Ends(Some(self.least.0), Some(self.most.0)))?;
        checker.ends(Ends(Some(self.least.1), Some(self.most.1)))
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.ball)?;
        let Some(state) = play.state(ball, &self.when) else {
            return Some(play.never(&self.when));
        };
        let at = plan(state.position);
        let (least, most) = (DVec2::from(self.least), DVec2::from(self.most));
        let outside = at.distance(at.clamp(least, most));
        Some(Reading::within(
            outside,
            "m outside",
            Ends(None, Some(0.0)),
            1.0,
        ))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.came(&self.when)
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-inside",
            "{a} is between x = {x} m, z = {z} m and x = {xx} m, z = {zz} m at {when}",
            a: tell::ball(&self.ball), x: Word::Number(self.least.0), z: Word::Number(self.least.1),
            xx: Word::Number(self.most.0), zz: Word::Number(self.most.1),
            when: tell::moment(&self.when),
        )
    }
}

/// The centre of the ball passes a mark.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Passes {
    /// The ball.
    pub ball: String,
    /// The mark.
    pub at: Spot,
    /// Greatest distance in plan, m.
    pub within: f64,
    /// Only what comes after this moment counts.
    #[serde(default, skip_serializing_if = "Moment::is_start")]
    pub from: Moment,
    /// Only what comes before this moment counts.
    #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
    pub until: Moment,
}

impl Kind for Passes {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.spot("at", &self.at)?;
        checker.positive("within", self.within)?;
        checker.moment("from", &self.from)?;
        checker.moment("until", &self.until)
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.ball)?;
        let mark = self.at.point(play.scene)?;
        let span = play.span(&self.from, &self.until)?;
        let away = |time: f64| plan(place(play.record, ball, time)).distance(mark);
        let (_, distance) = trace::least(play.record, &[ball], span, away)?;
        Some(Reading::within(
            distance,
            "m away",
            Ends(None, Some(self.within)),
            1.0,
        ))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.met || (progress.came(&self.until) && progress.came(&self.from))
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-passes", "{a} passes within {within} m of {spot}{span}",
            a: tell::ball(&self.ball), within: Word::Number(self.within),
            spot: tell::spot(&self.at), span: tell::between(&self.from, &self.until),
        )
    }
}
