//! Runs: consecutive half-edges of a loop that come from one source segment, merged into one segment. Where loops touch
//! nothing is merged: the rounding of the segment's ends would push it across the other loop.

use super::Corner;
use super::places::Places;
use super::trace::Pinches;
use crate::arrangement::curve::Curve;
use crate::arrangement::graph::{Graph, HalfEdge};
use crate::piece::{Piece, Pieces, Source};
use glam::DVec2;
use std::f64::consts::FRAC_PI_2;

/// A part of one piece that a loop runs along.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    from: DVec2,
    to: DVec2,
    /// Half the sweep, 0 for a line.
    delta: f64,
    curve: u32,
    /// The ends of the whole piece.
    whole: [u32; 2],
    source: Source,
    /// Whether the boundary passes through `from` more than once.
    pinched: bool,
}

/// What makes corners of loops. The lists are kept from loop to loop so that they need not grow again.
pub struct Runs<'a> {
    graph: &'a Graph,
    pieces: &'a Pieces,
    places: &'a Places,
    pinches: &'a Pinches,
    stretches: Vec<Stretch>,
    merged: Vec<Stretch>,
}

impl<'a> Runs<'a> {
    /// For the loops of a map of these pieces.
    pub fn new(graph: &'a Graph, pieces: &'a Pieces, places: &'a Places, pinches: &'a Pinches) -> Self {
        Self { graph, pieces, places, pinches, stretches: Vec::new(), merged: Vec::new() }
    }

    /// The corners of a loop.
    pub fn corners(&mut self, halves: &[HalfEdge]) -> Vec<Corner> {
        let mut stretches = std::mem::take(&mut self.stretches);
        stretches.clear();
        stretches.extend(halves.iter().map(|half| self.stretch(*half)));
        merge(&stretches, &mut self.merged, same_piece);
        stretches.clear();
        stretches.extend(self.merged.iter().map(|s| with_sweep(&self.graph.curves[s.curve as usize], *s)));
        merge(&stretches, &mut self.merged, same_source);
        self.stretches = stretches;
        self.merged.iter().map(|s| Corner { point: s.from, delta: s.delta }).collect()
    }

    /// The stretch of a half-edge; its sweep is still that of the whole piece, as the loop runs along it.
    fn stretch(&self, half: HalfEdge) -> Stretch {
        let index = self.graph.edges[(half / 2) as usize].curve;
        let curve = &self.graph.curves[index as usize];
        let vertex = self.graph.origin(half);
        let [from, to] = [vertex, self.graph.target(half)].map(|v| self.graph.points[v as usize]);
        let delta = if half.is_multiple_of(2) { curve.delta } else { -curve.delta };
        let Piece { source, whole, .. } = self.pieces.pieces[curve.piece as usize];
        let pinched = self.pinches.contains(self.places.of(vertex));
        Stretch { from, to, delta, curve: index, whole, source, pinched }
    }
}

/// Joins neighbours, cyclically, as long as `join` makes one of two and no other part of the boundary touches them where
/// they meet.
fn merge(stretches: &[Stretch], out: &mut Vec<Stretch>, join: impl Fn(&Stretch, &Stretch) -> Option<Stretch>) {
    let n = stretches.len();
    let join = |s: &Stretch, t: &Stretch| if t.pinched { None } else { join(s, t) };
    // Begin at a real corner, so that no run is torn at the seam.
    let start = (0..n).find(|i| join(&stretches[(i + n - 1) % n], &stretches[*i]).is_none()).unwrap_or(0);
    out.clear();
    for stretch in stretches[start..].iter().chain(&stretches[..start]) {
        match out.last_mut().and_then(|last| join(last, stretch).map(|joined| (last, joined))) {
            Some((last, joined)) => *last = joined,
            None => out.push(*stretch),
        }
    }
}

fn same_piece(s: &Stretch, t: &Stretch) -> Option<Stretch> {
    let same = s.whole == t.whole && s.delta == t.delta && s.from != t.to;
    (same || collinear(s, t)).then_some(Stretch { to: t.to, ..*s })
}

/// Two lines in one direction, as far as doubles can tell: the vertex between them lies within a rounding of their union.
fn collinear(s: &Stretch, t: &Stretch) -> bool {
    let (u, v) = (s.to - s.from, t.to - t.from);
    s.delta == 0.0 && t.delta == 0.0 && u.x * v.y == u.y * v.x && u.dot(v) > 0.0
}

/// Half a circle, with room for the rounding of the angles it was cut at: the most that is merged, so that the chord
/// stays long.
const LONGEST: f64 = FRAC_PI_2 + 1e-9;

/// Two arcs of one circle that go on in one direction.
fn same_source(s: &Stretch, t: &Stretch) -> Option<Stretch> {
    let sweep = s.delta + t.delta;
    let same = s.source == t.source && s.delta * t.delta > 0.0 && s.from != t.to && sweep.abs() <= LONGEST;
    same.then_some(Stretch { to: t.to, delta: sweep, ..*s })
}

/// Replaces the sweep of the whole piece by that of the stretch: sines are proportional to chords.
fn with_sweep(curve: &Curve, s: Stretch) -> Stretch {
    let whole = (s.from == curve.left && s.to == curve.right) || (s.from == curve.right && s.to == curve.left);
    if s.delta == 0.0 || whole {
        return s;
    }
    // Squares of the smallest chords would underflow.
    let length = |v: DVec2| libm::hypot(v.x, v.y);
    let chord = length(s.to - s.from) / length(curve.chord());
    Stretch { delta: libm::asin((libm::sin(s.delta) * chord).clamp(-1.0, 1.0)), ..s }
}
