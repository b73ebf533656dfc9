//! `claims.html`: the verdicts on the papers' claims, made from `claims/*.json` alone: a table, then each claim with its number, its
//! control, its plot, its worst input and the command that repeats it, and the errata with a witness each.

mod card;
mod errata;
mod plot;

#[cfg(test)]
mod tests;

use super::table::{Cell, Table};
use super::{PageError, Section, document, file, save};
use crate::claims::record::{Record, written};
use crate::claims::registry;
use std::path::{Path, PathBuf};

/// The name of the page.
pub const FILE: &str = "claims.html";

const GUIDE: &str = include_str!("guide.html");

/// Writes the page from the records in `dir`; returns its path, or nothing if there are none.
///
/// # Errors
///
/// If a record is broken, or the page cannot be written.
pub fn write(dir: &Path) -> Result<Option<PathBuf>, PageError> {
    let mut records: Vec<Record> = Vec::new();
    for claim in registry::claims() {
        records.extend(file::json(&dir.join("claims").join(claim.stem() + ".json"))?);
    }
    if records.is_empty() {
        return Ok(None);
    }
    let section = |id, title, html| Section { id, title, html };
    let sections = [
        section("verdicts", "Verdicts", verdicts(&records)),
        section("claims", "Claim by claim", records.iter().map(card::html).collect()),
        section("errata", "Errata, each with a witness", errata::html()),
    ];
    let other: Vec<_> =
        dir.join("index.html").is_file().then_some(("index.html", "Measured errors")).into_iter().collect();
    let page = dir.join(FILE);
    save(&page, &document("arcsum: the claims of the papers", GUIDE, &other, "", &sections))?;
    Ok(Some(page))
}

fn verdicts(records: &[Record]) -> String {
    let columns = [
        ("claim", ""),
        ("verdict", ""),
        ("it says", ""),
        ("measured", "the worst case, its lower bound where it is a bracket"),
        ("bound", ""),
        ("unit", ""),
        ("cases", "inputs that were measured"),
        ("undecided", "of these, how many decide nothing"),
        ("control", "the verdict on the planted error"),
    ];
    let mut table = Table::new("claims.csv in short", columns);
    for record in records {
        let finding = &record.finding;
        let control = record.control.as_ref().map_or_else(Cell::empty, |c| Cell::html(badge(c.verdict.word())));
        let number = |value: f64| Cell::number(value, written(value));
        let id = format!("<a href=\"#{}\">{}</a>", record.stem(), record.id);
        let cells = [
            Cell::html(id).keyed(&record.id),
            Cell::html(badge(finding.verdict.word())),
            Cell::text(&record.says),
            number(finding.lo),
            finding.bound.map_or_else(Cell::empty, number),
            Cell::text(&record.unit),
            Cell::count(finding.cases),
            Cell::count(finding.undecided),
            control,
        ];
        table.row(None, &cells);
    }
    table.html()
}

fn badge(word: &str) -> String {
    format!("<span class=\"badge {}\">{word}</span>", word.replace(' ', "-"))
}
