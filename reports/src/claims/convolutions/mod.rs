//! Claims about convex and monotonic convolutions (MS 3, 5, 6; M17 to M22).

mod cells;
mod envelope;
mod merge;
mod monotone;
mod rule;
mod sizes;

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    let mut claims = Vec::from(sizes::claims());
    claims.extend(cells::claims());
    claims.extend(envelope::claims());
    claims.extend(monotone::claims());
    claims.extend(rule::claims());
    claims.extend(merge::claims());
    claims
}
