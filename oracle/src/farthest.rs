//! How far convex pieces reach from a region: the supremum over the pieces of the distance to the region's boundary,
//! bracketed by branch and bound.
//!
//! The distance to one boundary edge is a convex function, so over a convex piece it is largest at a corner, and the
//! distance to the boundary is at most that to any single edge. Hence
//!
//! max over corners v of d(v, boundary)  <=  sup over the piece  <=  min over edges e of max over corners v of d(v, e).
//!
//! Both ends agree where one edge is nearest to all corners, which is so at once for a sliver along an edge however thin
//! and long it is: no cell ever has to be as small as the error. Where two edges are nearest in turn, a mean of both
//! distances gives a better bound ([`crate::rivals`]) and a point between the corners that may attain it. Pieces that are
//! still open are cut upright or level near that point. Such cuts keep the numbers short: the corners lie on few lines, at
//! abscissas or ordinates of our choice.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::clip::halves;
use crate::interval::Interval;
use crate::locate::{Locator, distance_to_segment};
use crate::number::Number;
use crate::point::{Place, Point};
use crate::rivals;
use crate::trapezoid::Convex;

/// A bracket is refined until its upper end is at most this factor above the lower one.
const TIGHT: f64 = 1.0 + 1.0 / 32.0;

/// Cuts before a loose bracket is returned as it is.
const CUTS: usize = 20_000;

/// A search over pieces for the greatest distance to a region's boundary; where they lie outside of it or on its boundary,
/// that is the distance to the region.
pub struct Farthest<'a, Q> {
    region: &'a Locator<Q>,
    open: BinaryHeap<Candidate<Q>>,
    /// The greatest distance found at a corner, rounded down, and that corner.
    reached: (f64, Option<Point<Q>>),
}

/// Edges that are tried in pairs, those that alone serve a piece best.
const TRIED: usize = 8;

/// A piece and an upper bound for its distance.
struct Candidate<Q> {
    bound: f64,
    piece: Convex<Q>,
    /// Where its farthest point may be, if not at a corner.
    between: Option<Point<Q>>,
}

impl<'a, Q: Number> Farthest<'a, Q> {
    /// Measures the corners of all pieces.
    pub fn new(region: &'a Locator<Q>, pieces: Vec<Convex<Q>>) -> Self {
        let mut search = Self { region, open: BinaryHeap::with_capacity(pieces.len()), reached: (0.0, None) };
        pieces.into_iter().for_each(|piece| search.add(piece));
        search
    }

    /// The greatest distance known to occur, rounded down, and where.
    #[must_use]
    pub fn reached(&self) -> (f64, Option<&Point<Q>>) {
        (self.reached.0, self.reached.1.as_ref())
    }

    /// An upper bound of the supremum, refined until it is close to `known` or to what this search reaches, or below
    /// `floor`.
    pub fn refine(&mut self, known: f64, floor: f64) -> f64 {
        for _ in 0..CUTS {
            let Some(worst) = self.open.pop() else { return 0.0 };
            if worst.bound <= floor.max(known.max(self.reached.0) * TIGHT) || worst.bound.is_infinite() {
                self.open.push(worst);
                break;
            }
            halves(&worst.piece, worst.between.as_ref()).into_iter().for_each(|piece| self.add(piece));
        }
        self.open.peek().map_or(0.0, |worst| worst.bound)
    }

    /// Measures the corners of a piece, and points between them as long as they show an edge that was not known to be near.
    fn add(&mut self, piece: Convex<Q>) {
        let mut near: Vec<(usize, Vec<Interval>)> = Vec::new();
        piece.iter().for_each(|corner| self.measure(corner, &piece, &mut near));
        loop {
            let known = near.len();
            let (bound, between) = self.bound(&piece, &mut near);
            if let Some(point) = &between {
                self.measure(&Place::from(point.clone()), &piece, &mut near);
            }
            if near.len() == known {
                return self.open.push(Candidate { bound, piece, between });
            }
        }
    }

    /// Measures a point, and adds the edges nearest to it with their distances from the corners of a piece.
    fn measure(&mut self, point: &Place<Q>, piece: &Convex<Q>, near: &mut Vec<(usize, Vec<Interval>)>) {
        let (distance, edges) = self.region.nearest(point);
        if distance.lo() > self.reached.0 {
            self.reached = (distance.lo(), Some(point.exact.clone()));
        }
        for edge in edges {
            if near.iter().all(|(known, _)| *known != edge) {
                let (a, b) = self.region.edge(edge);
                near.push((edge, piece.iter().map(|corner| distance_to_segment(corner, a, b)).collect()));
            }
        }
    }

    /// The best bound that the edges near a piece give alone and in pairs, and where it may be attained between corners.
    fn bound(&self, piece: &Convex<Q>, near: &mut [(usize, Vec<Interval>)]) -> (f64, Option<Point<Q>>) {
        near.sort_by(|a, b| rivals::to_one(&a.1).most.total_cmp(&rivals::to_one(&b.1).most));
        let Some((_, first)) = near.first() else { return (f64::INFINITY, None) };
        let mut best = rivals::to_one(first);
        if best.most <= self.reached.0 * TIGHT {
            return (best.most, None);
        }
        let tried = &near[..near.len().min(TRIED)];
        for (i, (_, first)) in tried.iter().enumerate() {
            for (_, second) in &tried[..i] {
                let bound = rivals::to_two(first, second);
                if bound.most < best.most {
                    best = bound;
                }
            }
        }
        let point = best.between.and_then(|(i, j, t)| Some(piece[i].exact.toward(&piece[j].exact, &fraction(t)?)));
        (best.most, point)
    }
}

/// A short number near a fraction between 0 and 1.
fn fraction<Q: Number>(t: f64) -> Option<Q> {
    Q::from_f64((t * 1048576.0).round() / 1048576.0)
}

impl<Q> PartialEq for Candidate<Q> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<Q> Eq for Candidate<Q> {}

impl<Q> PartialOrd for Candidate<Q> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<Q> Ord for Candidate<Q> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}
