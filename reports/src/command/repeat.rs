//! `arcsum repeat ENGINE TIMES`, hidden: runs an engine on the case on standard input, for [`crate::bench::instructions`].

use super::Failure;
use crate::cases::Case;
use crate::engine::registry::engine;
use clap::Args;
use std::hint::black_box;

/// The name of the command.
pub const COMMAND: &str = "repeat";

/// Arguments of `arcsum repeat`.
#[derive(Debug, Args)]
pub struct RepeatArgs {
    /// The engine.
    engine: String,
    /// How many times it runs.
    times: usize,
}

/// Runs the engine.
///
/// # Errors
/// When there is no such engine, no case, or no sum.
pub fn repeat(args: &RepeatArgs) -> Result<u8, Failure> {
    let case: Case = serde_json::from_reader(std::io::stdin().lock()).map_err(Failure::input)?;
    let mut engine = engine(&args.engine).map_err(Failure::input)?;
    for _ in 0..args.times {
        black_box(engine.alone(&case.a, &case.b).map_err(Failure::other)?);
    }
    Ok(0)
}
