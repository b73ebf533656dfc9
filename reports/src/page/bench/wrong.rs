//! What enters no mean, row by row: wrong results first, then engines that gave none, then those that were not asked.

use crate::bench::fate::Fate;
use crate::bench::timing::Timing;
use crate::page::number::{self, Toward};
use crate::page::table::{Cell, Table};

/// The table, or a sentence when all rows count.
pub fn html(timings: &[Timing]) -> String {
    let mut rows: Vec<&Timing> = timings.iter().filter(|row| !row.counts()).collect();
    if rows.is_empty() {
        return "<p>No result was found wrong, and no engine failed or was left out.</p>\n".to_owned();
    }
    rows.sort_by_key(|row| (row.correct != Some(false), !matches!(row.status, Fate::Crashed | Fate::Invalid)));
    let columns = [
        ("case", ""),
        ("engine", ""),
        ("what", ""),
        ("mu_hi", "upper bound of the error in unit-box lengths"),
        ("why", ""),
    ];
    let mut table = Table::new("Rows that enter no mean", columns);
    for row in rows {
        let mu = row.mu_hi.map_or_else(Cell::empty, |mu| Cell::number(mu, number::short(mu, Toward::Up)));
        table.row(None, &[Cell::text(&row.case), Cell::text(&row.engine), badge(row), mu, Cell::text(&row.note)]);
    }
    table.html()
}

fn badge(row: &Timing) -> Cell {
    let (class, word) = match row.status {
        Fate::Ok => ("refuted", "wrong"),
        Fate::Crashed => ("crashed", Fate::Crashed.word()),
        Fate::Invalid => ("invalid", Fate::Invalid.word()),
        fate @ (Fate::Timeout | Fate::TooSlow) => ("timeout", fate.word()),
        Fate::TooLarge => ("not-tested", Fate::TooLarge.word()),
    };
    Cell::html(format!("<span class=\"badge {class}\">{word}</span>"))
}
