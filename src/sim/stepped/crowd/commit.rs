//! The end of a tick: balls on their last paths.

use crate::physics::laws::motion::MotionLaw;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::field::Field;
use crate::sim::stepped::crowd::share::{light, share};
use crate::sim::stepped::crowd::stretch::Stretch;
use crate::sim::stepped::crowd::stripe::place;

impl<B: Body> Field<B> {
    /// Puts the balls that were turned on their last paths.
    pub fn commit(&mut self, threads: usize) {
        let mut rest = &mut self.bodies[..];
        let mut homes = Vec::with_capacity(self.stripes.len());
        for stripe in &self.stripes {
            let (home, others) = rest.split_at_mut(stripe.home.len());
            homes.push(home);
            rest = others;
        }
        share(
            light(threads, self.moving),
            self.stripes.iter_mut().zip(homes),
            |(stripe, home)| stripe.commit(home),
        );
        for stripe in &mut self.stripes {
            for id in std::mem::take(&mut stripe.foreign) {
                let (ball, body) = stripe.turned.at(id as usize);
                self.bodies[ball.slot as usize] = body;
                if ball.place & place::STILL != 0 {
                    stripe.still.clear(place::index(ball.place));
                    self.woken.push(ball.slot);
                    self.stirred[ball.slot as usize - self.moving] = true;
                }
            }
        }
    }

    /// The friction of the coursework report comes after the tick.
    pub fn rub(&mut self, stretch: &Stretch) {
        let MotionLaw::Coursework(coursework) = &stretch.laws.motion else {
            return;
        };
        let (law, ball, at) = (&stretch.laws.motion, &stretch.ball, stretch.end);
        let rub = |body: &mut B| {
            let state = coursework.rub(ball, &body.state(ball, at), at - stretch.start);
            *body = B::start(law, ball, &law.classify(ball, state), at);
        };
        self.bodies[..self.moving].iter_mut().for_each(rub);
        for slot in &self.woken {
            rub(&mut self.bodies[*slot as usize]);
        }
    }
}
