//! The three-term sum against exact arithmetic (memo A6, fact 9).

use arcsum::sum3::Rounding;
use arcsum_tests::cases;
use arcsum_tests::random::Random;

use proptest::prelude::*;
use rug::Float;

/// The correctly rounded sum: 2200 bits hold any sum of three doubles exactly.
fn exact(t: f64, d: f64, q: f64) -> f64 {
    let sum = Float::with_val(2200, t) + d + q;
    sum.to_f64()
}

/// MS 4.1: the errors of two TwoSums added to the rounded sum.
fn two_dekkers(t: f64, d: f64, q: f64) -> f64 {
    let (s, first) = arcsum::twofold::two_sum(t, d);
    let (s, second) = arcsum::twofold::two_sum(s, q);
    s + (first + second)
}

/// Sums next to ties, with cancellation, and with terms far apart.
fn adversary(random: &mut Random) -> [f64; 3] {
    let t = random.uniform(-1.0, 1.0);
    let d = random.uniform(-1.0, 1.0) * 2f64.powi(-(random.below(61) as i32));
    let small = |random: &mut Random, lo: i32| random.uniform(-1.0, 1.0) * 2f64.powi(-lo - random.below(60) as i32);
    let mut terms = match random.below(5) {
        0 => [t, d, random.uniform(-1.0, 1.0)],
        1 => [t, d, -t + small(random, 0)],
        2 => [t, d, -(t + d) + small(random, 20)],
        3 => {
            let odd_half = (random.below(1 << 10) as f64 - 512.0 + 0.5) * f64::EPSILON / 2.0;
            [(1.0 + random.uniform(0.0, 1.0)) / 2.0, odd_half, small(random, 55)]
        }
        _ => {
            let tie = f64::EPSILON / 4.0 * random.sign();
            [random.uniform(0.5, 1.0), tie, random.sign() * 2f64.powi(-55 - random.below(60) as i32)]
        }
    };
    terms.rotate_left(random.below(3));
    terms
}

#[test]
fn correct_rounding_is_correct_and_the_others_are_not() {
    let mut random = Random::new(1);
    let mut wrong = [0u32; 3];
    for _ in 0..400_000 {
        let [t, d, q] = adversary(&mut random);
        let right = exact(t, d, q);
        let answers = [Rounding::Correct.sum(t, d, q), two_dekkers(t, d, q), Rounding::Plain.sum(t, d, q)];
        for (count, answer) in wrong.iter_mut().zip(answers) {
            *count += u32::from(answer != right);
        }
    }
    println!("of 400000 sums wrong: round to odd {}, two TwoSums {}, plain {}", wrong[0], wrong[1], wrong[2]);
    assert_eq!(wrong[0], 0);
    assert!(wrong[1] > 1000, "the check must show that two TwoSums fail: {}", wrong[1]);
    assert!(wrong[2] > wrong[1]);
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
                    differ += u32::from(two_dekkers(t, d, q) != right);
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
