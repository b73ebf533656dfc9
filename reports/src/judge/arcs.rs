//! Regions with circle segments: the certified boundary of the exact sum, and the certified Hausdorff distance of the result
//! to it (memo I4, I6).

use super::Judgement;
use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::engine::Answer;
use arcsum_oracle::certified::meet::LIMIT;
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::error::{Budget, OracleError};

/// Judges the answer to a case with circle segments.
pub(super) fn judge(case: &Case, answer: &Answer) -> Result<Judgement, OracleError> {
    let unit = unit(&case.a, &case.b);
    let reference = Reference::new(&plain(&case.a), &plain(&case.b), unit, Budget::default())?;
    if reference.undecided() > 0 {
        let bits = LIMIT.bits();
        let note = format!("{} stretches of sum curves undecided at {bits} bits", reference.undecided());
        return Ok(Judgement { exact_bits: Some(bits), ..Judgement::undecided(note) });
    }
    match reference.measure(&plain(&answer.region))? {
        Some(bracket) => {
            let judgement = Judgement::measured(case, answer, bracket, reference.loops(), String::new());
            let judgement = Judgement { exact_bits: Some(reference.bits()), ..judgement };
            judgement.with_free(case, answer, reference.summed())
        }
        None => Ok(Judgement::undecided("curves of the result and of the sum that are neither apart nor the same")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{disc, polygon, rectangle};
    use crate::row::Status;
    use arcsum::region::Region;

    fn judged(answer: Region) -> Judgement {
        let case = Case { name: "c".into(), family: "f".into(), a: disc(1.0), b: disc(0.5), seed: None, golden: None };
        judge(&case, &Answer { region: answer, ..Answer::default() }).expect("within the budget")
    }

    #[test]
    fn the_right_disc_is_right_and_wrong_ones_are_measured() {
        let right = judged(disc(1.5));
        assert!(right.failed_checks.is_empty() && right.mu_hi.is_some_and(|mu| mu < 1e-15), "{right:?}");
        assert_eq!(right.exact_loops, Some(1));
        // The unit box has side 2: off by 1/4 of an input unit is 1/8.
        let small = judged(disc(1.25));
        assert!(small.mu_lo.is_some_and(|mu| mu > 0.1249 && mu <= 0.125), "{small:?}");
        assert!(small.mu_hi.is_some_and(|mu| mu < 0.1251), "{small:?}");
        assert_eq!((small.status, small.direction.as_deref()), (Status::Ok, Some("sum")));
    }

    #[test]
    fn a_square_of_the_right_area_is_told_by_its_distance() {
        let side = 1.5 * std::f64::consts::PI.sqrt();
        let square = judged(polygon(&rectangle([-0.5 * side, -0.5 * side], [0.5 * side, 0.5 * side])));
        assert_eq!(square.direction.as_deref(), Some("result"));
        let corner = (0.5 * side * std::f64::consts::SQRT_2 - 1.5) / 2.0;
        assert!(square.mu_lo.is_some_and(|mu| (mu - corner).abs() < 1e-9), "{square:?}");
    }
}
