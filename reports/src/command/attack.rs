//! `arcsum attack CLAIM`: a search for the worst input of a claim.
//!
//! For a claim of the registry it climbs ([`crate::claims::seek`]) and leaves `worst/ID.json` in the output folder, the form of
//! the files of worst inputs that every run of the tests measures again. `falsely-free` is a search of another kind ([`free`]).

mod free;

use super::claims::chosen;
use super::{Failure, INTERRUPTED, interrupt};
use crate::claims::finding::Worst;
use crate::claims::record::written;
use crate::claims::seek::{Search, Sought, seek};
use crate::claims::sup::Sup;
use crate::claims::{Claim, Test, kept};
use crate::run::folder::{Folder, FolderError, write_json, write_whole};
use clap::Args;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::time::Duration;

/// The name of the search for falsely free points.
const FREE: &str = "falsely-free";

/// Arguments of `arcsum attack`.
#[derive(Debug, Args)]
pub struct AttackArgs {
    /// A claim by number (M13) or id (M9_corrected), or `falsely-free`: points that an engine falsely takes for free, among random
    /// pairs.
    claim: String,
    /// The seed of the inputs.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The longest time, as in 90s, 10m or 2h; for a claim with several readings, of each.
    #[arg(long = "for", default_value = "10m", value_parser = time)]
    time: Duration,
    /// Climbs at a time [default: one a processor].
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// A folder of worst inputs to bring up to date.
    #[arg(long)]
    keep: Option<PathBuf>,
    /// With `falsely-free`: the engine, one of this project's.
    #[arg(long, default_value = "monotonic")]
    engine: String,
    /// With `falsely-free`: points to test.
    #[arg(long, default_value_t = 1_000_000)]
    probes: u64,
    /// The output folder.
    #[arg(long, default_value = "out")]
    out: PathBuf,
}

fn time(text: &str) -> Result<Duration, String> {
    let (number, unit) = text.split_at(text.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(text.len()));
    let seconds = match unit {
        "" | "s" => 1.0,
        "m" => 60.0,
        "h" => 3600.0,
        _ => return Err(format!("no unit of time: {unit}")),
    };
    let number: f64 = number.parse().map_err(|_| "not a number".to_owned())?;
    Duration::try_from_secs_f64(seconds * number).map_err(|e| e.to_string())
}

/// Searches, and prints what was found.
///
/// # Errors
/// When there is no such claim, none of its readings can be attacked, or a folder cannot be used.
pub fn attack(args: &AttackArgs) -> Result<u8, Failure> {
    if args.claim == FREE {
        return free::attack(args);
    }
    let claims = chosen(std::slice::from_ref(&args.claim))?;
    let sups: Vec<(&Claim, &Sup)> = claims.iter().filter_map(single).collect();
    if sups.is_empty() {
        return Err(Failure::input(format!("{} is not about single inputs: there is nothing to search", args.claim)));
    }
    let folder = Folder::open(&args.out).map_err(Failure::other)?;
    let stop = interrupt::flag()?;
    let threads = args.threads.map_or_else(|| std::thread::available_parallelism().map_or(1, usize::from), usize::from);
    for (claim, sup) in sups {
        let search = Search { seed: args.seed, time: args.time, threads };
        let found = folder.inner("worst");
        let each = |worst: &Worst| {
            eprintln!("{}: {} {}, {} {}", claim.id, sup.quantity, bracket(worst), worst.input.size(), sup.unit);
            let so_far = Sought { worst: vec![worst.clone()], ..Sought::default() };
            if let Err(failure) = write(&found, claim, &so_far) {
                eprintln!("arcsum: {failure}");
            }
        };
        let sought = seek(claim.id, sup, search, stop, each);
        let file = write(&found, claim, &sought).map_err(Failure::other)?;
        if let Some(keep) = &args.keep {
            write(keep, claim, &sought).map_err(Failure::other)?;
        }
        print(claim, sup, &sought, &file);
    }
    Ok(if stop.load(Ordering::Relaxed) { INTERRUPTED } else { 0 })
}

fn single(claim: &Claim) -> Option<(&Claim, &Sup)> {
    match &claim.test {
        Test::Sup(sup) => Some((claim, sup)),
        Test::Whole(_) | Test::Waits(_) => None,
    }
}

/// Writes the worst inputs, and those that crashed.
fn write(folder: &Path, claim: &Claim, sought: &Sought) -> Result<PathBuf, FolderError> {
    std::fs::create_dir_all(folder).map_err(|e| FolderError::new(folder, &e))?;
    let file = folder.join(format!("{}.json", claim.stem()));
    let text = kept::write(&sought.worst).map_err(|e| FolderError::new(&file, &e))?;
    write_whole(&file, text.as_bytes())?;
    if !sought.crashed.is_empty() {
        write_json(&folder.join(format!("{}.crashed.json", claim.stem())), &sought.crashed)?;
    }
    Ok(file)
}

fn bracket(worst: &Worst) -> String {
    if worst.lo == worst.hi { written(worst.lo) } else { format!("[{}, {}]", written(worst.lo), written(worst.hi)) }
}

fn print(claim: &Claim, sup: &Sup, sought: &Sought, file: &Path) {
    let Sought { measured, climbs, crashed, worst } = sought;
    println!("{}: {measured} inputs in {climbs} climbs, {} crashes; {}", claim.id, crashed.len(), file.display());
    for found in worst {
        println!("  {} {} ({}), size {}", bracket(found), sup.unit, sup.quantity, found.input.size());
    }
}
