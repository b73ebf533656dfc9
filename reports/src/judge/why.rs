//! Why the bits of an answer fall short, as far as the numbers of the case tell.

use crate::cases::Case;
use crate::engine::Answer;
use arcsum::region::Region;

/// Bits below this are explained in the note.
const WANTED_BITS: f64 = 45.0;

/// One sentence when -log2(mu) is below 45: what the spacing of doubles allows at these coordinates; empty otherwise. `mu`
/// is in unit-box lengths, `unit` is the side of the box in input units.
#[must_use]
pub fn short_bits(case: &Case, answer: &Answer, mu: f64, unit: f64) -> String {
    let bits = -mu.log2();
    if bits >= WANTED_BITS {
        return String::new();
    }
    if mu.is_infinite() {
        return "one of result and exact sum is empty or unbounded, the other not".into();
    }
    let spacing = ulp(reach(&answer.region).max(reach(&case.a)).max(reach(&case.b))) / unit;
    // A rounded vertex is off by up to half a spacing in each coordinate; three roundings make at most this.
    if mu <= 4.0 * spacing {
        return format!(
            "{bits:.1} bits: doubles are 2^{:.0} of the unit box apart at these coordinates",
            spacing.log2()
        );
    }
    format!("{bits:.1} bits: more than the spacing of doubles there, 2^{:.0} of the unit box, explains", spacing.log2())
}

/// One sentence when loops are missing or too many; their size is at most the distance measured.
#[must_use]
pub fn other_loops(answer: &Answer, exact: usize) -> String {
    let loops = answer.region.loops.len();
    if loops == exact { String::new() } else { format!("the result has {loops} loops, the exact sum {exact}") }
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
        assert!(short_bits(&far, &answer, libm::scalbn(1.0, -22), 1.0).contains("apart at these coordinates"));
        let (near, answer) = case(0.0);
        assert!(short_bits(&near, &answer, libm::scalbn(1.0, -22), 1.0).contains("more than"));
        assert_eq!(short_bits(&near, &answer, libm::scalbn(1.0, -50), 1.0), "");
        assert!(short_bits(&near, &answer, f64::INFINITY, 1.0).contains("empty or unbounded"));
    }
}
