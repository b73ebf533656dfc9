//! Failed checks by name, and the rows with falsely free points.

use super::escape::text;
use super::folder::Entry;
use super::number;
use super::rank;
use super::rows;
use super::table::{Cell, Table};

/// Rows named for one check; the rest is counted.
const NAMED: usize = 12;

/// The failed checks, most frequent first, and how many rows were checked at all.
pub fn html(entries: &[Entry]) -> String {
    let names = rank::distinct(entries.iter().flat_map(failed));
    let mut groups: Vec<(&str, Vec<&Entry>)> = names
        .into_iter()
        .map(|name| (name, entries.iter().filter(|e| failed(e).any(|n| n == name)).collect()))
        .collect();
    let falsely: Vec<&Entry> = entries.iter().filter(|e| e.row.falsely_free.is_some_and(|count| count > 0)).collect();
    if !falsely.is_empty() {
        groups.push(("falsely free points", falsely));
    }
    groups.sort_by_key(|(_, of)| std::cmp::Reverse(of.len()));
    let mut table = Table::new("Failed checks", [("check", ""), ("rows", ""), ("engines", ""), ("which", "")]);
    for (name, of) in &groups {
        let engines = rank::distinct(of.iter().map(|e| e.row.engine.as_str())).join(", ");
        table.row(None, &[Cell::text(name), Cell::count(of.len()), Cell::text(&engines), Cell::html(named(of))]);
    }
    let words = coverage(entries);
    if table.is_empty() {
        format!("<p>No check failed. {words}</p>\n")
    } else {
        format!("{}<p>{words}</p>\n", table.html())
    }
}

/// The names of the checks that failed.
fn failed(entry: &Entry) -> impl Iterator<Item = &str> {
    let names = entry.row.failed_checks.as_deref().unwrap_or("");
    names.split_whitespace().filter(|name| *name != "none")
}

fn named(of: &[&Entry]) -> String {
    let links: Vec<String> = of.iter().take(NAMED).map(|e| rows::link(e)).collect();
    let more = if of.len() > NAMED { format!(" and {} more", number::count(of.len() - NAMED)) } else { String::new() };
    format!("rows {}{more}", links.join(", "))
}

/// How much was checked: an unchecked row must not pass for a good one.
fn coverage(entries: &[Entry]) -> String {
    let held = entries.iter().filter(|e| e.row.failed_checks.as_deref() == Some("none")).count();
    let unchecked = entries.iter().filter(|e| e.row.failed_checks.is_none()).count();
    let probed = entries.iter().filter(|e| e.row.falsely_free.is_some()).count();
    text(&format!(
        "All checks held in {}, {} not checked. Falsely free points were looked for in {}.",
        number::counted(held, "row"),
        if unchecked == 1 { "1 row was".to_owned() } else { format!("{} rows were", number::count(unchecked)) },
        number::counted(probed, "row")
    ))
}
