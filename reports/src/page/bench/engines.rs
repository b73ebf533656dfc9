//! Engines by families: the geometric mean of the ratios to the first engine, and what does not count.

use crate::bench::fate::Fate;
use crate::bench::middle::Sorted;
use crate::bench::timing::Timing;
use crate::page::number;
use crate::page::rank::distinct;
use crate::page::table::{Cell, Table};

/// A row an engine, a column a family, and one for all.
pub fn html(timings: &[Timing]) -> String {
    if timings.is_empty() {
        return "<p>Nothing was timed.</p>\n".to_owned();
    }
    let engines = distinct(timings.iter().map(|row| row.engine.as_str()));
    let families = distinct(timings.iter().map(|row| row.family.as_str()));
    let columns = [("engine", ""), ("all", "")].into_iter().chain(families.iter().map(|family| (*family, "")));
    let caption = format!("Geometric mean of the ratio of times to {}, and what does not count", engines[0]);
    let mut table = Table::new(&caption, columns);
    for engine in engines {
        let of = |family: Option<&str>| -> Vec<&Timing> {
            let rows = timings.iter().filter(|row| row.engine == engine);
            rows.filter(|row| family.is_none_or(|family| row.family == family)).collect()
        };
        let cells = families.iter().map(|family| cell(&of(Some(family)), timings));
        let start = [Cell::text(engine), cell(&of(None), timings)];
        table.row(None, &start.into_iter().chain(cells).collect::<Vec<_>>());
    }
    table.html()
}

/// The mean over rows that count on cases where the first engine's count too, then counts of all others.
fn cell(rows: &[&Timing], all: &[Timing]) -> Cell {
    if rows.is_empty() {
        return Cell::html("<span class=\"quiet\">cannot</span>".to_owned());
    }
    let ratios =
        Sorted::new(rows.iter().filter(|row| row.counts() && base_counts(row, all)).filter_map(|r| r.to_first));
    let mean = ratios.map(|ratios| ratios.geometric_mean());
    let shown = mean.map_or_else(|| "–".to_owned(), number::plain);
    let html = format!("<b>{shown}</b> {}", counts(rows));
    let key = mean.map_or_else(String::new, |mean| format!("{mean:e}"));
    Cell::html(html.trim_end().to_owned()).keyed(&key)
}

/// Whether the first engine's row of the same case counts.
fn base_counts(row: &Timing, all: &[Timing]) -> bool {
    let first = all.first().map_or("", |row| row.engine.as_str());
    all.iter().any(|base| base.engine == first && base.case == row.case && base.counts())
}

/// How many rows are wrong, were not looked at, or have no time, in words; nothing where there are none.
pub fn counts(rows: &[&Timing]) -> String {
    let number = |of: &dyn Fn(&Timing) -> bool| rows.iter().filter(|row| of(row)).count();
    let badge = |class: &str, count: usize, word: &str| {
        if count == 0 { String::new() } else { format!("<span class=\"badge {class}\">{count} {word}</span> ") }
    };
    let unknown = number(&|row| row.status == Fate::Ok && row.correct.is_none());
    let mut html = badge("refuted", number(&|row| row.correct == Some(false)), "wrong");
    for (fate, class) in [
        (Fate::Crashed, "crashed"),
        (Fate::Invalid, "invalid"),
        (Fate::Timeout, "timeout"),
        (Fate::TooSlow, "timeout"),
        (Fate::TooLarge, "not-tested"),
    ] {
        html += &badge(class, number(&|row| row.status == fate), fate.word());
    }
    html + &badge("undecided", unknown, "unjudged")
}
