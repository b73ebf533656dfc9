//! Squares that certainly lie in the interior of a Minkowski sum.
//!
//! If a closed square S lies in the interior of A and a point b in B, then S+b lies in the interior of A+b, which is
//! contained in that of A ⊕ B; likewise with A and B exchanged. All squares and points are taken from one lattice, where
//! such sums are squares again.

use crate::boxes::Extent;
use crate::cells::Cells;
use crate::interval::Interval;
use crate::lattice::{Lattice, visit_squares};
use crate::number::Number;
use crate::point::Place;
use crate::region::ExactRegion;

/// Squares in the interior of a sum.
pub struct Cover {
    lattice: Lattice,
    squares: Cells,
}

/// A lattice has this many squares, times the root of the number of segments, along the larger side of the sum's box.
/// Fewer leave more of radial polygons to walk, more take longer to find than they save.
const ACROSS: f64 = 8.0;

/// A lattice has no more squares along the larger side of the sum's box: up to here finer ones paid off for polygons of
/// a hundred to a thousand vertices.
const FINEST: f64 = 1024.0;

/// So many pairs of runs are added for each segment at most, so that combs, whose rows have many runs, do not take
/// longer than without a cover.
const PAIRS: usize = 4000;

impl Cover {
    /// Squares in the interior of the sum of two regions, for a convolution with this number of segments. `None` if a
    /// region has no boundary or is too small for its coordinates.
    #[must_use]
    pub fn new<Q: Number>(a: &ExactRegion<Q>, b: &ExactRegion<Q>, segments: usize) -> Option<Self> {
        let across = (ACROSS * (segments as f64).sqrt()).clamp(1.0, FINEST);
        let mut side = ((size(a)? + size(b)?) / across).log2().ceil().exp2();
        loop {
            let lattice = Lattice::new(side);
            let (bounds_a, bounds_b) = (lattice.bounds(a)?, lattice.bounds(b)?);
            let [points_a, squares_a] = lattice.inside(a, bounds_a).map(|cells| cells.runs());
            let [points_b, squares_b] = lattice.inside(b, bounds_b).map(|cells| cells.runs());
            if squares_a.len() * points_b.len() + squares_b.len() * points_a.len() <= PAIRS * segments.max(1) {
                let mut squares = Cells::new([0, 1].map(|k| [0, 1].map(|axis| bounds_a[k][axis] + bounds_b[k][axis])));
                add_sums(&mut squares, &squares_a, &points_b);
                add_sums(&mut squares, &squares_b, &points_a);
                return Some(Self { lattice, squares });
            }
            side *= 2.0;
        }
    }

    /// Where a segment may leave the squares: the parameters, 0 at the tail and 1 at the head, of two points of it before
    /// and after which it lies in the squares, so in the interior of the sum; `None` if all of it does.
    #[must_use]
    pub fn exposed<Q: Number>(&self, tail: &Place<Q>, head: &Place<Q>) -> Option<[f64; 2]> {
        let ends = [tail, head].map(|place| self.lattice.coordinates(place));
        let parts = parts(ends);
        let hidden = |part: &u32| {
            let [from, to] = [*part, part + 1].map(|k| f64::from(k) / f64::from(parts));
            self.hides([between(ends, from), between(ends, to)])
        };
        let first = (0..parts).find(|part| !hidden(part))?;
        let last = (first..parts).rev().find(|part| !hidden(part))?;
        Some([f64::from(first) / f64::from(parts), f64::from(last + 1) / f64::from(parts)])
    }

    /// Whether the line between two points lies in the squares.
    fn hides(&self, [tail, head]: [[Interval; 2]; 2]) -> bool {
        let mut hidden = true;
        visit_squares(tail, head, |row, first, last| hidden = hidden && self.squares.contains(row, first, last));
        hidden
    }
}

/// The number of equal parts, a power of two so that their ends are short numbers, in which a segment is looked at: such
/// that a part is as long as about two squares.
fn parts([tail, head]: [[Interval; 2]; 2]) -> u32 {
    let [x, y] = [0, 1].map(|k| (head[k].mid() - tail[k].mid()).abs());
    ((x.max(y) / 2.0).clamp(1.0, FINEST) as u32).next_power_of_two()
}

/// Intervals around the point at a parameter on the way from one point to another.
fn between([tail, head]: [[Interval; 2]; 2], parameter: f64) -> [Interval; 2] {
    [0, 1].map(|k| tail[k] + (head[k] - tail[k]) * Interval::point(parameter))
}

/// The larger side of the box around the boundary of a region, about; `None` without a boundary.
fn size<Q: Number>(region: &ExactRegion<Q>) -> Option<f64> {
    let [left, bottom, right, top] = Extent::around(region.places().iter().flatten())?.ends;
    Some((right - left).max(top - bottom))
}

/// Adds every square that is the sum of a square and a point of these runs.
fn add_sums(sums: &mut Cells, squares: &[(i64, i64, i64)], points: &[(i64, i64, i64)]) {
    for (row, first, last) in squares {
        points.iter().for_each(|(up, from, to)| sums.insert(row + up, first + from, last + to));
    }
}
