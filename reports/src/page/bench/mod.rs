//! `bench.html`: the page that an engine is chosen by, made from `timing.csv`, `comparison.csv` and `goals.csv` alone.
//!
//! Only `timing.csv` must be there. The same files give the same page.

mod engines;
mod goals;
mod plots;
mod stages;
mod wrong;

#[cfg(test)]
mod tests;

use super::file::{Sheet, rows};
use super::{PageError, Section, document, save, table};
use crate::bench::comparison::Comparison;
use crate::bench::goals::Reached;
use crate::bench::timing::Timing;
use std::io;
use std::path::{Path, PathBuf};

/// The name of the page.
pub const FILE: &str = "bench.html";

const GUIDE: &str = include_str!("guide.html");

/// Writes the page from the tables in `dir`; returns its path.
///
/// # Errors
///
/// If `timing.csv` is missing, if a table is there but broken, or if the page cannot be written.
pub fn write(dir: &Path) -> Result<PathBuf, PageError> {
    let timing = dir.join("timing.csv");
    let missing = || PageError::Io { file: timing.clone(), source: io::ErrorKind::NotFound.into() };
    let (sheet, timings) = rows::<Timing>(&timing)?.ok_or_else(missing)?;
    let reached = rows::<Reached>(&dir.join("goals.csv"))?;
    let comparisons = rows::<Comparison>(&dir.join("comparison.csv"))?;
    let sections = sections(&sheet, &timings, reached, comparisons.map(|(sheet, _)| sheet));
    let other: Vec<_> =
        dir.join("index.html").is_file().then_some(("index.html", "Measured errors")).into_iter().collect();
    let file = dir.join(FILE);
    save(&file, &document("arcsum: engines side by side", GUIDE, &other, "", &sections))?;
    Ok(file)
}

fn sections(
    sheet: &Sheet,
    timings: &[Timing],
    reached: Option<(Sheet, Vec<Reached>)>,
    comparisons: Option<Sheet>,
) -> Vec<Section> {
    let section = |id, title, html| Section { id, title, html };
    let mut sections = Vec::new();
    if let Some((_, reached)) = reached {
        sections.push(section("goals", "Goals", goals::html(&reached)));
    }
    sections.push(section("engines", "Ratio of times by engine and family", engines::html(timings)));
    sections.push(section("wrong", "Wrong, crashed, too slow", wrong::html(timings)));
    sections.push(section("plots", "Time against size", plots::html(timings)));
    sections.push(section("stages", "Where the time goes", stages::html(timings)));
    if let Some(sheet) = comparisons {
        sections.push(section("comparison", "Each engine against the first", table::plain("comparison.csv", &sheet)));
    }
    sections.push(section("rows", "All rows", table::plain("timing.csv", sheet)));
    sections
}
