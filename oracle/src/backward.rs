//! The backward error of a set operation: how far the boundaries of the operands would have to move for a result to be
//! exact.
//!
//! The distance between a result and the exact one is no fair judge here. Two regions that overlap by less than a
//! rounding meet in a sliver that may be infinitely far from what a float engine rightly gives, nothing; and where
//! boundaries cross at a small angle, the tip of the intersection moves by a rounding over that angle. Both are the fault of the
//! question. What an engine can promise is that its result S is the operation on two regions A' and B' that differ from A
//! and B only within d of their boundaries, and the least such d is what is measured.
//!
//! A' and B' may be chosen point by point, so d is a supremum: over all points p where S disagrees with the exact result, of
//! the least distance that excuses it. To excuse p, membership in A, in B or in both has to be flipped so that the
//! operation gives what S has; flipping it in A costs the distance from p to the boundary of A. In each cell of the
//! arrangement of A, B and S the flips that help are the same, and the cost is one of
//!
//! * the distance to the boundary of A, or of B, where only flipping that one helps;
//! * the lesser of the two, which is the distance to both boundaries taken together, where either helps;
//! * the greater of the two, where only both together help, like a hole of S where A and B overlap in a union.
//!
//! The supremum of a maximum is the maximum of the suprema, so [`crate::farthest`] brackets all four. d is never more than the
//! distance of a point of disagreement from the exact result's boundary, because on the way there some operand is left or
//! entered.

use crate::arrange::boundaries;
use crate::boolean::Operation;
use crate::curves::Curves;
use crate::error::{Budget, OracleError};
use crate::farthest::Farthest;
use crate::interval::Interval;
use crate::locate::Locator;
use crate::measure::{Bracket, Direction, FLOOR};
use crate::number::Number;
use crate::region::ExactRegion;
use crate::trapezoid::trapezoids;

/// A bracket of the backward error of `result` as the operation on `a` and `b`; `unit` is the unit box's side in input
/// units, a power of two. The direction is from the result where it has too much, and from the exact one (in the place of
/// the sum) where it has too little. It is infinite if the result is wrong far away, or anywhere that no flip excuses
/// because an operand has no boundary.
///
/// # Errors
/// [`OracleError::BadNumber`] for coordinates too large for doubles.
pub fn error<Q: Number>(
    operation: Operation,
    a: &ExactRegion<Q>,
    b: &ExactRegion<Q>,
    result: &ExactRegion<Q>,
    unit: f64,
) -> Result<Bracket, OracleError> {
    let far = operation.holds(a.unbounded(), b.unbounded());
    if far != result.unbounded() {
        return Ok(Bracket::new::<Q>(Interval::point(f64::INFINITY), unit, direction(far), None));
    }
    let wrong = TRUTHS.map(|(first, second)| cell(first, second, !operation.holds(first, second)));
    let base = [a, b, result].map(|region| i32::from(region.unbounded()));
    let cells = boundaries(&Curves::of_regions([a, b, result]), base, wrong, Budget::NONE)?;
    let of_both = a.places().into_iter().chain(b.places()).collect();
    let locators = [Locator::new(a)?, Locator::new(b)?, Locator::of_rings(of_both, false)?];
    let mut searches = Vec::new();
    for ((first, second), edges) in TRUTHS.into_iter().zip(cells) {
        let pieces = trapezoids(edges);
        let way = direction(operation.holds(first, second));
        for &cost in costs(operation, first, second) {
            searches.push((way, Farthest::new(&locators[cost as usize], pieces.clone())));
        }
    }
    Ok(worst(searches, unit))
}

/// Membership in the operands, in all ways.
const TRUTHS: [(bool, bool); 4] = [(false, false), (false, true), (true, false), (true, true)];

/// Which boundaries a cost is the distance to; the value is the index of the locator.
#[derive(Clone, Copy)]
enum Cost {
    First,
    Second,
    Nearer,
}

/// The costs of flipping the operation's outcome where the operands are like this; the greatest one counts.
fn costs(operation: Operation, first: bool, second: bool) -> &'static [Cost] {
    let flips = |f: bool, s: bool| operation.holds(f, s) != operation.holds(first, second);
    match (flips(!first, second), flips(first, !second)) {
        (true, true) => &[Cost::Nearer],
        (true, false) => &[Cost::First],
        (false, true) => &[Cost::Second],
        (false, false) => &[Cost::First, Cost::Second],
    }
}

/// The direction of an error at a point that the exact result holds or not.
fn direction(holds: bool) -> Direction {
    if holds { Direction::FromSum } else { Direction::FromResult }
}

/// The predicate for being in the operands and in the result in this way.
fn cell(first: bool, second: bool, result: bool) -> fn(&[i32; 3]) -> bool {
    match (first, second, result) {
        (false, false, false) => is_at::<false, false, false>,
        (false, false, true) => is_at::<false, false, true>,
        (false, true, false) => is_at::<false, true, false>,
        (false, true, true) => is_at::<false, true, true>,
        (true, false, false) => is_at::<true, false, false>,
        (true, false, true) => is_at::<true, false, true>,
        (true, true, false) => is_at::<true, true, false>,
        (true, true, true) => is_at::<true, true, true>,
    }
}

fn is_at<const A: bool, const B: bool, const S: bool>(w: &[i32; 3]) -> bool {
    w.map(|w| w > 0) == [A, B, S]
}

/// The greatest of several suprema, with its direction and the point that attains the lower bound.
fn worst<Q: Number>(mut searches: Vec<(Direction, Farthest<'_, Q>)>, unit: f64) -> Bracket {
    let known = searches.iter().map(|(_, search)| search.reached().0).fold(0.0, f64::max);
    let hi = searches.iter_mut().map(|(_, search)| search.refine(known, FLOOR * unit)).fold(0.0, f64::max);
    let best = searches.iter().max_by(|(_, s), (_, t)| s.reached().0.total_cmp(&t.reached().0));
    let (way, (lo, place)) = best.map_or((Direction::FromResult, (0.0, None)), |(way, s)| (*way, s.reached()));
    Bracket::new(Interval::new(lo, hi.max(lo)), unit, way, place)
}
