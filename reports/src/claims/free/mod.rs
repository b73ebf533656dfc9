//! Claims about falsely free and falsely blocked points (MS 4, 7, 8; M25, M32, M34, M35, M51).

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    Vec::new()
}
