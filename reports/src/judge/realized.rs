//! The error against the sum of the realizations A*, B* (memo I5): what is left of `mu` once the angles that the engine
//! stores are taken as the truth.

use crate::bridge::{plain, stored, unit};
use crate::cases::Case;
use crate::engine::Answer;
use arcsum_oracle::certified::realize::realize;
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::error::Budget;
use arcsum_oracle::measure::Bracket;

/// The product of the segments of both operands up to which it is measured: realizations stop at every end of a sum
/// segment, and there are about as many of these.
const AFFORDABLE: usize = 10_000;

/// The certified distance of an answer of the built-in engine to the sum of the realizations; `None` for larger cases and
/// where something is undecided.
pub(super) fn measure(case: &Case, answer: &Answer) -> Option<Bracket> {
    if case.a.segments() * case.b.segments() > AFFORDABLE {
        return None;
    }
    let [a, b] = stored(&case.a, &case.b).ok()?.map(|region| realize(&region).ok());
    let unit = unit(&case.a, &case.b);
    let reference = Reference::of_shapes(&a?.shape, &b?.shape, unit, Budget::default()).ok()?;
    reference.measure(&plain(&answer.region)).ok()?
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::disc;
    use arcsum::sum::{Options, sum};

    #[test]
    fn the_error_against_realizations_is_a_few_units_of_rounding() {
        let case = Case { name: "c".into(), family: "f".into(), a: disc(1.0), b: disc(0.3), seed: None, golden: None };
        let region = sum(&case.a, &case.b, &Options::default()).expect("valid").region;
        let right = measure(&case, &Answer { region, ..Answer::default() }).expect("decided");
        assert!(right.hi < 16.0 * f64::EPSILON, "{right:?}");
        let wrong = measure(&case, &Answer { region: disc(1.2), ..Answer::default() }).expect("decided");
        assert!(wrong.lo > 0.04, "{wrong:?}");
    }
}
