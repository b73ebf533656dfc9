//! The vertical distance of a realization along the y axis from the stored boundary, as Theorem 1 of MS has it.

use super::error::RealizeError;
use super::plan::Plan;
use super::stored::StoredRegion;
use super::up::Up;
use crate::certified::real::Real;

/// Bounds of the greatest vertical distance, in the unit box, between an end of a line or circle segment of the stored
/// boundary and the point of the same abscissa after steps 2 and 3 of MS 4.2. On lines it is nowhere greater than at
/// their ends; on circle segments it may be.
///
/// # Errors
/// [`RealizeError`], as its variants say.
pub fn vertical_distance(region: &StoredRegion) -> Result<[f64; 2], RealizeError> {
    let plan = Plan::new(region.clone(), Up::VERTICAL)?;
    let mut greatest = Real::from(0.0);
    for (chain, lift) in plan.doubles().iter().zip(&plan.lifts) {
        for (placed, stored) in chain.placed.iter().zip(&chain.stored) {
            for (moved, from) in [(&placed.path.from, &stored.from), (&placed.path.to, &stored.to)] {
                greatest = greatest.max(&((&moved.y - &from.y) + *lift).abs());
            }
        }
    }
    Ok([greatest.lo(), greatest.hi()])
}
