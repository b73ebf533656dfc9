//! The certified region Hausdorff distance between a float result and the exact sum (memo I6).
//!
//! Both regions are brought to normal form exactly: the result S as the closure of what its loops wind around, so
//! cracks, spikes and crossings of its boundary are taken at face value, and the exact sum E. Their differences S \ E
//! and E \ S are computed exactly and cut into trapezoids. Only points of a difference have a positive distance to the
//! other region, and that distance is the one to the other region's boundary, because the segment to the nearest point
//! of a closed set ends on its boundary. The supremum over the trapezoids is bracketed by [`crate::farthest`].
//!
//! The bracket holds without any assumption on how S came about. A point of S outside E is a limit of interior points
//! of S \ E, since S is the closure of its interior and E is closed; the trapezoids are closed and cover the closure of
//! S \ E; and their corners belong to S and not to the interior of E, so the distances there are attained.
//!
//! `hi` is at most 1/32 above `lo`, or below 2^-62 unit-box lengths, unless [`crate::farthest`] runs out of cuts; then the
//! bracket is wider and still valid.

use crate::arrange::{Edge, boundaries};
use crate::curves::Curves;
use crate::error::{Budget, OracleError};
use crate::farthest::Farthest;
use crate::interval::Interval;
use crate::locate::Locator;
use crate::number::Number;
use crate::plain::PlainRegion;
use crate::point::Point;
use crate::region::ExactRegion;
use crate::trapezoid::trapezoids;

/// Below this many unit-box lengths a bracket is not refined further.
pub(crate) const FLOOR: f64 = 1.0 / (1u64 << 62) as f64;

/// From which of the regions the distance is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From a point of the result to the exact sum.
    FromResult,
    /// From a point of the exact sum to the result.
    FromSum,
}

/// A certified bracket of the region Hausdorff distance, in unit-box lengths: `lo` <= distance <= `hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bracket {
    /// The lower bound, rounded down.
    pub lo: f64,
    /// The upper bound, rounded up.
    pub hi: f64,
    /// The direction in which `lo` is attained.
    pub direction: Direction,
    /// The point that attains `lo`, rounded to doubles, in input units; NaN if there is none: equal regions, one of them
    /// empty, or one of them unbounded.
    pub witness: (f64, f64),
}

/// The distance between a polygonal result, read by [`ExactRegion::from_plain`], and the exact sum; `unit` is the unit
/// box's side in input units, a power of two. It is infinite if one region is unbounded or empty and the other is not.
///
/// # Errors
/// [`OracleError::NotPolygonal`] and [`OracleError::BadNumber`] for a result that is no polygonal region.
pub fn hausdorff<Q: Number>(result: &PlainRegion, sum: &ExactRegion<Q>, unit: f64) -> Result<Bracket, OracleError> {
    between(&ExactRegion::from_plain(result)?, sum, unit)
}

/// The distance between two exact regions, the first in the role of the result.
///
/// # Errors
/// [`OracleError::BadNumber`] for coordinates too large for doubles.
pub fn between<Q: Number>(result: &ExactRegion<Q>, sum: &ExactRegion<Q>, unit: f64) -> Result<Bracket, OracleError> {
    if result.unbounded() != sum.unbounded() || result.is_empty() != sum.is_empty() {
        let more = (result.unbounded() && !sum.unbounded()) || sum.is_empty();
        let direction = if more { Direction::FromResult } else { Direction::FromSum };
        return Ok(Bracket::new::<Q>(Interval::point(f64::INFINITY), unit, direction, None));
    }
    let [surplus, lack] = differences(result, sum)?;
    let (to_sum, to_result) = (Locator::new(sum)?, Locator::new(result)?);
    let mut forth = Farthest::new(&to_sum, trapezoids(surplus));
    let mut back = Farthest::new(&to_result, trapezoids(lack));
    let known = forth.reached().0.max(back.reached().0);
    let floor = FLOOR * unit;
    let hi = forth.refine(known, floor).max(back.refine(known, floor));
    let (direction, search) =
        if forth.reached().0 >= back.reached().0 { (Direction::FromResult, forth) } else { (Direction::FromSum, back) };
    let (lo, place) = search.reached();
    Ok(Bracket::new(Interval::new(lo, hi), unit, direction, place))
}

impl Bracket {
    /// The bracket of a length in input units, attained at this point.
    pub(crate) fn new<Q: Number>(length: Interval, unit: f64, direction: Direction, place: Option<&Point<Q>>) -> Self {
        let unit = Interval::point(unit);
        let scaled = |end: f64| if end.is_finite() { Interval::point(end) / unit } else { Interval::point(end) };
        let witness = place.map_or((f64::NAN, f64::NAN), Point::nearest);
        Self { lo: scaled(length.lo()).lo(), hi: scaled(length.hi()).hi(), direction, witness }
    }

    /// The bracket of a distance that may differ from this one by so much, not negative.
    #[must_use]
    pub(crate) fn widened(self, by: f64) -> Self {
        if by == 0.0 {
            return self;
        }
        Self { lo: (self.lo - by).next_down().max(0.0), hi: (self.hi + by).next_up(), ..self }
    }
}

/// Bounds of the directed distance, in input units: how far `from` reaches out of `to`, and the point that attains the
/// lower bound. Both are infinite where there is nothing to measure to.
///
/// # Errors
/// As [`between`].
pub fn reach<Q: Number>(
    from: &ExactRegion<Q>,
    to: &ExactRegion<Q>,
    floor: f64,
) -> Result<(Interval, Option<Point<Q>>), OracleError> {
    if (from.unbounded() && !to.unbounded()) || (to.is_empty() && !from.is_empty()) {
        return Ok((Interval::point(f64::INFINITY), None));
    }
    let [surplus, _] = differences(from, to)?;
    let locator = Locator::new(to)?;
    let mut search = Farthest::new(&locator, trapezoids(surplus));
    let hi = search.refine(0.0, floor);
    let (lo, place) = search.reached();
    Ok((Interval::new(lo, hi), place.cloned()))
}

/// The boundaries of `a` without `b` and of `b` without `a`.
fn differences<Q: Number>(a: &ExactRegion<Q>, b: &ExactRegion<Q>) -> Result<[Vec<Edge<Q>>; 2], OracleError> {
    let curves = Curves::of_regions([a, b]);
    let base = [a, b].map(|region| i32::from(region.unbounded()));
    boundaries(&curves, base, [|w| w[0] > 0 && w[1] == 0, |w| w[0] == 0 && w[1] > 0], Budget::NONE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bracket_is_widened_by_less_than_its_last_place() {
        let bracket = Bracket { lo: 0.5, hi: 0.5, direction: Direction::FromSum, witness: (0.0, 0.0) };
        let wide = bracket.widened(2f64.powi(-80));
        assert!(wide.lo < 0.5 && wide.hi > 0.5 && wide.hi - wide.lo < 2f64.powi(-51));
        assert_eq!(bracket.widened(0.0), bracket);
        assert_eq!(Bracket { lo: 0.0, ..bracket }.widened(1.0).lo, 0.0);
    }
}
