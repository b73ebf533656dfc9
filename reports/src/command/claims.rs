//! `arcsum claims [ID...]`: the experiments on the claims of the papers; `claims.csv` and a line a claim.

use super::{Failure, INTERRUPTED, interrupt};
use crate::claims::bench::Effort;
use crate::claims::finding::{Finding, Verdict};
use crate::claims::record::{Record, written};
use crate::claims::run::{Settings, run};
use crate::claims::{Claim, registry};
use crate::environment::Environment;
use crate::page;
use crate::run::folder::{Folder, write_json};
use crate::run::plan::Plan;
use clap::Args;
use std::path::PathBuf;
use std::sync::atomic::Ordering;

/// Arguments of `arcsum claims`.
#[derive(Debug, Args)]
pub struct ClaimsArgs {
    /// Claims by number (M9) or id (M9_corrected); without any, all.
    ids: Vec<String>,
    /// How much effort is made: minutes or hours.
    #[arg(long, value_enum, default_value_t)]
    effort: Effort,
    /// The seed of the inputs.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Take findings in the output folder for done if they are of the same effort, seed and version.
    #[arg(long)]
    resume: bool,
    /// Experiments at a time [default: one a processor].
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// Only make the page again, from the records in the output folder.
    #[arg(long, conflicts_with_all = ["ids", "resume", "threads"])]
    page: bool,
    /// The output folder; what else is in it stays.
    #[arg(long, default_value = "out")]
    out: PathBuf,
}

/// Tests the claims.
///
/// # Errors
/// When there is no such claim, or the folder cannot be used.
pub fn claims(args: &ClaimsArgs) -> Result<u8, Failure> {
    if args.page {
        let page = page::claims::write(&args.out).map_err(Failure::input)?;
        let page = page.ok_or_else(|| Failure::input(format!("{}: no records of claims", args.out.display())))?;
        println!("{}", page.display());
        return Ok(0);
    }
    let claims = chosen(&args.ids)?;
    let folder = Folder::open(&args.out).map_err(Failure::other)?;
    let stop = interrupt::flag()?;
    let threads = args.threads.map_or_else(|| std::thread::available_parallelism().map_or(1, usize::from), usize::from);
    let settings = Settings { effort: args.effort, seed: args.seed, threads, resume: args.resume };
    let nothing = Plan::new(Vec::new(), &[]).map_err(Failure::other)?;
    let environment = Environment::of(&nothing, threads, args.seed, 0.0);
    write_json(&folder.inner("claims").join("environment.json"), &environment).map_err(Failure::other)?;
    let mut done = 0;
    let each = |record: &Record| {
        done += 1;
        eprintln!("{done}/{} {}: {}", claims.len(), record.id, record.finding.verdict.word());
    };
    let records = run(&claims, &settings, &folder, stop, each).map_err(Failure::other)?;
    records.iter().for_each(print);
    let page = page::claims::write(&args.out).map_err(Failure::other)?;
    println!("{}", summary(&records));
    page.iter().for_each(|page| println!("{}", page.display()));
    Ok(if stop.load(Ordering::Relaxed) { INTERRUPTED } else { 0 })
}

/// The claims of these names, all without any.
///
/// # Errors
/// When there is none of a name.
pub(crate) fn chosen(names: &[String]) -> Result<Vec<Claim>, Failure> {
    if names.is_empty() {
        return Ok(registry::claims());
    }
    let mut claims: Vec<Claim> = Vec::new();
    for name in names {
        let found = registry::named(name);
        if found.is_empty() {
            return Err(Failure::input(format!("no such claim: {name}; there are M1 to M51, A1 to A4 and F1 to F16")));
        }
        claims.extend(
            found.into_iter().filter(|claim| claims.iter().all(|known| known.id != claim.id)).collect::<Vec<_>>(),
        );
    }
    Ok(claims)
}

fn print(record: &Record) {
    let Finding { verdict, lo, hi, bound, cases, undecided, note, .. } = &record.finding;
    println!("{:14} {:10} {} ({})", record.id, verdict.word(), record.says, record.place);
    if *verdict == Verdict::NotTested {
        println!("{:25} {note}", "");
        return;
    }
    let measured = if lo == hi { written(*lo) } else { format!("[{}, {}]", written(*lo), written(*hi)) };
    let bound = bound.map_or_else(String::new, |bound| format!(", bound {}", written(bound)));
    let open = if *undecided > 0 { format!(", {undecided} undecided") } else { String::new() };
    let unit = if record.unit == "1" { "" } else { &record.unit };
    println!("{:25} {}: {measured} {unit}{bound}, {cases} cases{open}", "", record.quantity);
    if let Some(control) = &record.control {
        println!("{:25} control: {}: {}, {}", "", record.plants, control.verdict.word(), written(control.lo));
    }
    for text in [note, &record.erratum].into_iter().filter(|text| !text.is_empty()) {
        println!("{:25} {text}", "");
    }
}

fn summary(records: &[Record]) -> String {
    let count = |verdict| records.iter().filter(|record| record.finding.verdict == verdict).count();
    let verdicts = [Verdict::Confirmed, Verdict::Refuted, Verdict::Undecided, Verdict::NotTested];
    let parts = verdicts.map(|verdict| format!("{} {}", count(verdict), verdict.word()));
    let controls: Vec<&Finding> = records.iter().filter_map(|record| record.control.as_ref()).collect();
    let refuted = controls.iter().filter(|control| control.verdict == Verdict::Refuted).count();
    format!("{} claims: {}; {refuted} of {} controls refuted", records.len(), parts.join(", "), controls.len())
}
