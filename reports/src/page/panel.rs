//! The panels of a picture: A, B, the convolution and the result at a common scale, and the place of the worst error
//! enlarged. Each is a small drawing with a heading and notes; nothing is left out without a note that says so.

use super::edge::Edge;
use super::number;
use super::path::{self, Drawing, decimal};
use super::view::{Frame, View};
use crate::row::Record;
use arcsum::region::Region;

/// Pixels of the larger side of the sum, and of the inset.
const SIDE: f64 = 230.0;
/// White around a frame, as a part of its scale: pixels.
const MARGIN: f64 = 12.0;
/// Strokes of a region after which its remaining small loops are left out.
const MAX_STROKES: usize = 20_000;
/// Segments of a convolution that are drawn.
const MAX_SEGMENTS: usize = 3_000;
/// The side of the first inset as a part of the sum's.
const INSET: f64 = 0.05;
/// From this part of the sum on the error can be seen through doubles, and a second inset is fitted to it.
const VISIBLE_MU: f64 = 1e-9;
/// The side of the fitted inset in errors.
const INSET_IN_MU: f64 = 20.0;

/// A drawing with its words.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// What it shows, not escaped.
    pub heading: String,
    /// What must be known to read it, not escaped.
    pub notes: Vec<String>,
    /// Width and height in pixels.
    pub size: [f64; 2],
    /// The SVG elements inside.
    pub body: String,
}

/// The panels of a record, from left to right.
pub fn panels(record: &Record) -> Vec<Panel> {
    let stage = Stage::of(record);
    let mut panels = vec![stage.operand("A", "a", &record.a), stage.operand("B", "b", &record.b)];
    panels.push(stage.convolution(record));
    panels.push(stage.result(record));
    panels.extend(stage.insets(record));
    panels
}

/// The operands and the result of a record, and the surroundings of its worst point at these parts of the sum's side.
pub fn closer(record: &Record, parts: &[f64]) -> Vec<Panel> {
    let stage = Stage::of(record);
    let whole = stage.sum.side();
    let operands = [stage.operand("A", "a", &record.a), stage.operand("B", "b", &record.b), stage.result(record)];
    operands.into_iter().chain(stage.at_worst(record, parts.iter().map(|part| part * whole))).collect()
}

/// What the panels of one record share.
struct Stage {
    /// Pixels per input unit.
    scale: f64,
    /// Where the sum lies.
    sum: Frame,
    /// Whether the result reaches beyond `sum`.
    cut: bool,
    /// The point that attains `mu_lo`.
    worst: Option<[f64; 2]>,
    /// `mu_lo` in input units.
    mu: f64,
}

impl Stage {
    fn of(record: &Record) -> Self {
        let (a, b) = (Frame::of_region(&record.a), Frame::of_region(&record.b));
        let result = record.result.as_ref().and_then(Frame::of_region);
        let segments = record.convolution.iter().flat_map(|s| Edge::from_numbers(*s).samples());
        let expected = match (a, b) {
            (Some(a), Some(b)) => Some(a.plus(b)),
            _ => Frame::of(segments),
        };
        let expected = expected.or(result).unwrap_or(Frame { low: [0.0; 2], high: [1.0; 2] });
        let expected = if expected.side() > 0.0 { expected } else { expected.grown(0.5) };
        let worst = record.row.worst_x.zip(record.row.worst_y).map(|(x, y)| [x, y]);
        let worst = worst.filter(|w| w.iter().all(|v| v.is_finite()));
        // A wild result must not shrink everything else to a dot.
        let bound = expected.grown(expected.side());
        let all = result.map_or(expected, |r| expected.join(r));
        let all = worst.map_or(all, |w| all.join(Frame::around(w, 0.0)));
        let sum = all.clipped(bound);
        let unit = [a, b].iter().flatten().map(Frame::side).fold(0.0, f64::max).log2().ceil().exp2();
        Self {
            scale: SIDE / sum.side(),
            sum,
            cut: !bound.holds(all),
            worst,
            mu: record.row.mu_lo.unwrap_or(0.0) * unit,
        }
    }

    fn view(&self, frame: Frame) -> View {
        View { frame: frame.grown(MARGIN / self.scale), scale: self.scale }
    }

    fn operand(&self, name: &str, class: &str, region: &Region) -> Panel {
        let frame = Frame::of_region(region).unwrap_or(Frame { low: [0.0; 2], high: [0.3 * SIDE / self.scale; 2] });
        let view = self.view(frame);
        let (body, notes) = drawn(region, class, &view);
        Panel { heading: format!("{name}: {}", sizes(region)), notes, size: view.size(), body }
    }

    fn convolution(&self, record: &Record) -> Panel {
        let view = self.view(self.sum);
        let all = record.convolution.len();
        let drawing = path::convolution(&record.convolution, &view, MAX_SEGMENTS);
        let mut notes = Vec::new();
        if all == 0 {
            notes.push("the engine shows none".to_owned());
        } else if drawing.shown < all {
            notes.push(format!("{} of {} drawn", number::count(drawing.shown), number::count(all)));
        }
        let heading = format!("Convolution: {}", number::counted(all, "segment"));
        Panel { heading, notes, size: view.size(), body: stroked("c", &drawing.data) + &self.cross(&view) }
    }

    fn result(&self, record: &Record) -> Panel {
        let view = self.view(self.sum);
        let Some(result) = &record.result else {
            let heading = "Result: none".to_owned();
            return Panel {
                heading,
                notes: vec![super::status::name(record.row.status).to_owned()],
                size: view.size(),
                body: String::new(),
            };
        };
        let (mut body, mut notes) = drawn(result, "r", &view);
        if self.cut {
            notes.push("reaches beyond the frame".to_owned());
        }
        body.push_str(&self.cross(&view));
        Panel { heading: format!("Result: {}", sizes(result)), notes, size: view.size(), body }
    }

    /// The surroundings of the worst point: a fixed part of the sum, and closer up an error that can be seen.
    fn insets(&self, record: &Record) -> Vec<Panel> {
        let whole = self.sum.side();
        let fitted = (INSET_IN_MU * self.mu).min(whole);
        let sides = match self.mu > VISIBLE_MU * whole {
            true if fitted >= INSET * whole => vec![fitted],
            true => vec![INSET * whole, fitted],
            false => vec![INSET * whole],
        };
        self.at_worst(record, sides)
    }

    /// The surroundings of the worst point, squares of these sides; none without such a point.
    fn at_worst(&self, record: &Record, sides: impl IntoIterator<Item = f64>) -> Vec<Panel> {
        let Some(worst) = self.worst else { return Vec::new() };
        let view = |side: f64| View { frame: Frame::around(worst, side), scale: SIDE / side };
        sides.into_iter().map(|side| self.inset(record, &view(side))).collect()
    }

    fn inset(&self, record: &Record, view: &View) -> Panel {
        let mut notes = vec![format!("{} of the sum's side", number::plain(view.frame.side() / self.sum.side()))];
        if self.mu.is_finite() && self.mu > 0.0 {
            notes.push(format!("mu_lo is {} px here", number::plain(self.mu * view.scale)));
        }
        let result = record.result.as_ref().map_or(String::new(), |result| drawn(result, "r", view).0);
        let drawing = path::convolution(&record.convolution, view, MAX_SEGMENTS);
        if drawing.shown < drawing.of {
            notes.push(format!("{} of {} segments drawn", number::count(drawing.shown), number::count(drawing.of)));
        }
        let body = result + &stroked("c", &drawing.data) + &self.cross(view);
        let heading = format!("Worst point, {} times larger", number::plain(view.scale / self.scale));
        Panel { heading, notes, size: view.size(), body }
    }

    /// Cross hairs around the worst point, open in the middle.
    fn cross(&self, view: &View) -> String {
        let Some(worst) = self.worst else { return String::new() };
        let [x, up] = view.point(worst);
        let y = view.size()[1] - up;
        let arm = |x0: f64, y0: f64, x1: f64, y1: f64| {
            format!("M{} {}L{} {}", decimal(x + x0), decimal(y + y0), decimal(x + x1), decimal(y + y1))
        };
        let arms = [
            arm(-12.0, 0.0, -4.0, 0.0),
            arm(4.0, 0.0, 12.0, 0.0),
            arm(0.0, -12.0, 0.0, -4.0),
            arm(0.0, 4.0, 0.0, 12.0),
        ];
        stroked("x", &arms.concat())
    }
}

/// A region as SVG, and notes on what it does not show.
fn drawn(region: &Region, class: &str, view: &View) -> (String, Vec<String>) {
    let mut notes = Vec::new();
    if region.loops.iter().all(Vec::is_empty) {
        notes.push(if region.unbounded { "the whole plane" } else { "empty" }.to_owned());
    } else {
        if region.unbounded {
            notes.push("unbounded".to_owned());
        }
        if Frame::of_region(region).is_none() {
            notes.push("not drawn: its coordinates are not finite or too large".to_owned());
            return (String::new(), notes);
        }
    }
    let Drawing { data, shown, of } = path::region(region, view, MAX_STROKES);
    if shown < of {
        notes.push(format!("{} of {} loops drawn", number::count(shown), number::count(of)));
    }
    (stroked(class, &data), notes)
}

fn stroked(class: &str, data: &str) -> String {
    if data.is_empty() { String::new() } else { format!("<path class=\"{class}\" d=\"{data}\"/>") }
}

fn sizes(region: &Region) -> String {
    let (segments, loops) = (region.segments(), region.loops.len());
    format!("{}, {}", number::counted(segments, "segment"), number::counted(loops, "loop"))
}

#[cfg(test)]
#[path = "panel_tests.rs"]
mod tests;
