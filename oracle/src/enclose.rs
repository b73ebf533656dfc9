//! Polygons certainly inside and certainly outside regions with circle segments, and what they certify about sums.
//!
//! Each circle segment is replaced by a polyline on one side of it ([`crate::arc`]), so the winding numbers of the inner
//! loops are nowhere above, and those of the outer loops nowhere below, the ones of the region: between the polylines
//! and the circle segments the difference of the winding numbers has one sign. Where polylines cross because the region
//! is narrower than its circle segments are flattened, that still holds, and the sign of the winding numbers decides.

use crate::arc::{Arc, bulges};
use crate::arrange::boundaries;
use crate::convolve;
use crate::curves::Curves;
use crate::error::{Budget, OracleError};
use crate::interval::Interval;
use crate::number::Number;
use crate::plain::PlainRegion;
use crate::point::Point;
use crate::region::{ExactRegion, ring_points};

/// Two polygonal regions, one inside and one around a region that is not known exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enclosure<Q> {
    /// A subset, empty if the region is too narrow for the flattening.
    pub inner: ExactRegion<Q>,
    /// A superset.
    pub outer: ExactRegion<Q>,
}

/// Encloses the region of the points around which the loops wind a number of times that is not 0, where an unbounded
/// region starts from 1. Circle segments are taken literally (a radius as the minor arc) and replaced by about
/// `pieces` (at least two) chords or tangents; with polygons the enclosure is exact.
///
/// # Errors
/// [`OracleError::BadNumber`] for numbers that are not finite and radii that no arc over the chord has.
pub fn enclose<Q: Number>(region: &PlainRegion, pieces: usize) -> Result<Enclosure<Q>, OracleError> {
    let mut curves = Curves::default();
    for (index, corners) in region.loops.iter().enumerate() {
        let points: Vec<Point<Q>> = ring_points(index, corners)?;
        let (mut inner, mut outer) = (Vec::new(), Vec::new());
        for (vertex, corner) in corners.iter().enumerate() {
            let (from, to) = (&points[vertex], &points[(vertex + 1) % points.len()]);
            let bad = |reason| OracleError::BadNumber { ring: index, vertex, reason };
            let [low, high] = bulges(corner.bend, from, to).map_err(bad)?;
            inner.extend(flattened(from, to, low, false, pieces));
            outer.extend(flattened(from, to, high, true, pieces));
        }
        curves.ring(inner, 0);
        curves.ring(outer, 1);
    }
    let base = [i32::from(region.unbounded); 2];
    // With w the region's winding number, w[0] <= w <= w[1].
    let inside = [|w: &[i32; 2]| w[0] > 0 || w[1] < 0, |w: &[i32; 2]| w[1] > 0 || w[0] < 0];
    let [inner, outer] = boundaries(&curves, base, inside, Budget::NONE)?;
    let region = |edges| ExactRegion::from_edges(edges, region.unbounded);
    Ok(Enclosure { inner: region(inner)?, outer: region(outer)? })
}

/// The polyline in place of a circle segment, without its end: to its right if `outwards`, else to its left.
fn flattened<Q: Number>(from: &Point<Q>, to: &Point<Q>, bulge: Q, outwards: bool, pieces: usize) -> Vec<Point<Q>> {
    let convex = bulge.sign().is_gt();
    match Arc::new(from, to, bulge) {
        None => vec![from.clone()],
        Some(arc) if convex == outwards => arc.tangents(pieces),
        Some(arc) => arc.chords(pieces),
    }
}

impl<Q: Number> Enclosure<Q> {
    /// An enclosure of the Minkowski sum of two enclosed regions: the exact sums of the inner and of the outer ones.
    ///
    /// # Errors
    /// As [`convolve::sum`].
    pub fn sum(&self, other: &Self, budget: Budget) -> Result<Self, OracleError> {
        let inner = convolve::sum(&self.inner, &other.inner, budget)?;
        let outer = convolve::sum(&self.outer, &other.outer, budget)?;
        Ok(Self { inner, outer })
    }

    /// Bounds of the area; of an unbounded region, minus the area it lacks.
    #[must_use]
    pub fn area(&self) -> Interval {
        Interval::new(self.inner.area().enclosure().lo(), self.outer.area().enclosure().hi())
    }
}
