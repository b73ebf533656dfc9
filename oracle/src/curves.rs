//! Closed curves as weighted segments between places. Equal places share a number and equal segments are one segment
//! whose weight counts them, opposite ones negatively: winding numbers depend on nothing else.

use std::cmp::Ordering;
use std::collections::HashMap;

use crate::boxes::Extent;
use crate::number::Number;
use crate::point::{Place, Point};
use crate::region::ring_edges;

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
    /// Whether no boundary asked for has a piece on it.
    pub hidden: bool,
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
            self.segments.push(Segment { tail, head, layer, weight: 0, hidden: false });
        }
        let segment = &mut self.segments[position];
        segment.weight += if segment.tail == tail { 1 } else { -1 };
        segment.hidden |= hidden;
    }

    /// Adds a closed polyline.
    pub fn ring(&mut self, ring: impl IntoIterator<Item = Point<Q>>, layer: usize) {
        let numbers: Vec<usize> = ring.into_iter().map(|point| self.place(point)).collect();
        ring_edges(&numbers).for_each(|(&tail, &head)| self.segment(tail, head, layer));
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

    /// The box around a segment.
    #[must_use]
    pub fn extent(&self, segment: &Segment) -> Extent {
        let ends = [segment.tail, segment.head].map(|number| &self.places[number]);
        Extent::around(ends).expect("two places have an extent")
    }
}
