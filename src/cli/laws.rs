//! `masse laws`.

use clap::Args;
use serde_json::json;

use crate::cli::{CommandError, judge, to_stdout};
use crate::report::catalogue;

/// Which law.
#[derive(Args, Debug)]
pub(super) struct LawsOptions {
    /// A law, such as Han2005: its formula, its numbers with their ranges, and every row of the judges
    law: Option<String>,
    /// Write it as one JSON value
    #[arg(long)]
    json: bool,
}

/// Lists the laws with their papers and their errors, or tells everything of one.
pub(super) fn run(options: &LawsOptions) -> Result<(), CommandError> {
    let all = catalogue::all();
    let wanted = |name: &String| {
        let found: Vec<_> = all.iter().filter(|law| law.name == *name).collect();
        if found.is_empty() {
            let names: Vec<&str> = all.iter().map(|law| law.name.as_str()).collect();
            return Err(CommandError::Usage(format!(
                "laws: there is no law `{name}`; there are {}",
                names.join(", ")
            )));
        }
        Ok(found)
    };
    let found = options.law.as_ref().map(wanted).transpose()?;
    let judgement = judge::judgement(1.0)?;
    to_stdout(|out| {
        if options.json {
            let told = found.unwrap_or_else(|| all.iter().collect());
            let told = told.iter().map(|law| {
                let rows = judgement.exact.iter().chain(&judgement.experiments);
                let rows = rows.chain(&judgement.coursework);
                let rows: Vec<_> = rows.filter(|row| law.is_judged_by(row)).collect();
                json!({"law": law, "verdict": law.verdict(&judgement), "rows": rows})
            });
            let told: Vec<_> = told.collect();
            serde_json::to_writer_pretty(&mut *out, &told)?;
            return writeln!(out);
        }
        match found {
            Some(found) => found
                .iter()
                .try_for_each(|law| out.write_all(catalogue::sheet(law, &judgement).as_bytes())),
            None => out.write_all(catalogue::table(&judgement).as_bytes()),
        }
    })
}
