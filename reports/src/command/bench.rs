//! `arcsum bench`: engines timed against each other and against sorting; `timing.csv`, `comparison.csv` and
//! `environment.json`.

use super::{Failure, INTERRUPTED, interrupt};
use crate::bench::comparison::{Comparison, comparisons};
use crate::bench::suite::Suite;
use crate::bench::time;
use crate::bench::timing::Timing;
use crate::cases::Case;
use crate::cases::source::collect;
use crate::engine::Engine;
use crate::engine::registry::engine;
use crate::environment::Environment;
use crate::run::folder::{Folder, FolderError, write_json};
use crate::run::plan::Plan;
use clap::Args;
use std::path::PathBuf;
use std::sync::atomic::Ordering;

/// Arguments of `arcsum bench`.
#[derive(Debug, Args)]
pub struct BenchArgs {
    /// Files, folders, families (`fork`), or families of one size (`fork_5`).
    #[arg(conflicts_with = "suite")]
    cases: Vec<String>,
    /// The cases timed when none are named: families of growing size, or the nine parts and convex parts in containers.
    #[arg(long, value_enum, default_value_t = Suite::Growth)]
    suite: Suite,
    /// An engine, as for `verify`; can be given again. Times are compared with those of the first.
    #[arg(long = "engine", default_values = ["kinetic", "monotonic"])]
    engines: Vec<String>,
    /// Runs of each engine on each case; less when it takes long, never below three.
    #[arg(long, default_value_t = 7)]
    runs: usize,
    /// Leave out engines on cases where their arrangement has more vertices.
    #[arg(long, default_value_t = 1_200_000)]
    max_vertices: u64,
    /// The seed of the cases.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The output folder; what else is in it stays.
    #[arg(long, default_value = "out")]
    out: PathBuf,
}

/// Times the engines.
///
/// # Errors
/// When a word or an engine's name is bad, or the folder cannot be used.
pub fn bench(args: &BenchArgs) -> Result<u8, Failure> {
    let stop = interrupt::flag()?;
    let named: Result<Vec<_>, _> = args.engines.iter().map(|name| engine(name)).collect();
    let mut engines = named.map_err(Failure::input)?;
    let (plan, bad) = plan(args)?;
    let folder = Folder::open(&args.out).map_err(Failure::other)?;
    let environment = Environment::of(&plan, 1, args.seed, f64::INFINITY);
    write_json(&args.out.join("environment.json"), &environment).map_err(Failure::other)?;
    let mut rows = Vec::new();
    println!("{}", heading(&args.engines[0]));
    for case in &plan.cases {
        if stop.load(Ordering::Relaxed) {
            return Ok(INTERRUPTED);
        }
        rows.extend(timed(case, &mut engines, args));
        write(&folder, &rows, &args.engines[0]).map_err(Failure::other)?;
    }
    comparisons(&rows, &args.engines[0]).iter().for_each(|found| println!("{}", sentence(found)));
    Ok(if bad { 2 } else { 0 })
}

/// The cases and engines, and whether some file held no region.
fn plan(args: &BenchArgs) -> Result<(Plan, bool), Failure> {
    let (cases, bad) = if args.cases.is_empty() {
        (args.suite.cases(args.seed), false)
    } else {
        let found = collect(&args.cases, args.seed).map_err(Failure::input)?;
        found.bad.iter().for_each(|bad| eprintln!("arcsum: {bad}"));
        (found.cases, !found.bad.is_empty())
    };
    if cases.is_empty() {
        return Err(Failure::input("no case is left to be timed"));
    }
    Ok((Plan::new(cases, &args.engines).map_err(Failure::input)?, bad))
}

/// Times a case, prints its rows, and says what is missing.
fn timed(case: &Case, engines: &mut [Box<dyn Engine>], args: &BenchArgs) -> Vec<Timing> {
    let timed = time(case, engines, args.runs, args.max_vertices);
    let mut rows = Vec::new();
    for (engine, timed) in engines.iter().zip(timed) {
        match timed {
            Ok(row) => {
                println!("{}", line(&row));
                rows.push(row);
            }
            Err(missing) => eprintln!("arcsum: {}: {} was not timed: {missing}", case.name, engine.name()),
        }
    }
    rows
}

fn write(folder: &Folder, rows: &[Timing], first: &str) -> Result<(), FolderError> {
    folder.write_table("timing.csv", rows.iter())?;
    folder.write_table("comparison.csv", comparisons(rows, first).iter())
}

fn heading(first: &str) -> String {
    let to_first = format!("ratio to {first}");
    let columns = format!("{:>8} {:>9} {:>9} {:>9} {:>9}", "sums", "vertices", "cells", "ms", "ns/vertex");
    format!("{:28} {:16} {columns} {:>20} {to_first:>20}", "case", "engine", "ratio to sort")
}

fn line(row: &Timing) -> String {
    let count = |n: Option<u64>| n.map_or_else(String::new, |n| n.to_string());
    let counts = format!("{:>8} {:>9} {:>9}", count(row.sums), count(row.vertices), count(row.cells));
    let by_vertex = row.ns_per_vertex.map_or_else(String::new, |ns| format!("{ns:.0}"));
    let sort = spread([row.ratio, row.ratio_min, row.ratio_max], 1);
    let first = spread([row.to_first, row.to_first_min, row.to_first_max], 3);
    let times = format!("{:9.2} {by_vertex:>9} {sort:>20} {first:>20}", row.median_ms);
    format!("{:28} {:16} {counts} {times}", row.case, row.engine)
}

/// A ratio with its least and greatest value.
fn spread(ratio: [Option<f64>; 3], digits: usize) -> String {
    match ratio {
        [Some(middle), Some(least), Some(greatest)] => {
            format!("{middle:.digits$} ({least:.digits$}..{greatest:.digits$})")
        }
        _ => String::new(),
    }
}

fn sentence(c: &Comparison) -> String {
    let times = format!("{}: {:.1} ms in all, {}: {:.1} ms", c.engine, c.total_ms, c.first, c.first_total_ms);
    let ratio = |middle: f64, lo: f64, hi: f64| format!("{middle:.3} ({lo:.3}..{hi:.3})");
    let sums = ratio(c.ratio_of_sums, c.ratio_of_sums_lo, c.ratio_of_sums_hi);
    let mean = ratio(c.geometric_mean, c.geometric_mean_lo, c.geometric_mean_hi);
    let slower = c.slower.split_whitespace().count();
    let of = format!("of {} cases slower in {slower}, in every run of {}", c.cases, c.always_slower);
    format!(
        "{times}; ratio of sums {sums}, geometric mean of ratios {mean}, arithmetic {:.3}; {of}: {}",
        c.mean, c.slower
    )
}
