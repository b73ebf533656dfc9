//! Whether a result is right, the rule of the bench: it was answered, and `mu_hi` is at most 1e-6 unit-box lengths; of an
//! engine that declares a coarser resolution, as one that flattens its operands does, at most twice that resolution.
//!
//! There is no other tolerance. A result is wrong if it is certainly not right (`mu_lo` above the bound), and what is
//! neither, or was not looked at, is neither.

use crate::judge::Judgement;

/// The greatest error of a right result, in unit-box lengths.
pub const BOUND: f64 = 1e-6;

/// How much of its declared resolution an engine may be off.
pub const RESOLUTIONS: f64 = 2.0;

/// The greatest error of a right result of an engine of this resolution, both in unit-box lengths.
#[must_use]
pub fn bound(resolution: Option<f64>) -> f64 {
    resolution.map_or(BOUND, |resolution| BOUND.max(RESOLUTIONS * resolution))
}

/// Whether the result so judged is right; `None` where that was not found out.
#[must_use]
pub fn right(judgement: &Judgement, resolution: Option<f64>) -> Option<bool> {
    let bound = bound(resolution);
    match (judgement.mu_lo, judgement.mu_hi) {
        (_, Some(hi)) if hi <= bound => Some(true),
        (Some(lo), _) if lo > bound => Some(false),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::row::Status;

    fn judged(lo: f64, hi: f64) -> Judgement {
        Judgement { status: Status::Ok, mu_lo: Some(lo), mu_hi: Some(hi), ..Judgement::undecided("") }
    }

    #[test]
    fn the_bound_is_what_the_rule_says() {
        let above = BOUND.next_up();
        for (lo, hi, resolution, expected) in [
            (0.0, BOUND, None, Some(true)),
            (above, above, None, Some(false)),
            (0.0, above, None, None),
            (f64::INFINITY, f64::INFINITY, None, Some(false)),
            (2e-3, 2e-3, Some(1e-3), Some(true)),
            (2.1e-3, 2.2e-3, Some(1e-3), Some(false)),
            (5e-7, 5e-7, Some(1e-9), Some(true)),
            (f64::NAN, f64::NAN, None, None),
        ] {
            assert_eq!(right(&judged(lo, hi), resolution), expected, "{lo} {hi} {resolution:?}");
        }
        assert_eq!(right(&Judgement::undecided("late"), None), None);
    }
}
