//! What is true beyond the horizon, as Markdown.

use std::fmt::Write;

use crate::physics::ball::Ball;
use crate::report::speed_and_error::ladder::GAS;
use crate::report::speed_and_error::many::{COUNTED, COVERED, enskog_rate};
use crate::report::speed_and_error::{BOARD, DAM, Ensemble, Report};

/// Writes a table for each scene that was played many times.
pub(super) fn write(report: &Report, out: &mut String) -> std::fmt::Result {
    let mut scenes: Vec<&str> = Vec::new();
    for ensemble in &report.ensembles {
        if !scenes.contains(&ensemble.scene.as_str()) {
            scenes.push(&ensemble.scene);
        }
    }
    if scenes.is_empty() {
        return Ok(());
    }
    writeln!(
        out,
        "## Beyond the horizon\n\nWhere no single shot can be told, many are compared: mean \u{b1} standard deviation, and in brackets how far the mean lies from the exact solver's in standard errors of the difference: up to 2 it is chance.\n"
    )?;
    for scene in scenes {
        let of: Vec<&Ensemble> = report
            .ensembles
            .iter()
            .filter(|ensemble| ensemble.scene == scene)
            .collect();
        table(report, scene, &of, out)?;
    }
    Ok(())
}

fn table(report: &Report, scene: &str, of: &[&Ensemble], out: &mut String) -> std::fmt::Result {
    let quantities = of[0].quantities;
    let shots = of[0].shots;
    writeln!(out, "### {scene}\n\n{}\n", about(report, scene, shots))?;
    writeln!(
        out,
        "| method | {} |\n|---|{}",
        quantities.join(" | "),
        "---|".repeat(quantities.len())
    )?;
    for ensemble in of {
        write!(out, "| {} |", ensemble.method)?;
        for ((mean, spread), off) in ensemble.values.iter().zip(&ensemble.off) {
            write!(out, " {mean:.3} \u{b1} {spread:.3} ({off:+.1}) |")?;
        }
        writeln!(out)?;
    }
    writeln!(out)
}

/// What was played, and what is known of it beforehand.
fn about(report: &Report, scene: &str, shots: usize) -> String {
    match scene {
        GAS => {
            let balls = COUNTED.min(report.effort.most_balls);
            let theory = enskog_rate(COVERED, Ball::POOL.radius, 1.0);
            format!(
                "{shots} gases of {balls} balls, counted for a second after one in which they forget the lattice that they began on. Kinetic theory (Enskog's rate, Henderson's pressure of hard discs) has {theory:.1} contacts of a ball a second in an endless gas of mean square speed 1 m\u{b2}/s\u{b2}; at a wall there are more, so a small box lies above: by 1 % with 2,500 balls, by 0.1 % with 50,000. Speeds of Maxwell's law have 2 in the last column."
            )
        }
        DAM => format!(
            "{shots} breaks, each with other pushes of a centimetre a second at most at the start, 1.2 s after it: later the balls lie in heaps, whose lasting contacts the exact solver cannot follow."
        ),
        BOARD => format!("{shots} balls, one by one."),
        _ => format!(
            "{shots} breaks, each turned by up to 1e-3 rad. Paths are summed over chords of 1/60 s."
        ),
    }
}
