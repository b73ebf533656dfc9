//! Time against size, both logarithmic: a chart a family, a line an engine. Wrong results are ringed.

use crate::bench::timing::Timing;
use crate::page::chart::{Chart, dashes, legend, point, series};
use crate::page::path::decimal;
use crate::page::rank::distinct;

/// Height of a chart in pixels.
const HEIGHT: f64 = 300.0;

/// The charts of all families with cases of more than one size.
pub fn html(timings: &[Timing]) -> String {
    let engines = distinct(timings.iter().map(|row| row.engine.as_str()));
    let families = distinct(timings.iter().map(|row| row.family.as_str()));
    let charts: String = families
        .iter()
        .filter_map(|family| {
            chart(family, &engines, &timings.iter().filter(|r| r.family == *family).collect::<Vec<_>>())
        })
        .collect();
    if charts.is_empty() {
        return "<p>No family has timed cases of more than one size.</p>\n".to_owned();
    }
    legend(&engines) + &format!("<div class=\"charts\">{charts}</div>\n")
}

fn chart(family: &str, engines: &[&str], rows: &[&Timing]) -> Option<String> {
    let places: Vec<(f64, f64)> = rows.iter().filter_map(|row| place(row)).collect();
    if places.iter().all(|(size, _)| Some(*size) == places.first().map(|p| p.0)) {
        return None;
    }
    let chart = Chart::of_powers(HEIGHT, places)?;
    let mut body = chart.powers() + &chart.across_name("segments of the kinetic convolution; times in milliseconds");
    for (i, engine) in engines.iter().enumerate() {
        let of: Vec<&Timing> = rows.iter().filter(|row| row.engine == *engine).copied().collect();
        body += &line(&chart, i, &of);
    }
    let count = |of: &dyn Fn(&&&Timing) -> bool| rows.iter().filter(of).count();
    let wrong = count(&|row| row.median_ms.is_some() && row.correct == Some(false));
    let missing = count(&|row| place(row).is_none());
    let words =
        format!("Median time of a sum in milliseconds. Ringed: {wrong} wrong. Not shown: {missing} without a time.");
    Some(chart.html(family, &words, &body))
}

/// The logarithms of size and time of a row that has both.
fn place(row: &Timing) -> Option<(f64, f64)> {
    let (size, time) = (row.sum_segments? as f64, row.median_ms?);
    (size > 0.0 && time > 0.0 && time.is_finite()).then(|| (size.log10(), time.log10()))
}

/// The line and the points of an engine, from its least to its greatest case.
fn line(chart: &Chart, engine: usize, rows: &[&Timing]) -> String {
    let mut places: Vec<(f64, f64, bool)> =
        rows.iter().filter_map(|row| place(row).map(|(x, y)| (x, y, row.correct == Some(false)))).collect();
    places.sort_by(|p, q| p.0.total_cmp(&q.0).then(p.1.total_cmp(&q.1)));
    let pixels: Vec<(String, String, bool)> =
        places.iter().map(|&(x, y, wrong)| (decimal(chart.x(x)), decimal(chart.y(y)), wrong)).collect();
    let path: String =
        pixels.iter().enumerate().map(|(i, (x, y, _))| format!("{}{x} {y}", if i == 0 { "M" } else { "L" })).collect();
    let dots: String = pixels.iter().map(|(x, y, _)| format!("M{x} {y}{}", point(engine))).collect();
    let rings: String = pixels
        .iter()
        .filter(|(_, _, wrong)| *wrong)
        .map(|(x, y, _)| format!("<circle class=\"ring\" cx=\"{x}\" cy=\"{y}\" r=\"6\"/>"))
        .collect();
    let (class, dashes) = (series(engine), dashes(engine));
    format!(
        "<path class=\"line {class}\" stroke-dasharray=\"{dashes}\" d=\"{path}\"/><path class=\"dot {class}\" \
         d=\"{dots}\"/>{rings}"
    )
}
