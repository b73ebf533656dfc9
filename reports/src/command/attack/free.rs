//! `arcsum attack falsely-free`: the search over random pairs for points that an engine falsely takes for free.
//!
//! The output folder gets `attack.csv`, a line a kind of pairs; `results.csv`, the measured cases that show something; and a
//! witness for each of them.

use super::AttackArgs;
use crate::attack::tally::Line;
use crate::attack::{Attack, Found, Search, What};
use crate::command::{Failure, INTERRUPTED, interrupt};
use crate::run::folder::{Folder, FolderError, write_json};
use crate::run::witness::Witness;
use std::sync::atomic::Ordering;

/// Searches, and prints what was found.
///
/// # Errors
/// When the engine is none of this project's, or the folder cannot be used.
pub(super) fn attack(args: &AttackArgs) -> Result<u8, Failure> {
    let search = Search { engine: args.engine.clone(), seed: args.seed, probes: args.probes, time: args.time };
    let mut attack = Attack::new(search).map_err(Failure::input)?;
    let folder = Folder::fresh(&args.out).map_err(Failure::other)?;
    let stop = interrupt::flag()?;
    let mut kept: Vec<Found> = Vec::new();
    attack
        .run(stop, |found| {
            kept.push(found);
            keep(&folder, args, &kept)
        })
        .map_err(Failure::other)?;
    folder.write_table("attack.csv", attack.tally.lines()).map_err(Failure::other)?;
    attack.tally.lines().for_each(print);
    Ok(if stop.load(Ordering::Relaxed) { INTERRUPTED } else { 0 })
}

/// Writes the rows so far and the witness of the last one.
fn keep(folder: &Folder, args: &AttackArgs, kept: &[Found]) -> Result<(), FolderError> {
    folder.write_table("results.csv", kept.iter().map(|found| &found.row))?;
    let Some(Found { case, row, what }) = kept.last() else { return Ok(()) };
    let claim = match what {
        What::Inside => "falsely free points inside of a cell in spite of 2 mu separation",
        What::Boundary => "falsely free points on the boundary in spite of 2 mu separation",
        What::Unseparated => "falsely free points without 2 mu separation",
        What::Conflict => "a swap against the convolution order",
    };
    let witness = Witness {
        claim: claim.into(),
        engine: args.engine.clone(),
        options: "default".into(),
        seed: Some(args.seed),
        version: env!("CARGO_PKG_VERSION").into(),
        case: case.clone(),
        measured: row.clone(),
    };
    write_json(&folder.witness(kept.len()), &witness)
}

fn print(line: &Line) {
    let number = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| format!("{value:.3e}"));
    println!(
        "{:9} {:8} cases {:10} probes {:7} suspects {:6} inside {:6} measured {:5} undecided; rho > mu: {:4} inside {:4} on \
         the boundary {:4} not separated, \
         separation/mu from {} to {}, rho up to {}; {:4} order conflicts, separation/mu from {}",
        line.kind,
        line.cases,
        line.probes,
        line.suspects,
        line.suspects_inside,
        line.measured,
        line.undecided,
        line.inside,
        line.boundary,
        line.unseparated,
        number(line.least_ratio),
        number(line.greatest_ratio),
        number(line.greatest_rho),
        line.conflicts,
        number(line.least_ratio_of_conflicts),
    );
}
