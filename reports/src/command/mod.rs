//! The command line: one module a command, each returning an exit code or one sentence.
//!
//! Exit codes: 0 done, 1 a witness that no longer holds or a failure of the machine, 2 bad input, 130 interrupted.

pub mod attack;
pub mod bench;
pub mod claims;
pub mod interrupt;
pub mod iterate;
pub mod repeat;
pub mod replay;
pub mod report;
pub mod sum;
pub mod verify;

use crate::engine::cgal::COMMAND;
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

/// Exit code after an interrupt from the keyboard.
pub const INTERRUPTED: u8 = 130;

/// Measures how wrong a floating-point Minkowski sum is, and proves it.
#[derive(Debug, Parser)]
#[command(name = "arcsum", version)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// The sum of two or more regions, any format to any format.
    Sum(sum::SumArgs),
    /// Measure engines on cases: files, folders and built-in families.
    Verify(verify::VerifyArgs),
    /// Measure the built-in cases and make the page; the last line is its path.
    Report(report::ReportArgs),
    /// Measure a witness again and say whether it still holds.
    Replay(replay::ReplayArgs),
    /// Test the claims of the papers and print their verdicts.
    Claims(claims::ClaimsArgs),
    /// Search for cases that a claim does not hold for.
    Attack(attack::AttackArgs),
    /// Time engines against each other and against sorting.
    Bench(bench::BenchArgs),
    /// Add B to A again and again and measure each sum.
    Iterate(iterate::IterateArgs),
    /// Measure cases for a parent process.
    #[command(hide = true)]
    Worker,
    /// Run an engine again and again, for a parent process that counts.
    #[command(hide = true, name = repeat::COMMAND)]
    Repeat(repeat::RepeatArgs),
    /// Answer questions to CGAL for a parent process.
    #[command(hide = true, name = COMMAND)]
    Cgal,
}

/// Why a command failed, in one sentence.
#[derive(Debug, thiserror::Error)]
#[error("{message}")]
pub struct Failure {
    /// The exit code.
    pub code: u8,
    /// The sentence.
    pub message: String,
}

impl Failure {
    /// The input is at fault.
    #[must_use]
    pub fn input(message: impl ToString) -> Self {
        Self { code: 2, message: message.to_string() }
    }

    /// The machine is at fault, or this program.
    #[must_use]
    pub fn other(message: impl ToString) -> Self {
        Self { code: 1, message: message.to_string() }
    }
}

/// How a run is carried out, the same for all commands that measure.
#[derive(Clone, Debug, Args)]
pub struct RunArgs {
    /// The seed of the built-in cases.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Go on with the interrupted run in the output folder.
    #[arg(long)]
    pub resume: bool,
    /// Seconds for an engine, and again for the reference, on a case.
    #[arg(long, default_value = "60", value_parser = seconds)]
    pub time_limit: Duration,
    /// Worker processes at a time [default: one a processor].
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
    /// The output folder.
    #[arg(long, default_value = "out")]
    pub out: PathBuf,
}

pub(crate) fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.parse().map_err(|_| "not a number of seconds".to_owned())?;
    let limit = Duration::try_from_secs_f64(seconds).map_err(|e| e.to_string())?;
    if limit.is_zero() { Err("a limit of no time".into()) } else { Ok(limit) }
}

/// Runs the command line and prints the sentence of a failure.
#[must_use]
pub fn main() -> ExitCode {
    let done = match Cli::parse().command {
        Command::Sum(args) => sum::sum(&args),
        Command::Verify(args) => verify::verify(&args),
        Command::Report(args) => report::report(&args),
        Command::Replay(args) => replay::replay(&args),
        Command::Claims(args) => claims::claims(&args),
        Command::Attack(args) => attack::attack(&args),
        Command::Bench(args) => bench::bench(&args),
        Command::Iterate(args) => iterate::iterate(&args),
        Command::Repeat(args) => repeat::repeat(&args),
        Command::Cgal => arcsum_cgal::child::serve().map(|()| 0).map_err(Failure::other),
        Command::Worker => crate::worker::child::serve().map(|()| 0).map_err(Failure::other),
    };
    match done {
        Ok(code) => ExitCode::from(code),
        Err(failure) => {
            eprintln!("arcsum: {failure}");
            ExitCode::from(failure.code)
        }
    }
}
