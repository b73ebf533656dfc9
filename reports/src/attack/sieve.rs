//! A cheap sieve over the points that an engine takes for free: which of them may be deep inside of the sum?
//!
//! Points are those of memo F: the middles and corners of the trapezoids of free cells, and the middles of the edges around
//! them. A point passes if all points on a small circle around it have a winding number other than 0 in the kinetic
//! convolution, counted in doubles, curve by curve, without any arrangement. A point that is free, or near a free one, does
//! not pass; one that is blocked and farther from the free space than the circle is wide does, up to a few roundings.

use crate::cases::Case;
use crate::engine::corners::Corners;
use arcsum::arrangement::Arrangement;
use arcsum::arrangement::curve::Curve;
use arcsum::convolution::kinetic;
use arcsum::piece::Pieces;
use arcsum::smooth::Smooth;
use arcsum::sum::{Options, sum};
use arcsum::sum3::Rounding;
use glam::DVec2;

/// The radius of the circle, in unit-box lengths: a few times mu, and several roundings.
const RADIUS: f64 = 2e-15;

/// Points on the circle; their number is odd, so that no two are opposite.
const AROUND: usize = 9;

/// What the sieve says about a case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sieved {
    /// Points that were tested.
    pub probes: u64,
    /// Points that passed.
    pub suspects: u64,
    /// Of these, points strictly inside of a free cell.
    pub inside: u64,
    /// Swaps against the convolution order.
    pub order_conflict: u64,
}

/// Puts the free points of a case through the sieve; none if there is no sum.
#[must_use]
pub fn sieve(case: &Case, options: &Options) -> Option<Sieved> {
    let sum = sum(&case.a, &case.b, options).ok()?;
    let smooth = |region, frame| Smooth::new(region, frame).ok();
    let (a, b) = (smooth(&case.a, &sum.frames.0)?, smooth(&case.b, &sum.frames.1)?);
    let winding = Winding::new(&kinetic(&a, &b, Rounding::Correct)?);
    let circle: Vec<DVec2> = (0..AROUND).map(direction).map(|way| RADIUS * way).collect();
    let mut found = Sieved { order_conflict: sum.arrangement.audit.order_conflict as u64, ..Sieved::default() };
    probes(&sum.arrangement, |p, inside| {
        found.probes += 1;
        if circle.iter().all(|way| winding.around(p + *way) != 0) {
            found.suspects += 1;
            found.inside += u64::from(inside);
        }
    });
    Some(found)
}

fn direction(i: usize) -> DVec2 {
    DVec2::from_angle(0.1 + std::f64::consts::TAU * i as f64 / AROUND as f64)
}

/// Visits the test points of the free cells, and whether they are strictly inside.
fn probes(arrangement: &Arrangement, mut visit: impl FnMut(DVec2, bool)) {
    let (graph, corners) = (&arrangement.graph, Corners::new(arrangement));
    let is_free = |face: u32| graph.windings[face as usize][0] == 0;
    for trapezoid in arrangement.trapezoids.iter().filter(|t| is_free(t.face)) {
        let curves = [trapezoid.bottom, trapezoid.top].map(|curve| &graph.curves[curve as usize]);
        let x = 0.5 * (trapezoid.from + trapezoid.to);
        let [low, high] = curves.map(|curve| curve.y_at(x));
        let y = 0.5 * (low + high);
        if trapezoid.from < x && x < trapezoid.to && low < y && y < high {
            visit(DVec2::new(x, y), true);
        }
        corners.of(trapezoid).for_each(|corner| visit(corner, false));
    }
    for edge in graph.edges.iter().filter(|edge| is_free(edge.below) != is_free(edge.above)) {
        let [p, q] = [edge.from, edge.to].map(|vertex| graph.points[vertex as usize]);
        let is_vertical = graph.curves[edge.curve as usize].is_vertical();
        visit(if is_vertical { 0.5 * (p + q) } else { corners.at(edge, 0.5 * (p.x + q.x)) }, false);
    }
}

/// Winding numbers in doubles.
struct Winding {
    curves: Vec<Curve>,
    base: i32,
}

impl Winding {
    fn new(pieces: &Pieces) -> Self {
        let at = |vertex: u32| pieces.points[vertex as usize];
        let curve = |(index, piece): (usize, &arcsum::piece::Piece)| {
            let end = |vertex: u32| (vertex, at(vertex));
            Curve::new(index as u32, piece, end(piece.tail), end(piece.head), piece.whole.map(at))
        };
        let curves = pieces.pieces.iter().enumerate().filter_map(curve).filter(|curve| !curve.is_vertical());
        Self { curves: curves.collect(), base: pieces.base[0] }
    }

    /// The base and the weights of all curves below a point.
    fn around(&self, p: DVec2) -> i32 {
        let over = self.curves.iter().filter(|curve| curve.start.x <= p.x && p.x < curve.end.x);
        self.base + over.filter(|curve| curve.side(p) > 0.0).map(|curve| curve.weight[0]).sum::<i32>()
    }
}
