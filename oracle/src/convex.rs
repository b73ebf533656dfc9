//! Sums of convex polygons by merging their edges in the order of direction (memo J2).

use std::cmp::Ordering;

use crate::number::Number;
use crate::point::{Place, Point, cross_sign};
use crate::trapezoid::Convex;

/// The sum of two convex polygons, counter-clockwise from its lexicographic minimum, without collinear vertices.
#[must_use]
pub fn sum<Q: Number>(p: &Convex<Q>, q: &Convex<Q>) -> Convex<Q> {
    let (first, second) = (Side::from_lowest(p), Side::from_lowest(q));
    let mut corners = Vec::with_capacity(p.len() + q.len());
    let (mut i, mut j) = (0, 0);
    while i < p.len() || j < q.len() {
        corners.push(Place::from(first.corner(i).plus(second.corner(j))));
        let turn = match (i < p.len(), j < q.len()) {
            (true, true) => {
                let ([a, b], [c, d]) = (first.side(i), second.side(j));
                cross_sign(a, b, c, d)
            }
            (true, false) => Ordering::Greater,
            _ => Ordering::Less,
        };
        // The edge that comes first counter-clockwise goes first; equal directions go together.
        i += usize::from(turn.is_ge());
        j += usize::from(turn.is_le());
    }
    corners
}

/// A convex polygon read from its lexicographic minimum on.
struct Side<'a, Q> {
    polygon: &'a Convex<Q>,
    lowest: usize,
}

impl<'a, Q: Number> Side<'a, Q> {
    fn from_lowest(polygon: &'a Convex<Q>) -> Self {
        let lowest = (0..polygon.len()).min_by(|&i, &j| polygon[i].order(&polygon[j])).unwrap_or(0);
        Self { polygon, lowest }
    }

    fn place(&self, i: usize) -> &'a Place<Q> {
        &self.polygon[(self.lowest + i) % self.polygon.len()]
    }

    fn corner(&self, i: usize) -> &'a Point<Q> {
        &self.place(i).exact
    }

    fn side(&self, i: usize) -> [&'a Place<Q>; 2] {
        [self.place(i), self.place(i + 1)]
    }
}

#[cfg(test)]
mod tests {
    use super::sum;
    use crate::point::{Place, Point};
    use rug::Rational;

    fn polygon(corners: &[(i32, i32)]) -> Vec<Place<Rational>> {
        corners.iter().map(|&(x, y)| Place::from(Point { x: Rational::from(x), y: Rational::from(y) })).collect()
    }

    #[test]
    fn parallel_edges_merge() {
        let square = polygon(&[(1, 0), (1, 1), (0, 1), (0, 0)]);
        let triangle = polygon(&[(0, 0), (2, 0), (0, 2)]);
        let expected = polygon(&[(0, 0), (3, 0), (3, 1), (1, 3), (0, 3)]);
        let points = |p: &[Place<Rational>]| p.iter().map(|p| p.exact.clone()).collect::<Vec<_>>();
        assert_eq!(points(&sum(&square, &triangle)), points(&expected));
        assert_eq!(points(&sum(&triangle, &square)), points(&expected));
    }
}
