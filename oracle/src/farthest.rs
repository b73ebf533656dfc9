//! How far convex pieces reach from a region: the supremum over the pieces of the distance to the region's boundary,
//! bracketed by branch and bound.
//!
//! The distance to one boundary edge is a convex function, so over a convex piece it is largest at a corner, and the
//! distance to the boundary is at most that to any single edge. Hence
//!
//! max over corners v of d(v, boundary)  <=  sup over the piece  <=  min over edges e of max over corners v of d(v, e).
//!
//! Both ends agree where one edge is nearest to all corners, which is so at once for a sliver along an edge however thin
//! and long it is: no cell ever has to be as small as the error. A piece with several nearest edges is cut where two of
//! them are about equally far. Any cut keeps the pieces a cover, so rounding the place of the cut costs nothing.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::interval::Interval;
use crate::locate::{Locator, distance_to_segment};
use crate::number::Number;
use crate::point::{Place, Point};
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

/// A piece and an upper bound for its distance.
struct Candidate<Q> {
    bound: f64,
    piece: Convex<Q>,
    /// The corners' distances to the edge that gives the bound, and to the edge nearest to the worst corner.
    rival: Option<(Vec<f64>, Vec<f64>)>,
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
            worst.cut().into_iter().for_each(|piece| self.add(piece));
        }
        self.open.peek().map_or(0.0, |worst| worst.bound)
    }

    fn add(&mut self, piece: Convex<Q>) {
        let nearest: Vec<(Interval, Vec<usize>)> = piece.iter().map(|corner| self.region.nearest(corner)).collect();
        for (corner, (distance, _)) in piece.iter().zip(&nearest) {
            if distance.lo() > self.reached.0 {
                self.reached = (distance.lo(), Some(corner.exact.clone()));
            }
        }
        let mut edges: Vec<usize> = nearest.iter().flat_map(|(_, edges)| edges.iter().copied()).collect();
        edges.sort_unstable();
        edges.dedup();
        let Some((bound, best)) =
            edges.iter().map(|&e| (self.reach(&piece, e), e)).min_by(|(a, _), (b, _)| a.total_cmp(b))
        else {
            return self.open.push(Candidate { bound: f64::INFINITY, piece, rival: None });
        };
        let excess = |k: usize| distance_from(self.region, &piece[k], best).hi() - nearest[k].0.hi();
        let worst = (0..piece.len()).max_by(|&i, &j| excess(i).total_cmp(&excess(j)));
        let rival = worst.map(|k| nearest[k].1[0]).filter(|&edge| edge != best).map(|edge| {
            let all = |e| piece.iter().map(|corner| distance_from(self.region, corner, e).mid()).collect();
            (all(best), all(edge))
        });
        self.open.push(Candidate { bound, piece, rival });
    }

    /// The greatest distance of a corner to one edge, rounded up.
    fn reach(&self, piece: &Convex<Q>, edge: usize) -> f64 {
        piece.iter().map(|corner| distance_from(self.region, corner, edge).hi()).fold(0.0, f64::max)
    }
}

fn distance_from<Q: Number>(region: &Locator<Q>, corner: &Place<Q>, edge: usize) -> Interval {
    let (a, b) = region.edge(edge);
    distance_to_segment(corner, a, b)
}

impl<Q: Number> Candidate<Q> {
    /// Two convex pieces that make up this one: cut between the two rival edges if they are equally far on exactly two
    /// sides, else through the middle of the longest side.
    fn cut(self) -> [Convex<Q>; 2] {
        let n = self.piece.len();
        let (first, second) = self.rival_cuts().unwrap_or_else(|| self.middle_cuts());
        let [start, end] = [first, second].map(|(side, t)| {
            let t = Q::from_i64((t * 1024.0) as i64).over(&Q::from_i64(1024));
            Place::from(self.piece[side].exact.toward(&self.piece[(side + 1) % n].exact, &t))
        });
        let part = |from: &Place<Q>, after: usize, to: &Place<Q>, until: usize| {
            let between = (1..=(until + n - after) % n).map(|k| self.piece[(after + k) % n].clone());
            let mut part: Convex<Q> = std::iter::once(from.clone()).chain(between).chain([to.clone()]).collect();
            part.dedup_by(|a, b| a.exact == b.exact);
            part
        };
        [part(&start, first.0, &end, second.0), part(&end, second.0, &start, first.0)]
    }

    /// The two sides on which the rival edges are equally far, each with the parameter of that point.
    fn rival_cuts(&self) -> Option<((usize, f64), (usize, f64))> {
        let (best, rival) = self.rival.as_ref()?;
        let lead: Vec<f64> = best.iter().zip(rival).map(|(b, r)| b - r).collect();
        let after = |i: usize| lead[(i + 1) % lead.len()];
        let mut changes = (0..lead.len()).filter(|&i| (lead[i] > 0.0) != (after(i) > 0.0));
        let sides = (changes.next()?, changes.next()?);
        // Away from the corners, so that both parts get smaller.
        let at = |i: usize| (i, (lead[i] / (lead[i] - after(i))).clamp(1.0 / 16.0, 15.0 / 16.0));
        changes.next().is_none().then(|| (at(sides.0), at(sides.1)))
    }

    /// The middle of the longest side and the middle or corner across.
    fn middle_cuts(&self) -> ((usize, f64), (usize, f64)) {
        let n = self.piece.len();
        let length = |i: usize| {
            let (dx, dy) = self.piece[i].step(&self.piece[(i + 1) % n]);
            dx.mid().hypot(dy.mid())
        };
        let longest = (0..n).max_by(|&i, &j| length(i).total_cmp(&length(j))).unwrap_or(0);
        let across = if n == 3 { ((longest + 2) % n, 0.0) } else { ((longest + n / 2) % n, 0.5) };
        ((longest, 0.5), across)
    }
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
