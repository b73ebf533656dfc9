//! Claims about convex and monotonic convolutions (MS 3, 5, 6; M17 to M22).

mod envelope;
mod monotone;
mod rule;

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    let mut claims: Vec<Claim> = Vec::new();
    claims.extend(envelope::claims());
    claims.extend(monotone::claims());
    claims.extend(rule::claims());
    claims
}
