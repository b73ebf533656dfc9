//! Vertical decomposition of a polygonal region into trapezoids and triangles (memo J1), by an exact sweep.
//!
//! Chosen over ear clipping because holes, several components and pinches need no special care, and because the number
//! of pieces stays linear. Places are visited by abscissa, then ordinate; a vertical edge then counts as the steepest of
//! all and never bounds a trapezoid.

use std::cmp::Ordering;

use crate::arrange::Edge;
use crate::graph::Graph;
use crate::number::Number;
use crate::point::{Place, Point, orient};

/// A convex polygon, counter-clockwise.
pub type Convex<Q> = Vec<Place<Q>>;

/// Convex pieces with disjoint interiors that cover the bounded region left of these edges, which meet only at ends or
/// with an end on the inside of an edge.
#[must_use]
pub fn trapezoids<Q: Number>(edges: Vec<Edge<Q>>) -> Vec<Convex<Q>> {
    let mut sweep = Sweep::new(Graph::new(edges));
    let mut order: Vec<usize> = (0..sweep.graph.places.len()).collect();
    order.sort_by(|&p, &q| sweep.graph.places[p].order(&sweep.graph.places[q]));
    order.into_iter().for_each(|place| sweep.pass(place));
    sweep.pieces
}

/// An edge the sweep line meets, and the place where the gap above it began.
#[derive(Clone, Copy)]
struct Active {
    edge: usize,
    since: usize,
}

struct Sweep<Q> {
    graph: Graph<Q>,
    /// Left and right end of each edge.
    spans: Vec<(usize, usize)>,
    /// The edges with their left end at a place.
    starting: Vec<Vec<usize>>,
    /// The edges on the sweep line, upwards.
    line: Vec<Active>,
    pieces: Vec<Convex<Q>>,
}

impl<Q: Number> Sweep<Q> {
    fn new(graph: Graph<Q>) -> Self {
        let forward = |&(a, b): &(usize, usize)| graph.places[a].order(&graph.places[b]) == Ordering::Less;
        let span = |edge: &(usize, usize)| if forward(edge) { *edge } else { (edge.1, edge.0) };
        let spans: Vec<(usize, usize)> = graph.edges.iter().map(span).collect();
        let mut starting = vec![Vec::new(); graph.places.len()];
        spans.iter().enumerate().for_each(|(edge, &(left, _))| starting[left].push(edge));
        Self { graph, spans, starting, line: Vec::new(), pieces: Vec::new() }
    }

    /// Moves the sweep line past a place.
    fn pass(&mut self, place: usize) {
        let low = self.line.partition_point(|active| self.height(active.edge, place) == Ordering::Greater);
        let touching = self.line[low..].iter().take_while(|a| self.height(a.edge, place) == Ordering::Equal).count();
        let high = low + touching;
        for gap in low.saturating_sub(1)..high {
            self.close(gap, place);
        }
        let through = self.line[low..high].iter().map(|a| a.edge).filter(|&edge| self.spans[edge].1 != place);
        let mut leaving: Vec<usize> = through.chain(self.starting[place].iter().copied()).collect();
        leaving.sort_by(|&e, &f| self.turn(place, self.spans[f].1, self.spans[e].1));
        self.line.splice(low..high, leaving.into_iter().map(|edge| Active { edge, since: place }));
        if low > 0 {
            self.line[low - 1].since = place;
        }
    }

    /// Whether a place is above (`Greater`), on or below an edge.
    fn height(&self, edge: usize, place: usize) -> Ordering {
        let (left, right) = self.spans[edge];
        if place == left || place == right { Ordering::Equal } else { self.turn(left, right, place) }
    }

    fn turn(&self, a: usize, b: usize, c: usize) -> Ordering {
        orient(&self.graph.places[a], &self.graph.places[b], &self.graph.places[c])
    }

    /// Emits the trapezoid in the gap above the active edge of this rank, from where the gap began up to `place`.
    fn close(&mut self, gap: usize, place: usize) {
        let (Some(&lower), Some(upper)) = (self.line.get(gap), self.line.get(gap + 1)) else { return };
        let inside = self.spans[lower.edge] == self.graph.edges[lower.edge];
        let [from, to] = [lower.since, place].map(|p| &self.graph.places[p].exact.x);
        if !inside || from == to {
            return;
        }
        let corners = [(lower.edge, from), (lower.edge, to), (upper.edge, to), (upper.edge, from)];
        let mut piece: Convex<Q> = corners.into_iter().map(|(edge, x)| self.at(edge, x)).collect();
        piece.dedup_by(|a, b| a.exact == b.exact);
        if piece.first().map(|p| &p.exact) == piece.last().map(|p| &p.exact) {
            piece.pop();
        }
        self.pieces.push(piece);
    }

    /// The point of an edge that is not vertical at abscissa x.
    fn at(&self, edge: usize, x: &Q) -> Place<Q> {
        let (left, right) = self.spans[edge];
        let (left, right) = (&self.graph.places[left], &self.graph.places[right]);
        if left.exact.x == *x {
            return left.clone();
        }
        if right.exact.x == *x {
            return right.clone();
        }
        let run = right.exact.minus(&left.exact);
        let rise = x.minus(&left.exact.x).times(&run.y).over(&run.x);
        Place::from(Point { x: x.clone(), y: left.exact.y.plus(&rise) })
    }
}

#[cfg(test)]
mod tests {
    use super::trapezoids;
    use crate::number::Number;
    use crate::plain::{Bend, Corner, PlainRegion};
    use crate::point::{Point, orient};
    use crate::region::{ExactRegion, ring_area, ring_edges};
    use rug::Rational;

    fn region(rings: &[&[(f64, f64)]]) -> ExactRegion<Rational> {
        let ring = |ring: &&[(f64, f64)]| ring.iter().map(|&(x, y)| Corner { x, y, bend: Bend::Line }).collect();
        let plain = PlainRegion { loops: rings.iter().map(ring).collect(), unbounded: false };
        ExactRegion::from_plain(&plain).expect("finite")
    }

    fn check(rings: &[&[(f64, f64)]], pieces: usize) {
        let region = region(rings);
        let found = trapezoids(region.edges().map(|(a, b)| (a.clone(), b.clone())).collect());
        let mut area = Rational::from(0);
        for piece in &found {
            let points: Vec<Point<Rational>> = piece.iter().map(|p| p.exact.clone()).collect();
            area += ring_area(&points);
            assert!(points.len() > 2);
            let n = piece.len();
            for (i, (a, b)) in ring_edges(piece).enumerate() {
                assert!(orient(a, b, &piece[(i + 2) % n]).is_gt(), "a corner is not convex");
            }
        }
        assert_eq!(area, region.area());
        assert_eq!(area.sign(), std::cmp::Ordering::Greater);
        assert_eq!(found.len(), pieces);
    }

    #[test]
    fn pieces_are_convex_and_fill_the_area() {
        let square: &[_] = &[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
        check(&[square], 1);
        check(&[square, &[(1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0)]], 4);
        // A hole that touches the outer edge from inside, and an island that touches it from outside at the same point.
        check(&[square, &[(4.0, 2.0), (2.0, 1.0), (2.0, 3.0)], &[(4.0, 2.0), (6.0, 1.0), (6.0, 3.0)]], 4);
        check(&[&[(0.0, 0.0), (3.0, 1.0), (5.0, -2.0), (4.0, 6.0), (2.0, 2.0)]], 4);
    }
}
