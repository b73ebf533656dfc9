//! What `arcsum bench` prints: a line a row, and a sentence a comparison.

use crate::bench::comparison::Comparison;
use crate::bench::fate::Fate;
use crate::bench::timing::Timing;

/// The names of the columns; `first` is the run's first engine.
pub fn heading(first: &str) -> String {
    let to_first = format!("ratio to {first}");
    let columns = format!("{:>8} {:>9} {:>9} {:>9} {:>9}", "sums", "vertices", "cells", "ms", "ns/vertex");
    format!("{:28} {:16} {columns} {:>20} {to_first:>20} {:>8} right", "case", "engine", "ratio to sort", "MB")
}

/// A row.
pub fn line(row: &Timing) -> String {
    let start = format!("{:28} {:16}", row.case, row.engine);
    if row.status != Fate::Ok {
        return format!("{start} {}: {}", row.status.word(), row.note);
    }
    let count = |n: Option<u64>| n.map_or_else(String::new, |n| n.to_string());
    let counts = format!("{:>8} {:>9} {:>9}", count(row.sums), count(row.vertices), count(row.cells));
    let number = |value: Option<f64>, digits: usize| value.map_or_else(String::new, |v| format!("{v:.digits$}"));
    let (ms, by_vertex) = (number(row.median_ms, 2), number(row.ns_per_vertex, 0));
    let sort = spread([row.ratio, row.ratio_min, row.ratio_max], 1);
    let first = spread([row.to_first, row.to_first_min, row.to_first_max], 3);
    let right = match row.correct {
        Some(true) => "yes".to_owned(),
        Some(false) => format!("WRONG: {}", row.note),
        None => format!("? {}", row.note),
    };
    let memory = number(row.peak_mb, 1);
    format!("{start} {counts} {ms:>9} {by_vertex:>9} {sort:>20} {first:>20} {memory:>8} {}", right.trim_end())
}

/// A ratio with its least and greatest value.
fn spread(ratio: [Option<f64>; 3], digits: usize) -> String {
    match ratio {
        [Some(middle), Some(least), Some(greatest)] => {
            format!("{middle:.digits$} ({least:.digits$}..{greatest:.digits$})")
        }
        _ => String::new(),
    }
}

/// A comparison.
pub fn sentence(c: &Comparison) -> String {
    let times = format!("{}: {:.1} ms in all, {}: {:.1} ms", c.engine, c.total_ms, c.first, c.first_total_ms);
    let ratio = |middle: f64, lo: f64, hi: f64| format!("{middle:.3} ({lo:.3}..{hi:.3})");
    let sums = ratio(c.ratio_of_sums, c.ratio_of_sums_lo, c.ratio_of_sums_hi);
    let mean = ratio(c.geometric_mean, c.geometric_mean_lo, c.geometric_mean_hi);
    let slower = c.slower.split_whitespace().count();
    let of = format!("of {} cases slower in {slower}, in every run of {}", c.cases, c.always_slower);
    let left_out = format!("left out {} wrong, {} without a sum", c.wrong, c.failed);
    format!(
        "{times}; ratio of sums {sums}, geometric mean of ratios {mean}, arithmetic {:.3}; {left_out}; {of}: {}",
        c.mean, c.slower
    )
}
