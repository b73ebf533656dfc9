//! `arcsum report`: the built-in cases at quick effort on every built-in engine, a short timing, the claims of the papers, then the
//! page. The last line printed is the path of the page.

use super::verify::{measure, stamp};
use super::{Failure, INTERRUPTED, RunArgs, interrupt};
use crate::cases::source::collect;
use crate::engine::registry::BUILT_IN;
use crate::page;
use crate::run::plan::Plan;
use clap::Args;
use std::process::{Command, Stdio};
use std::sync::atomic::Ordering;

/// Arguments of `arcsum report`.
#[derive(Debug, Args)]
pub struct ReportArgs {
    #[command(flatten)]
    run: RunArgs,
}

/// Measures and writes the page.
///
/// # Errors
/// When the folder cannot be used or the page cannot be made.
pub fn report(args: &ReportArgs) -> Result<u8, Failure> {
    let found = collect(&[], args.run.seed).map_err(Failure::input)?;
    let engines: Vec<String> = BUILT_IN.iter().map(|&e| e.to_owned()).collect();
    let plan = Plan::new(found.cases, &engines).map_err(Failure::input)?;
    if measure(&plan, &args.run)?.interrupted {
        return Ok(INTERRUPTED);
    }
    let stop = interrupt::flag()?;
    beside(&BENCH, args)?;
    let resume = if args.run.resume { &["--resume"][..] } else { &[] };
    if !stop.load(Ordering::Relaxed) {
        beside(&[&CLAIMS, resume].concat(), args)?;
    }
    if stop.load(Ordering::Relaxed) {
        return Ok(INTERRUPTED);
    }
    // The timing left its own.
    stamp(&plan, &args.run)?;
    let index = page::write(&args.run.out).map_err(Failure::other)?;
    if args.run.out.join("timing.csv").is_file() {
        // Once more: now there is a page to link to.
        page::bench::write(&args.run.out).map_err(Failure::other)?;
    }
    page::claims::write(&args.run.out).map_err(Failure::other)?;
    println!("{}", index.canonicalize().unwrap_or(index).display());
    Ok(0)
}

/// A short `arcsum bench`.
const BENCH: [&str; 12] = [
    "bench",
    "--suite",
    "growth",
    "--engine",
    "kinetic",
    "--engine",
    "monotonic",
    "--runs",
    "3",
    "--max-vertices",
    "150000",
    "--time-limit=5",
];

/// The experiments on the papers' claims, at quick effort.
const CLAIMS: [&str; 1] = ["claims"];

/// Another command into the same folder, in a process of its own: if it dies the page lacks its part, and says so.
fn beside(command: &[&str], args: &ReportArgs) -> Result<(), Failure> {
    let program = std::env::current_exe().map_err(Failure::other)?;
    let ended = Command::new(program)
        .args(command)
        .args(["--seed", &args.run.seed.to_string(), "--out"])
        .arg(&args.run.out)
        .stdout(Stdio::null())
        .status()
        .map_err(Failure::other)?;
    if !ended.success() {
        eprintln!("arcsum: {} failed: {ended}", command[0]);
    }
    Ok(())
}
