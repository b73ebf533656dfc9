//! Claims about sum segments and winding numbers (MS 2, 3; M1, M3 to M7, M17b).

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    Vec::new()
}
