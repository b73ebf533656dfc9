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

#[cfg(test)]
mod tests {
    use super::super::{Test, exact, kept};
    use super::*;

    #[test]
    fn kept_inputs_measure_as_they_did() {
        let mut count = 0;
        for claim in claims().into_iter().chain(exact::claims()) {
            let Test::Sup(sup) = claim.test else { continue };
            for kept in kept::read(sup.kept) {
                let measured = (sup.measure)(&kept.input).expect("it was measured before");
                assert!(measured.lo >= kept.lo * (1.0 - 1e-9) && measured.hi <= kept.hi * (1.0 + 1e-9), "{}", claim.id);
                count += 1;
            }
        }
        assert!(count > 10);
    }
}
