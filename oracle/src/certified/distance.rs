//! The distance D(t) of a point to the sum without the sum (memo I4): D(t) = dist(t, A ⊕ B) = dist(A, t - B).
//!
//! Unless A and t - B overlap, it is the least distance of their boundary pieces. Boxes and doubles leave few pairs, and
//! only those are measured at the precision asked for.

use super::gap::gap;
use super::membership::{Membership, State};
use super::precision::Precision;
use super::real::Real;
use super::spot::Spot;

/// The least distance of two boundaries.
#[derive(Clone, Debug)]
pub struct Nearest {
    /// An interval around it.
    pub distance: Real,
    /// The piece of A that attains it, or one that nearly does, by its place in [`super::shape::Shape::sides`].
    pub first: usize,
    /// The piece of B, mirrored at t.
    pub second: usize,
}

impl Membership {
    /// An interval around D(t), in the unit of the coordinates: 0 if t is certainly blocked, from 0 up if that is open at this
    /// precision, infinite if one of the regions is empty.
    #[must_use]
    pub fn distance(&self, t: &Spot, precision: Precision) -> Real {
        let state = self.state_within(t, precision);
        if state == State::Blocked {
            return Real::from(0.0);
        }
        let distance = self.nearest(t, precision).map_or(Real::from(f64::INFINITY), |nearest| nearest.distance);
        if state == State::Free { distance } else { distance.hull(&Real::from(0.0)) }
    }

    /// The distance of the boundaries of A and of t - B, and a pair that attains it; `None` if one has no boundary.
    #[must_use]
    pub fn nearest(&self, t: &Spot, precision: Precision) -> Option<Nearest> {
        let (pairs, mut nearest) = self.nearest_pairs(t)?;
        if precision > Precision::DOUBLE && nearest.distance.hi() > 0.0 {
            let place = t.at(precision);
            let gap = |&pair: &(usize, usize)| {
                let (a, b) = self.pieces(pair, &place, precision);
                Nearest { distance: gap(a, &b), first: pair.0, second: pair.1 }
            };
            nearest = pairs.iter().map(gap).reduce(Nearest::nearer)?;
        }
        Some(nearest)
    }

    /// The pairs that may be nearest according to doubles, and what doubles make of them.
    fn nearest_pairs(&self, t: &Spot) -> Option<(Vec<(usize, usize)>, Nearest)> {
        let precision = Precision::DOUBLE;
        let place = t.at(precision);
        let gap = |pair| {
            let (a, b) = self.pieces(pair, &place, precision);
            gap(a, &b)
        };
        let known = self.nearest.get().map_or(f64::INFINITY, |pair| gap(pair).hi());
        let mut best: Option<Nearest> = None;
        let mut found = Vec::new();
        self.first.winding.tree().visit_pairs(self.second.winding.tree(), &place, known, |first, second| {
            let distance = gap((first, second));
            found.push((distance.lo(), (first, second)));
            let new = Nearest { distance, first, second };
            let nearest = match best.take() {
                None => new,
                Some(old) => old.nearer(new),
            };
            let least = nearest.distance.hi();
            best = Some(nearest);
            // Nothing is nearer than pieces that cross.
            if least > 0.0 { least.min(known) } else { -1.0 }
        });
        let nearest = best?;
        self.nearest.set((nearest.first, nearest.second));
        let limit = nearest.distance.hi();
        let near = found.into_iter().filter(|&(lo, _)| lo <= limit).map(|(_, pair)| pair);
        Some((near.collect(), nearest))
    }
}

impl Nearest {
    /// The lesser distance, with the pair of the lesser upper bound.
    fn nearer(self, other: Self) -> Self {
        let distance = self.distance.min(&other.distance);
        let pair = if other.distance.hi() < self.distance.hi() { other } else { self };
        Self { distance, ..pair }
    }
}
