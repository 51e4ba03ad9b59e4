//! The report as Markdown.

use std::fmt::Write;

use crate::report::speed_and_error::comparison::Measured;
use crate::report::speed_and_error::fit::Convergence;
use crate::report::speed_and_error::{Comparison, GridCost, Method, NUDGE, Report, beyond};

/// What a crowd in single precision is.
const SINGLE: &str = "*In f32*: places and velocities of a crowd are kept, moved and changed at contacts in single precision; only times of contacts are found in f64 from these. Every contact on the paths as they are kept is found, so none is missed; but paths are off by rounding from the first contact on, and energy is kept but for the rounding of all contacts. It is a method for smooth balls without cloth.";

/// The whole report as Markdown, with its pictures beside it.
#[must_use]
pub fn markdown(report: &Report) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = write(report, &mut text);
    text
}

fn write(report: &Report, out: &mut String) -> std::fmt::Result {
    let length = if report.effort.quick {
        "short report (`--quick`)"
    } else {
        "full report"
    };
    writeln!(
        out,
        "# Speed against error\n\nmasse {}, {length}.\n",
        env!("CARGO_PKG_VERSION")
    )?;
    writeln!(
        out,
        "Each scene is played by every method from {} places. *Cost* is processor time for a second of the scene, the cheapest of \
         repeated rounds, on one thread, laying out the balls not counted for the stepped methods. *Error* is the distance from \
         the exact solver at every 1/{} s before the horizon: the first contact that comes out otherwise when the whole motion is \
         turned by {NUDGE:e} rad at the start. *Floor* is how far that turn alone carries a ball until then; errors up to it, or up \
         to 1e-9 m, are rounding. The exact solver is the truth for the others; for the coursework model, whose laws are its own, \
         the error is how far it is off real physics.\n\n{SINGLE}\n",
        report.effort.starts,
        crate::report::speed_and_error::play::SAMPLES,
    )?;
    for (file, of) in [
        ("speed-against-error", "Error against cost"),
        ("error-against-tick", "Error against tick"),
    ] {
        writeln!(out, "![{of}]({file}.svg)\n")?;
    }
    for scene in &report.scenes {
        scene_table(scene, out)?;
    }
    orders(report, out)?;
    beyond::write(report, out)?;
    crowds(report, out)?;
    grids(report, out)?;
    drifts(report, out)
}

fn scene_table(scene: &Comparison, out: &mut String) -> std::fmt::Result {
    let (from, to) = scene.until();
    let end = if scene.truths.iter().all(|truth| truth.whole) {
        "to the end"
    } else {
        "to the horizon"
    };
    let contacts: usize = scene.truths.iter().map(|truth| truth.contacts).sum();
    write!(
        out,
        "## {}\n\n{}. Compared {end}, ",
        scene.rung.name, scene.rung.title
    )?;
    if from == to {
        write!(out, "{to:.3} s")?;
    } else {
        write!(out, "{from:.3} to {to:.3} s")?;
    }
    writeln!(
        out,
        "; {contacts} contacts in {} starts; floor {:.1e} m.\n",
        scene.truths.len(),
        scene.floor()
    )?;
    writeln!(
        out,
        "| method | cost, ms/s | error rms, m | largest, m | energy off by | contacts alike | starts that differ | on the front |"
    )?;
    writeln!(out, "|---|--:|--:|--:|--:|--:|--:|---|")?;
    let front = scene.front();
    for (
        place,
        Measured {
            method,
            cost,
            errors,
        },
    ) in scene.measured.iter().enumerate()
    {
        let alike = match errors.agreed {
            None => "-".to_owned(),
            Some(usize::MAX) => "all".to_owned(),
            Some(_) if errors.differing == 0 => "all".to_owned(),
            Some(agreed) => format!("first {agreed}"),
        };
        let differing = errors
            .agreed
            .map_or("-".to_owned(), |_| errors.differing.to_string());
        let best = if front.contains(&place) { "yes" } else { "" };
        writeln!(
            out,
            "| {method} | {:.4} | {} | {} | {} | {alike} | {differing} | {best} |",
            1e3 * cost,
            size(errors.rms),
            size(errors.most),
            size(errors.energy),
        )?;
    }
    writeln!(out)
}

fn size(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else {
        format!("{value:.1e}")
    }
}

/// The families of stepped methods, each once.
pub(super) fn families(scene: &Comparison) -> Vec<Method> {
    let mut families: Vec<Method> = Vec::new();
    for measured in &scene.measured {
        if families
            .iter()
            .all(|family| family.family() != measured.method.family())
        {
            families.push(measured.method);
        }
    }
    families
}

fn orders(report: &Report, out: &mut String) -> std::fmt::Result {
    writeln!(
        out,
        "## Order in the tick\n\nThe slope of log error against log tick. Located contacts must be of order 2 or better, or exact to rounding, where nothing amplifies errors.\n"
    )?;
    writeln!(
        out,
        "| scene | method | order | demanded |\n|---|---|---|---|"
    )?;
    for scene in &report.scenes {
        for family in families(scene)
            .into_iter()
            .filter(|family| family.rate().is_some())
        {
            let order = match scene.convergence(family) {
                Convergence::Rounding => "exact to rounding".to_owned(),
                Convergence::Order { order, scatter } => {
                    format!("{order:.2} (scatter {scatter:.2} powers of ten)")
                }
                Convergence::Unknown => "-".to_owned(),
            };
            let demanded = match family {
                Method::Located(_) if scene.rung.gentle && scene.keeps_order() => "2: pass",
                Method::Located(_) if scene.rung.gentle => "2: MISS",
                _ => "",
            };
            writeln!(
                out,
                "| {} | {} | {order} | {demanded} |",
                scene.rung.name,
                family.family()
            )?;
        }
    }
    writeln!(out)
}

fn crowds(report: &Report, out: &mut String) -> std::fmt::Result {
    let mut columns: Vec<&str> = Vec::new();
    let mut counts: Vec<u32> = Vec::new();
    for cost in &report.crowds {
        if !columns.contains(&cost.what.as_str()) {
            columns.push(&cost.what);
        }
        if !counts.contains(&cost.balls) {
            counts.push(cost.balls);
        }
    }
    writeln!(
        out,
        "## What a ball costs\n\nNanoseconds of processor time a ball and 1/120 s; balls cover 0.4 of the floor and move at about 1 m/s.\n\n![Cost per ball](cost-per-ball.svg)\n"
    )?;
    writeln!(
        out,
        "| balls | {} |\n|--:{}|",
        columns.join(" | "),
        "|--:".repeat(columns.len())
    )?;
    for count in counts {
        write!(out, "| {count} |")?;
        for column in &columns {
            let cost = report
                .crowds
                .iter()
                .find(|cost| cost.balls == count && cost.what == *column);
            write!(
                out,
                " {} |",
                cost.map_or(String::new(), |cost| format!("{:.1}", cost.nanoseconds))
            )?;
        }
        writeln!(out)?;
    }
    for (cheap, dear) in [(AT_REST, CLOTH), (IN_F32, SMOOTH)] {
        let of = |what| {
            let row = report.crowds.iter().rfind(|cost| cost.what == what);
            row.map(|cost| (cost.balls, cost.nanoseconds))
        };
        if let (Some((balls, cheap_cost)), Some((_, cost))) = (of(cheap), of(dear)) {
            let share = cheap_cost / cost;
            writeln!(
                out,
                "\nOf {balls} balls, \"{cheap}\" costs {share:.3} of \"{dear}\"."
            )?;
        }
    }
    writeln!(out)
}

/// What is set beside each other in a sentence.
const AT_REST: &str = "stepped, as a crowd, all but one at rest, with cloth and spin";
const CLOTH: &str = "stepped, as a crowd, with cloth and spin";
const IN_F32: &str = "stepped, as a crowd in f32, without friction";
const SMOOTH: &str = "stepped, as a crowd, without friction";

/// The cheapest grid of each way, in the order of the ways.
pub(super) fn best_grids(report: &Report) -> Vec<&GridCost> {
    let mut best: Vec<&GridCost> = Vec::new();
    for cost in &report.grids {
        match best.iter_mut().find(|best| best.what == cost.what) {
            Some(best) if cost.milliseconds < best.milliseconds => *best = cost,
            Some(_) => {}
            None => best.push(cost),
        }
    }
    best
}

fn grids(report: &Report, out: &mut String) -> std::fmt::Result {
    let balls = report.grid_balls;
    writeln!(
        out,
        "## The grid: {balls} balls\n\nThe experiment of the coursework report: processor time of a tick against the number of cells.\n\n![Time of a tick against the number of cells](grid.svg)\n"
    )?;
    for best in best_grids(report) {
        writeln!(
            out,
            "- {}: best are {} x {} cells of {:.4} m, {:.2} diameters of a ball: {:.3} ms a tick",
            best.what, best.cells, best.cells, best.side, best.diameters, best.milliseconds
        )?;
    }
    writeln!(
        out,
        "\n| cells | side, diameters | way | ms a tick |\n|--:|--:|---|--:|"
    )?;
    for cost in &report.grids {
        writeln!(
            out,
            "| {0} x {0} | {1:.2} | {2} | {3:.3} |",
            cost.cells, cost.diameters, cost.what, cost.milliseconds
        )?;
    }
    writeln!(out)
}

fn drifts(report: &Report, out: &mut String) -> std::fmt::Result {
    writeln!(
        out,
        "## Energy\n\nHow far the energy is off, as a part of that at the start: in the gas it should stay, with cloth it should be the exact solver's.\n\n![Energy over time](energy.svg)\n"
    )?;
    writeln!(
        out,
        "| scene | method | after, s | largest | at the end |\n|---|---|--:|--:|--:|"
    )?;
    for drift in &report.drifts {
        let largest = drift
            .points
            .iter()
            .map(|point| point.1.abs())
            .fold(0.0, f64::max);
        let (time, end) = drift.points.last().copied().unwrap_or_default();
        writeln!(
            out,
            "| {} | {} | {time:.2} | {} | {} |",
            drift.scene,
            drift.method,
            size(largest),
            size(end)
        )?;
    }
    Ok(())
}
