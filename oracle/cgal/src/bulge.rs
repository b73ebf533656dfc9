//! The bulge of a circle segment between two points that are near its circle.

use rug::Float;

/// Bits to which it is computed before it is rounded to a double.
const BITS: u32 = 256;

/// The tangent of a quarter of the sweep around the centre from the first point to the last, at most half a turn; positive
/// for a segment that runs counter-clockwise. What differs from half a turn by no more than roundings counts as that.
#[must_use]
pub fn bulge(centre: [&Float; 2], from: [&Float; 2], to: [&Float; 2], left: bool) -> f64 {
    let arm = |end: [&Float; 2]| [0, 1].map(|i| Float::with_val(BITS, end[i] - centre[i]));
    let ([ux, uy], [vx, vy]) = (arm(from), arm(to));
    let dot = Float::with_val(BITS, &ux * &vx) + Float::with_val(BITS, &uy * &vy);
    let cross = Float::with_val(BITS, &ux * &vy) - Float::with_val(BITS, &uy * &vx);
    let size = Float::with_val(BITS, cross.clone().hypot(&dot));
    let cross = if left { cross } else { -cross };
    // tan(s/2) = sin s / (1 + cos s), and the same once more.
    let half = cross.max(&Float::new(BITS)) / (Float::with_val(BITS, &size + &dot));
    let is_finite = half.is_finite();
    let root = Float::with_val(BITS, 1 + half.clone().square()).sqrt();
    let quarter: Float = half / (1 + root);
    let size = if is_finite { quarter.to_f64() } else { 1.0 };
    if left { size } else { -size }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Against the definition in doubles.
        #[test]
        fn it_is_the_tangent_of_a_quarter_of_the_sweep(start in -3.0..3.0f64, sweep in 0.01..3.1f64, left: bool) {
            let number = |x: f64| Float::with_val(BITS, x);
            let at = |angle: f64| [number(2.0 + 3.0 * angle.cos()), number(1.0 + 3.0 * angle.sin())];
            let (from, to) = (at(start), at(if left { start + sweep } else { start - sweep }));
            let centre = [number(2.0), number(1.0)];
            let pair = |p: &[Float; 2]| p.clone();
            let (c, f, t) = (pair(&centre), pair(&from), pair(&to));
            let found = bulge([&c[0], &c[1]], [&f[0], &f[1]], [&t[0], &t[1]], left);
            let expected = if left { (0.25 * sweep).tan() } else { -(0.25 * sweep).tan() };
            prop_assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
    }

    #[test]
    fn half_a_turn_has_the_bulge_1() {
        let [one, minus, zero] = [1.0, -1.0, 0.0].map(|x| Float::with_val(BITS, x));
        for left in [true, false] {
            let found = bulge([&zero, &zero], [&minus, &zero], [&one, &zero], left);
            assert_eq!(found, if left { 1.0 } else { -1.0 });
        }
    }
}
