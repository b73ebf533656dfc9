//! Why the bits of an answer fall short, as far as the numbers of the case tell.

use crate::cases::Case;
use crate::engine::Answer;
use arcsum::region::Region;

/// Bits below this are explained in the note.
const WANTED_BITS: f64 = 45.0;

/// One sentence when -log2(mu) is below 45: what the spacing of doubles allows at these coordinates, whether loops are
/// missing; empty otherwise. `mu` is in unit-box lengths, `unit` is the side of the box in input units.
#[must_use]
pub fn short_bits(case: &Case, answer: &Answer, exact_loops: usize, mu: f64, unit: f64) -> String {
    let bits = -mu.log2();
    if bits >= WANTED_BITS {
        return String::new();
    }
    let loops = answer.region.loops.len();
    let spacing = ulp(reach(&answer.region).max(reach(&case.a)).max(reach(&case.b))) / unit;
    let mut reasons = Vec::new();
    // A rounded vertex is off by up to half a spacing in each coordinate, and each of the operands' roundings adds one.
    if mu <= 4.0 * spacing {
        reasons.push(format!("doubles are 2^{:.0} of the unit box apart at these coordinates", spacing.log2()));
    }
    if loops != exact_loops {
        reasons.push(format!("the result has {loops} loops, the exact sum {exact_loops}"));
    }
    if reasons.is_empty() {
        reasons.push("the spacing of doubles and the number of loops do not explain it".into());
    }
    format!("{bits:.1} bits: {}", reasons.join("; "))
}

/// The largest coordinate by absolute value.
fn reach(region: &Region) -> f64 {
    region.loops.iter().flatten().fold(0.0, |m: f64, n| m.max(n.x.abs()).max(n.y.abs()))
}

/// The distance from a nonnegative double to the next.
fn ulp(value: f64) -> f64 {
    value.next_up() - value
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{polygon, rectangle};

    fn case(away: f64) -> (Case, Answer) {
        let square = |at: f64| polygon(&rectangle([at, at], [at + 1.0, at + 1.0]));
        let case =
            Case { name: "c".into(), family: "f".into(), a: square(away), b: square(0.0), seed: None, golden: None };
        (case, Answer { region: square(away), ..Answer::default() })
    }

    #[test]
    fn far_coordinates_are_named_and_near_ones_are_not() {
        let (far, answer) = case(libm::scalbn(1.0, 30));
        assert!(short_bits(&far, &answer, 1, libm::scalbn(1.0, -22), 1.0).contains("2^-22"));
        let (near, answer) = case(0.0);
        let note = short_bits(&near, &answer, 2, libm::scalbn(1.0, -22), 1.0);
        assert!(note.contains("1 loops, the exact sum 2") && !note.contains("doubles"), "{note}");
        assert_eq!(short_bits(&near, &answer, 1, libm::scalbn(1.0, -50), 1.0), "");
    }
}
