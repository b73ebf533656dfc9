//! Closed curves as weighted segments between places. Equal places share a number and equal segments are one segment
//! whose weight counts them, opposite ones negatively: winding numbers depend on nothing else.

use std::cmp::Ordering;
use std::collections::HashMap;

use crate::boxes::Extent;
use crate::number::Number;
use crate::point::{Place, Point};
use crate::region::{ExactRegion, ring_edges};

/// A directed segment of positive length.
#[derive(Clone, Copy, Debug)]
pub struct Segment {
    /// Number of the place it leaves.
    pub tail: usize,
    /// Number of the place it enters.
    pub head: usize,
    /// The layer it belongs to.
    pub layer: usize,
    /// How often the curves run along it, less how often against it: the winding number on its left less the one on its
    /// right, where no other segment lies on it.
    pub weight: i32,
    /// Numbers of two places on it, in order, between which every piece of boundary on it lies; `None` if it has none.
    pub exposed: Option<[usize; 2]>,
}

/// Closed curves in layers: in each layer the weights of the segments that leave a place add up to those that enter it.
pub struct Curves<Q> {
    places: Vec<Place<Q>>,
    segments: Vec<Segment>,
    /// The places whose intervals begin at these doubles.
    numbers: HashMap<[u64; 2], Vec<usize>>,
    /// The segments by their places, the lower number first, and layer.
    positions: HashMap<(usize, usize, usize), usize>,
}

impl<Q: Number> Default for Curves<Q> {
    fn default() -> Self {
        Self { places: Vec::new(), segments: Vec::new(), numbers: HashMap::new(), positions: HashMap::new() }
    }
}

impl<Q: Number> Curves<Q> {
    /// The number of the place at a point.
    pub fn place(&mut self, point: Point<Q>) -> usize {
        let place = Place::from(point);
        let known = self.numbers.entry([place.x.lo(), place.y.lo()].map(f64::to_bits)).or_default();
        if let Some(&number) = known.iter().find(|&&k| self.places[k].order(&place) == Ordering::Equal) {
            return number;
        }
        known.push(self.places.len());
        self.places.push(place);
        self.places.len() - 1
    }

    /// Adds a segment; one of no length is left out.
    pub fn segment(&mut self, tail: usize, head: usize, layer: usize) {
        self.add(tail, head, layer, false);
    }

    /// Adds a segment on which no boundary asked for has a piece.
    pub fn hidden_segment(&mut self, tail: usize, head: usize, layer: usize) {
        self.add(tail, head, layer, true);
    }

    fn add(&mut self, tail: usize, head: usize, layer: usize, hidden: bool) {
        if tail == head {
            return;
        }
        let next = self.segments.len();
        let position = *self.positions.entry((tail.min(head), tail.max(head), layer)).or_insert(next);
        if position == next {
            self.segments.push(Segment { tail, head, layer, weight: 0, exposed: Some([tail, head]) });
        }
        let segment = &mut self.segments[position];
        segment.weight += if segment.tail == tail { 1 } else { -1 };
        if hidden {
            segment.exposed = None;
        }
    }

    /// Narrows where each segment may have a piece of boundary: `exposed` tells for its ends between which parameters,
    /// 0 at the tail and 1 at the head, pieces may lie, or `None`.
    pub fn expose(&mut self, exposed: impl Fn(&Place<Q>, &Place<Q>) -> Option<[f64; 2]>) {
        for position in 0..self.segments.len() {
            let Segment { tail, head, exposed: Some(_), .. } = self.segments[position] else { continue };
            let range = exposed(&self.places[tail], &self.places[head]);
            self.segments[position].exposed = range.map(|range| range.map(|t| self.place_between(tail, head, t)));
        }
    }

    /// The number of the place at a parameter on the way from one place to another.
    fn place_between(&mut self, tail: usize, head: usize, parameter: f64) -> usize {
        if parameter == 0.0 {
            return tail;
        } else if parameter == 1.0 {
            return head;
        }
        let parameter = Q::from_f64(parameter).expect("parameters are finite");
        self.place(self.places[tail].exact.toward(&self.places[head].exact, &parameter))
    }

    /// Adds a closed polyline.
    pub fn ring(&mut self, ring: impl IntoIterator<Item = Point<Q>>, layer: usize) {
        let numbers: Vec<usize> = ring.into_iter().map(|point| self.place(point)).collect();
        ring_edges(&numbers).for_each(|(&tail, &head)| self.segment(tail, head, layer));
    }

    /// The boundaries of regions, one layer each.
    #[must_use]
    pub fn of_regions<const L: usize>(regions: [&ExactRegion<Q>; L]) -> Self {
        let mut curves = Self::default();
        for (layer, region) in regions.into_iter().enumerate() {
            region.loops().iter().for_each(|ring| curves.ring(ring.iter().cloned(), layer));
        }
        curves
    }

    /// The number of segments between different places, those that cancel included.
    #[must_use]
    pub fn len(&self) -> usize {
        self.segments.len()
    }

    /// Whether there are no segments.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.segments.is_empty()
    }

    /// The place of this number.
    #[must_use]
    pub fn at(&self, number: usize) -> &Place<Q> {
        &self.places[number]
    }

    /// The segments that do not cancel.
    pub fn segments(&self) -> impl Iterator<Item = &Segment> {
        self.segments.iter().filter(|segment| segment.weight != 0)
    }

    /// The box around two places.
    #[must_use]
    pub fn extent(&self, ends: [usize; 2]) -> Extent {
        Extent::around(ends.map(|number| &self.places[number])).expect("two places have an extent")
    }
}

#[cfg(test)]
mod tests {
    use super::Curves;
    use crate::arrange::boundaries;
    use crate::error::{Budget, OracleError};
    use crate::point::{Place, Point};
    use crate::region::ExactRegion;
    use rug::Rational;

    fn ring(corners: &[(i32, i32)]) -> Vec<Point<Rational>> {
        corners.iter().map(|&(x, y)| Point { x: Rational::from(x), y: Rational::from(y) }).collect()
    }

    /// Where the curves wind more than a number of times.
    fn region(curves: &Curves<Rational>, inside: fn(&[i32; 1]) -> bool) -> Result<ExactRegion<Rational>, OracleError> {
        let [edges] = boundaries(curves, [0], [inside], Budget::NONE)?;
        ExactRegion::from_edges(edges, false)
    }

    #[test]
    fn equal_segments_add_up_and_opposite_ones_cancel() {
        let square = [(0, 0), (2, 0), (2, 2), (0, 2)];
        let mut curves = Curves::default();
        curves.ring(ring(&square), 0);
        curves.ring(ring(&square), 0);
        assert_eq!(curves.segments().count(), 4);
        assert!(curves.segments().all(|segment| segment.weight == 2));
        assert!(!region(&curves, |w| w[0] == 2).expect("closed").is_empty());
        assert!(region(&curves, |w| w[0] == 1).expect("closed").is_empty());
        curves.ring(ring(&[(2, 0), (4, 0), (4, 2), (2, 2)]), 0);
        let wall: Vec<i32> = curves.segments().filter(|s| [s.tail, s.head] == [1, 2]).map(|s| s.weight).collect();
        assert_eq!(wall, [1]);
        let back: Vec<_> = square.iter().rev().copied().collect();
        curves.ring(ring(&back), 0);
        // Now the two squares have a wall between them of weight 0.
        assert_eq!((curves.len(), curves.segments().count()), (7, 6));
        let both = ExactRegion::from_rings(vec![ring(&[(0, 0), (4, 0), (4, 2), (0, 2)])], false, |w| w[0] != 0);
        assert_eq!(region(&curves, |w| w[0] > 0), both);
    }

    #[test]
    fn layers_do_not_cancel() {
        let mut curves = Curves::default();
        curves.ring(ring(&[(0, 0), (2, 0), (0, 2)]), 0);
        curves.ring(ring(&[(0, 2), (2, 0), (0, 0)]), 1);
        assert_eq!(curves.segments().count(), 6);
    }

    #[test]
    fn exposing_all_that_bounds_changes_nothing_and_less_is_noticed() {
        let expose = |range: Option<[f64; 2]>| {
            let mut curves = Curves::default();
            // Two squares with a common corner region: boundary lies on the first half of the segment from (2, 0).
            curves.ring(ring(&[(0, 0), (2, 0), (2, 2), (0, 2)]), 0);
            curves.ring(ring(&[(1, 1), (3, 1), (3, 3), (1, 3)]), 0);
            let start = Place::from(ring(&[(2, 0)])[0].clone());
            curves.expose(|tail, _| if tail.order(&start).is_eq() { range } else { Some([0.0, 1.0]) });
            region(&curves, |w| w[0] > 0)
        };
        let whole = expose(Some([0.0, 1.0])).expect("closed");
        assert_eq!(whole.area(), 7);
        assert_eq!(expose(Some([0.0, 0.5])).as_ref(), Ok(&whole));
        assert_eq!(expose(Some([0.0, 0.75])).as_ref(), Ok(&whole));
        for too_little in [None, Some([0.25, 1.0]), Some([0.0, 0.25])] {
            assert!(matches!(expose(too_little), Err(OracleError::Inconsistent(_))), "{too_little:?}");
        }
    }
}
