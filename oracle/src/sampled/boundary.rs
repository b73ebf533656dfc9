//! Samples on the boundary of the result: how near the boundary of the sum is.
//!
//! From a place on the boundary one goes in and out by d along the normal, for d = 2^-58, 2^-57, ... If the inner point is in
//! the interior of the sum and the outer one is not, the boundary of the sum passes between them, at most d away from the
//! place. The first such d is certified. On the way each point that is on the wrong side of the result proves an error.

use crate::certified::membership::State;
use crate::error::OracleError;
use crate::point::Point;
use rug::Rational;

use super::sides::{Place, Sampler};
use super::{Sample, regions::Base};

/// The smallest distance that is tried is 2 to this power, in unit-box lengths.
pub const FINEST: i32 = -58;

/// The largest one.
pub const COARSEST: i32 = -4;

impl Sampler<'_> {
    /// The place at a share of a side of the result, from 0, its start, to less than 1.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    ///
    /// # Panics
    /// If there is no such side.
    pub fn boundary(&self, side: usize, share: f64) -> Result<Sample, OracleError> {
        let base = self.regions.base(side, share);
        let place = exact(base.place);
        // The double next to the place is off the boundary by that much.
        let rounding = self.off(&place).1;
        let (mut far, mut undecided) = (0.0_f64, false);
        for exponent in FINEST..=COARSEST {
            let ends = [1.0, -1.0].map(|way| stepped(&place, base, way, exponent));
            let [inner, outer] = [self.state(&ends[0])?, self.state(&ends[1])?];
            if inner == State::Blocked && outer != State::Blocked {
                let near = (2f64.powi(exponent) + rounding).next_up();
                return Ok(self.sample(&place, Some(near), far, false));
            }
            for (t, state) in ends.iter().zip([inner, outer]) {
                let proved = self.far(t, state);
                far = far.max(proved.unwrap_or(0.0));
                undecided |= proved.is_none() || state == State::Undecided;
            }
        }
        Ok(self.sample(&place, None, far, undecided))
    }

    /// What a point beside the boundary shows, 2 to the power of `exponent` inward or outward.
    ///
    /// # Errors
    /// As [`Self::boundary`].
    ///
    /// # Panics
    /// If there is no such side.
    pub fn beside(&self, side: usize, share: f64, inward: bool, exponent: i32) -> Result<Sample, OracleError> {
        let base = self.regions.base(side, share);
        let t = stepped(&exact(base.place), base, if inward { 1.0 } else { -1.0 }, exponent);
        let state = self.state(&t)?;
        let far = self.far(&t, state);
        Ok(self.sample(&t, None, far.unwrap_or(0.0), far.is_none() || state == State::Undecided))
    }
}

/// A point of two finite doubles.
pub(super) fn exact([x, y]: [f64; 2]) -> Place {
    let number = |c: f64| Rational::from_f64(c).unwrap_or_default();
    Point { x: number(x), y: number(y) }
}

/// The place moved along the direction by less than 2 to the power of `exponent`.
fn stepped(place: &Place, base: Base, way: f64, exponent: i32) -> Place {
    let size = 2f64.powi(exponent);
    place.plus(&exact(base.inward.map(|c| way * size * c)))
}
