//! The boundary of what closed curves wind around (memo D, I2), exactly and without an arrangement data structure.
//!
//! Each segment is walked from tail to head. The winding numbers just left of its start come from one ray; after that
//! they change only where another segment comes in from the left, and the difference between left and right changes
//! only where segments lie on top of each other. Along the way it is always known whether the segment separates inside
//! from outside, so no point is ever computed except the ends of boundary pieces. Coincident segments are reported once,
//! by the first of them. What of a segment its caller knows to bound nothing is not walked, but counts for the others;
//! to hide what does bound something leaves boundaries that do not close up.
//!
//! Several layers of curves keep separate winding numbers, so that a Boolean operation is a predicate on them.

use std::cmp::Ordering;

use crate::boxes::{Boxes, Extent};
use crate::curves::{Curves, Segment};
use crate::error::{Budget, OracleError};
use crate::number::Number;
use crate::point::{Place, Point, cross_sign, dot_sign, orient};
use crate::walk::Walk;

/// A directed piece of boundary, the inside on its left.
pub type Edge<Q> = (Point<Q>, Point<Q>);

/// The boundaries of R regions: region k is where `inside[k]` holds for the winding numbers of the L layers, which far
/// away are `base`. Each boundary is a set of directed edges with the region on the left that meet only at ends, except
/// that an end may touch the inside of an edge.
///
/// # Errors
/// [`OracleError::TooCostly`] beyond the budget, [`OracleError::BadNumber`] for coordinates too large for doubles.
pub fn boundaries<Q: Number, const L: usize, const R: usize>(
    curves: &Curves<Q>,
    base: [i32; L],
    inside: [fn(&[i32; L]) -> bool; R],
    budget: Budget,
) -> Result<[Vec<Edge<Q>>; R], OracleError> {
    budget.check_segments(curves.len())?;
    let field = Field::new(curves, base)?;
    let mut edges = std::array::from_fn(|_| Vec::new());
    let mut meetings = 0;
    for (index, segment) in field.segments.iter().enumerate() {
        let Some(ends) = segment.exposed else { continue };
        meetings += Walk::new(&field, index, ends).follow(inside, &mut edges);
        budget.check_meetings(meetings)?;
    }
    Ok(edges)
}

/// Segments indexed by their boxes, and the winding numbers they make.
pub(crate) struct Field<'a, Q, const L: usize> {
    curves: &'a Curves<Q>,
    pub(crate) segments: Vec<Segment>,
    extents: Vec<Extent>,
    boxes: Boxes,
    base: [i32; L],
    /// The abscissa halfway between the left and the right end.
    middle: f64,
}

impl<'a, Q: Number, const L: usize> Field<'a, Q, L> {
    fn new(curves: &'a Curves<Q>, base: [i32; L]) -> Result<Self, OracleError> {
        let segments: Vec<Segment> = curves.segments().copied().collect();
        let extents: Vec<Extent> = segments.iter().map(|s| curves.extent([s.tail, s.head])).collect();
        let boxes = Boxes::new(&extents)?;
        let left = extents.iter().map(|extent| extent.ends[0]).fold(f64::INFINITY, f64::min);
        let right = extents.iter().map(|extent| extent.ends[2]).fold(f64::NEG_INFINITY, f64::max);
        Ok(Self { curves, segments, extents, boxes, base, middle: 0.5 * left + 0.5 * right })
    }

    /// The place of this number.
    pub(crate) fn place(&self, number: usize) -> &'a Place<Q> {
        self.curves.at(number)
    }

    /// The ends of a segment.
    pub(crate) fn ends(&self, index: usize) -> (&'a Place<Q>, &'a Place<Q>) {
        let segment = &self.segments[index];
        (self.place(segment.tail), self.place(segment.head))
    }

    /// The side of the line through two places on which a third one lies, all given by their numbers.
    pub(crate) fn side(&self, [tail, head]: [usize; 2], place: usize) -> Ordering {
        if place == tail || place == head {
            return Ordering::Equal;
        }
        orient(self.place(tail), self.place(head), self.place(place))
    }

    /// Calls `visit` with every segment that may meet the one between two places and returns how many there are.
    pub(crate) fn visit_near(&self, ends: [usize; 2], mut visit: impl FnMut(usize)) -> u64 {
        let mut count = 0;
        self.boxes.visit(&self.curves.extent(ends), |index| {
            count += 1;
            visit(index);
        });
        count
    }

    /// The winding numbers at a point q infinitesimally ahead of the tail on the way to the head and, by far less, to
    /// its left, and the number of segments looked at: a ray from q to the nearer of the left and the right end of the
    /// field, since most walks begin near the boundary.
    pub(crate) fn winding_left_of(&self, tail: &Place<Q>, head: &Place<Q>) -> ([i32; L], u64) {
        self.winding_by_ray(tail, head, tail.x.mid() > self.middle)
    }

    /// [`Self::winding_left_of`] by a ray in the direction of +x, or else -x.
    fn winding_by_ray(&self, tail: &Place<Q>, head: &Place<Q>, to_right: bool) -> ([i32; L], u64) {
        let q_above = match head.compare_y(tail) {
            Ordering::Equal => head.order(tail) == Ordering::Greater,
            climb => climb == Ordering::Greater,
        };
        let below = |p: &Place<Q>| match p.compare_y(tail) {
            Ordering::Equal => q_above,
            order => order == Ordering::Less,
        };
        let (x0, x1) = if to_right { (tail.x.lo(), f64::INFINITY) } else { (f64::NEG_INFINITY, tail.x.hi()) };
        let mut winding = self.base;
        let mut count = 0;
        self.boxes.visit(&Extent { ends: [x0, tail.y.lo(), x1, tail.y.hi()] }, |index| {
            count += 1;
            let (from, to) = self.ends(index);
            let climbs = below(from);
            if climbs == below(to) {
                return;
            }
            let [left, _, right, _] = self.extents[index].ends;
            let q_before = if left > tail.x.hi() {
                true
            } else if right < tail.x.lo() {
                false
            } else {
                is_left_of([tail, head], [from, to]) == climbs
            };
            if q_before == to_right {
                let Segment { layer, weight, .. } = self.segments[index];
                winding[layer] += if climbs == to_right { weight } else { -weight };
            }
        });
        (winding, count)
    }
}

/// Whether the point q of [`Field::winding_left_of`] is left of a segment that passes its height.
fn is_left_of<Q: Number>([tail, head]: [&Place<Q>; 2], [from, to]: [&Place<Q>; 2]) -> bool {
    orient(from, to, tail)
        .then_with(|| cross_sign(from, to, tail, head))
        .then_with(|| dot_sign(from, to, tail, head))
        .is_gt()
}

#[cfg(test)]
mod tests {
    use super::Field;
    use crate::curves::Curves;
    use crate::point::Point;
    use proptest::prelude::*;
    use rug::Rational;

    fn ring() -> impl Strategy<Value = Vec<Point<Rational>>> {
        let point = (0i32..4, 0i32..4).prop_map(|(x, y)| Point { x: Rational::from(x), y: Rational::from(y) });
        prop::collection::vec(point, 2..6)
    }

    proptest! {
        #[test]
        fn rays_to_both_sides_count_the_same(rings in prop::collection::vec(ring(), 1..4), base in -1i32..2) {
            let mut curves = Curves::default();
            rings.into_iter().for_each(|ring| curves.ring(ring, 0));
            let field = Field::new(&curves, [base]).expect("small");
            for index in 0..field.segments.len() {
                let (tail, head) = field.ends(index);
                for (tail, head) in [(tail, head), (head, tail)] {
                    let [left, right] = [false, true].map(|to_right| field.winding_by_ray(tail, head, to_right).0);
                    prop_assert_eq!(left, right);
                }
            }
        }
    }
}
