//! `arcsum replay WITNESS`: a witness measured again. Exit code 0 when it still holds, 1 when not.

use super::claims::chosen;
use super::{Failure, INTERRUPTED, interrupt};
use crate::claims::finding::Worst;
use crate::claims::witness::ClaimWitness;
use crate::claims::{Claim, Test};
use crate::row::Row;
use crate::run::plan::Plan;
use crate::run::witness::Witness;
use crate::run::{Settings, measure_one};
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;

/// Arguments of `arcsum replay`.
#[derive(Debug, Args)]
pub struct ReplayArgs {
    /// The witness file.
    witness: PathBuf,
    /// Seconds for the engine, and again for the reference.
    #[arg(long, default_value = "60", value_parser = super::seconds)]
    time_limit: Duration,
}

/// Measures the witness again.
///
/// # Errors
/// When the file is no witness, its engine is unknown, or no worker starts.
pub fn replay(args: &ReplayArgs) -> Result<u8, Failure> {
    if let Some(witness) = ClaimWitness::read(&args.witness) {
        return again(&witness);
    }
    let witness = Witness::read(&args.witness).map_err(Failure::input)?;
    let plan = Plan::new(vec![witness.case.clone()], std::slice::from_ref(&witness.engine)).map_err(Failure::input)?;
    if plan.jobs.is_empty() {
        return Err(Failure::input(format!("{}: {} cannot sum such regions", args.witness.display(), witness.engine)));
    }
    let program = std::env::current_exe().map_err(Failure::other)?;
    let settings = Settings { out: PathBuf::new(), threads: 1, limit: args.time_limit, resume: false, program };
    let stop = interrupt::flag()?;
    let Some(record) = measure_one(&plan, &settings, stop).map_err(Failure::other)? else {
        return Ok(INTERRUPTED);
    };
    let changes = witness.changes(&record.row);
    println!("{}", witness.claim);
    println!("measured now: {}", numbers(&record.row));
    if changes.is_empty() {
        println!("holds");
        return Ok(0);
    }
    println!("no longer holds: {}", changes.join("; "));
    Ok(1)
}

/// Measures the worst input of a claim. It holds as long as the brackets have a number in common.
fn again(witness: &ClaimWitness) -> Result<u8, Failure> {
    let known = chosen(std::slice::from_ref(&witness.claim))?.into_iter().find(|claim| claim.id == witness.claim);
    let Some(Claim { says, test: Test::Sup(sup), .. }) = known else {
        return Err(Failure::input(format!("{} is not measured on single inputs", witness.claim)));
    };
    println!("{}: {says}", witness.claim);
    let Some(now) = (sup.measure)(&witness.worst.input) else {
        println!("no longer holds: the claim says nothing about this input");
        return Ok(1);
    };
    let Worst { lo, hi, .. } = witness.worst;
    println!("measured now: {} in [{}, {}] {}, was in [{lo}, {hi}]", sup.quantity, now.lo, now.hi, sup.unit);
    let holds = now.lo <= hi && now.hi >= lo;
    println!("{}", if holds { "holds" } else { "no longer holds" });
    Ok(u8::from(!holds))
}

fn numbers(row: &Row) -> String {
    let number = |v: Option<f64>| v.map_or_else(|| "-".to_owned(), |v| format!("{v:e}"));
    let checks = row.failed_checks.as_deref().unwrap_or("-");
    let mut text =
        format!("{:?}, mu in [{}, {}], failed checks {checks}", row.status, number(row.mu_lo), number(row.mu_hi));
    if !row.note.is_empty() {
        text.push_str(", ");
        text.push_str(&row.note);
    }
    text
}
