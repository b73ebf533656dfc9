//! Iterated sums: every sum is tidied ([`crate::tidy`]) and is an operand of the next (MS 8.1; memo D).
//!
//! Sums are 1-Lipschitz in the Hausdorff metric, so errors add up: after j steps the error is at most that of j - 1 steps,
//! plus that of one sum, plus what tidying moves. Arcs stay arcs, and edges that are parallel or concentric but for rounding
//! become one, so the number of segments is that of the exact sum but for features of the size of the error.

use crate::region::Region;
use crate::sum::{Options, SumError, sum};
use crate::tidy::tidy;

/// The sums of the first region and the first one, two, three, ... of the others, each tidied. Ends after the first error.
///
/// # Errors
/// As [`sum`]; operand A is the sum so far.
pub fn partial_sums<'a>(
    first: &Region,
    others: impl IntoIterator<Item = &'a Region>,
    options: Options,
) -> impl Iterator<Item = Result<Region, SumError>> {
    let mut so_far = Some(first.clone());
    others.into_iter().map_while(move |other| {
        let next = sum(so_far.as_ref()?, other, &options).map(|sum| tidy(&sum.region));
        so_far = next.as_ref().ok().cloned();
        Some(next)
    })
}
