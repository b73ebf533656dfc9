//! The exact Minkowski sum of polygonal regions, by the method to use by default.

use rug::Rational;

use crate::convolve;
use crate::error::{Budget, OracleError};
use crate::plain::PlainRegion;
use crate::region::ExactRegion;

/// The closed, regularised Minkowski sum of two polygonal regions given literally by their doubles, within the default
/// budget. Loops that cross are read by [`ExactRegion::from_plain`].
///
/// # Errors
/// [`OracleError::NotPolygonal`] and [`OracleError::BadNumber`] for bad input, [`OracleError::TooCostly`] beyond the
/// budget.
pub fn sum(a: &PlainRegion, b: &PlainRegion) -> Result<ExactRegion<Rational>, OracleError> {
    sum_within(a, b, Budget::default())
}

/// [`sum`] within a budget of the caller's.
///
/// # Errors
/// As [`sum`].
pub fn sum_within(a: &PlainRegion, b: &PlainRegion, budget: Budget) -> Result<ExactRegion<Rational>, OracleError> {
    convolve::sum(&ExactRegion::from_plain(a)?, &ExactRegion::from_plain(b)?, budget)
}
