//! `arcsum report`: the built-in cases at quick effort on every built-in engine, then the page. The last line printed is
//! the path of the page.

use super::verify::measure;
use super::{Failure, INTERRUPTED, RunArgs};
use crate::cases::source::collect;
use crate::engine::registry::BUILT_IN;
use crate::page;
use crate::run::plan::Plan;
use clap::Args;

/// Arguments of `arcsum report`.
#[derive(Debug, Args)]
pub struct ReportArgs {
    #[command(flatten)]
    run: RunArgs,
}

/// Measures and writes the page.
///
/// # Errors
/// When the folder cannot be used or the page cannot be made.
pub fn report(args: &ReportArgs) -> Result<u8, Failure> {
    let found = collect(&[], args.run.seed).map_err(Failure::input)?;
    let engines: Vec<String> = BUILT_IN.iter().map(|&e| e.to_owned()).collect();
    let plan = Plan::new(found.cases, &engines).map_err(Failure::input)?;
    if measure(&plan, &args.run)?.interrupted {
        return Ok(INTERRUPTED);
    }
    let index = page::write(&args.run.out).map_err(Failure::other)?;
    println!("{}", index.canonicalize().unwrap_or(index).display());
    Ok(0)
}
