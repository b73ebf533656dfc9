//! A picture: the panels of a record as one SVG file, or as figures inside the page.

use super::escape::text;
use super::panel::{Panel, panels};
use super::path::decimal;
use super::status;
use crate::row::Record;

/// The style of pictures, with `prefers-color-scheme`; the page carries it once, every SVG file for itself.
pub const STYLE: &str = include_str!("picture.css");

/// Pixels between panels.
const GAP: f64 = 18.0;
/// Pixels of a line of text.
const LINE: f64 = 17.0;
/// Pixels of a character, at most on average: a line of text must not run into the next panel's.
const LETTER: f64 = 7.4;

/// A whole SVG file: the panels side by side under their headings.
pub fn document(record: &Record) -> String {
    let panels = panels(record);
    let lines = 1 + panels.iter().map(|p| p.notes.len()).max().unwrap_or(0);
    let top = GAP + 2.0 * LINE + lines as f64 * LINE;
    let height = top + panels.iter().map(|p| p.size[1]).fold(0.0, f64::max) + GAP;
    let (mut left, mut body) = (GAP, String::new());
    for panel in &panels {
        body.push_str(&headed(panel, left, top));
        left += panel.size[0].max(text_width(panel)) + GAP;
    }
    let (width, title) = (decimal(left), text(&title(record)));
    let height = decimal(height);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"pic\" role=\"img\" aria-labelledby=\"t d\" \
         width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
         <title id=\"t\">{title}</title>\n<desc id=\"d\">{}</desc>\n<style>{STYLE}</style>\n\
         <text class=\"h\" x=\"{GAP}\" y=\"26\">{title}</text>\n{body}</svg>\n",
        text(&description(&panels)),
    )
}

/// The panels as figures for the page, which may wrap them to its width.
pub fn figures(record: &Record) -> String {
    framed(&panels(record))
}

/// Some panels as figures.
pub fn framed(panels: &[Panel]) -> String {
    let figure = |panel: &Panel| {
        let [width, height] = panel.size.map(decimal);
        let notes: String = panel.notes.iter().map(|n| format!("<br>{}", text(n))).collect();
        format!(
            "<figure><figcaption><b>{heading}</b>{notes}</figcaption><svg class=\"pic\" role=\"img\" \
             aria-label=\"{heading}\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">{}</svg>\
             </figure>\n",
            panel.body,
            heading = text(&panel.heading),
        )
    };
    panels.iter().map(figure).collect()
}

/// The panel at a place of the file, its heading and notes above it.
fn headed(panel: &Panel, left: f64, top: f64) -> String {
    let (x, [width, height]) = (decimal(left), panel.size.map(decimal));
    let words = std::iter::once(&panel.heading).chain(&panel.notes).enumerate();
    let lines: String = words
        .map(|(i, line)| {
            let y = decimal(26.0 + (1.5 + i as f64) * LINE);
            format!("<text class=\"{}\" x=\"{x}\" y=\"{y}\">{}</text>\n", if i == 0 { "h" } else { "n" }, text(line))
        })
        .collect();
    let (y, body) = (decimal(top), &panel.body);
    let place = format!("x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"");
    // An inner svg clips to its own box, without the ids that a clip path would need.
    format!("{lines}<svg {place}>{body}</svg>\n<rect class=\"f\" {place}/>\n")
}

fn text_width(panel: &Panel) -> f64 {
    let longest = std::iter::once(&panel.heading).chain(&panel.notes).map(|line| line.chars().count()).max();
    longest.unwrap_or(0) as f64 * LETTER
}

fn title(record: &Record) -> String {
    let row = &record.row;
    format!("{} ({}), engine {} {}: {}", row.case, row.family, row.engine, row.engine_version, status::name(row.status))
}

fn description(panels: &[Panel]) -> String {
    let said = |p: &Panel| std::iter::once(&p.heading).chain(&p.notes).cloned().collect::<Vec<_>>().join(", ");
    panels.iter().map(said).collect::<Vec<_>>().join(". ") + "."
}
