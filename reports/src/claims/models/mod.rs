//! The claim about the size of models with and without arcs (MS 1; M2).

mod curves;
mod fit;
mod sizes;

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    sizes::claims().into()
}
