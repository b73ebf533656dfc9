//! A square lattice laid over regions: which of its squares a segment meets, and which of its points and squares lie in
//! a region. Everything is decided by intervals, so that what is claimed is certain and what is uncertain is not claimed.
//!
//! Coordinates are in units of the side of a square: the points of the lattice are those with integer coordinates, and a
//! square has the numbers of its lower left corner.

use crate::cells::Cells;
use crate::interval::Interval;
use crate::number::Number;
use crate::point::{Place, Point};
use crate::region::{ExactRegion, ring_edges};

/// A lattice.
#[derive(Clone, Copy, Debug)]
pub struct Lattice {
    side: f64,
}

/// The numbers of the first and of the last column and row of some cells.
pub type Bounds = [[i64; 2]; 2];

impl Lattice {
    /// The lattice whose squares have this side, a power of two, in input units.
    #[must_use]
    pub fn new(side: f64) -> Self {
        Self { side }
    }

    /// Intervals around the coordinates of a place.
    #[must_use]
    pub fn coordinates<Q: Number>(self, place: &Place<Q>) -> [Interval; 2] {
        [place.x, place.y].map(|coordinate| coordinate / Interval::point(self.side))
    }

    /// The squares around the boundary of a region; `None` without one, or where numbers get too large to count by.
    #[must_use]
    pub fn bounds<Q: Number>(self, region: &ExactRegion<Q>) -> Option<Bounds> {
        const LARGE: i64 = 1 << 50;
        let places = region.places();
        let each = places.iter().flatten().map(|place| self.coordinates(place));
        let [x, y] = each.reduce(|a, b| [a[0].hull(b[0]), a[1].hull(b[1])])?;
        let ((left, right), (bottom, top)) = (squares(x), squares(y));
        let small = [left, right, bottom, top].iter().all(|number| number.saturating_abs() < LARGE);
        small.then_some([[left, bottom], [right, top]])
    }

    /// Lattice points of a region and lattice squares in its interior, all within the bounds.
    ///
    /// A square that no edge meets lies inside if its lower left corner does.
    #[must_use]
    pub fn inside<Q: Number>(self, region: &ExactRegion<Q>, bounds: Bounds) -> [Cells; 2] {
        let places = region.places();
        let edges = || places.iter().flat_map(|ring| ring_edges(ring));
        let mut met = Cells::new(bounds);
        let mut rows = Rows::new(self, bounds, i32::from(region.unbounded()));
        for (tail, head) in edges() {
            visit_squares(self.coordinates(tail), self.coordinates(head), |row, first, last| {
                met.insert(row, first, last)
            });
            rows.cross(tail, head);
        }
        let points = rows.points();
        let mut squares = points.clone();
        squares.remove_all(&met);
        [points, squares]
    }
}

/// The squares that a segment may meet, closed: calls `visit` with a row and its first and last square.
pub fn visit_squares(tail: [Interval; 2], head: [Interval; 2], mut visit: impl FnMut(i64, i64, i64)) {
    let line = Line::new(tail, head);
    let (first, last) = squares(line.y);
    for row in first..=last {
        let (from, to) = squares(line.abscissa(Interval::new(row as f64, (row + 1) as f64)));
        visit(row, from, to);
    }
}

/// The numbers of the first and last closed unit interval between integers that meets an interval.
fn squares(around: Interval) -> (i64, i64) {
    ((around.lo().ceil() as i64).saturating_sub(1), around.hi().floor() as i64)
}

/// A segment in the lattice's coordinates.
struct Line {
    tail: [Interval; 2],
    /// The change of the abscissa with the ordinate.
    slope: Interval,
    x: Interval,
    y: Interval,
}

impl Line {
    fn new(tail: [Interval; 2], head: [Interval; 2]) -> Self {
        let slope = (head[0] - tail[0]) / (head[1] - tail[1]);
        Self { tail, slope, x: tail[0].hull(head[0]), y: tail[1].hull(head[1]) }
    }

    /// An interval around the abscissas of the points of the segment with these ordinates.
    fn abscissa(&self, y: Interval) -> Interval {
        let x = self.tail[0] + (y - self.tail[1]) * self.slope;
        let (lo, hi) = (x.lo().max(self.x.lo()), x.hi().min(self.x.hi()));
        if lo <= hi { Interval::new(lo, hi) } else { self.x }
    }
}

/// The winding numbers of lattice points, row by row.
struct Rows<Q> {
    lattice: Lattice,
    bounds: Bounds,
    base: i32,
    /// Each row's height.
    heights: Vec<Place<Q>>,
    /// Each row's changes of the winding number from one point to the next.
    steps: Vec<Vec<i32>>,
    /// Runs of points too close to an edge to say on which side they are: row, first and last.
    unknown: Vec<(i64, i64, i64)>,
}

impl<Q: Number> Rows<Q> {
    fn new(lattice: Lattice, bounds: Bounds, base: i32) -> Self {
        let [[left, bottom], [right, top]] = bounds;
        let height = |row: i64| Q::from_f64(row as f64 * lattice.side).expect("the bounds are finite");
        let place = |row: i64| Place::from(Point { x: Q::from_i64(0), y: height(row) });
        let heights: Vec<Place<Q>> = (bottom..=top).map(place).collect();
        let steps = vec![vec![0; (right - left + 2) as usize]; heights.len()];
        Self { lattice, bounds, base, heights, steps, unknown: Vec::new() }
    }

    /// Counts an edge for the points to its left in every row that it crosses.
    fn cross(&mut self, tail: &Place<Q>, head: &Place<Q>) {
        let [[left, bottom], [right, top]] = self.bounds;
        let line = Line::new(self.lattice.coordinates(tail), self.lattice.coordinates(head));
        let (first, last) = squares(line.y);
        for row in first.max(bottom)..=last.min(top) {
            let index = (row - bottom) as usize;
            let below = |place: &Place<Q>| place.compare_y(&self.heights[index]).is_le();
            let climbs = below(tail);
            if climbs == below(head) {
                continue;
            }
            let x = line.abscissa(Interval::point(row as f64));
            let (from, to) = (x.lo().ceil() as i64, x.hi().floor() as i64);
            if from <= to {
                self.unknown.push((row, from, to));
            }
            let step = if climbs { 1 } else { -1 };
            self.steps[index][0] += step;
            self.steps[index][(from.clamp(left, right + 1) - left) as usize] -= step;
        }
    }

    /// The points with a winding number that is known not to be 0.
    fn points(&self) -> Cells {
        let [[left, bottom], _] = self.bounds;
        let mut points = Cells::new(self.bounds);
        for (row, steps) in (bottom..).zip(&self.steps) {
            let mut winding = self.base;
            for (column, step) in (left..).zip(steps) {
                winding += step;
                if winding != 0 {
                    points.insert(row, column, column);
                }
            }
        }
        self.unknown.iter().for_each(|&(row, first, last)| points.remove(row, first, last));
        points
    }
}
