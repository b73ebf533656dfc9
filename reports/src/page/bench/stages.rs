//! The shares of convolution, arrangement and extraction in the time of an engine that tells them, by family.

use crate::bench::timing::Timing;
use crate::page::rank::distinct;
use crate::page::table::{Cell, Table};

/// The table, or a sentence when no engine tells.
pub fn html(timings: &[Timing]) -> String {
    let engines = distinct(timings.iter().map(|row| row.engine.as_str()));
    let families = distinct(timings.iter().map(|row| row.family.as_str()));
    let columns = [
        ("engine", ""),
        ("family", ""),
        ("cases", "with times of stages"),
        ("total ms", "sum of the median times"),
        ("convolution", ""),
        ("arrangement", ""),
        ("extraction", ""),
    ];
    let mut table = Table::new("Share of each stage in the sum of the stages", columns);
    for engine in engines {
        for family in &families {
            let of = |row: &&Timing| row.engine == engine && row.family == **family && row.counts();
            let told: Vec<[f64; 3]> = timings.iter().filter(of).filter_map(stages).collect();
            if !told.is_empty() {
                table.row(None, &cells(engine, family, &told));
            }
        }
    }
    if table.is_empty() { "<p>No engine tells how long its stages take.</p>\n".to_owned() } else { table.html() }
}

/// The times of the three stages; an engine without an extraction spends nothing on it.
fn stages(row: &Timing) -> Option<[f64; 3]> {
    Some([row.t_convolution?, row.t_arrangement?, row.t_extraction.unwrap_or(0.0)])
}

fn cells(engine: &str, family: &str, told: &[[f64; 3]]) -> Vec<Cell> {
    let sums = [0, 1, 2].map(|stage| told.iter().map(|times| times[stage]).sum::<f64>());
    let total: f64 = sums.iter().sum();
    let share = |sum: f64| {
        let percent = 100.0 * sum / total;
        Cell::number(percent, format!("{percent:.0}%"))
    };
    let start = [Cell::text(engine), Cell::text(family), Cell::count(told.len())];
    let [convolution, arrangement, extraction] = sums.map(share);
    let total = Cell::number(total, format!("{total:.3}"));
    start.into_iter().chain([total, convolution, arrangement, extraction]).collect()
}
