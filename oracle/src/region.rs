//! Exact polygonal regions in normal form, so that equal regions are equal values.
//!
//! The loops are simple, keep the interior on their left, have no collinear vertices, begin at their lexicographic
//! minimum and are sorted; they may touch at points ([`crate::trace`] says how they are paired there). The region is the
//! closure of its interior.

use std::cmp::Ordering;

use crate::arrange::{Edge, boundaries};
use crate::curves::Curves;
use crate::error::{Budget, OracleError};
use crate::interval::Interval;
use crate::number::Number;
use crate::plain::{Bend, Corner, PlainRegion};
use crate::point::{Place, Point};
use crate::trace;

/// A region in normal form, in input units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExactRegion<Q> {
    loops: Vec<Vec<Point<Q>>>,
    unbounded: bool,
}

impl<Q: Number> ExactRegion<Q> {
    /// The empty region.
    #[must_use]
    pub fn empty() -> Self {
        Self { loops: Vec::new(), unbounded: false }
    }

    /// The whole plane.
    #[must_use]
    pub fn plane() -> Self {
        Self { loops: Vec::new(), unbounded: true }
    }

    /// The region with these boundary edges, the interior on their left, that meet only at ends (or with an end on the
    /// inside of an edge).
    ///
    /// # Errors
    /// [`OracleError::Inconsistent`] if they do not close up, [`OracleError::BadNumber`] for coordinates too large for
    /// doubles.
    pub fn from_edges(edges: Vec<Edge<Q>>, unbounded: bool) -> Result<Self, OracleError> {
        Ok(Self { loops: trace::loops(edges)?, unbounded })
    }

    /// The closure of the points around which the loops wind a number of times that is not 0, where an unbounded region
    /// starts from 1. So slightly crossing loops still describe a region.
    ///
    /// # Errors
    /// [`OracleError::NotPolygonal`] for circle segments, [`OracleError::BadNumber`] for coordinates that are not
    /// finite.
    pub fn from_plain(region: &PlainRegion) -> Result<Self, OracleError> {
        Self::from_rings(exact_rings(region)?, region.unbounded, |w| w[0] != 0)
    }

    /// The closure of the points whose winding number is `inside`; far away it is 1 if `unbounded` and 0 otherwise.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn from_rings(
        rings: Vec<Vec<Point<Q>>>,
        unbounded: bool,
        inside: fn(&[i32; 1]) -> bool,
    ) -> Result<Self, OracleError> {
        let mut curves = Curves::default();
        rings.into_iter().for_each(|ring| curves.ring(ring, 0));
        let [edges] = boundaries(&curves, [i32::from(unbounded)], [inside], Budget::NONE)?;
        Self::from_edges(edges, unbounded)
    }

    /// The loops: outer ones counter-clockwise, holes clockwise.
    #[must_use]
    pub fn loops(&self) -> &[Vec<Point<Q>>] {
        &self.loops
    }

    /// Whether everything far away belongs to the region.
    #[must_use]
    pub fn unbounded(&self) -> bool {
        self.unbounded
    }

    /// Whether nothing belongs to the region.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.loops.is_empty() && !self.unbounded
    }

    /// The number of vertices.
    #[must_use]
    pub fn vertices(&self) -> usize {
        self.loops.iter().map(Vec::len).sum()
    }

    /// The number of clockwise loops.
    #[must_use]
    pub fn holes(&self) -> usize {
        self.loops.iter().filter(|ring| ring_area(ring).sign().is_lt()).count()
    }

    /// The edges, the interior on their left.
    pub fn edges(&self) -> impl Iterator<Item = (&Point<Q>, &Point<Q>)> {
        self.loops.iter().flat_map(|ring| ring_edges(ring))
    }

    /// The exact area; of an unbounded region, minus the area it lacks.
    #[must_use]
    pub fn area(&self) -> Q {
        self.loops.iter().fold(Q::from_i64(0), |sum, ring| sum.plus(&ring_area(ring)))
    }

    /// An interval around the length of the boundary.
    #[must_use]
    pub fn perimeter(&self) -> Interval {
        let length = |(a, b): (&Point<Q>, &Point<Q>)| {
            let step = b.minus(a);
            step.dot(&step).enclosure().sqrt()
        };
        self.edges().map(length).fold(Interval::ZERO, |sum, edge| sum + edge)
    }

    /// The closure of the complement. Its loops need not be the same ones reversed: at pinches they are paired anew.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn complement(&self) -> Result<Self, OracleError> {
        let back = self.edges().map(|(tail, head)| (head.clone(), tail.clone())).collect();
        Self::from_edges(back, !self.unbounded)
    }

    /// The region moved by a vector.
    #[must_use]
    pub fn translated(&self, by: &Point<Q>) -> Self {
        self.mapped(|p| p.plus(by))
    }

    /// The region scaled about the origin by a factor that is not 0; a negative one turns it by half a turn.
    ///
    /// # Panics
    /// If the factor is 0.
    #[must_use]
    pub fn scaled(&self, factor: &Q) -> Self {
        assert_ne!(factor.sign(), Ordering::Equal, "a scale of 0 leaves no region");
        self.mapped(|p| p.times(factor))
    }

    /// The vertices rounded to the nearest doubles, every bend a line.
    #[must_use]
    pub fn to_plain(&self) -> PlainRegion {
        let corner = |p: &Point<Q>| Corner { x: p.x.nearest(), y: p.y.nearest(), bend: Bend::Line };
        let loops = self.loops.iter().map(|ring| ring.iter().map(corner).collect()).collect();
        PlainRegion { loops, unbounded: self.unbounded }
    }

    /// The loops with intervals around the coordinates.
    #[must_use]
    pub fn places(&self) -> Vec<Vec<Place<Q>>> {
        self.loops.iter().map(|ring| ring.iter().cloned().map(Place::from).collect()).collect()
    }

    /// Maps the vertices by a map that keeps orientations.
    fn mapped(&self, map: impl Fn(&Point<Q>) -> Point<Q>) -> Self {
        let image = |ring: &Vec<Point<Q>>| {
            let mut ring: Vec<_> = ring.iter().map(&map).collect();
            let lowest = (0..ring.len()).min_by(|&i, &j| ring[i].cmp(&ring[j])).unwrap_or(0);
            ring.rotate_left(lowest);
            ring
        };
        let mut loops: Vec<_> = self.loops.iter().map(image).collect();
        loops.sort();
        Self { loops, unbounded: self.unbounded }
    }
}

/// The edges of a closed ring.
pub fn ring_edges<T>(ring: &[T]) -> impl Iterator<Item = (&T, &T)> {
    ring.iter().zip(ring.iter().cycle().skip(1))
}

/// The signed area of a closed ring, positive counter-clockwise.
#[must_use]
pub fn ring_area<Q: Number>(ring: &[Point<Q>]) -> Q {
    let twice = ring_edges(ring).fold(Q::from_i64(0), |sum, (a, b)| sum.plus(&a.cross(b)));
    twice.over(&Q::from_i64(2))
}

/// The loops of a polygonal plain region as exact points.
fn exact_rings<Q: Number>(region: &PlainRegion) -> Result<Vec<Vec<Point<Q>>>, OracleError> {
    for (ring, corners) in region.loops.iter().enumerate() {
        if let Some(vertex) = corners.iter().position(|corner| corner.bend != Bend::Line) {
            return Err(OracleError::NotPolygonal { ring, vertex });
        }
    }
    region.loops.iter().enumerate().map(|(r, ring)| ring_points(r, ring)).collect()
}

/// The exact points of a loop's corners; `ring` is its index for the error.
///
/// # Errors
/// [`OracleError::BadNumber`] for a coordinate that is not finite.
pub fn ring_points<Q: Number>(ring: usize, corners: &[Corner]) -> Result<Vec<Point<Q>>, OracleError> {
    let reason = "a coordinate is not finite";
    let point = |(vertex, corner): (usize, &Corner)| {
        Point::from_f64(corner.x, corner.y).ok_or(OracleError::BadNumber { ring, vertex, reason })
    };
    corners.iter().enumerate().map(point).collect()
}
