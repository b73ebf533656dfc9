//! `arcsum verify [CASES...]`: engines measured on cases.
//!
//! Files that hold no valid region are listed, a sentence each. The other cases are measured all the same, and the exit
//! code is 2 at the end; when no case is left, nothing is written.

use super::{Failure, INTERRUPTED, RunArgs, interrupt};
use crate::cases::Case;
use crate::cases::source::collect;
use crate::environment::{Environment, processors};
use crate::judge::samples::{DEFAULT, Sampling};
use crate::run::folder::write_json;
use crate::run::journal::JournalError;
use crate::run::plan::Plan;
use crate::run::{RunError, Settings, Summary, run};
use clap::Args;

/// Arguments of `arcsum verify`.
#[derive(Debug, Args)]
pub struct VerifyArgs {
    /// Files, folders, families (`fork`), or families of one size (`fork_5`); all families without any.
    cases: Vec<String>,
    /// An engine: `monotonic`, `kinetic`, `kinetic-heuristic`, `convex`, `naive-kinetic`, `kinetic-without-STEP`,
    /// `cgal:STRATEGY:KERNEL`, `cmd:PROGRAM`, or one of others where built in; can be given again.
    #[arg(long = "engine", default_value = "monotonic")]
    engines: Vec<String>,
    /// Leave out cases whose operands have more segments together.
    #[arg(long)]
    max_segments: Option<usize>,
    /// Certify cases too large for the reference at so many places each way, 200 if no number is given.
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "200", value_parser = clap::value_parser!(u32).range(1..))]
    samples: Option<u32>,
    /// Sample all cases; no reference is asked.
    #[arg(long)]
    sample_all: bool,
    #[command(flatten)]
    run: RunArgs,
}

/// Measures the engines on the cases.
///
/// # Errors
/// When a word or an engine's name is bad, no case is left, or the folder cannot be used.
pub fn verify(args: &VerifyArgs) -> Result<u8, Failure> {
    let found = collect(&args.cases, args.run.seed).map_err(Failure::input)?;
    for bad in &found.bad {
        eprintln!("arcsum: {bad}");
    }
    let fits = |c: &Case| args.max_segments.is_none_or(|most| c.segments() <= most);
    let cases: Vec<Case> = found.cases.into_iter().filter(fits).collect();
    if cases.is_empty() {
        return Err(Failure::input("no case is left to be measured"));
    }
    let mut plan = Plan::new(cases, &args.engines).map_err(Failure::input)?;
    let count = args.samples.or(args.sample_all.then_some(DEFAULT));
    plan.sampling = count.map(|count| Sampling { count, all: args.sample_all });
    let summary = measure(&plan, &args.run)?;
    match (summary.interrupted, found.bad.is_empty()) {
        (true, _) => Ok(INTERRUPTED),
        (false, true) => Ok(0),
        (false, false) => Ok(2),
    }
}

/// Carries out a plan as the arguments say and leaves `environment.json` beside the results.
pub(super) fn measure(plan: &Plan, args: &RunArgs) -> Result<Summary, Failure> {
    let threads = args.threads.map_or_else(processors, usize::from);
    let program = std::env::current_exe().map_err(Failure::other)?;
    let settings = Settings { out: args.out.clone(), threads, limit: args.time_limit, resume: args.resume, program };
    let summary = run(plan, &settings, interrupt::flag()?).map_err(|e| match e {
        RunError::Journal(JournalError::OtherRun(_)) => Failure::input(e),
        other => Failure::other(other),
    })?;
    stamp(plan, args)?;
    Ok(summary)
}

/// Writes `environment.json`.
pub(super) fn stamp(plan: &Plan, args: &RunArgs) -> Result<(), Failure> {
    let threads = args.threads.map_or_else(processors, usize::from);
    let environment = Environment::of(plan, threads, args.seed, args.time_limit.as_secs_f64());
    write_json(&args.out.join("environment.json"), &environment).map_err(Failure::other)
}
