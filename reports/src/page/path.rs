//! SVG path data of regions and convolutions, in pixels of a view.
//!
//! Arcs stay arcs. They are halved until they sweep at most 90 degrees: rounded to hundredths of a pixel, the ends of a
//! longer one would no longer fix its centre (near a half circle it moves by the root of radius times rounding). So the
//! large-arc flag is always 0. What lies outside of the view is drawn in as few strokes as keep the fill right.

use super::edge::{self, Edge, Point};
use super::view::View;
use arcsum::region::Region;

/// tan(90/4 degrees): the bulge of a quarter circle.
const QUARTER: f64 = 0.414_213_562_373_095_03;
/// Bows lower than this many pixels are drawn as lines; vertices nearer than this to the last one are left out.
const INVISIBLE: f64 = 0.04;
/// How many pixels beyond the view a stroke may still reach into it.
const RIM: f64 = 4.0;
/// Halvings cut an edge to the size of the view; what is 2^64 times larger is drawn as a line.
const MAX_HALVINGS: u32 = 64;

/// Path data, and how much of the whole it shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// The value of the attribute `d`; empty when nothing is visible.
    pub data: String,
    /// Loops, or segments of a convolution, that the path shows.
    pub shown: usize,
    /// How many there are to show.
    pub of: usize,
}

/// The loops of a region, closed. Once `limit` strokes are drawn the remaining, smaller loops are left out.
///
/// An unbounded region begins with a frame around the view, so that a nonzero fill covers what lies outside its loops.
pub fn region(region: &Region, view: &View, limit: usize) -> Drawing {
    let mut loops: Vec<Pen> = region.loops.iter().filter(|nodes| !nodes.is_empty()).map(|n| trace(n, view)).collect();
    let of = loops.len();
    loops.sort_by(|a, b| b.extent.total_cmp(&a.extent));
    let mut strokes = 0;
    let kept = loops.iter().take_while(|pen| {
        let room = strokes < limit;
        strokes += pen.strokes;
        room
    });
    let mut data = if region.unbounded { around(view) } else { String::new() };
    let mut shown = 0;
    for pen in kept {
        shown += 1;
        if pen.extent >= INVISIBLE {
            data.push_str(&pen.data);
            data.push('Z');
        }
    }
    Drawing { data, shown, of }
}

/// The segments of a convolution that meet the view, at most `limit` of them, evenly picked.
pub fn convolution(segments: &[[f64; 5]], view: &View, limit: usize) -> Drawing {
    let finite = segments.iter().filter(|s| s.iter().all(|v| v.is_finite()));
    let visible: Vec<Vec<Edge>> = finite
        .map(|s| pieces(&view.edge(&Edge::from_numbers(*s)), view))
        .map(|parts| parts.into_iter().filter(|e| !outside(e, view)).collect())
        .filter(|parts: &Vec<Edge>| !parts.is_empty())
        .collect();
    let (of, shown) = (visible.len(), visible.len().min(limit));
    let mut pen = Pen::new(view);
    for i in 0..shown {
        for edge in &visible[i * of / shown] {
            pen.lift_to(edge.tail);
            pen.draw(edge, true);
        }
    }
    Drawing { data: pen.data, shown, of }
}

fn trace(nodes: &[arcsum::region::Node], view: &View) -> Pen {
    let mut pen = Pen::new(view);
    pen.lift_to(view.point([nodes[0].x, nodes[0].y]));
    for edge in edge::of_loop(nodes) {
        for part in pieces(&view.edge(&edge), view) {
            pen.draw(&part, !outside(&part, view));
        }
    }
    pen
}

/// The edge cut so that each part sweeps at most 90 degrees and is either outside of the view or of its size.
fn pieces(edge: &Edge, view: &View) -> Vec<Edge> {
    let [width, height] = view.size();
    let large = 2.0 * (width + height);
    let mut parts = Vec::new();
    // Halves wait in reverse order, so that parts come out from tail to head.
    let mut waiting = vec![(*edge, 0)];
    while let Some((edge, halvings)) = waiting.pop() {
        let wide = edge.bulge.abs() > QUARTER;
        let far = edge.chord() > large && !outside(&edge, view);
        if (wide || far) && halvings < MAX_HALVINGS {
            let [first, second] = edge.halves();
            waiting.extend([(second, halvings + 1), (first, halvings + 1)]);
        } else {
            parts.push(edge);
        }
    }
    parts
}

/// Whether an edge of at most 90 degrees certainly stays out of the view.
fn outside(edge: &Edge, view: &View) -> bool {
    let (size, reach) = (view.size(), edge.sagitta() + RIM);
    (0..2).any(|i| edge.tail[i].max(edge.head[i]) + reach < 0.0 || edge.tail[i].min(edge.head[i]) - reach > size[i])
}

/// A counter-clockwise rectangle just beyond the view.
fn around(view: &View) -> String {
    let [width, height] = view.size();
    let mut pen = Pen::new(view);
    let corners = [[-RIM, -RIM], [width + RIM, -RIM], [width + RIM, height + RIM], [-RIM, height + RIM]];
    pen.lift_to(corners[0]);
    for pair in corners.windows(2) {
        pen.draw(&Edge { tail: pair[0], head: pair[1], bulge: 0.0 }, true);
    }
    pen.data + "Z"
}

/// Path data being written.
struct Pen {
    size: Point,
    start: Point,
    at: Option<Point>,
    data: String,
    strokes: usize,
    /// Greatest distance from the point where the pen was last put down.
    extent: f64,
}

impl Pen {
    fn new(view: &View) -> Self {
        Self { size: view.size(), start: [0.0; 2], at: None, data: String::new(), strokes: 0, extent: 0.0 }
    }

    /// Goes to `point` without a stroke, unless it is there already.
    fn lift_to(&mut self, point: Point) {
        let point = self.near(point);
        if self.at.is_none_or(|at| distance(at, point) >= INVISIBLE) {
            self.data.push_str(&format!("M{}", self.written(point)));
            (self.start, self.at) = (point, Some(point));
        }
    }

    /// Follows the edge; straight to its head where the bow does not matter.
    fn draw(&mut self, edge: &Edge, visible: bool) {
        let head = self.near(edge.head);
        if self.at.is_some_and(|at| distance(at, head) < INVISIBLE) {
            return;
        }
        let stroke = if visible && edge.sagitta() >= INVISIBLE {
            // Counter-clockwise with the ordinate up is sweep 0 with the ordinate down.
            let sweep = u8::from(edge.bulge < 0.0);
            let radius = decimal(edge.radius());
            format!("A{radius} {radius} 0 0 {sweep} {}", self.written(head))
        } else {
            format!("L{}", self.written(head))
        };
        self.data.push_str(&stroke);
        self.at = Some(head);
        self.strokes += 1;
        self.extent = self.extent.max(distance(self.start, head));
    }

    /// The point itself near the view. Far points move to a box around it: that changes no winding number inside the
    /// view, and keeps renderers with single precision out of trouble.
    fn near(&self, point: Point) -> Point {
        let far = 4.0 * (self.size[0] + self.size[1]);
        [0, 1].map(|i| point[i].clamp(-far, self.size[i] + far))
    }

    fn written(&self, point: Point) -> String {
        format!("{} {}", decimal(point[0]), decimal(self.size[1] - point[1]))
    }
}

/// At most two decimals, no trailing zeros.
pub fn decimal(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn distance(p: Point, q: Point) -> f64 {
    (q[0] - p[0]).hypot(q[1] - p[1])
}

#[cfg(test)]
#[path = "path_tests.rs"]
mod tests;
