//! Claims of Flato and Halperin that the exact references can test (F1, F3, F4, F16).

mod collision;
mod draw;
mod growth;
mod references;

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    let mut claims = Vec::from(references::claims());
    claims.extend(growth::claims());
    claims.extend(collision::claims());
    claims
}
