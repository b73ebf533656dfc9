//! Claims about the convolution order (MS 7; M26 to M31, M33).

mod between;
mod cancellations;
mod chains;
mod exact;
mod related;
mod relation;
mod rules;
mod separated;
pub(in crate::claims) mod swept;

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    let families = [
        rules::claims().into(),
        cancellations::claims().into(),
        separated::claims().into(),
        related::claims().into(),
        relation::claims().into(),
        between::claims().into(),
    ];
    let families: [Vec<Claim>; 6] = families;
    families.into_iter().flatten().collect()
}
