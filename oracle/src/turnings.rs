//! Turning points of polygons with the chains that meet there, and the order of the sum segments at a pair of them (MS 7.1;
//! memo E6), in exact arithmetic: what the convolution order says of ordinates at one abscissa.

use crate::chains::{Chain, Point, chains, concave, convolved, extreme, rings};
use crate::plain::PlainRegion;
use rug::Rational;

/// A turning point with its lower and its upper chain.
#[derive(Clone, Debug)]
pub struct Turning {
    /// Where it is.
    pub point: Point,
    /// Whether the chains begin at it, from left to right.
    pub left: bool,
    /// Whether the lower chain is above the upper one.
    pub concave: bool,
    /// The lower chain.
    pub lower: Chain,
    /// The upper chain.
    pub upper: Chain,
}

/// The ordinates of the six kinds of segments at an abscissa, where there are such: of lower chains first.
#[derive(Clone, Debug)]
pub struct Ordinates {
    /// L1+L2 and U1+U2.
    pub crust: [Option<Rational>; 2],
    /// L1+p2 and U1+p2.
    pub of_a: [Option<Rational>; 2],
    /// p1+L2 and p1+U2.
    pub of_b: [Option<Rational>; 2],
}

/// The turning points of the first loop of a polygon.
///
/// # Panics
/// If it is no polygon with a loop.
#[must_use]
pub fn turnings(region: &PlainRegion) -> Vec<Turning> {
    let all = chains(&rings(region)[0]);
    let concave = concave(&all);
    let turning = |k: usize| {
        let (before, after) = (&all[k], &all[(k + 1) % all.len()]);
        let point = after.path[0].clone();
        let (upper, lower) = if before.upper { (before, after) } else { (after, before) };
        let is_concave = concave.contains(&point);
        Turning { point, left: before.upper, concave: is_concave, lower: lower.clone(), upper: upper.clone() }
    };
    (0..all.len()).map(turning).collect()
}

impl Turning {
    /// The ordinates of the lower and the upper chain moved by a point.
    fn moved(&self, by: &Point, x: &Rational) -> [Option<Rational>; 2] {
        let own = Rational::from(x - &by[0]);
        [&self.lower, &self.upper].map(|chain| Some(extreme(&chain.path, &own, chain.upper)? + &by[1]))
    }
}

impl Ordinates {
    /// Those at two turning points of one handedness.
    #[must_use]
    pub fn new(p: &Turning, q: &Turning, x: &Rational) -> Self {
        let crust =
            [convolved(&p.lower.path, &q.lower.path, x, false), convolved(&p.upper.path, &q.upper.path, x, true)];
        Self { crust, of_a: p.moved(&q.point, x), of_b: q.moved(&p.point, x) }
    }

    /// The same with the two regions exchanged.
    #[must_use]
    pub fn exchanged(self) -> Self {
        Self { of_a: self.of_b, of_b: self.of_a, ..self }
    }

    /// What the rows of the order table say that are about A first, as pairs of ordinates of which the first is not above the
    /// second. The other rows are these with the regions exchanged. The last three rows are about cancellations.
    #[must_use]
    pub fn rows(&self, [concave_a, concave_b]: [bool; 2]) -> [Option<[Rational; 2]>; 10] {
        let Self { crust: [low, high], of_a: [low_a, high_a], of_b: [low_b, high_b] } = self;
        let (convex, mixed, both) = (!concave_a, !concave_a && concave_b, concave_a && concave_b);
        let along = |crust: &Option<Rational>, chain: &Option<Rational>| both && crust.is_some() && crust == chain;
        [
            row(concave_b, low, low_a),
            row(concave_b, high_a, high),
            row(concave_b && convex, low_a, high_a),
            row(concave_b && concave_a, high_a, low_a),
            row(mixed && low_a.is_some() && high_a.is_some(), low, high),
            row(mixed && low_a.is_some(), low, high_a),
            row(mixed && high_a.is_some(), low_a, high),
            row(along(high, high_b), high_a, low_b),
            row(along(low, low_a), high_a, low_b),
            row(along(high, high_a) || along(low, low_b), high_b, low_a),
        ]
    }
}

/// A row, where it holds and both segments are there.
fn row(holds: bool, f: &Option<Rational>, g: &Option<Rational>) -> Option<[Rational; 2]> {
    if holds { Some([f.clone()?, g.clone()?]) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plain::{Bend, Corner};

    /// A block with a notch from the right: the turning point in the notch is concave.
    #[test]
    fn a_notch_has_a_concave_turning_point() {
        let corners = [(0.0, 0.0), (4.0, 1.0), (1.0, 2.0), (4.0, 3.0), (0.0, 4.0)];
        let corner = |(x, y)| Corner { x, y, bend: Bend::Line };
        let region = PlainRegion { loops: vec![corners.map(corner).to_vec()], unbounded: false };
        let all = turnings(&region);
        let concave: Vec<_> = all.iter().filter(|turning| turning.concave).collect();
        assert_eq!((all.len(), concave.len()), (4, 1));
        assert_eq!(concave[0].point, [Rational::from(1), Rational::from(2)]);
        assert!(concave[0].left && all.iter().filter(|turning| turning.left).count() == 2);
    }
}
