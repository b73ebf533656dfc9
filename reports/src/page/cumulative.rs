//! How many rows stay below each number of bits, by engine. Rows without bits stay below all; both axes show the tail.

use super::bins::Bins;
use super::chart::{Chart, dashes, legend, series};
use super::folder::Entry;
use super::number;
use super::path::decimal;
use super::rank;

/// The chart with its legend.
pub fn html(entries: &[Entry], engines: &[&str]) -> String {
    let (low, high) = Bins::range(entries);
    let of = |engine: &str| entries.iter().filter(|e| e.row.engine == engine).collect::<Vec<_>>();
    let most = engines.iter().map(|e| of(e).len()).max().unwrap_or(1).max(2) as f64;
    let chart = Chart { height: 300.0, across: (f64::from(low), f64::from(high)), up: (-0.15, most.log10()) };
    let mut body = String::new();
    for power in 0..=most.log10() as i32 {
        body += &chart.left(f64::from(power), &number::count(10_usize.pow(power.unsigned_abs())));
    }
    body += &(chart.bits_below(low, high, if high - low > 30 { 5 } else { 2 }) + &chart.bit_marks());
    body += &chart.across_name("bits");
    for (i, engine) in engines.iter().enumerate() {
        let data = steps(&chart, &of(engine));
        body += &format!("<path class=\"line {}\" stroke-dasharray=\"{}\" d=\"{data}\"/>", series(i), dashes(i));
    }
    let words = "How many rows have fewer bits than that, on a logarithmic scale. Rows without bits count from the left \
                 on; a curve that begins late is a good one.";
    chart.html("Rows below each number of bits", words, &body) + &legend(engines)
}

/// The steps of one engine as path data.
fn steps(chart: &Chart, entries: &[&Entry]) -> String {
    let mut bits: Vec<f64> = entries.iter().filter_map(|e| rank::bits(e)).collect();
    bits.sort_by(f64::total_cmp);
    let mut below = entries.len() - bits.len();
    let mut data = String::new();
    let height = |below: usize| decimal(chart.y((below as f64).log10()));
    if below > 0 {
        data = format!("M{} {}", decimal(chart.x(chart.across.0)), height(below));
    }
    for group in bits.chunk_by(|a, b| a == b) {
        let x = decimal(chart.x(group[0].clamp(chart.across.0, chart.across.1)));
        let start = if below == 0 { format!("M{x} {}", decimal(chart.floor())) } else { format!("H{x}") };
        below += group.len();
        data += &format!("{start}V{}", height(below));
    }
    data
}
