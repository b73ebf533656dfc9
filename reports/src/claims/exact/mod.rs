//! Claims of Flato and Halperin that the exact references can test (F1, F3, F4, F16).

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    Vec::new()
}
