//! Whether the translate t - B overlaps A (memo I4): membership of t in the interior of the sum, without the sum.
//!
//! If boundary pieces cross properly, the left sides of both overlap there: t is blocked. Likewise if a boundary point of
//! the one lies in the interior of the other.
//!
//! Suppose that the boundaries have no point in common. A loop, being connected, then lies in one face of each loop of the
//! other region. Two unbounded regions overlap far away. So let K and M be components of A and of t - B, one of
//! them bounded. If the outer loop of one has a point in the other, that point is in the interior, and t is blocked.
//! Otherwise K and M are disjoint:
//! - If the outer loop of K lies in a hole of M, or in a pocket that the outer loop of M surrounds by touching itself, so
//!   does all of K: in the sphere, a face of a connected curve has no holes. The same with K and M exchanged.
//! - Else both are bounded and each outer loop is in the face of the other that reaches far away. The first one
//!   together with all that it surrounds is connected and does not meet the second, so it lies in that face too, and
//!   M does not reach there.
//!
//! So one point of every outer loop settles whether t is blocked or free.

use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::crossing::crosses;
use super::curve::Curve;
use super::inside::Winding;
use super::piece::Piece;
use super::precision::Precision;
use super::real::Real;
use super::shape::{Shape, Side};
use super::spot::Spot;
use super::vector::Vector;

/// So many pairs that doubles do not tell apart are looked into at once.
const FEW: usize = 4;

/// How A and t - B lie to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Their interiors overlap: t is in the interior of the sum.
    Blocked,
    /// They are disjoint: t is not in the sum.
    Free,
    /// They touch, or nearly so.
    Undecided,
}

/// Two regions prepared for many questions.
#[derive(Debug)]
pub struct Membership {
    pub(super) first: Operand,
    pub(super) second: Operand,
    /// The pair that crossed last: neighbouring questions often have the same answer for the same reason.
    crossed: Witness,
    /// The piece that last had a point in both interiors, and whether it is one of the second region (1) or not (0).
    overlapped: Witness,
    /// The pair that was nearest last.
    pub(super) nearest: Witness,
}

/// A region of the two.
#[derive(Debug)]
pub(super) struct Operand {
    pub(super) winding: Winding,
    /// A piece of every outer loop.
    outer: Vec<Arc<Curve>>,
    unbounded: bool,
}

/// A pair of indices that threads may read and replace at any time.
#[derive(Debug)]
pub(super) struct Witness(AtomicU64);

impl Membership {
    /// Prepares two regions: valid ones, their loops not crossing and oriented with the interior on the left.
    #[must_use]
    pub fn new(a: &Shape, b: &Shape) -> Self {
        let [first, second] = [a, b].map(Operand::new);
        Self { first, second, crossed: Witness::new(), overlapped: Witness::new(), nearest: Witness::new() }
    }

    /// How A and t - B lie to each other, at whatever precision that takes.
    #[must_use]
    pub fn state(&self, t: &Spot) -> State {
        self.state_within(t, Precision::FINEST)
    }

    /// The same without going beyond a precision.
    #[must_use]
    pub fn state_within(&self, t: &Spot, limit: Precision) -> State {
        if self.first.unbounded && self.second.unbounded {
            return State::Blocked;
        }
        let near = t.rough();
        if self.overlapped.get().is_some_and(|(i, side)| self.overlaps(i, side == 1, &near, Precision::DOUBLE)) {
            return State::Blocked;
        }
        let Some(mut open) = self.meeting_pairs(&near) else {
            return State::Blocked;
        };
        for precision in limit.up_to() {
            if open.is_empty() {
                return self.state_of_apart(t, limit);
            }
            let rough = precision == Precision::DOUBLE;
            let place = if rough { near.clone() } else { t.at(precision) };
            if !rough && !self.narrow(&mut open, &place, precision) {
                return State::Blocked;
            }
            // Of many pairs that doubles do not tell apart most are told apart by the next precision.
            let some = if rough && precision < limit { open.len().min(FEW) } else { open.len() };
            if self.reach_inside(&open[..some], &place, precision) {
                return State::Blocked;
            }
        }
        if open.is_empty() { self.state_of_apart(t, limit) } else { State::Undecided }
    }

    /// The pairs of pieces that doubles do not tell apart; `None` if some pair certainly crosses.
    fn meeting_pairs(&self, t: &Vector) -> Option<Vec<(usize, usize)>> {
        let precision = Precision::DOUBLE;
        let crossing = |(i, j)| self.cross((i, j), t, precision);
        if self.crossed.get().and_then(crossing) == Some(true) {
            return None;
        }
        let mut open = Some(Vec::new());
        self.first.winding.tree().visit_pairs(self.second.winding.tree(), t, 0.0, |i, j| {
            match (crossing((i, j)), &mut open) {
                (Some(true), _) => {
                    self.crossed.set((i, j));
                    open = None;
                    return -1.0;
                }
                (None, Some(open)) => open.push((i, j)),
                _ => (),
            }
            0.0
        });
        open
    }

    /// Drops the pairs that this precision tells apart; false if some pair certainly crosses.
    fn narrow(&self, open: &mut Vec<(usize, usize)>, t: &Vector, precision: Precision) -> bool {
        let mut crossed = false;
        open.retain(|&pair| {
            let crossing = if crossed { None } else { self.cross(pair, t, precision) };
            crossed |= crossing == Some(true);
            crossing != Some(false)
        });
        !crossed
    }

    fn cross(&self, pair: (usize, usize), t: &Vector, precision: Precision) -> Option<bool> {
        let (a, b) = self.pieces(pair, t, precision);
        crosses(a, &b)
    }

    /// A piece of A and a piece of t - B.
    pub(super) fn pieces(&self, (i, j): (usize, usize), t: &Vector, precision: Precision) -> (&Piece, Piece) {
        (self.first.winding.piece(i).at(precision), self.second.winding.piece(j).at(precision).mirrored(t))
    }

    /// Whether a piece of one of these pairs reaches into the other region. So pieces that overlap or end on each other exactly
    /// do not keep a blocked t undecided.
    fn reach_inside(&self, pairs: &[(usize, usize)], t: &Vector, precision: Precision) -> bool {
        let pieces: BTreeSet<(usize, bool)> = pairs.iter().flat_map(|&(i, j)| [(i, false), (j, true)]).collect();
        let found = pieces.into_iter().find(|&(piece, of_second)| self.overlaps(piece, of_second, t, precision));
        if let Some((piece, of_second)) = found {
            self.overlapped.set((piece, usize::from(of_second)));
        }
        found.is_some()
    }

    /// Whether a piece of one region certainly has its ends or middle in the interior of the other one, or a point beside it in
    /// both.
    fn overlaps(&self, piece: usize, of_second: bool, t: &Vector, precision: Precision) -> bool {
        let (own, other) = if of_second { (&self.second, &self.first) } else { (&self.first, &self.second) };
        let is_inside = |operand: &Operand, p: &Vector| operand.winding.inside_at(p, precision) == Some(true);
        let piece = own.winding.piece(piece).at(precision);
        let (middle, beside) = beside(piece);
        [&middle, &piece.from, &piece.to].iter().any(|&p| is_inside(other, &(t - p)))
            || is_inside(own, &beside) && is_inside(other, &(t - &beside))
    }

    /// The state if the boundaries have no point in common.
    fn state_of_apart(&self, t: &Spot, limit: Precision) -> State {
        let pairs = [(&self.first, &self.second), (&self.second, &self.first)];
        let mut state = State::Free;
        for (inner, outer) in pairs {
            for curve in &inner.outer {
                match outer.winding.inside(|p| &t.at(p) - &curve.at(p).from, limit) {
                    Some(true) => return State::Blocked,
                    Some(false) => (),
                    None => state = State::Undecided,
                }
            }
        }
        state
    }
}

impl Operand {
    fn new(shape: &Shape) -> Self {
        let is_outer = |ring: &&Vec<Side>| !ring.is_empty() && !double_area(ring).is_negative();
        let outer = shape.loops.iter().filter(is_outer).map(|ring| ring[0].curve.clone()).collect();
        Self { winding: Winding::new(shape), outer, unbounded: shape.unbounded }
    }
}

impl Witness {
    const NONE: u64 = u64::MAX;

    fn new() -> Self {
        Self(AtomicU64::new(Self::NONE))
    }

    /// The pair kept last.
    pub(super) fn get(&self) -> Option<(usize, usize)> {
        let pair = self.0.load(Ordering::Relaxed);
        (pair != Self::NONE).then_some(((pair >> 32) as usize, (pair & u64::from(u32::MAX)) as usize))
    }

    /// Keeps a pair of indices that fit 32 bits each.
    pub(super) fn set(&self, (i, j): (usize, usize)) {
        self.0.store((i as u64) << 32 | j as u64, Ordering::Relaxed);
    }
}

/// Twice the signed area of a loop, known well enough to tell outer loops from holes: between its chord and its box an arc
/// adds at most half the box.
fn double_area(ring: &[Side]) -> Real {
    ring.iter().fold(Real::from(0.0), |sum, side| {
        let piece = side.curve.rough();
        let chord = piece.chord();
        let half_box = (&chord.x * &chord.y).abs().hull(&Real::from(0.0));
        let area = sum + piece.from.cross(&piece.to);
        match &piece.circle {
            None => area,
            Some(circle) if circle.left => area + half_box,
            Some(_) => area - half_box,
        }
    })
}

/// A point in the middle of a piece and one to its left, away by a small part of its length.
fn beside(piece: &Piece) -> (Vector, Vector) {
    const PART: f64 = 1.0 / 64.0;
    let chord = piece.chord();
    let middle = &piece.from + &(&chord * &Real::from(0.5));
    let middle = match &piece.circle {
        None => middle,
        Some(circle) => &circle.centre + &(&(&middle - &circle.centre).unit() * &circle.radius),
    };
    let beside = &middle + &(&chord.left() * &Real::from(PART));
    (middle, beside)
}
