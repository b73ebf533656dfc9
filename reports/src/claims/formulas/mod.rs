//! Claims about angles, points and sums in floating point (MS 4.1; M9 to M12).

pub mod angle;
pub mod arc;
pub mod formula;
pub mod modification;
mod points;
pub mod three_terms;

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    points::claims().into_iter().chain(three_terms::claims()).chain(modification::claims()).collect()
}
