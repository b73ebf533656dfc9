//! Bits against the number of segments of the convolution, one mark a row.

use super::bins::Bins;
use super::chart::{Chart, legend, point, series};
use super::folder::Entry;
use super::number;
use super::path::decimal;
use super::rank;
use std::collections::BTreeSet;

/// The chart with its legend, or a sentence when no row has both numbers.
pub fn html(entries: &[Entry], engines: &[&str]) -> String {
    let most = entries.iter().filter_map(place).map(|p| p.0).fold(0.0, f64::max);
    if most == 0.0 {
        return "<p>No row has both bits and the size of a convolution: no chart of one against the other.</p>\n"
            .to_owned();
    }
    let (low, high) = Bins::range(entries);
    let exact = f64::from(high) + 1.5;
    let chart = Chart { height: 300.0, across: (-0.1, most.log10().max(1.0) + 0.1), up: (f64::from(low), exact + 0.5) };
    let mut body: String = (0..=most.log10() as i32)
        .map(|power| chart.below(f64::from(power), &number::count(10_usize.pow(power.unsigned_abs()))))
        .collect();
    for bits in (low..=high).filter(|b| b % 5 == 0) {
        body += &chart.left(f64::from(bits), &bits.to_string());
    }
    body += &(chart.left(exact, "exact") + &chart.across_name("segments of the convolution"));
    for (i, engine) in engines.iter().enumerate() {
        let of: Vec<&Entry> = entries.iter().filter(|e| e.row.engine == *engine).collect();
        body += &format!("<path class=\"dot {}\" d=\"{}\"/>", series(i), dots(&chart, &of, exact, point(i)));
        body += &worst(&chart, &of, exact);
    }
    let missing = entries.iter().filter(|e| place(e).is_none()).count();
    let words = format!(
        "Each mark is a row; the ringed one is the worst of its engine. {} without bits or without a convolution \
         not shown.",
        number::counted(missing, "row")
    );
    chart.html("Bits against size", &words, &body) + &legend(engines)
}

/// Size and bits of a row that has both.
fn place(entry: &Entry) -> Option<(f64, f64)> {
    Some((entry.row.sums.filter(|s| *s > 0)? as f64, rank::bits(entry)?))
}

fn pixels(chart: &Chart, (sums, bits): (f64, f64), exact: f64) -> (f64, f64) {
    let bits = if bits == f64::INFINITY { exact } else { bits.clamp(chart.up.0, chart.up.1 - 2.0) };
    (chart.x(sums.log10()), chart.y(bits))
}

/// The marks of one engine as path data; marks on the same half pixel are drawn once.
fn dots(chart: &Chart, entries: &[&Entry], exact: f64, outline: &str) -> String {
    let half = |v: f64| (v * 2.0).round() as i64;
    let places = entries.iter().filter_map(|e| place(e)).map(|p| pixels(chart, p, exact));
    let places: BTreeSet<(i64, i64)> = places.map(|(x, y)| (half(x), half(y))).collect();
    places.iter().map(|(x, y)| format!("M{} {}{outline}", decimal(*x as f64 / 2.0), decimal(*y as f64 / 2.0))).collect()
}

fn worst(chart: &Chart, entries: &[&Entry], exact: f64) -> String {
    let Some((worst, at)) = rank::worst(entries.iter().copied()).and_then(|e| Some((e, place(e)?))) else {
        return String::new();
    };
    let (x, y) = pixels(chart, at, exact);
    format!(
        "<a href=\"#r{0}\" aria-label=\"row {0}\"><circle class=\"ring\" cx=\"{1}\" cy=\"{2}\" r=\"7\"/></a>",
        worst.number,
        decimal(x),
        decimal(y)
    )
}
