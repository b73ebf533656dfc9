//! The plot of an experiment: points on linear or logarithmic axes, or a histogram, with the bound as a line.

use crate::claims::plot::{Plot, Series};
use crate::claims::record::written;
use crate::page::chart::{Chart, dashes, legend, point, series};
use crate::page::path::decimal;

const HEIGHT: f64 = 260.0;
/// Bars of a histogram.
const BARS: usize = 24;
/// Labels on a linear axis.
const TICKS: usize = 5;

/// The plot as a figure; nothing if there is nothing to draw.
pub fn html(plot: &Plot, bound: Option<f64>) -> String {
    let drawn = if plot.y.is_empty() { histogram(plot, bound) } else { points(plot, bound) };
    drawn.map_or_else(String::new, |figure| format!("<div class=\"charts\">{figure}</div>\n"))
}

/// A coordinate on its axis; none if a logarithmic axis has no place for it.
fn scaled(value: f64, log: bool) -> Option<f64> {
    let place = if log { value.log10() } else { value };
    place.is_finite().then_some(place)
}

fn points(plot: &Plot, bound: Option<f64>) -> Option<String> {
    let place = |p: &[f64; 2]| Some((scaled(p[0], plot.log[0])?, scaled(p[1], plot.log[1])?));
    let all: Vec<(f64, f64)> = plot.series.iter().flat_map(|s| s.points.iter().filter_map(place)).collect();
    let first = *all.first()?;
    let range = |of: fn(&(f64, f64)) -> f64| {
        all.iter().map(of).fold((of(&first), of(&first)), |(low, high), v| (low.min(v), high.max(v)))
    };
    let limit = bound.and_then(|bound| scaled(bound, plot.log[1]));
    let (across, mut up) = (range(|p| p.0), range(|p| p.1));
    if let Some(limit) = limit {
        up = (up.0.min(limit), up.1.max(limit));
    }
    let chart = Chart { height: HEIGHT, across: axis(across, plot.log[0]), up: axis(up, plot.log[1]) };
    let mut body = labels(&chart, plot.log, 0)
        + &chart.across_name(&plot.x)
        + &limit.map_or_else(String::new, |y| line(&chart, y));
    for (i, of) in plot.series.iter().enumerate() {
        body += &marks(&chart, i, of, plot.log);
    }
    let names: Vec<&str> = plot.series.iter().map(|s| s.name.as_str()).filter(|name| !name.is_empty()).collect();
    let key = if names.len() > 1 { legend(&names) } else { String::new() };
    let words =
        limit.map_or_else(String::new, |_| format!("The line is the bound, {}.", written(bound.unwrap_or_default())));
    Some(key + &chart.html(&plot.y, &words, &body))
}

/// A range with room around it: whole powers of a logarithmic axis.
fn axis((low, high): (f64, f64), log: bool) -> (f64, f64) {
    if log {
        return (low.floor() - 0.05, high.ceil().max(low.floor() + 1.0) + 0.05);
    }
    let room = 0.05 * (high - low).max(1e-300);
    if high > low { (low - room, high + room) } else { (low - 0.5, high + 0.5) }
}

/// Labels on both axes; where `most` is not 0 the vertical one counts up to it.
fn labels(chart: &Chart, log: [bool; 2], most: usize) -> String {
    let ticks = |(low, high): (f64, f64), log: bool| -> Vec<(f64, String)> {
        if log {
            let (first, last) = (low.ceil() as i32, high.floor() as i32);
            let step = ((last - first) / 8 + 1) as usize;
            return (first..=last).step_by(step).map(|e| (f64::from(e), format!("1e{e}"))).collect();
        }
        let at = |i: usize| low + (high - low) * (i as f64 + 0.5) / TICKS as f64;
        (0..TICKS).map(|i| (at(i), written(at(i)))).collect()
    };
    let below: String = ticks(chart.across, log[0]).iter().map(|(v, words)| chart.below(*v, words)).collect();
    let counts = (0..=most).step_by((most / TICKS).max(1)).map(|n| (n as f64, n.to_string()));
    let left = if most > 0 { counts.collect() } else { ticks(chart.up, log[1]) };
    below + &left.iter().map(|(v, words)| chart.left(*v, words)).collect::<String>()
}

/// A horizontal line.
fn line(chart: &Chart, y: f64) -> String {
    let [left, right] = [chart.across.0, chart.across.1].map(|x| decimal(chart.x(x)));
    format!("<path class=\"mark\" d=\"M{left} {}H{right}\"/>", decimal(chart.y(y)))
}

fn marks(chart: &Chart, index: usize, of: &Series, log: [bool; 2]) -> String {
    let place = |p: &[f64; 2]| Some((decimal(chart.x(scaled(p[0], log[0])?)), decimal(chart.y(scaled(p[1], log[1])?))));
    let pixels: Vec<(String, String)> = of.points.iter().filter_map(place).collect();
    let dots: String = pixels.iter().map(|(x, y)| format!("M{x} {y}{}", point(index))).collect();
    let step = |(i, (x, y)): (usize, &(String, String))| format!("{}{x} {y}", if i == 0 { "M" } else { "L" });
    let path: String = if of.line { pixels.iter().enumerate().map(step).collect() } else { String::new() };
    let (class, dashes) = (series(index), dashes(index));
    let joined = format!("<path class=\"line {class}\" stroke-dasharray=\"{dashes}\" d=\"{path}\"/>");
    format!("{}<path class=\"dot {class}\" d=\"{dots}\"/>", if path.is_empty() { "" } else { &joined })
}

fn histogram(plot: &Plot, bound: Option<f64>) -> Option<String> {
    let values: Vec<f64> = plot.series.iter().flat_map(|s| s.points.iter().map(|p| p[0])).collect();
    let low = values.iter().copied().reduce(f64::min)?;
    let high = values.iter().copied().reduce(f64::max)?;
    // A value out of all proportion would leave one bar: such values are counted by their logarithm.
    let log = low >= 0.0 && high > 1e3 * median(&values).max(f64::MIN_POSITIVE);
    let on_axis: Vec<f64> = values.iter().filter_map(|v| scaled(*v, log)).collect();
    let across = axis((on_axis.iter().copied().reduce(f64::min)?, on_axis.iter().copied().reduce(f64::max)?), log);
    let mut counts = [0_usize; BARS];
    for value in &on_axis {
        let bar = (value - across.0) / (across.1 - across.0) * BARS as f64;
        counts[(bar as usize).min(BARS - 1)] += 1;
    }
    let most = counts.iter().copied().max().unwrap_or(0);
    let chart = Chart { height: HEIGHT, across, up: (0.0, most as f64 * 1.05) };
    let width = (across.1 - across.0) / BARS as f64;
    let bar = |(i, count): (usize, &usize)| {
        let (x, y) = (chart.x(across.0 + width * i as f64), chart.y(*count as f64));
        let [w, h] = [chart.x(across.0 + width) - chart.x(across.0) - 1.0, chart.floor() - y];
        format!(
            "<rect class=\"good\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
            decimal(x),
            decimal(y),
            decimal(w),
            decimal(h)
        )
    };
    let bars: String = counts.iter().enumerate().filter(|(_, count)| **count > 0).map(bar).collect();
    let below = labels(&chart, [log, false], most);
    let left_out = values.len() - on_axis.len();
    let bound = bound.map_or_else(String::new, |bound| format!(" The bound is {}.", written(bound)));
    let zero = if left_out > 0 { format!(" {left_out} are 0.") } else { String::new() };
    let words = format!("How many of {} inputs, a sample if there are more.{zero}{bound}", values.len());
    Some(chart.html(&plot.x, &words, &(below + &bars)))
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}
