//! Claims about falsely free and falsely blocked points (MS 4, 7, 8; M25, M32, M34, M35, M51).

mod blocked;
mod bubbles;
mod crusts;
mod disc;
pub(in crate::claims) mod mu;
mod probes;
mod theorem;

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    let families: [Vec<Claim>; 5] = [
        bubbles::claims().into(),
        crusts::claims().into(),
        theorem::claims().into(),
        blocked::claims().into(),
        disc::claims().into(),
    ];
    families.into_iter().flatten().collect()
}
