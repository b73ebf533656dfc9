//! `arcsum bench`: sums timed against sorting, on families of growing size; `timing.csv` and `environment.json`.

use super::{Failure, INTERRUPTED, interrupt};
use crate::bench::{Timing, cases, time};
use crate::environment::Environment;
use crate::run::folder::{Folder, write_json};
use crate::run::plan::Plan;
use clap::Args;
use std::path::PathBuf;
use std::sync::atomic::Ordering;

/// Arguments of `arcsum bench`.
#[derive(Debug, Args)]
pub struct BenchArgs {
    /// Runs of each case; less when it takes long, never below three.
    #[arg(long, default_value_t = 7)]
    runs: usize,
    /// Leave out cases whose arrangement has more vertices.
    #[arg(long, default_value_t = 1_200_000)]
    max_vertices: usize,
    /// The seed of the cases.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The output folder; what else is in it stays.
    #[arg(long, default_value = "out")]
    out: PathBuf,
}

/// Times the built-in engine.
///
/// # Errors
/// When the folder cannot be used, or the engine refuses a case.
pub fn bench(args: &BenchArgs) -> Result<u8, Failure> {
    let stop = interrupt::flag()?;
    let folder = Folder::open(&args.out).map_err(Failure::other)?;
    let plan = Plan::new(cases(args.seed), &["kinetic".to_owned()]).map_err(Failure::other)?;
    let environment = Environment::of(&plan, 1, args.seed, f64::INFINITY);
    write_json(&args.out.join("environment.json"), &environment).map_err(Failure::other)?;
    let mut rows: Vec<Timing> = Vec::new();
    println!("{:20} {:>9} {:>10} {:>10} {:>16}", "case", "vertices", "ms", "ns/vertex", "ratio to sort");
    for case in &plan.cases {
        if stop.load(Ordering::Relaxed) {
            return Ok(INTERRUPTED);
        }
        if let Some(row) = time(case, args.runs, args.max_vertices).map_err(Failure::other)? {
            println!("{}", line(&row));
            rows.push(row);
            folder.write_table("timing.csv", rows.iter()).map_err(Failure::other)?;
        }
    }
    Ok(0)
}

fn line(row: &Timing) -> String {
    let spread = format!("{:.1} ({:.1}..{:.1})", row.ratio, row.ratio_min, row.ratio_max);
    format!("{:20} {:9} {:10.2} {:10.0} {spread:>16}", row.case, row.vertices, row.median_ms, row.ns_per_vertex)
}
