//! Contacts that come too often: balls pressed together, by others around them or by a slope, would meet without end.

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::stretch::Stretch;
use crate::sim::stepped::crowd::turned::Seen;
use crate::sim::stepped::resolve::BOUNCES;

/// A ball that has met so many others in a part of a tick that it no longer bounces meets them at most this often in a
/// part. Until then they may overlap a little.
const RATTLES: f64 = 16.0;
/// On a slope, contacts of a ball that follow each other within this share of a part of a tick can be one that lasts. The
/// longer, the more what lies there trembles; the shorter, the more contacts it costs.
const LASTING: f64 = 0.5;
/// They are one if the later closes no faster than a ball falls in so many of these times: what lies under so many others
/// trembles about as fast. In a gas some slow contacts lose nothing for it, fewer the shorter the tick.
const DEPTH: f64 = 64.0;

impl Stretch<'_> {
    /// Least time in s to the next contact of a ball with so many impacts in this part of the tick.
    #[inline]
    pub fn pause(&self, impacts: u32) -> f64 {
        if impacts < BOUNCES {
            0.0
        } else {
            (self.end - self.start) / RATTLES
        }
    }

    /// The restitution of a contact of balls on these legs, the greater number of impacts of both, that lasts, instead of the
    /// law's. On a slope it loses nothing (the TC model of Luding et al., Granular Matter 1 (1998) 113): what lies there
    /// keeps trembling, and the time between its contacts does not go to zero. Elsewhere nothing drives balls together
    /// again: after too many impacts they give nothing back.
    #[inline]
    pub fn settled<B: Body>(
        &self,
        time: f64,
        legs: [&Seen<B>; 2],
        closing: impl FnOnce() -> f64,
    ) -> Option<f64> {
        if self.pull == 0.0 {
            let impacts = legs[0].impacts.max(legs[1].impacts);
            return (u32::from(impacts) >= BOUNCES).then_some(0.0);
        }
        let long = LASTING * (self.end - self.start);
        let lately = legs.iter().any(|leg| time - leg.body.since() < long);
        let most = self.pull * long * if lately { DEPTH } else { 0.5 };
        (closing() < most).then_some(1.0)
    }
}
