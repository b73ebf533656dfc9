//! The sum curves of two regions: a superset of the boundary of their Minkowski sum (memo B1, I4).
//!
//! At a boundary point t of E = A ⊕ B the bodies A and t - B touch from outside. At the touching points a and b the outward
//! normals agree, and the curvatures allow it: with κ infinite at a convex corner, 0 on a line, ±1/r on a convex or concave
//! arc and minus infinity at a reflex corner, κ_a + κ_b >= 0. So the boundary lies on these curves a + b:
//! a line or an arc moved by a convex corner, an arc with the centre c_a + c_b and the signed radius r_a + r_b, if it is
//! positive or one of the arcs concave and it is negative, and a line moved by the arc's point with its normal. Where two
//! lines have the same normal, the end of each that comes first along the boundary of A, or last along that of B, moves
//! the other: the common stretch of A and t - B always has such an end. Exceptions are single points.
//!
//! All curves consist of points of E, so what is more than needed does no harm. The inside of E is on their left.

use std::cmp::Ordering;
use std::sync::Arc;

use super::curve::Curve;
use super::fan::{Fan, Flat, Normals, Part, Round, Spoke};
use super::meet::LIMIT;
use super::piece::{Circle, Piece};
use super::real::Real;
use super::shape::Shape;

/// A sum curve and the parts it comes from.
#[derive(Clone, Debug)]
pub struct Sum {
    /// The curve, E on its left.
    pub curve: Arc<Curve>,
    /// The part of A.
    pub first: Part,
    /// The part of B.
    pub second: Part,
}

/// The sum curves of two regions.
#[must_use]
pub fn sums(a: &Shape, b: &Shape) -> Vec<Sum> {
    let (a, b) = (Normals::new(a), Normals::new(b));
    let mut sums = Vec::new();
    for fan in &a.fans {
        sums.extend(b.fans.iter().filter_map(|other| rounds(fan, other)));
        for flat in &b.flats {
            let moved = fan.spoke(flat, Spoke::High).map(|spoke| moved(flat, fan, spoke));
            sums.extend(moved.map(|curve| Sum { curve, first: fan.part, second: flat.part }));
        }
    }
    for fan in &b.fans {
        for flat in &a.flats {
            let moved = fan.spoke(flat, Spoke::Low).map(|spoke| moved(flat, fan, spoke));
            sums.extend(moved.map(|curve| Sum { curve, first: flat.part, second: fan.part }));
        }
    }
    sums
}

/// A line moved by a point.
fn moved(flat: &Flat, fan: &Fan, spoke: Spoke) -> Arc<Curve> {
    let (line, fan) = (Arc::clone(&flat.curve), fan.clone());
    Arc::new(Curve::new(move |precision| line.at(precision).moved(&fan.point(&spoke, precision))))
}

/// The common directions of two fans, with the points of both at the first and at the last.
struct Overlap {
    low: [Spoke; 2],
    high: [Spoke; 2],
}

impl Overlap {
    fn of(a: &Fan, b: &Fan) -> Option<Self> {
        let quadrant = a.quadrant;
        let (low, first) = match a.low.order(&b.low, quadrant) {
            Ordering::Less => ([Spoke::Along(b.low.clone()), Spoke::Low], &b.low),
            Ordering::Equal => ([Spoke::Low, Spoke::Low], &a.low),
            Ordering::Greater => ([Spoke::Low, Spoke::Along(a.low.clone())], &a.low),
        };
        let (high, last) = match a.high.order(&b.high, quadrant) {
            Ordering::Less => ([Spoke::High, Spoke::Along(a.high.clone())], &a.high),
            Ordering::Equal => ([Spoke::High, Spoke::High], &a.high),
            Ordering::Greater => ([Spoke::Along(b.high.clone()), Spoke::High], &b.high),
        };
        first.order(last, quadrant).is_lt().then_some(Self { low, high })
    }
}

/// The sum of two fans, if it is a curve that A and t - B can touch along.
fn rounds(a: &Fan, b: &Fan) -> Option<Sum> {
    let concave = usize::from(a.is_concave()) + usize::from(b.is_concave());
    if a.quadrant != b.quadrant || (a.part.corner && b.part.corner) || concave == 2 {
        return None;
    }
    let expected = if concave == 0 { Ordering::Greater } else { Ordering::Less };
    let overlap = Overlap::of(a, b)?;
    let total = LIMIT.decide(|p| (a.round(p).radius + b.round(p).radius).sign());
    if total != Some(expected) {
        return None;
    }
    let (first, second) = (a.part, b.part);
    let (a, b) = (a.clone(), b.clone());
    let curve = Curve::new(move |precision| {
        let [low, high] = [&overlap.low, &overlap.high].map(|[p, q]| &a.point(p, precision) + &b.point(q, precision));
        let (Round { centre: c, radius: r }, Round { centre: d, radius: s }) = (a.round(precision), b.round(precision));
        let (centre, radius): (_, Real) = (&c + &d, (r + s).abs());
        let left = expected.is_gt();
        let (from, to) = if left { (low, high) } else { (high, low) };
        Piece { from, to, circle: Some(Circle { centre, radius, left }) }
    });
    Some(Sum { curve: Arc::new(curve), first, second })
}
