//! On which side of both boundaries a point lies, and how far from them: the exact sum by its operands, the result by its
//! winding number.

use crate::certified::inside::Winding;
use crate::certified::membership::{Membership, State};
use crate::certified::nearest::{FINE, Nearest};
use crate::certified::precision::Precision;
use crate::certified::spot::Spot;
use crate::error::OracleError;
use crate::overlap::Overlap;
use crate::point::Point;
use rug::Rational;

use super::{Regions, Sample};

/// A point of the unit box.
pub(super) type Place = Point<Rational>;

/// The sum and the result of [`Regions`] prepared for many samples.
pub struct Sampler<'a> {
    pub(super) regions: &'a Regions,
    membership: Membership,
    /// For polygons, which are decided in rational numbers.
    overlap: Option<Overlap>,
    winding: Winding,
    boundary: Nearest<'a>,
}

impl<'a> Sampler<'a> {
    /// Prepares the regions.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn new(regions: &'a Regions) -> Result<Self, OracleError> {
        let [a, b] = &regions.operands;
        Ok(Self {
            regions,
            membership: Membership::new(a, b),
            overlap: regions.polygons.clone().map(|[a, b]| Overlap::new(a, b)).transpose()?,
            winding: Winding::new(&regions.result),
            boundary: Nearest::new(&regions.curves)?,
        })
    }

    /// Whether a point is in the interior of the sum (blocked), not in the sum (free), or neither for certain.
    pub(super) fn state(&self, t: &Place) -> Result<State, OracleError> {
        match &self.overlap {
            Some(overlap) => overlap.state(t),
            None => Ok(self.membership.state(&Spot::rational(t))),
        }
    }

    /// Whether a point is in the result; none on its boundary.
    pub(super) fn contains(&self, t: &Place) -> Option<bool> {
        let spot = Spot::rational(t);
        self.winding.inside(|p| spot.at(p), Precision::FINEST)
    }

    /// Bounds of the distance of a point to the boundary of the result; infinite without one.
    pub(super) fn off(&self, t: &Place) -> (f64, f64) {
        let found = self.boundary.distance(&Spot::rational(t).at(FINE));
        found.map_or((f64::INFINITY, f64::INFINITY), |(distance, _)| (distance.lo().max(0.0), distance.hi()))
    }

    /// How far off a point of this state shows the result to be: what is free and in the result is that far from the sum,
    /// what is blocked and not in the result is that far from the result. None if its side of the result is unknown.
    pub(super) fn far(&self, t: &Place, state: State) -> Option<f64> {
        match (state, self.contains(t)?) {
            (State::Free, true) => Some(self.membership.distance(&Spot::rational(t), FINE).lo().max(0.0)),
            (State::Blocked, false) => Some(self.off(t).0),
            _ => Some(0.0),
        }
    }

    /// What a point of the unit box shows by itself, given in shares of the box around the result made half as large again.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn point(&self, shares: [f64; 2]) -> Result<Sample, OracleError> {
        let place = self.at(shares);
        let Some(t) = place.and_then(|[x, y]| Point::from_f64(x, y)) else {
            return Ok(Sample { place: [0.0; 2], near: None, far: 0.0, undecided: true });
        };
        let state = self.state(&t)?;
        let far = self.far(&t, state);
        Ok(self.sample(&t, None, far.unwrap_or(0.0), far.is_none() || state == State::Undecided))
    }

    /// The point at these shares of the box around the result made half as large again; none for a result without a boundary.
    pub(super) fn at(&self, shares: [f64; 2]) -> Option<[f64; 2]> {
        let [x0, y0, x1, y1] = self.regions.extent()?;
        let place = |lo: f64, hi: f64, share: f64| lo - 0.25 * (hi - lo) + 1.5 * share * (hi - lo);
        Some([place(x0, x1, shares[0]), place(y0, y1, shares[1])])
    }

    /// A sample at a place of the unit box.
    pub(super) fn sample(&self, t: &Place, near: Option<f64>, far: f64, undecided: bool) -> Sample {
        let (x, y) = t.nearest();
        Sample { place: [x * self.regions.unit, y * self.regions.unit], near, far, undecided }
    }
}
