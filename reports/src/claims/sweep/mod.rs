//! Claims about the arrangement: its error, size and time (MS 4, its reference 5, 8; M8, M14, M49, M50, A1 to A4).

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    Vec::new()
}
