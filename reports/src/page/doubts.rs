//! What in the files contradicts itself. The page is the last to look: it says so before it shows any number.

use super::escape::text;
use super::folder::Entry;
use super::number;
use super::rank;
use super::rows;
use crate::row::{Row, Status};
use std::collections::BTreeMap;

/// Rows named for one doubt; the rest is counted.
const NAMED: usize = 12;
/// Greatest difference of `bits` from -log2(mu_hi) that printing may leave.
const BITS_SLACK: f64 = 1e-6;

/// The doubts as a list, empty when there are none. `broken` are sentences on records that could not be used.
pub fn html(entries: &[Entry], broken: &[String]) -> String {
    let mut doubts: Vec<String> = versions(entries);
    let of_row: [(&str, fn(&Row) -> bool); 5] = [
        ("an error that is NaN or negative", |r| any(r, |v| v.is_nan() || v < 0.0)),
        ("mu_lo greater than mu_hi", |r| r.mu_lo.zip(r.mu_hi).is_some_and(|(lo, hi)| lo > hi)),
        ("bits that are not -log2(mu_hi)", bits_disagree),
        ("status ok without mu_hi", |r| r.status == Status::Ok && r.mu_hi.is_none()),
        ("an error but no answer", |r| matches!(r.status, Status::Crashed | Status::Timeout) && r.mu_hi.is_some()),
    ];
    for (words, holds) in of_row {
        doubts.extend(named(words, entries.iter().filter(|e| holds(&e.row))));
    }
    doubts.extend(named("a case and engine that an earlier row has too", repeated(entries)));
    doubts.extend(broken.iter().map(|sentence| text(sentence)));
    if doubts.is_empty() {
        return String::new();
    }
    let items: String = doubts.iter().map(|d| format!("<li>{d}</li>")).collect();
    format!("<div class=\"doubts\" role=\"note\"><h2>Doubts about the data</h2><ul>{items}</ul></div>\n")
}

fn any(row: &Row, test: fn(f64) -> bool) -> bool {
    [row.mu_lo, row.mu_hi, row.mu_realized_lo, row.mu_realized_hi].into_iter().flatten().any(test)
}

fn bits_disagree(row: &Row) -> bool {
    match (row.bits, row.mu_hi) {
        (Some(bits), Some(mu)) => {
            let expected = -mu.log2();
            // Equal infinities have no difference.
            bits != expected && !((bits - expected).abs() <= BITS_SLACK)
        }
        (None, None) => false,
        _ => true,
    }
}

/// Engines of which the file mixes versions: their numbers must not be compared.
fn versions(entries: &[Entry]) -> Vec<String> {
    let mut by_engine: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for entry in entries {
        by_engine.entry(&entry.row.engine).or_default().push(&entry.row.engine_version);
    }
    let all = by_engine.into_iter().map(|(engine, versions)| (engine, rank::distinct(versions)));
    let mixed = all.filter(|(_, versions)| versions.len() > 1);
    mixed.map(|(engine, v)| text(&format!("engine {engine} appears in versions {}", v.join(", ")))).collect()
}

fn repeated(entries: &[Entry]) -> impl Iterator<Item = &Entry> {
    let mut seen = std::collections::BTreeSet::new();
    entries.iter().filter(move |e| !seen.insert((&e.row.case, &e.row.engine)))
}

fn named<'a>(words: &str, of: impl Iterator<Item = &'a Entry>) -> Option<String> {
    let of: Vec<&Entry> = of.collect();
    let links: Vec<String> = of.iter().take(NAMED).map(|e| rows::link(e)).collect();
    let more = if of.len() > NAMED { ", ..." } else { "" };
    let rows = number::counted(of.len(), "row");
    (!of.is_empty()).then(|| format!("{rows} with {}: {}{more}", text(words), links.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::sample;

    #[test]
    fn sound_rows_raise_no_doubt() {
        let entries = sample::entries(&[Some(1e-16), Some(0.0), Some(f64::INFINITY), None]);
        assert_eq!(html(&entries, &[]), "");
    }

    #[test]
    fn each_planted_fault_is_named() {
        let planted = |plant: fn(&mut Row)| {
            let mut entries = sample::entries(&[Some(1e-16), Some(2e-16)]);
            plant(&mut entries[1].row);
            html(&entries, &[])
        };
        assert!(planted(|r| r.mu_lo = Some(-1.0)).contains("NaN or negative"));
        assert!(planted(|r| r.mu_realized_hi = Some(f64::NAN)).contains("NaN or negative"));
        assert!(planted(|r| r.mu_lo = Some(3e-16)).contains("mu_lo greater"));
        assert!(planted(|r| r.bits = Some(52.0)).contains("bits that are not"));
        assert!(planted(|r| r.bits = None).contains("bits that are not"));
        assert!(planted(|r| (r.mu_hi, r.bits) = (None, None)).contains("ok without mu_hi"));
        assert!(planted(|r| r.status = Status::Crashed).contains("but no answer"));
        assert!(planted(|r| r.case = "case 1".to_owned()).contains("earlier row"));
        assert!(planted(|r| r.engine_version = "<9>".to_owned()).contains("versions 1.0, &lt;9&gt;"));
    }
}
