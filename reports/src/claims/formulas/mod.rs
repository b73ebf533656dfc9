//! Claims about angles, points and sums in floating point (MS 4.1; M9 to M12).

mod three_terms;

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    three_terms::claims().into()
}
