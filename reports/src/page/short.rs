//! The rows that fall short: no certified answer, or fewer than 45 bits; each with its note.

use super::folder::Entry;
use super::number;
use super::rank;
use super::status;
use super::summary::worst_cells;
use super::table::{Cell, Table};

/// Rows listed; the rest is counted and can be had from the full table.
const LISTED: usize = 400;

/// The list: rows without bits first, then by bits.
pub fn html(entries: &[Entry]) -> String {
    let mut short: Vec<&Entry> = entries.iter().filter(|e| rank::falls_short(e)).collect();
    if short.is_empty() {
        let all = number::counted(entries.len(), "row");
        return format!("<p>None of {all}.</p>\n");
    }
    let key = |e: &Entry| rank::bits(e).unwrap_or(f64::NEG_INFINITY);
    short.sort_by(|a, b| key(a).total_cmp(&key(b)));
    let columns = ["row", "case", "family", "engine", "status", "bits", "mu_hi", "note"].map(|name| (name, ""));
    let mut table = Table::new("Rows that are not ok, or have fewer than 45 bits", columns);
    for entry in short.iter().take(LISTED) {
        let row = &entry.row;
        let [bits, mu, link] = worst_cells(Some(entry));
        let badge = Cell::html(status::badge(row.status));
        let note = if row.note.is_empty() { "no note" } else { &row.note };
        let names = [Cell::text(&row.case), Cell::text(&row.family), Cell::text(&row.engine)];
        table.row(None, &[&[link], &names[..], &[badge, bits, mu, Cell::text(note)]].concat());
    }
    let more = if short.len() > LISTED {
        format!("<p>{} of {} listed. The rest: ", number::count(LISTED), number::count(short.len()))
            + "<a href=\"#rows\" data-filter=\"bits&lt;45\">rows with bits below 45</a>, \
               <a href=\"#rows\" data-filter=\"status!=ok\">rows that are not ok</a>.</p>\n"
    } else {
        String::new()
    };
    let share = format!("<p>{} of {}.</p>\n", number::count(short.len()), number::counted(entries.len(), "row"));
    share + &more + &table.html()
}
