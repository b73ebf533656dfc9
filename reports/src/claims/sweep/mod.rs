//! Claims about the arrangement: its error, size and time (MS 4, its reference 5, 8; M8, M14, M49, M50, A1 to A4).

pub(super) mod audit;
mod clock;
mod degenerate;
mod exact;
mod growth;
pub(super) mod liar;
mod naive;
mod perturbed;
mod tails;
pub(super) mod tangle;
mod vertices;

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    let mut claims = vec![growth::claim(), exact::claim(), naive::claim()];
    claims.extend(perturbed::claims());
    claims.extend(vertices::claims());
    claims.extend(tails::claims());
    claims.extend(degenerate::claims());
    claims
}
