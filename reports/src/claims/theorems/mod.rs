//! Theorems 1 to 3 of MS as stated, against realizations (MS 4.2, 6; M13, M15, M16, M23, M24).

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    Vec::new()
}
