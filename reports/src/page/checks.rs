//! Failed checks by name, and the rows with falsely free points.

use super::escape::text;
use super::folder::Entry;
use super::number;
use super::rank;
use super::rows;
use super::table::{Cell, Table};
use crate::row::Row;

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
    let words = coverage(entries) + &separated(entries);
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

/// What MS 7 claims for the monotonic convolution, engine by engine: no tested point with rho > mu where the chains of the
/// operands are separated by 2 mu. Rows count as separated if they certainly are.
fn separated(entries: &[Entry]) -> String {
    let engines = rank::distinct(entries.iter().map(|e| e.row.engine.as_str()));
    let sentence = |engine: &str| {
        let of = entries.iter().map(|e| &e.row).filter(|r| r.engine == engine);
        let measured: Vec<&Row> = of.filter(|r| r.rho_lo.is_some() && r.separation_lo.is_some()).collect();
        let apart: Vec<&&Row> = measured.iter().filter(|r| r.separation_lo >= r.mu_hi.map(|mu| 2.0 * mu)).collect();
        let deep = apart.iter().filter(|r| r.rho_lo > r.mu_hi).count();
        let falsely = apart.iter().filter(|r| r.falsely_free.is_some_and(|count| count > 0)).count();
        (!measured.is_empty()).then(|| {
            text(&format!(
                " {engine}: of {} with regions 2 mu_hi separated, {} have rho_lo > mu_hi and {} falsely free points.",
                number::counted(apart.len(), "row"),
                number::count(deep),
                number::count(falsely)
            ))
        })
    };
    engines.into_iter().filter_map(sentence).collect()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::sample;

    #[test]
    fn separated_rows_with_deep_points_are_counted_by_engine() {
        let mut entries = sample::entries(&[Some(1e-16); 5]);
        for (entry, [rho, separation]) in
            entries.iter_mut().zip([[2e-16, 2e-16], [2e-16, 1.9e-16], [0.9e-16, f64::INFINITY], [2e-16, f64::INFINITY]])
        {
            (entry.row.rho_lo, entry.row.separation_lo) = (Some(rho), Some(separation));
        }
        entries[3].row.falsely_free = Some(1);
        let words = separated(&entries);
        let expected =
            " kinetic: of 3 rows with regions 2 mu_hi separated, 2 have rho_lo &gt; mu_hi and 1 falsely free points.";
        assert_eq!(words, expected);
        assert_eq!(separated(&entries[4..]), "");
    }
}
