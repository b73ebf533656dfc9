//! The worst of every family, greatest error first, with a small histogram of its bits.

use super::bins::Bins;
use super::folder::Entry;
use super::histogram;
use super::number;
use super::rank;
use super::summary::worst_cells;
use super::table::{Cell, Table};
use crate::row::Status;
use std::cmp::Ordering;

/// One row a family and engine. Families without any measurement, and those not all ok, are counted as such.
pub fn html(entries: &[Entry]) -> String {
    let mut groups: Vec<Vec<&Entry>> = Vec::new();
    for entry in entries {
        let same =
            |g: &&mut Vec<&Entry>| (&g[0].row.family, &g[0].row.engine) == (&entry.row.family, &entry.row.engine);
        match groups.iter_mut().find(same) {
            Some(group) => group.push(entry),
            None => groups.push(vec![entry]),
        }
    }
    groups.sort_by(|a, b| match (rank::worst(a.iter().copied()), rank::worst(b.iter().copied())) {
        (Some(a), Some(b)) => rank::by_error(b, a),
        // Nothing measured at all is the worst there is.
        (None, Some(_)) => Ordering::Less,
        (Some(_), None) => Ordering::Greater,
        (None, None) => Ordering::Equal,
    });
    let columns = [
        ("family", ""),
        ("engine", ""),
        ("rows", ""),
        ("not ok", "rows without a certified answer"),
        ("least bits", "of the worst case"),
        ("greatest mu_hi", "of the worst case, in unit-box lengths"),
        ("worst row", ""),
        ("median bits", "rows without bits count as none, below all others"),
        ("bits", "histogram over the same range for every family"),
    ];
    let range = Bins::range(entries);
    let mut table = Table::new("Worst case of every family and engine, greatest error first", columns);
    for group in &groups {
        table.row(None, &cells(group, range));
    }
    table.html()
}

fn cells(group: &[&Entry], range: (i32, i32)) -> Vec<Cell> {
    let row = &group[0].row;
    let unmeasured = group.iter().filter(|e| e.row.status != Status::Ok).count();
    let [bits, mu, link] = worst_cells(rank::worst(group.iter().copied()));
    let small = histogram::small(&Bins::of(group.iter().copied(), range));
    let median = median(group).map_or(Cell::html("none".to_owned()), |bits| Cell::number(bits, number::bits(bits)));
    let counts = [Cell::count(group.len()), Cell::count(unmeasured)];
    let [rows, failed] = counts;
    vec![Cell::text(&row.family), Cell::text(&row.engine), rows, failed, bits, mu, link, median, Cell::html(small)]
}

/// The lower median, so that it is the bits of a case; `None` when that case has none.
fn median(group: &[&Entry]) -> Option<f64> {
    let mut bits: Vec<Option<f64>> = group.iter().map(|e| rank::bits(e)).collect();
    let key = |b: &Option<f64>| b.unwrap_or(f64::NEG_INFINITY);
    bits.sort_by(|a, b| key(a).total_cmp(&key(b)));
    bits[(bits.len() - 1) / 2]
}
