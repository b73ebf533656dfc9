//! Edges that go on straight, or on one circle, become one edge: without this iterated sums would grow by a vertex for
//! every pair of edges that are parallel but for rounding (memo D).

use super::HALF;
use super::edge::{Edge, Net, Span};

/// The net with runs of edges replaced by one edge that no part of the run is farther from than half the tolerance.
/// Vertices that the boundary passes twice stay.
pub(super) fn merge(net: Net, tolerance: f64) -> Net {
    let mut passes = vec![0; net.points.len()];
    net.loops.iter().flatten().for_each(|e| passes[e.tail as usize] += 1);
    let merger = Merger { net: &net, passes, slack: 0.5 * tolerance };
    let loops = net.loops.iter().map(|edges| merger.merged(edges)).collect();
    Net { loops, points: net.points }
}

struct Merger<'a> {
    net: &'a Net,
    /// How often the boundary passes a vertex.
    passes: Vec<u32>,
    slack: f64,
}

impl Merger<'_> {
    fn merged(&self, edges: &[Edge]) -> Vec<Edge> {
        let n = edges.len();
        // Begin at a real corner, so that no run is torn at the seam.
        let start = (0..n).find(|i| self.one(&[edges[(i + n - 1) % n], edges[*i]]).is_none()).unwrap_or(0);
        let edges = [&edges[start..], &edges[..start]].concat();
        let (mut out, mut from) = (Vec::with_capacity(n), 0);
        while from < n {
            let (mut upto, mut edge) = (from + 1, edges[from]);
            while let Some(longer) = (upto < n).then(|| self.one(&edges[from..=upto])).flatten() {
                (upto, edge) = (upto + 1, longer);
            }
            out.push(edge);
            from = upto;
        }
        out
    }

    /// The edge that stands for a run of edges, if there is one.
    fn one(&self, run: &[Edge]) -> Option<Edge> {
        let (first, last) = (run.first()?, run.last()?);
        let straight = run.iter().all(|e| e.delta == 0.0);
        let bent = run.iter().all(|e| e.delta * first.delta > 0.0);
        let delta = run.iter().map(|e| e.delta).sum::<f64>();
        let edge = Edge { tail: first.tail, head: last.head, delta };
        let free = run[1..].iter().all(|e| self.passes[e.tail as usize] == 1);
        if !(free && edge.tail != edge.head && (straight || bent && delta.abs() <= HALF)) {
            return None;
        }
        let span = self.net.span(&edge);
        let near = |p| span.distance(p).is_some_and(|d| d <= self.slack);
        let on = |part: &Span| near(part.middle()) && (part.tail == span.tail || near(part.tail));
        run.iter().map(|e| self.net.span(e)).all(|part| on(&part)).then_some(edge)
    }
}
