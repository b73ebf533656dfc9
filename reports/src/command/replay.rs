//! `arcsum replay WITNESS`: a witness measured again. Exit code 0 when it still holds, 1 when not.

use super::{Failure, INTERRUPTED, interrupt};
use crate::row::Row;
use crate::run::plan::Plan;
use crate::run::witness::Witness;
use crate::run::{Settings, measure_one};
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;

/// Arguments of `arcsum replay`.
#[derive(Debug, Args)]
pub struct ReplayArgs {
    /// The witness file.
    witness: PathBuf,
    /// Seconds for the engine, and again for the reference.
    #[arg(long, default_value = "60", value_parser = super::seconds)]
    time_limit: Duration,
}

/// Measures the witness again.
///
/// # Errors
/// When the file is no witness, its engine is unknown, or no worker starts.
pub fn replay(args: &ReplayArgs) -> Result<u8, Failure> {
    let witness = Witness::read(&args.witness).map_err(Failure::input)?;
    let plan = Plan::new(vec![witness.case.clone()], std::slice::from_ref(&witness.engine)).map_err(Failure::input)?;
    if plan.jobs.is_empty() {
        return Err(Failure::input(format!("{}: {} cannot sum such regions", args.witness.display(), witness.engine)));
    }
    let program = std::env::current_exe().map_err(Failure::other)?;
    let settings = Settings { out: PathBuf::new(), threads: 1, limit: args.time_limit, resume: false, program };
    let stop = interrupt::flag()?;
    let Some(record) = measure_one(&plan, &settings, stop).map_err(Failure::other)? else {
        return Ok(INTERRUPTED);
    };
    let changes = witness.changes(&record.row);
    println!("{}", witness.claim);
    println!("measured now: {}", numbers(&record.row));
    if changes.is_empty() {
        println!("holds");
        return Ok(0);
    }
    println!("no longer holds: {}", changes.join("; "));
    Ok(1)
}

fn numbers(row: &Row) -> String {
    let number = |v: Option<f64>| v.map_or_else(|| "-".to_owned(), |v| format!("{v:e}"));
    let checks = row.failed_checks.as_deref().unwrap_or("-");
    let mut text =
        format!("{:?}, mu in [{}, {}], failed checks {checks}", row.status, number(row.mu_lo), number(row.mu_hi));
    if !row.note.is_empty() {
        text.push_str(", ");
        text.push_str(&row.note);
    }
    text
}
