//! How far one region reaches out of another: the supremum over the trapezoids of their difference of the distance to the
//! other region's boundary, bracketed by branch and bound (memo I6).
//!
//! The distance to a region is at most the distance to any one piece of its boundary, and that is bounded over a whole
//! cell in closed form ([`super::cell`]). For a sliver along a piece, however thin and long, the bound is as good as exact,
//! so no cell ever has to be as small as the error. Cells that no one piece serves are cut where a piece ends or in the
//! middle of the longer side.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::cell::{Cell, Outline};
use super::nearest::{FINE, Nearest};
use super::real::Real;
use super::slabs::Trapezoid;
use super::vector::Vector;

/// A bracket is refined until its upper end is at most this factor above the lower one.
const TIGHT: f64 = 1.0 + 1.0 / 32.0;

/// Cuts before a loose bracket is returned as it is.
const CUTS: usize = 40_000;

/// No cell is cut nearer to the end of a piece than this.
const FINEST: f64 = 1.0 / (1u64 << 60) as f64;

/// Pieces near a cell that are tried as its nearest.
const TRIED: usize = 4;

/// A search over parts of the plane outside a region or on its boundary.
pub struct Reach<'a> {
    boundary: &'a Nearest<'a>,
    open: BinaryHeap<Candidate>,
    /// The greatest distance found at a point of a cell, rounded down, and that point.
    reached: (f64, Option<Vector>),
}

/// A cell and an upper bound for its distance.
struct Candidate {
    bound: f64,
    cell: Cell,
    outline: Outline,
    /// The pieces near it.
    near: Vec<usize>,
}

impl<'a> Reach<'a> {
    /// Measures all trapezoids.
    #[must_use]
    pub fn new(boundary: &'a Nearest<'a>, parts: &[Trapezoid]) -> Self {
        let mut search = Self { boundary, open: BinaryHeap::with_capacity(parts.len()), reached: (0.0, None) };
        parts.iter().for_each(|part| search.add(Cell::new(part)));
        search
    }

    /// The greatest distance known to occur, rounded down, and where.
    #[must_use]
    pub fn reached(&self) -> (f64, Option<&Vector>) {
        (self.reached.0, self.reached.1.as_ref())
    }

    /// An upper bound of the supremum, refined until it is close to `known` or to what this search reaches, or below
    /// `floor`.
    pub fn refine(&mut self, known: f64, floor: f64) -> f64 {
        for _ in 0..CUTS {
            let Some(worst) = self.open.pop() else { return 0.0 };
            let least = known.max(self.reached.0);
            if worst.bound <= (least * TIGHT).max(least + floor) || worst.bound.is_infinite() {
                self.open.push(worst);
                break;
            }
            let (across_x, at) = self.cut(&worst.outline, &worst.near);
            worst.cell.cut(across_x, &at).into_iter().for_each(|part| self.add(part));
        }
        self.open.peek().map_or(0.0, |worst| worst.bound)
    }

    fn add(&mut self, cell: Cell) {
        let Some(outline) = cell.outline() else { return };
        let mut bound = f64::INFINITY;
        let mut tried: Vec<usize> = Vec::new();
        let mut measured: Vec<(&Vector, Real)> = Vec::new();
        let inner = cell.inner();
        for point in outline.corners.iter().chain(&inner) {
            let Some((distance, near)) = self.boundary.distance(point) else { continue };
            if distance.lo() > self.reached.0 {
                self.reached = (distance.lo(), Some(point.clone()));
            }
            measured.push((point, distance));
            tried.extend(near.into_iter().take(TRIED));
        }
        tried.sort_unstable();
        tried.dedup();
        for &edge in &tried {
            bound = bound.min(outline.reach(self.boundary.curve(edge).at(FINE)));
        }
        let is_open = |bound: f64| bound > self.reached.0 * TIGHT;
        if is_open(bound) {
            let around = measured.iter().map(|(point, distance)| (distance + &outline.farthest(point)).hi());
            bound = around.fold(bound, f64::min);
        }
        if is_open(bound) {
            bound = bound.min(self.bound_between(&outline, &tried));
        }
        let own = |wall| tried.iter().any(|&edge| std::sync::Arc::ptr_eq(self.boundary.curve(edge), wall));
        if cell.walls().iter().all(own) {
            bound = bound.min(outline.half_gap(&cell));
        }
        self.open.push(Candidate { bound, cell, outline, near: tried });
    }

    /// The best bound of two pieces that the cell may lie between.
    fn bound_between(&self, outline: &Outline, near: &[usize]) -> f64 {
        let pieces: Vec<_> = near.iter().map(|&edge| self.boundary.curve(edge).at(FINE)).collect();
        let pairs = (0..pieces.len()).flat_map(|i| (0..i).map(move |j| [i, j]));
        pairs.map(|pair| outline.reach_between(pair.map(|i| pieces[i]))).fold(f64::INFINITY, f64::min)
    }

    /// Where to cut a cell: just inside the end of a piece near it, so that the piece serves one part alone, else in the
    /// middle.
    fn cut(&self, outline: &Outline, near: &[usize]) -> (bool, Real) {
        let [width, height] = outline.extent();
        let across_x = width.mid() >= height.mid();
        let coordinate = |v: &Vector| if across_x { v.x.clone() } else { v.y.clone() };
        let middle = coordinate(&outline.middle());
        let length = if across_x { width } else { height };
        // Points no farther than was reached have their foot on the piece if they are that far from its end.
        let margin = Real::from(1.25 * self.reached.0.max(FINEST));
        // Halving would take as many cuts to get to the end of a long thin cell as it takes halves.
        let inner = |at: &Real| (at - &middle).abs().is_below(&((&length - &margin) * 0.5));
        for &edge in near {
            let piece = self.boundary.curve(edge).at(FINE);
            for (end, other) in [(&piece.from, &piece.to), (&piece.to, &piece.from)] {
                let forward = coordinate(end).is_below(&coordinate(other));
                let at = if forward { coordinate(end) + &margin } else { coordinate(end) - &margin };
                if inner(&at) {
                    return (across_x, exact(&at));
                }
            }
        }
        (across_x, exact(&middle))
    }
}

/// A number of a known value near one that is only known to lie in an interval.
fn exact(x: &Real) -> Real {
    let [lo, _] = x.floats(FINE);
    Real::from(lo)
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Candidate {}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}
