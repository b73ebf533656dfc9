//! `arcsum report`: the built-in cases at quick effort on every built-in engine, a short timing, then the page. The last
//! line printed is the path of the page.

use super::verify::{measure, stamp};
use super::{Failure, INTERRUPTED, RunArgs};
use crate::cases::source::collect;
use crate::engine::registry::BUILT_IN;
use crate::page;
use crate::run::plan::Plan;
use clap::Args;
use std::process::{Command, Stdio};

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
    time_sums(args)?;
    // The timing left its own.
    stamp(&plan, &args.run)?;
    let index = page::write(&args.run.out).map_err(Failure::other)?;
    if args.run.out.join("timing.csv").is_file() {
        // Once more: now there is a page to link to.
        page::bench::write(&args.run.out).map_err(Failure::other)?;
    }
    println!("{}", index.canonicalize().unwrap_or(index).display());
    Ok(0)
}

/// A short `arcsum bench` into the same folder, in a process of its own: if it dies the page has no timing, and says so.
fn time_sums(args: &ReportArgs) -> Result<(), Failure> {
    let program = std::env::current_exe().map_err(Failure::other)?;
    let seed = args.run.seed.to_string();
    let ended = Command::new(program)
        .args([
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
            "--time-limit",
            "5",
            "--seed",
            &seed,
            "--out",
        ])
        .arg(&args.run.out)
        .stdout(Stdio::null())
        .status()
        .map_err(Failure::other)?;
    if !ended.success() {
        eprintln!("arcsum: the timing failed: {ended}");
    }
    Ok(())
}
