//! The three-term sum against exact arithmetic (memo A6, fact 9); the claim M10 counts how often the printed one is wrong.

use arcsum::sum3::Rounding;
use arcsum_reports::claims::formulas::three_terms::two_dekkers;
use arcsum_tests::cases;

use proptest::prelude::*;
use rug::Float;

/// The correctly rounded sum: 2200 bits hold any sum of three doubles exactly.
fn exact(t: f64, d: f64, q: f64) -> f64 {
    let sum = Float::with_val(2200, t) + d + q;
    sum.to_f64()
}

/// All triples of a small world around a power of two, where ties are everywhere.
#[test]
fn small_world() {
    let ulp = f64::EPSILON;
    let coarse: Vec<f64> = (-4..=4).map(|i| 1.0 + f64::from(i) * ulp / 2.0).collect();
    let fine: Vec<f64> = (-9..=9).map(|i| f64::from(i) * ulp / 8.0).collect();
    let finest: Vec<f64> = (-9..=9).map(|i| f64::from(i) * 2f64.powi(-110)).collect();
    let mut differ = 0;
    for &t in &coarse {
        for &d in &fine {
            for &q in &finest {
                for [t, d, q] in [[t, d, q], [-t, d, q], [q, t, d], [d, q, t]] {
                    let right = exact(t, d, q);
                    assert_eq!(Rounding::Correct.sum(t, d, q), right, "{t:e} {d:e} {q:e}");
                    differ += u32::from(two_dekkers([t, d, q]) != right);
                }
            }
        }
    }
    assert!(differ > 0, "the small world must show that two TwoSums fail");
}

proptest! {
    #![proptest_config(cases(2000))]

    #[test]
    fn any_finite_triple(t in wide(), d in wide(), q in wide()) {
        prop_assert_eq!(Rounding::Correct.sum(t, d, q), exact(t, d, q));
    }

    /// Theorem 3 of MS needs a monotone function of the exact sum.
    #[test]
    fn monotone(t in -1.0..1.0f64, d in -1.0..1.0f64, q in -1.0..1.0f64, step in 0u64..4) {
        let more = f64::from_bits(q.to_bits() + step);
        let (lo, hi) = if more < q { (more, q) } else { (q, more) };
        prop_assert!(Rounding::Correct.sum(t, d, lo) <= Rounding::Correct.sum(t, d, hi));
    }
}

/// Doubles of all magnitudes below 2^1022, subnormal numbers included.
fn wide() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>().prop_filter("within the range of the sum", |x| x.abs() < 2f64.powi(1022)),
        (-(1i64 << 53)..(1i64 << 53)).prop_map(|i| i as f64 * f64::MIN_POSITIVE),
        (-20i64..20).prop_map(|i| i as f64 * 5e-324),
    ]
}
