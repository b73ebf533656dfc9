//! `arcsum bench`: engines timed against each other and against sorting; `timing.csv`, `comparison.csv`, `goals.csv`,
//! `environment.json` and the page `bench.html`.

mod lines;

use super::{Failure, INTERRUPTED, interrupt, seconds};
use crate::bench::comparison::comparisons;
use crate::bench::goals::reached;
use crate::bench::instructions::Counter;
use crate::bench::look::{Limits, Looks};
use crate::bench::suite::Suite;
use crate::bench::timing::Timing;
use crate::bench::{Effort, time};
use crate::cases::Case;
use crate::cases::source::{collect, number_repeats};
use crate::engine::Engine;
use crate::engine::cgal::NOT_BUILT_IN;
use crate::engine::registry::engine;
use crate::environment::Environment;
use crate::page;
use crate::run::folder::{Folder, write_json};
use crate::run::plan::Plan;
use crate::worker::parent::WorkerError;
use clap::Args;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Arguments of `arcsum bench`.
#[derive(Clone, Debug, Args)]
pub struct BenchArgs {
    /// Files, folders, families (`fork`), or families of one size (`fork_5`).
    cases: Vec<String>,
    /// Cases timed besides those named, and when none are named [default: peers]: families of growing size, the nine parts
    /// and convex parts in containers, or what engines of others are compared on.
    #[arg(long, value_enum)]
    suite: Option<Suite>,
    /// An engine, as for `verify`; can be given again. Times are compared with those of the first [default: ours with culling
    /// and those of others that are built in].
    #[arg(long = "engine")]
    engines: Vec<String>,
    /// Runs of each engine on each case; less when it takes long, never below three.
    #[arg(long, default_value_t = 7)]
    runs: usize,
    /// Leave out engines on cases where their arrangement has more vertices, and on larger ones of the family.
    #[arg(long, default_value_t = 1_200_000)]
    max_vertices: u64,
    /// Seconds for an engine, and again for the reference, on the first look at a case.
    #[arg(long, default_value = "60", value_parser = seconds)]
    time_limit: Duration,
    /// Seconds above which an engine runs once and is left out on larger cases of the family.
    #[arg(long, default_value = "10", value_parser = seconds)]
    slow: Duration,
    /// Count the machine instructions of sums of up to two seconds, with valgrind.
    #[arg(long)]
    instructions: bool,
    /// The seed of the cases.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The output folder; what else is in it stays.
    #[arg(long, default_value = "out")]
    out: PathBuf,
    /// Time nothing: make the page again from the tables in the output folder.
    #[arg(long)]
    page: bool,
}

/// The engines that are timed when none are named, ours first.
const COMPARED: [&str; 11] = [
    "monotonic-culled",
    "kinetic-culled",
    "cgal:reduced:exact",
    "cgal:small-side:exact",
    "cgal:vertical:exact",
    "cgal:reduced:inexact",
    "clipper2:minkowski",
    "clipper2:union",
    "i_overlay",
    "cavalier",
    "clipper2:flat-1e-3",
];

/// Those of them that are built in.
fn compared() -> Vec<String> {
    let is_built_in = |name: &&str| engine(name).is_ok_and(|engine| engine.version() != NOT_BUILT_IN);
    let (there, missing): (Vec<&str>, Vec<&str>) = COMPARED.into_iter().partition(is_built_in);
    if !missing.is_empty() {
        eprintln!("arcsum: left out, for they are not built in: {}", missing.join(", "));
    }
    there.into_iter().map(str::to_owned).collect()
}

/// Times the engines.
///
/// # Errors
/// When a word or an engine's name is bad, or the folder cannot be used.
pub fn bench(args: &BenchArgs) -> Result<u8, Failure> {
    if args.page {
        return page(args).map(|()| 0);
    }
    let engines = if args.engines.is_empty() { compared() } else { args.engines.clone() };
    let args = &BenchArgs { engines, ..args.clone() };
    let stop = interrupt::flag()?;
    let (plan, bad) = plan(args)?;
    let mut bench = Bench::new(args)?;
    let environment = Environment::of(&plan, 1, args.seed, args.time_limit.as_secs_f64());
    write_json(&args.out.join("environment.json"), &environment).map_err(Failure::other)?;
    println!("{}", lines::heading(&args.engines[0]));
    for case in &plan.cases {
        if stop.load(Ordering::Relaxed) || !bench.time(case, stop)? {
            return Ok(INTERRUPTED);
        }
    }
    comparisons(&bench.rows, &args.engines[0]).iter().for_each(|found| println!("{}", lines::sentence(found)));
    page(args)?;
    Ok(if bad { 2 } else { 0 })
}

/// Makes the page and prints where it is.
fn page(args: &BenchArgs) -> Result<(), Failure> {
    let file = page::bench::write(&args.out).map_err(Failure::other)?;
    println!("{}", file.canonicalize().unwrap_or(file).display());
    Ok(())
}

/// The cases and engines, and whether some file held no region.
fn plan(args: &BenchArgs) -> Result<(Plan, bool), Failure> {
    let mut bad = false;
    let suite = args.suite.or(args.cases.is_empty().then_some(Suite::Peers));
    let mut cases = suite.map_or(Vec::new(), |suite| suite.cases(args.seed));
    if !args.cases.is_empty() {
        let found = collect(&args.cases, args.seed).map_err(Failure::input)?;
        found.bad.iter().for_each(|bad| eprintln!("arcsum: {bad}"));
        bad = !found.bad.is_empty();
        cases.extend(found.cases);
        number_repeats(&mut cases);
    }
    if cases.is_empty() {
        return Err(Failure::input("no case is left to be timed"));
    }
    Ok((Plan::new(cases, &args.engines).map_err(Failure::input)?, bad))
}

/// A run under way.
struct Bench<'a> {
    args: &'a BenchArgs,
    folder: Folder,
    engines: Vec<Box<dyn Engine>>,
    looks: Looks,
    counter: Option<Counter>,
    rows: Vec<Timing>,
}

impl<'a> Bench<'a> {
    fn new(args: &'a BenchArgs) -> Result<Self, Failure> {
        let named: Result<Vec<_>, _> = args.engines.iter().map(|name| engine(name)).collect();
        let program = std::env::current_exe().map_err(Failure::other)?;
        let counter = args.instructions.then(|| Counter::new(program.clone())).flatten();
        if args.instructions && counter.is_none() {
            eprintln!("arcsum: no instructions are counted: valgrind is not installed");
        }
        Ok(Self {
            args,
            engines: named.map_err(Failure::input)?,
            folder: Folder::open(&args.out).map_err(Failure::other)?,
            looks: Looks::new(Limits { program, time: args.time_limit, slow: args.slow }),
            counter,
            rows: Vec::new(),
        })
    }

    /// Times a case, prints its rows and puts them on disk; whether nobody stopped it.
    fn time(&mut self, case: &Case, stop: &AtomicBool) -> Result<bool, Failure> {
        let effort = Effort { rounds: self.args.runs, most: self.args.max_vertices, counter: self.counter.as_ref() };
        let rows = match time(case, &mut self.engines, effort, &mut self.looks, stop) {
            Ok(rows) => rows,
            Err(WorkerError::Stopped) => return Ok(false),
            Err(error) => return Err(Failure::other(error)),
        };
        for (engine, row) in self.engines.iter().zip(&rows) {
            match row {
                Some(row) => println!("{}", lines::line(row)),
                None => eprintln!("arcsum: {}: {} cannot sum such regions", case.name, engine.name()),
            }
        }
        self.rows.extend(rows.into_iter().flatten());
        self.write()?;
        Ok(true)
    }

    fn write(&self) -> Result<(), Failure> {
        let first = &self.args.engines[0];
        self.folder.write_table("timing.csv", self.rows.iter()).map_err(Failure::other)?;
        self.folder.write_table("comparison.csv", comparisons(&self.rows, first).iter()).map_err(Failure::other)?;
        self.folder.write_table("goals.csv", reached(&self.rows, first).iter()).map_err(Failure::other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        args: BenchArgs,
    }

    fn cases(words: &[&str]) -> Vec<String> {
        let line = Line::parse_from([&["bench"], words].concat());
        plan(&line.args).unwrap().0.cases.into_iter().map(|case| case.name).collect()
    }

    #[test]
    fn named_cases_come_after_those_of_a_suite_and_alone_without_one() {
        let suite = cases(&["--suite", "parts"]);
        let both = cases(&["--suite", "parts", "fork_2", "fig8_8"]);
        assert_eq!(both[..suite.len()], suite);
        assert_eq!(both[suite.len()..], ["fork_2", "fig8_8#2"], "names stay unique");
        assert_eq!(cases(&["fork_2"]), ["fork_2"]);
    }
}
