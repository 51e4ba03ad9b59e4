//! From a scene to a table in motion.

use crate::physics::exact::cells::Cells;
use crate::physics::exact::engine::Engine;
use crate::physics::exact::flight::Flight;
use crate::physics::exact::queue::Queue;
use crate::physics::exact::walls::Walls;
use crate::physics::exact::{Limits, SolveError};
use crate::physics::laws::cluster::{Cluster, TOUCH, Touched};
use crate::physics::record::PathPiece;
use crate::physics::scene::Scene;

/// From this many balls on neighbours are found by cells.
const MANY: usize = 40;

/// From this many cushions and pockets on they are found by cells.
const MANY_WALLS: usize = 120;

impl Engine {
    /// The balls of a scene at time 0, before its shot.
    ///
    /// # Errors
    /// [`SolveError`] if the laws have no closed form or a number is not finite. Overlaps are found when they matter;
    /// [`Scene::check`] finds them before.
    pub fn new(scene: &Scene, limits: Limits) -> Result<Self, SolveError> {
        let mut engine = Self::unpredicted(scene, limits)?;
        engine.predict_all()?;
        Ok(engine)
    }

    /// Begins again with a scene, in the room of the old one: on the same table with as many balls nothing is allocated.
    /// This is what a preview calls every frame. The result is that of [`Self::new`] to the last bit.
    ///
    /// # Errors
    /// As [`Self::new`]; the engine is then of no further use.
    pub fn reload(&mut self, scene: &Scene) -> Result<(), SolveError> {
        if self.table != scene.table
            || self.count() != scene.balls.len()
            || self.widest != widest(scene)
        {
            *self = Self::new(scene, self.limits)?;
            return Ok(());
        }
        if let Some(cells) = &mut self.cells {
            for ball in 0..self.bodies.len() {
                cells.remove(ball as u32);
            }
        }
        self.paths.clear();
        self.flights.clear();
        self.place(scene)?;
        self.predict_all()
    }

    /// Everything but the next events.
    pub(super) fn unpredicted(scene: &Scene, limits: Limits) -> Result<Self, SolveError> {
        let count = scene.balls.len();
        let radius = widest(scene);
        let walls = Walls::new(&scene.table, radius);
        let cells = (count >= MANY || walls.list.len() >= MANY_WALLS)
            .then(|| Cells::new(&scene.table, &walls, count, 2.0 * radius));
        let everyone = match cells {
            Some(_) => Vec::new(),
            None => (0..count as u32).collect(),
        };
        let mut engine = Self {
            table: scene.table.clone(),
            laws: scene.laws,
            names: vec![String::new(); count],
            bodies: scene.balls.iter().map(|ball| ball.ball).collect(),
            paths: Vec::with_capacity(count),
            flights: Vec::with_capacity(count),
            touched: vec![Touched::NOTHING; count],
            widest: radius,
            touch: 1.001 * TOUCH * (4.0 * radius + TOUCH),
            walls,
            cells,
            queue: Queue::new(count),
            clock: 0.0,
            last: 0.0,
            happened: 0,
            limits,
            cluster: Cluster::default(),
            near: Vec::new(),
            everyone,
        };
        engine.place(scene)?;
        Ok(engine)
    }

    /// Puts the balls on their first paths.
    fn place(&mut self, scene: &Scene) -> Result<(), SolveError> {
        if !scene.laws.motion.is_closed_form() {
            return Err(SolveError::NotClosedForm);
        }
        self.laws = scene.laws;
        self.touched.fill(Touched::NOTHING);
        self.clock = 0.0;
        self.last = 0.0;
        self.happened = 0;
        for (index, ball) in scene.balls.iter().enumerate() {
            self.names[index].clone_from(&ball.name);
            self.bodies[index] = ball.ball;
            let mut state = scene.laws.motion.classify(&ball.ball, ball.state);
            if !state.motion.flies() && state.motion.in_play() {
                // Files round: on the slate is on the slate.
                state.position.y = ball.ball.radius;
            }
            if !state.is_finite() {
                return Err(self.not_finite(index, state));
            }
            let path = PathPiece {
                time: 0.0,
                piece: scene.laws.piece(&scene.table, &ball.ball, &state),
            };
            self.paths.push(path);
            self.flights.push(Flight::new(&ball.ball, &path, 0));
            if let Some(cells) = self.cells.as_mut().filter(|_| state.motion.in_play()) {
                let cell = cells.at(glam::DVec2::new(state.position.x, state.position.z));
                cells.insert(index as u32, cell);
            }
        }
        Ok(())
    }

    fn predict_all(&mut self) -> Result<(), SolveError> {
        (0..self.count()).try_for_each(|ball| self.predict(ball))?;
        self.wake_loose(&mut ())
    }
}

/// The largest radius.
fn widest(scene: &Scene) -> f64 {
    scene
        .balls
        .iter()
        .fold(0.0, |most, ball| most.max(ball.ball.radius))
}
