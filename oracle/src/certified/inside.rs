//! Whether a point lies in a region, by its winding number (memo I4).
//!
//! A ray runs from the point to the right and counts the pieces that pass it, upwards as 1 and downwards as -1. A joint of
//! two pieces that is level with the point, or too near to that to tell, counts as below for both pieces. That is
//! the winding number of the boundary with the joint moved down or up a little, near its abscissa only. It is the true one
//! if the move does not sweep over the point: for a piece with such a joint, the point must be on the same side of
//! the joint as of the place where the carrier passes the height of the point; between two such joints there must be no
//! point. This fails only near the boundary, and so the ray needs no other directions however many joints are level with it.

use std::cmp::Ordering;
use std::sync::Arc;

use super::curve::Curve;
use super::piece::Piece;
use super::precision::Precision;
use super::real::Real;
use super::shape::Shape;
use super::spot::Spot;
use super::tree::Tree;
use super::vector::Vector;

/// Whether the point is certainly in the interior or certainly outside; `None` on the boundary or too near to it. To ask
/// about many points, prepare a [`Winding`].
#[must_use]
pub fn inside(shape: &Shape, spot: &Spot) -> Option<bool> {
    Winding::new(shape).inside(|p| spot.at(p), Precision::FINEST)
}

/// The boundary of a region, prepared for winding numbers.
#[derive(Debug)]
pub struct Winding {
    arms: Vec<Arm>,
    tree: Tree,
    base: i32,
}

/// A piece, and the piece after it on its loop, whose start stands for the end of this one: neighbours must agree.
#[derive(Debug)]
struct Arm {
    curve: Arc<Curve>,
    next: Arc<Curve>,
}

impl Winding {
    /// Prepares a region.
    #[must_use]
    pub fn new(shape: &Shape) -> Self {
        let next = |ring: &[_], i: usize| (i + 1) % ring.len();
        let mut arms = Vec::new();
        for ring in &shape.loops {
            let arm = |i: usize| Arm { curve: ring[i].curve.clone(), next: ring[next(ring, i)].curve.clone() };
            arms.extend((0..ring.len()).map(arm));
        }
        let boxes: Vec<_> = arms.iter().map(|arm| arm.curve.rough().bounds()).collect();
        Self { arms, tree: Tree::new(&boxes), base: i32::from(shape.unbounded) }
    }

    /// A piece by its place in [`Shape::sides`].
    #[must_use]
    pub fn piece(&self, side: usize) -> &Curve {
        &self.arms[side].curve
    }

    /// The boxes of the pieces, known to doubles.
    #[must_use]
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// Whether the winding number of the point, which must be the same point at every precision, is certainly not 0 or
    /// certainly 0; `None` if even the limit does not tell.
    pub fn inside(&self, point: impl Fn(Precision) -> Vector, limit: Precision) -> Option<bool> {
        limit.decide(|p| self.inside_at(&point(p), p))
    }

    /// The same for a point known to one precision.
    #[must_use]
    pub fn inside_at(&self, point: &Vector, precision: Precision) -> Option<bool> {
        let mut winding = Some(self.base);
        let ray = [point.x.lo(), point.y.lo(), f64::INFINITY, point.y.hi()];
        self.tree.visit(&ray, |i| {
            let Arm { curve, next } = &self.arms[i];
            let pass = |w| Some(w + passes(curve.at(precision), &next.at(precision).from, point)?);
            winding = winding.and_then(pass);
        });
        winding.map(|w| w != 0)
    }
}

/// How a piece with this end passes the ray to the right of the point: 1 upwards, -1 downwards, 0 not.
fn passes(piece: &Piece, end: &Vector, point: &Vector) -> Option<i32> {
    let joints = [&piece.from, end];
    let heights = joints.map(|joint| (&joint.y - &point.y).sign());
    let level = heights.map(|height| !matches!(height, Some(Ordering::Less | Ordering::Greater)));
    let step = match heights.map(|height| height == Some(Ordering::Greater)) {
        [false, true] => 1,
        [true, false] => -1,
        _ if level == [false; 2] => return Some(0),
        _ => 0,
    };
    let sides = joints.map(|joint| (&joint.x - &point.x).sign());
    if sides == [Some(Ordering::Greater); 2] {
        return Some(step);
    }
    if sides == [Some(Ordering::Less); 2] {
        return Some(0);
    }
    let right = is_right_of(piece, end, point)?;
    let side = if right { Ordering::Greater } else { Ordering::Less };
    let agree = (0..2).all(|joint| !level[joint] || sides[joint] == Some(side));
    agree.then_some(if right { step } else { 0 })
}

/// Whether the carrier of a piece, within the piece's box and at the height of the point, is to the right of the point.
fn is_right_of(piece: &Piece, end: &Vector, point: &Vector) -> Option<bool> {
    let definite = |x: Real| x.sign().filter(|sign| sign.is_ne()).map(Ordering::is_gt);
    let rises = definite(&end.y - &piece.from.y)?;
    let is_left = match &piece.circle {
        None => definite(piece.chord().cross(&(point - &piece.from)))?,
        Some(circle) => {
            let within = definite(circle.radius.square() - (point - &circle.centre).square())?;
            within == circle.left
        }
    };
    Some(is_left == rises)
}
