//! What the charts share: the plotting area, axes, also logarithmic ones, and the marks of engines. A chart is an inline SVG of the page.

use super::escape::text;
use super::path::decimal;
use super::rank::ENOUGH_BITS;

/// Width of a chart in pixels.
pub const WIDTH: f64 = 560.0;
/// Space for labels: left, right, top, bottom.
const EDGES: [f64; 4] = [46.0, 14.0, 22.0, 36.0];
/// Bits of eps = 2^-53.
const EPS_BITS: f64 = 53.0;

/// The plotting area and the ranges of its two axes.
#[derive(Clone, Copy, Debug)]
pub struct Chart {
    /// Height in pixels, labels included.
    pub height: f64,
    /// Values at the left and right ends.
    pub across: (f64, f64),
    /// Values at the lower and upper ends.
    pub up: (f64, f64),
}

impl Chart {
    /// Abscissa in pixels.
    pub fn x(&self, value: f64) -> f64 {
        EDGES[0] + (value - self.across.0) / (self.across.1 - self.across.0) * (WIDTH - EDGES[0] - EDGES[1])
    }

    /// Ordinate in pixels, downwards.
    pub fn y(&self, value: f64) -> f64 {
        self.floor() - (value - self.up.0) / (self.up.1 - self.up.0) * (self.floor() - EDGES[2])
    }

    /// The ordinate of the lower end.
    pub fn floor(&self) -> f64 {
        self.height - EDGES[3]
    }

    /// The chart as a figure. `label` names it, `description` says in words what it shows.
    pub fn html(&self, label: &str, description: &str, body: &str) -> String {
        let (label, description) = (text(label), text(description));
        let height = decimal(self.height);
        format!(
            "<figure class=\"chart\"><figcaption><b>{label}</b><br>{description}</figcaption>\
             <svg role=\"img\" aria-label=\"{label}. {description}\" viewBox=\"0 0 {WIDTH} {height}\">{body}</svg></figure>\n"
        )
    }

    /// A label below the axis, at a value.
    pub fn below(&self, value: f64, words: &str) -> String {
        let (x, y) = (decimal(self.x(value)), decimal(self.floor() + 15.0));
        format!("<text class=\"mid\" x=\"{x}\" y=\"{y}\">{}</text>", text(words))
    }

    /// The name of the axis across.
    pub fn across_name(&self, name: &str) -> String {
        let (x, y) = (decimal((EDGES[0] + WIDTH - EDGES[1]) / 2.0), decimal(self.height - 4.0));
        format!("<text class=\"mid quiet\" x=\"{x}\" y=\"{y}\">{}</text>", text(name))
    }

    /// A grid line with its label at the left.
    pub fn left(&self, value: f64, words: &str) -> String {
        let (y, x) = (self.y(value), EDGES[0]);
        let right = decimal(WIDTH - EDGES[1]);
        format!(
            "<path class=\"grid\" d=\"M{x} {0}H{right}\"/><text class=\"end\" x=\"{1}\" y=\"{2}\">{3}</text>",
            decimal(y),
            decimal(x - 6.0),
            decimal(y + 4.0),
            text(words)
        )
    }

    /// The chart of two axes of powers of ten that holds all points, each given by the logarithms of its coordinates; none
    /// without points.
    pub fn of_powers(height: f64, points: impl IntoIterator<Item = (f64, f64)>) -> Option<Self> {
        let start = (f64::INFINITY, f64::NEG_INFINITY);
        let grown = |(low, high): (f64, f64), v: f64| (low.min(v), high.max(v));
        let (across, up) =
            points.into_iter().fold((start, start), |(across, up), (x, y)| (grown(across, x), grown(up, y)));
        let whole = |(low, high): (f64, f64)| (low.floor() - 0.05, high.ceil().max(low.floor() + 1.0) + 0.05);
        (across.0 <= across.1 && up.0 <= up.1).then(|| Self { height, across: whole(across), up: whole(up) })
    }

    /// Labels and grid lines at the powers of ten on both axes.
    pub fn powers(&self) -> String {
        let within = |(low, high): (f64, f64)| (low.ceil() as i32..=high.floor() as i32).map(f64::from);
        let below: String = within(self.across).map(|v| self.below(v, &power(v))).collect();
        below + &within(self.up).map(|v| self.left(v, &power(v))).collect::<String>()
    }

    /// Labels for whole bits across, multiples of `step`.
    pub fn bits_below(&self, low: i32, high: i32, step: i32) -> String {
        (low..=high).filter(|b| b % step == 0).map(|b| self.below(f64::from(b), &b.to_string())).collect()
    }

    /// Vertical lines at the 45 bits that are asked for and at eps.
    pub fn bit_marks(&self) -> String {
        let mark = |bits: f64, words: &str| {
            let (x, y) = (decimal(self.x(bits)), decimal(self.floor()));
            let top = EDGES[2];
            format!(
                "<path class=\"mark\" d=\"M{x} {top}V{y}\"/><text class=\"mid\" x=\"{x}\" y=\"{}\">{words}</text>",
                top - 6.0
            )
        };
        mark(ENOUGH_BITS, "45 bits") + &mark(EPS_BITS, "eps")
    }
}

/// Ten to this whole power: written out where that is short.
fn power(exponent: f64) -> String {
    if (-3.0..=4.0).contains(&exponent) {
        let digits = 0.0_f64.max(-exponent) as usize;
        return format!("{:.digits$}", 10.0_f64.powf(exponent));
    }
    format!("1e{exponent}")
}

/// The marks of engines in order: class of the colour, dashes of a line, outline of a point around its place.
const MARKS: [(&str, &str); 4] = [
    ("none", "m-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0-5 0z"),
    ("7 3", "m-2.2-2.2h4.4v4.4h-4.4z"),
    ("2 3", "m0-3.2l3.2 3.2-3.2 3.2-3.2-3.2z"),
    ("9 3 2 3", "m0-3.2l3 5.4h-6z"),
];

/// The class that colours the engine's marks.
pub fn series(engine: usize) -> String {
    format!("s{}", engine % 7)
}

/// The dashes of the engine's line.
pub fn dashes(engine: usize) -> &'static str {
    MARKS[engine % MARKS.len()].0
}

/// The engine's point, relative to its place.
pub fn point(engine: usize) -> &'static str {
    MARKS[engine % MARKS.len()].1
}

/// A legend of engines by colour, dashes and shape.
pub fn legend(engines: &[&str]) -> String {
    let item = |(i, name): (usize, &&str)| {
        let (class, dashes, point) = (series(i), dashes(i), point(i));
        format!(
            "<li><svg class=\"key {class}\" width=\"34\" height=\"12\" aria-hidden=\"true\"><path class=\"line\" \
             stroke-dasharray=\"{dashes}\" d=\"M1 6H33\"/><path class=\"dot\" d=\"M17 6{point}\"/></svg>{}</li>",
            text(name)
        )
    };
    format!("<ul class=\"legend\">{}</ul>\n", engines.iter().enumerate().map(item).collect::<String>())
}

#[cfg(test)]
#[path = "chart_tests.rs"]
mod tests;
