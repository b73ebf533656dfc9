//! Where a point lies relative to an exact region, and which boundary edge is nearest to it.

use std::cmp::Ordering;

use crate::boxes::{Boxes, Extent};
use crate::error::OracleError;
use crate::interval::Interval;
use crate::number::Number;
use crate::point::{Place, Point, area_exact, dot_sign, orient};
use crate::region::{ExactRegion, ring_edges};

/// The place of a point relative to a closed region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Location {
    /// In the interior.
    Inside,
    /// On the boundary.
    Boundary,
    /// Not in the region.
    Outside,
}

/// A region prepared for many questions.
pub struct Locator<Q> {
    places: Vec<Place<Q>>,
    edges: Vec<(usize, usize)>,
    extents: Vec<Extent>,
    boxes: Boxes,
    /// The winding number far away.
    base: i32,
}

impl<Q: Number> Locator<Q> {
    /// Prepares a region.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn new(region: &ExactRegion<Q>) -> Result<Self, OracleError> {
        Self::of_rings(region.places(), region.unbounded())
    }

    /// Prepares the region inside some rings.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn of_rings(rings: Vec<Vec<Place<Q>>>, unbounded: bool) -> Result<Self, OracleError> {
        let mut places = Vec::new();
        let mut edges = Vec::new();
        for ring in rings {
            let numbers: Vec<usize> = (places.len()..places.len() + ring.len()).collect();
            edges.extend(ring_edges(&numbers).map(|(&a, &b)| (a, b)));
            places.extend(ring);
        }
        Self::of_edges(places, edges, i32::from(unbounded))
    }

    /// Prepares closed curves, given by places, edges between them and the winding number far away.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn of_edges(places: Vec<Place<Q>>, edges: Vec<(usize, usize)>, base: i32) -> Result<Self, OracleError> {
        let extent = |&(a, b): &(usize, usize)| Extent::around([&places[a], &places[b]]);
        let extents: Vec<Extent> = edges.iter().filter_map(extent).collect();
        let boxes = Boxes::new(&extents)?;
        Ok(Self { places, edges, extents, boxes, base })
    }

    /// The winding number around a point, 1 inside and 0 outside; `None` on the boundary.
    #[must_use]
    pub fn winding(&self, point: &Place<Q>) -> Option<i32> {
        let mut winding = Some(self.base);
        let ray = Extent { ends: [point.x.lo(), point.y.lo(), f64::INFINITY, point.y.hi()] };
        self.boxes.visit(&ray, |e| {
            let (from, to) = self.edge(e);
            let below = |p: &Place<Q>| p.compare_y(point).is_le();
            let climbs = below(from);
            let crosses = climbs != below(to);
            let side = if self.extents[e].ends[0] > point.x.hi() {
                if climbs { Ordering::Greater } else { Ordering::Less }
            } else {
                orient(from, to, point)
            };
            if side == Ordering::Equal && dot_sign(from, point, point, to).is_ge() {
                winding = None;
            } else if crosses && side.is_gt() == climbs {
                winding = winding.map(|w| w + if climbs { 1 } else { -1 });
            }
        });
        winding
    }

    /// Where the point lies.
    #[must_use]
    pub fn locate(&self, point: &Place<Q>) -> Location {
        match self.winding(point) {
            None => Location::Boundary,
            Some(0) => Location::Outside,
            Some(_) => Location::Inside,
        }
    }

    /// The end places of an edge.
    #[must_use]
    pub fn edge(&self, edge: usize) -> (&Place<Q>, &Place<Q>) {
        let (a, b) = self.edges[edge];
        (&self.places[a], &self.places[b])
    }

    /// An interval around the distance from the point to the boundary and every edge that may be nearest; infinite and
    /// none without a boundary.
    #[must_use]
    pub fn nearest(&self, point: &Place<Q>) -> (Interval, Vec<usize>) {
        let (x, y) = (point.x.mid(), point.y.mid());
        let offset = (point.x - Interval::point(x)).square() + (point.y - Interval::point(y)).square();
        let slack = offset.sqrt().hi();
        let mut best = Interval::point(f64::INFINITY);
        let mut found: Vec<(Interval, usize)> = Vec::new();
        self.boxes.visit_nearest(x, y, |e, distance| {
            if distance - slack > best.hi() {
                return false;
            }
            let (a, b) = self.edge(e);
            let distance = distance_to_segment(point, a, b);
            best = best.min(distance);
            found.push((distance, e));
            true
        });
        found.retain(|(distance, _)| distance.lo() <= best.hi());
        (best, found.into_iter().map(|(_, e)| e).collect())
    }
}

/// An interval around the distance from p to the segment ab, tight relative to the distance itself: what may cancel is
/// computed exactly.
#[must_use]
pub fn distance_to_segment<Q: Number>(p: &Place<Q>, a: &Place<Q>, b: &Place<Q>) -> Interval {
    if dot_sign(a, b, a, p).is_le() {
        return distance_to_point(&p.exact, &a.exact);
    }
    if dot_sign(b, a, b, p).is_le() {
        return distance_to_point(&p.exact, &b.exact);
    }
    let cross = area_exact(&a.exact, &b.exact, &p.exact).enclosure();
    cross.max(-cross).max(Interval::ZERO) / distance_to_point(&a.exact, &b.exact)
}

/// A tight interval around the distance of two points.
#[must_use]
pub fn distance_to_point<Q: Number>(p: &Point<Q>, q: &Point<Q>) -> Interval {
    let step = p.minus(q);
    (step.x.enclosure().square() + step.y.enclosure().square()).sqrt()
}
