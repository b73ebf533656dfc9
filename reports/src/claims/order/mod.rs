//! Claims about the convolution order (MS 7; M26 to M31, M33).

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    Vec::new()
}
