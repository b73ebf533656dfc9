//! Minkowski sums by convex decomposition and union (memo I1): the second opinion, which shares with
//! [`crate::convolve`] only numbers, predicates and the normal form of regions.

use crate::arrange::Edge;
use crate::convex;
use crate::error::{Budget, OracleError};
use crate::number::Number;
use crate::point::Point;
use crate::region::{ExactRegion, ring_edges};
use crate::trapezoid::{Convex, trapezoids};
use crate::union;

/// The closed, regularised Minkowski sum of two regions.
///
/// # Errors
/// [`OracleError::TooCostly`] beyond the budget.
pub fn sum<Q: Number>(a: &ExactRegion<Q>, b: &ExactRegion<Q>, budget: Budget) -> Result<ExactRegion<Q>, OracleError> {
    if a.is_empty() || b.is_empty() {
        return Ok(ExactRegion::empty());
    }
    match (a.unbounded(), b.unbounded()) {
        (true, true) => Ok(ExactRegion::plane()),
        (true, false) => unbounded_sum(a, b, budget),
        (false, true) => unbounded_sum(b, a, budget),
        (false, false) => ExactRegion::from_edges(edges_of_sum(edges(a), edges(b), budget)?, false),
    }
}

/// The boundary of the sum of two bounded regions given by their edges.
fn edges_of_sum<Q: Number>(a: Vec<Edge<Q>>, b: Vec<Edge<Q>>, budget: Budget) -> Result<Vec<Edge<Q>>, OracleError> {
    let (pieces_a, pieces_b) = (trapezoids(a), trapezoids(b));
    budget.check_segments(pieces_a.len().saturating_mul(pieces_b.len()))?;
    let sums: Vec<Convex<Q>> = pieces_a.iter().flat_map(|p| pieces_b.iter().map(|q| convex::sum(p, q))).collect();
    union::boundary(&sums, budget)
}

/// The sum of an unbounded and a bounded region, by clipping the unbounded one to a box.
///
/// A point t is outside the sum only if t-B lies in the complement of A, hence in the bounding box of A's boundary: so t
/// lies in the window W, the sum of that box and the one of B. For t within half a B of W, t-B lies in the box of A's
/// boundary enlarged by twice the size of B, so inside W the sum with A clipped to that box is the true one, and every
/// edge of the true boundary lies in W. The edges elsewhere come from the clipping.
fn unbounded_sum<Q: Number>(
    a: &ExactRegion<Q>,
    b: &ExactRegion<Q>,
    budget: Budget,
) -> Result<ExactRegion<Q>, OracleError> {
    let (Some(frame), Some(size)) = (Frame::around(a), Frame::around(b)) else {
        return Ok(ExactRegion::plane());
    };
    let window = Frame { low: frame.low.plus(&size.low), high: frame.high.plus(&size.high) };
    let margin = size.high.minus(&size.low).times(&Q::from_i64(2));
    let clip = Frame { low: frame.low.minus(&margin), high: frame.high.plus(&margin) };
    let mut clipped = edges(a);
    clipped.extend(clip.edges());
    let mut sum = edges_of_sum(clipped, edges(b), budget)?;
    sum.retain(|(tail, head)| window.contains(tail) && window.contains(head));
    ExactRegion::from_edges(sum, true)
}

fn edges<Q: Number>(region: &ExactRegion<Q>) -> Vec<Edge<Q>> {
    region.edges().map(|(tail, head)| (tail.clone(), head.clone())).collect()
}

/// An exact box.
struct Frame<Q> {
    low: Point<Q>,
    high: Point<Q>,
}

impl<Q: Number> Frame<Q> {
    /// The bounding box of the boundary of a region, if it has one.
    fn around(region: &ExactRegion<Q>) -> Option<Self> {
        let points = || region.loops().iter().flatten();
        let (xs, ys) = (|| points().map(|p| &p.x), || points().map(|p| &p.y));
        let low = Point { x: xs().min()?.clone(), y: ys().min()?.clone() };
        let high = Point { x: xs().max()?.clone(), y: ys().max()?.clone() };
        Some(Self { low, high })
    }

    fn contains(&self, p: &Point<Q>) -> bool {
        self.low.x <= p.x && p.x <= self.high.x && self.low.y <= p.y && p.y <= self.high.y
    }

    /// The edges, counter-clockwise.
    fn edges(&self) -> Vec<Edge<Q>> {
        let corner = |x: &Q, y: &Q| Point { x: x.clone(), y: y.clone() };
        let (low, high) = (&self.low, &self.high);
        let ring = [corner(&low.x, &low.y), corner(&high.x, &low.y), corner(&high.x, &high.y), corner(&low.x, &high.y)];
        ring_edges(&ring).map(|(tail, head)| (tail.clone(), head.clone())).collect()
    }
}
