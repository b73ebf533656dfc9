//! M10: the sum of three doubles rounded once (MS 4.1; memo A6, fact 9).

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use crate::cases::rng::Rng;
use crate::kept;
use arcsum::sum3::Rounding;
use arcsum::twofold::two_sum;
use libm::scalbn;
use rug::Float;

/// What the numbers are.
const TERMS: &str = "t, d, q";

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "distance to the rounded exact sum",
        unit: "ulp",
        rule: Rule::AtMost(0.0),
        draws: [200_000, 20_000_000],
        draw,
        measure: |input| off(input, two_dekkers),
        kept: kept!("M10_printed"),
        control: Control::Itself,
    };
    let printed = Claim {
        id: "M10 printed",
        place: "MS 4.1",
        says: "Two applications of Dekker's method give the rounded exact sum of three numbers.",
        erratum: "They do not; rounding to odd does (Boldo and Melquiond 2008).",
        test: Test::Sup(sup.clone()),
    };
    let corrected = Claim {
        id: "M10 corrected",
        place: "MS 4.1",
        says: "Rounding to odd in between gives the rounded exact sum of three numbers.",
        erratum: "",
        test: Test::Sup(Sup {
            measure: |input| off(input, |[t, d, q]| Rounding::Correct.sum(t, d, q)),
            kept: kept!("M10_corrected"),
            control: Control::Claim("M10 printed"),
            ..sup
        }),
    };
    [printed, corrected]
}

/// The errors of two sums added to the rounded sum, as MS 4.1 print it.
#[must_use]
pub fn two_dekkers([t, d, q]: [f64; 3]) -> f64 {
    let (s, first) = two_sum(t, d);
    let (s, second) = two_sum(s, q);
    s + (first + second)
}

/// How many doubles a sum is off the rounded exact one. 2200 bits hold any sum of three doubles exactly.
fn off(input: &Input, sum: fn([f64; 3]) -> f64) -> Option<Measured> {
    let terms: [f64; 3] = input.as_numbers(TERMS)?.try_into().ok()?;
    let exact = (Float::with_val(2200, terms[0]) + terms[1] + terms[2]).to_f64();
    let computed = sum(terms);
    let place = |x: f64| i128::from(if x < 0.0 { -(x.abs().to_bits() as i64) } else { x.to_bits() as i64 });
    Some(Measured::exactly((place(exact) - place(computed)).unsigned_abs() as f64))
}

/// Sums next to ties, with cancellation, and with terms far apart.
fn draw(rng: &mut Rng, _: usize) -> Input {
    let any = |rng: &mut Rng| rng.between(-1.0, 1.0);
    let small = |rng: &mut Rng, lo: i32| scalbn(any(rng), -lo - rng.below(60) as i32);
    let sign = |rng: &mut Rng| if rng.below(2) == 0 { 1.0 } else { -1.0 };
    let t = any(rng);
    let d = scalbn(any(rng), -(rng.below(61) as i32));
    let mut terms = match rng.below(5) {
        0 => [t, d, any(rng)],
        1 => [t, d, -t + small(rng, 0)],
        2 => [t, d, -(t + d) + small(rng, 20)],
        3 => {
            let odd_half = (rng.below(1 << 10) as f64 - 512.0 + 0.5) * f64::EPSILON / 2.0;
            [(1.0 + rng.unit()) / 2.0, odd_half, small(rng, 55)]
        }
        _ => {
            let tie = f64::EPSILON / 4.0 * sign(rng);
            [rng.between(0.5, 1.0), tie, scalbn(sign(rng), -55 - rng.below(60) as i32)]
        }
    };
    terms.rotate_left(rng.below(3));
    Input::numbers(TERMS, terms)
}
