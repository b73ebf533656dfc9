//! Histograms of bits, rows without bits and exact ones included.

use super::bins::Bins;
use super::chart::Chart;
use super::folder::Entry;
use super::number;
use super::path::decimal;
use super::rank::{self, ENOUGH_BITS};

/// Bins left free between the special places at the ends and the bits.
const GAP: i32 = 1;

/// One histogram an engine, all over the same range.
pub fn html(entries: &[Entry], engines: &[&str]) -> String {
    let range = Bins::range(entries);
    let one = |engine: &&str| {
        let of: Vec<&Entry> = entries.iter().filter(|e| e.row.engine == **engine).collect();
        large(engine, &of, range)
    };
    engines.iter().map(one).collect()
}

fn large(engine: &str, entries: &[&Entry], range: (i32, i32)) -> String {
    let bins = Bins::of(entries.iter().copied(), range);
    let (low, high) = (f64::from(bins.low), f64::from(bins.low) + bins.counts.len() as f64);
    let (none, exact) = (low - f64::from(GAP) - 1.0, high + f64::from(GAP));
    let top = bins.highest().max(1);
    let chart = Chart { height: 190.0, across: (none - 0.5, exact + 1.5), up: (0.0, top as f64) };
    let mut body = chart.left(0.0, "0") + &chart.left(top as f64, &number::count(top));
    body += &bar(&chart, none, bins.none, "no", "no bits");
    body += &bar(&chart, exact, bins.exact, "good", "exact");
    for (i, count) in bins.counts.iter().enumerate() {
        let from = low + i as f64;
        body += &bar(&chart, from, *count, class(from), &format!("{from} to {} bits", from + 1.0));
    }
    let step = if high - low > 30.0 { 5 } else { 2 };
    body += &(chart.bits_below(bins.low, bins.low + bins.counts.len() as i32, step) + &chart.bit_marks());
    body += &(chart.below(none + 0.5, "none") + &chart.below(exact + 0.5, "exact"));
    body += &chart.across_name("bits, one bar a bit");
    chart.html(engine, &description(entries, &bins), &body)
}

fn bar(chart: &Chart, from: f64, count: usize, class: &str, name: &str) -> String {
    if count == 0 {
        return String::new();
    }
    let (left, right) = (chart.x(from) + 0.75, chart.x(from + 1.0) - 0.75);
    // A single case among thousands must still be seen.
    let height = (chart.floor() - chart.y(count as f64)).max(2.0);
    format!(
        "<rect class=\"{class}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"><title>{name}: {}</title></rect>",
        decimal(left),
        decimal(chart.floor() - height),
        decimal(right - left),
        decimal(height),
        number::counted(count, "row")
    )
}

fn class(from: f64) -> &'static str {
    if from < ENOUGH_BITS { "bad" } else { "good" }
}

fn description(entries: &[&Entry], bins: &Bins) -> String {
    let finite = entries.iter().filter_map(|e| rank::bits(e));
    let least = finite.reduce(f64::min).map_or("none".to_owned(), number::bits);
    let (rows, none, exact) = (number::counted(entries.len(), "row"), bins.none, bins.exact);
    format!("{rows}; least bits {least}; {} without bits, {} exact", number::count(none), number::count(exact))
}

/// A histogram for a cell of a table: no labels but its name, heights by the root so that single cases are seen.
pub fn small(bins: &Bins) -> String {
    let (places, height) = (bins.counts.len() + 4, 24.0);
    let top = (bins.highest().max(1) as f64).sqrt();
    let bar = |place: usize, count: usize, class: &str| {
        if count == 0 {
            return String::new();
        }
        let tall = ((count as f64).sqrt() / top * height).max(1.0);
        format!("<path class=\"{class}\" d=\"M{place} {height}v-{}h.8V{height}z\"/>", decimal(tall))
    };
    let counted = bins.counts.iter().enumerate();
    let bars: String = counted.map(|(i, c)| bar(i + 2, *c, class(f64::from(bins.low) + i as f64))).collect();
    let ends = bar(0, bins.none, "no") + &bar(places - 1, bins.exact, "good");
    format!(
        "<svg class=\"small\" role=\"img\" aria-label=\"histogram of bits\" width=\"110\" height=\"24\" \
         viewBox=\"0 0 {places} {height}\" preserveAspectRatio=\"none\"><path class=\"grid\" d=\"M0 {height}H{places}\"/>\
         {bars}{ends}</svg>"
    )
}
