//! Bounds of the error of a result with circle segments, from enclosures of the result and of the sum.
//!
//! With S_in ⊆ S ⊆ S_out and E_in ⊆ E ⊆ E_out, every point of S_in is a point of S at least as far from E as from
//! E_out, and S lies in S_out while E contains E_in; the same with S and E exchanged.

use crate::enclose::Enclosure;
use crate::error::OracleError;
use crate::interval::Interval;
use crate::measure::{Bracket, Direction, reach};
use crate::number::Number;

/// A bracket of the region Hausdorff distance between an enclosed result and an enclosed sum; `unit` is the unit box's
/// side in input units, a power of two. The lower bound counts only what no flattening explains; the upper bound
/// contains the gaps of both enclosures, so it is only as sharp as they are, and infinite if an inner region is empty.
///
/// # Errors
/// As [`crate::measure::between`].
pub fn bracket<Q: Number>(result: &Enclosure<Q>, sum: &Enclosure<Q>, unit: f64) -> Result<Bracket, OracleError> {
    let floor = unit * f64::EPSILON;
    let (forth, place_forth) = reach(&result.inner, &sum.outer, floor)?;
    let (back, place_back) = reach(&sum.inner, &result.outer, floor)?;
    let (forth_hi, _) = reach(&result.outer, &sum.inner, floor)?;
    let (back_hi, _) = reach(&sum.outer, &result.inner, floor)?;
    let (direction, place) = match forth.lo() >= back.lo() {
        true => (Direction::FromResult, place_forth),
        false => (Direction::FromSum, place_back),
    };
    let length = Interval::new(forth.lo().max(back.lo()), forth_hi.hi().max(back_hi.hi()));
    Ok(Bracket::new(length, unit, direction, place.as_ref()))
}
