//! A scene on the command line, and what may be changed in it.

use clap::{Args, ValueEnum};

use crate::cli::CommandError;
use crate::physics::scene::{Scene, Solver, Stepped};
use crate::scenarios::file::Scenario;
use crate::scenarios::{library, preset};

/// Which scene, and what is changed in it.
#[derive(Args, Debug)]
pub(super) struct SceneOptions {
    /// Built-in scene (see `masse list`), scene file or shared text
    pub(super) scene: String,
    /// Solver to use instead of the one the scene names
    #[arg(long, value_enum)]
    solver: Option<SolverName>,
    /// Length in s of a tick of the stepped solver
    #[arg(long, value_name = "S")]
    tick: Option<f64>,
    /// Grid of the stepped solver, such as 20x20; `none` tests every pair
    #[arg(long, value_name = "COLUMNSxROWS", value_parser = grid)]
    grid: Option<GridOption>,
    /// Seconds after which the run ends even if balls still move
    #[arg(long, value_name = "S")]
    time_limit: Option<f64>,
    /// Preset to play it with (see `masse list`), or a preset file
    #[arg(long, value_name = "NAME|FILE")]
    preset: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SolverName {
    /// Every event at its own time
    Exact,
    /// A fixed tick
    Stepped,
}

#[derive(Clone, Copy, Debug)]
struct GridOption(Option<(u32, u32)>);

fn grid(text: &str) -> Result<GridOption, String> {
    if text == "none" {
        return Ok(GridOption(None));
    }
    text.split_once('x')
        .and_then(|(columns, rows)| Some((columns.parse().ok()?, rows.parse().ok()?)))
        .map(|cells| GridOption(Some(cells)))
        .ok_or_else(|| "two numbers such as 20x20, or `none`".to_owned())
}

impl SceneOptions {
    /// The scene, changed to what the options say and checked.
    pub(super) fn open(&self) -> Result<Scenario, CommandError> {
        let mut scenario = library::open(&self.scene)?;
        self.change(&mut scenario.scene)?;
        Ok(scenario)
    }

    /// Changes a scene to what the options say.
    fn change(&self, scene: &mut Scene) -> Result<(), CommandError> {
        if let Some(name) = &self.preset {
            let shot = scene.shot;
            if !preset::open(name)?.equipment.take_over(scene) {
                return Err(CommandError::Usage(format!(
                    "--preset {name}: the balls of the scene have no room there"
                )));
            }
            scene.shot = shot;
        }
        match (self.solver, scene.solver) {
            (Some(SolverName::Exact), _) => scene.solver = Solver::Exact,
            (Some(SolverName::Stepped), Solver::Exact) => {
                scene.solver = Solver::Stepped(Stepped::default());
            }
            _ => {}
        }
        if let Some(time_limit) = self.time_limit {
            scene.time_limit = time_limit;
        }
        if self.tick.is_some() || self.grid.is_some() {
            let Solver::Stepped(stepped) = &mut scene.solver else {
                return Err(CommandError::Usage(
                    "--tick and --grid belong to the stepped solver; add --solver stepped"
                        .to_owned(),
                ));
            };
            stepped.tick = self.tick.unwrap_or(stepped.tick);
            if let Some(GridOption(cells)) = self.grid {
                stepped.grid = cells;
            }
        }
        scene.check()?;
        Ok(())
    }
}
