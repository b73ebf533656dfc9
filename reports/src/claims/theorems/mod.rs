//! Theorems 1 to 3 of MS as stated, against realizations (MS 4.2, 6; M13, M15, M16, M23, M24).

mod crusts;
mod families;
mod hills;
mod lemma;
mod moved;
mod realization;
mod sums;

use super::Claim;
use arcsum_oracle::error::Budget;

/// The unit of the theorems, 2^-53.
const EPS: f64 = f64::EPSILON / 2.0;

/// Work on one certified reference.
const BUDGET: Budget = Budget { segments: 20_000, meetings: 2_000_000 };

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    let families: [Vec<Claim>; 5] = [
        realization::claims().into(),
        lemma::claims().into(),
        sums::claims().into(),
        crusts::claims().into(),
        moved::claims().into(),
    ];
    families.into_iter().flatten().collect()
}
