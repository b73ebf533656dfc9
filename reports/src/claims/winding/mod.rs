//! Claims about sum segments and winding numbers (MS 2, 3; M1, M3 to M7, M17b).

mod carriers;
mod compatible;
mod components;
mod draw;
mod negative;
mod orientation;
mod pieces;
mod probes;
mod selection;
mod ties;

use super::Claim;

/// The claims of this family.
#[must_use]
pub fn claims() -> Vec<Claim> {
    let mut claims = Vec::from(components::claims());
    claims.extend(selection::claims());
    claims.extend(orientation::claims());
    claims.extend(ties::claims());
    claims.extend(carriers::claims());
    claims.extend(negative::claims());
    claims.extend(compatible::claims());
    claims
}
