//! `arcsum sum A B`: one sum, any format to any format.

use super::Failure;
use crate::cases::files::read;
use crate::engine::registry::engine;
use crate::run::folder::write_whole;
use arcsum::format;
use clap::Args;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

/// Arguments of `arcsum sum`.
#[derive(Debug, Args)]
pub struct SumArgs {
    /// The first region.
    a: PathBuf,
    /// The second region.
    b: PathBuf,
    /// Where the sum goes, in the format its extension says; JSON to standard output without it.
    #[arg(short, long)]
    output: Option<PathBuf>,
    /// The engine.
    #[arg(long, default_value = "kinetic")]
    engine: String,
}

/// Sums the two regions.
///
/// # Errors
/// When an input or the engine's name is bad, the engine gives no region, or the output cannot be written.
pub fn sum(args: &SumArgs) -> Result<u8, Failure> {
    let mut engine = engine(&args.engine).map_err(Failure::input)?;
    let (a, b) = (read(&args.a).map_err(Failure::input)?, read(&args.b).map_err(Failure::input)?);
    if !engine.abilities().cover(&a, &b) {
        return Err(Failure::input(format!("{} cannot sum such regions", engine.name())));
    }
    // The sentence below is all a person needs of a panic.
    std::panic::set_hook(Box::new(|_| {}));
    let answer = catch_unwind(AssertUnwindSafe(|| engine.sum(&a, &b)));
    let answer = answer.map_err(|_| Failure::other(format!("{} panicked on this sum", args.engine)))?;
    let region = answer.map_err(|e| Failure::other(format!("{} gave no sum: {e}", args.engine)))?.region;
    match &args.output {
        Some(file) => write_whole(file, format::json::write(&region).as_bytes()).map_err(Failure::other)?,
        None => writeln!(std::io::stdout(), "{}", format::json::write(&region).trim_end()).map_err(Failure::other)?,
    }
    Ok(0)
}
