//! `arcsum iterate [CASES...]`: A + B, A + 2 B, ... with their errors; `iterated.csv`.

use super::{Failure, INTERRUPTED, interrupt};
use crate::cases::Case;
use crate::cases::source::collect;
use crate::engine::registry::engine;
use crate::iterate::{Row, cases, chain};
use crate::run::folder::Folder;
use crate::worker::parent::{Worker, WorkerError};
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;

/// Arguments of `arcsum iterate`.
#[derive(Debug, Args)]
pub struct IterateArgs {
    /// Files, folders or families; without any, the nine parts added to themselves and polygons of each kind.
    cases: Vec<String>,
    /// An engine, as for `verify`; can be given again.
    #[arg(long = "engine", default_values = ["kinetic", "monotonic"])]
    engines: Vec<String>,
    /// How often B is added.
    #[arg(long, default_value_t = 10)]
    depth: usize,
    /// Seconds for the reference at a step; where they run out, this step and the later ones are undecided.
    #[arg(long, default_value = "60", value_parser = super::seconds)]
    time_limit: Duration,
    /// The seed of the built-in cases.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The output folder; what else is in it stays.
    #[arg(long, default_value = "out")]
    out: PathBuf,
}

/// Measures the chains.
///
/// # Errors
/// When a word or an engine's name is bad, or the folder cannot be used.
pub fn iterate(args: &IterateArgs) -> Result<u8, Failure> {
    let stop = interrupt::flag()?;
    let named: Result<Vec<_>, _> = args.engines.iter().map(|name| engine(name)).collect();
    let mut engines = named.map_err(Failure::input)?;
    let (cases, bad) = chains(args)?;
    let folder = Folder::open(&args.out).map_err(Failure::other)?;
    let mut worker = Worker::new(std::env::current_exe().map_err(Failure::other)?, args.time_limit);
    let (mut rows, mut wrong): (Vec<Row>, _) = (Vec::new(), None);
    for case in &cases {
        for engine in engines.iter_mut().filter(|engine| engine.abilities().cover(&case.a, &case.b)) {
            let mut each = |row: Row| {
                println!("{}", line(&row));
                rows.push(row);
                wrong = folder.write_table("iterated.csv", rows.iter()).err();
            };
            let limits = (args.depth, args.time_limit);
            match chain(case, engine.as_mut(), &mut worker, limits, stop, &mut each) {
                Err(WorkerError::Stopped) => return Ok(INTERRUPTED),
                other => other.map_err(Failure::other)?,
            }
            wrong.take().map_or(Ok(()), |e| Err(Failure::other(e)))?;
        }
    }
    Ok(if bad { 2 } else { 0 })
}

/// The chains, and whether some file held no region.
fn chains(args: &IterateArgs) -> Result<(Vec<Case>, bool), Failure> {
    if args.cases.is_empty() {
        return Ok((cases::cases(args.seed), false));
    }
    let found = collect(&args.cases, args.seed).map_err(Failure::input)?;
    found.bad.iter().for_each(|bad| eprintln!("arcsum: {bad}"));
    Ok((found.cases, !found.bad.is_empty()))
}

fn line(row: &Row) -> String {
    let bits = row.bits.map_or_else(|| "undecided".to_owned(), |bits| format!("{bits:.1} bits"));
    let count = |n: Option<usize>| n.map_or_else(String::new, |n| n.to_string());
    let segments = format!("{} segments, exactly {}", count(row.segments), count(row.exact_segments));
    format!(
        "{:16} {:16} {:>3} {bits:>10}  {}  {}",
        row.case,
        row.engine,
        row.depth,
        segments.trim_end_matches(", exactly "),
        row.note
    )
}
