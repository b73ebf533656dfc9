//! `arcsum sum A B...`: the sum of two or more regions, any format to any format.

use super::Failure;
use crate::cases::files::read;
use crate::engine::Engine;
use crate::engine::registry::engine;
use crate::run::folder::write_whole;
use arcsum::format;
use arcsum::region::Region;
use arcsum::tidy::tidy;
use clap::Args;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

/// Arguments of `arcsum sum`.
#[derive(Debug, Args)]
pub struct SumArgs {
    /// The regions, added up from left to right.
    #[arg(required = true, num_args = 2..)]
    regions: Vec<PathBuf>,
    /// Where the sum goes, in the format its extension says; JSON to standard output without it.
    #[arg(short, long)]
    output: Option<PathBuf>,
    /// The engine.
    #[arg(long, default_value = "monotonic")]
    engine: String,
}

/// Sums the regions.
///
/// # Errors
/// When an input or the engine's name is bad, the engine gives no region, or the output cannot be written.
pub fn sum(args: &SumArgs) -> Result<u8, Failure> {
    let mut engine = engine(&args.engine).map_err(Failure::input)?;
    let regions = args.regions.iter().map(|file| read(file)).collect::<Result<Vec<_>, _>>().map_err(Failure::input)?;
    // The sentence below is all a person needs of a panic.
    std::panic::set_hook(Box::new(|_| {}));
    let mut regions = regions.into_iter();
    let mut region = regions.next().unwrap_or_default();
    for (i, next) in regions.enumerate() {
        // Results have flaws of the size of a rounding, which would add up.
        let so_far = if i == 0 { region } else { tidy(&region) };
        region = one(&mut *engine, &so_far, &next)?;
    }
    match &args.output {
        Some(file) => write_whole(file, format::json::write(&region).as_bytes()).map_err(Failure::other)?,
        None => writeln!(std::io::stdout(), "{}", format::json::write(&region).trim_end()).map_err(Failure::other)?,
    }
    Ok(0)
}

/// The sum of two regions.
fn one(engine: &mut dyn Engine, a: &Region, b: &Region) -> Result<Region, Failure> {
    if !engine.abilities().cover(a, b) {
        return Err(Failure::input(format!("{} cannot sum such regions", engine.name())));
    }
    let answer = catch_unwind(AssertUnwindSafe(|| engine.sum(a, b)));
    let answer = answer.map_err(|_| Failure::other(format!("{} panicked on this sum", engine.name())))?;
    Ok(answer.map_err(|e| Failure::other(format!("{} gave no sum: {e}", engine.name())))?.region)
}
