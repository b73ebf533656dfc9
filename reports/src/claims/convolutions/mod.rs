//! Claims about convex and monotonic convolutions (MS 3, 5, 6; M17 to M22).

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    Vec::new()
}
