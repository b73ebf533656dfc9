//! The exact numbers every algorithm of the oracle is generic over: a small trait with two independent backends,
//! GMP rationals ([`rug::Rational`]) and pure Rust rationals ([`BigRational`]).

use std::cmp::Ordering;
use std::fmt::Debug;
use std::hash::Hash;

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use crate::interval::Interval;

/// A rational number in lowest terms, so that equality, order and hash are those of the value.
pub trait Number: Clone + Debug + Ord + Hash + Send + Sync + 'static {
    /// The value of a finite double, exactly; `None` for infinities and NaN.
    fn from_f64(x: f64) -> Option<Self>;
    /// An integer.
    fn from_i64(x: i64) -> Self;
    /// `self + other`.
    #[must_use]
    fn plus(&self, other: &Self) -> Self;
    /// `self - other`.
    #[must_use]
    fn minus(&self, other: &Self) -> Self;
    /// `self * other`.
    #[must_use]
    fn times(&self, other: &Self) -> Self;
    /// `self / other`.
    ///
    /// # Panics
    /// If `other` is 0.
    #[must_use]
    fn over(&self, other: &Self) -> Self;
    /// How the value compares with 0.
    fn sign(&self) -> Ordering;
    /// The value rounded towards zero to a double (infinite beyond the largest one).
    fn toward_zero(&self) -> f64;
    /// Numerator and denominator in decimal, `p` or `p/q`.
    fn digits(&self) -> String;

    /// The tightest interval of doubles around the value.
    #[must_use]
    fn enclosure(&self) -> Interval {
        let near = self.toward_zero();
        if Self::from_f64(near).is_some_and(|exact| exact == *self) {
            return Interval::point(near);
        }
        match self.sign() {
            Ordering::Less if near.is_infinite() => Interval::new(near, f64::MIN),
            Ordering::Less => Interval::new(near.next_down(), near),
            _ if near.is_infinite() => Interval::new(f64::MAX, near),
            _ => Interval::new(near, near.next_up()),
        }
    }

    /// The nearest double, ties to even; beyond the largest double, the infinity.
    #[must_use]
    fn nearest(&self) -> f64 {
        let around = self.enclosure();
        let (lo, hi) = (around.lo(), around.hi());
        let (Some(below), Some(above)) = (Self::from_f64(lo), Self::from_f64(hi)) else {
            return if lo.is_infinite() { lo } else { hi };
        };
        match self.minus(&below).cmp(&above.minus(self)) {
            Ordering::Less => lo,
            Ordering::Greater => hi,
            Ordering::Equal if lo.to_bits() & 1 == 0 => lo,
            Ordering::Equal => hi,
        }
    }
}

impl Number for rug::Rational {
    fn from_f64(x: f64) -> Option<Self> {
        Self::from_f64(x)
    }
    fn from_i64(x: i64) -> Self {
        Self::from(x)
    }
    fn plus(&self, other: &Self) -> Self {
        Self::from(self + other)
    }
    fn minus(&self, other: &Self) -> Self {
        Self::from(self - other)
    }
    fn times(&self, other: &Self) -> Self {
        Self::from(self * other)
    }
    fn over(&self, other: &Self) -> Self {
        Self::from(self / other)
    }
    fn sign(&self) -> Ordering {
        self.cmp0()
    }
    fn toward_zero(&self) -> f64 {
        self.to_f64()
    }
    fn digits(&self) -> String {
        self.to_string()
    }
}

impl Number for BigRational {
    fn from_f64(x: f64) -> Option<Self> {
        Self::from_float(x)
    }
    fn from_i64(x: i64) -> Self {
        Self::from_integer(x.into())
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn over(&self, other: &Self) -> Self {
        self / other
    }
    fn sign(&self) -> Ordering {
        self.numer().sign().cmp(&Sign::NoSign)
    }
    fn toward_zero(&self) -> f64 {
        let size = quotient_toward_zero(&self.numer().abs(), self.denom());
        if self.is_negative() { -size } else { size }
    }
    fn digits(&self) -> String {
        self.to_string()
    }
}

/// num/den rounded down to a double, for num >= 0 and den > 0: an integer quotient of exactly 53 bits (fewer among the
/// subnormals) times a power of two.
fn quotient_toward_zero(num: &BigInt, den: &BigInt) -> f64 {
    if num.is_zero() {
        return 0.0;
    }
    let shifted = |shift: i64| -> u64 {
        let quotient = if shift >= 0 { (num << shift as u64) / den } else { num / (den << (-shift) as u64) };
        quotient.to_u64().expect("the shift leaves at most 54 bits")
    };
    let bits = num.bits() as i64 - den.bits() as i64;
    let mut shift = 53 - bits;
    let mut quotient = shifted(shift);
    if quotient >= 1 << 53 {
        shift -= 1;
        quotient = shifted(shift);
    }
    if shift > 1074 {
        shift = 1074;
        quotient = shifted(shift);
    }
    scale(quotient as f64, -shift)
}

/// x * 2^k for x below 2^53, in steps that cannot round: the result is a double or overflows.
fn scale(x: f64, k: i64) -> f64 {
    let half = (k / 2).clamp(-1022, 1022);
    let rest = (k - half).clamp(-1022, 1022);
    x * 2f64.powi(half as i32) * 2f64.powi(rest as i32)
}

#[cfg(test)]
mod tests {
    use super::Number;
    use num_rational::BigRational;
    use proptest::prelude::*;
    use rug::Rational;
    use std::cmp::Ordering;

    fn finite() -> impl Strategy<Value = f64> {
        prop_oneof![
            prop::num::f64::NORMAL,
            prop::num::f64::SUBNORMAL,
            -2.0..2.0,
            (-50i32..50).prop_map(f64::from),
            Just(f64::MAX)
        ]
    }

    /// A few results of the field operations, to the digit and to the double.
    fn workout<Q: Number>(a: f64, b: f64) -> Vec<(String, f64, f64, f64, Ordering)> {
        let (p, q) = (Q::from_f64(a).expect("finite"), Q::from_f64(b).expect("finite"));
        let mut values = vec![p.plus(&q), p.minus(&q), p.times(&q), p.times(&p).minus(&q)];
        if q.sign() != Ordering::Equal {
            values.push(p.over(&q));
            values.push(p.over(&q).plus(&Q::from_i64(3)).over(&q));
        }
        let row = |v: &Q| (v.digits(), v.nearest(), v.enclosure().lo(), v.enclosure().hi(), v.sign());
        values.iter().map(row).collect()
    }

    proptest! {
        #[test]
        fn backends_agree_to_the_digit(a in finite(), b in finite()) {
            prop_assert_eq!(workout::<Rational>(a, b), workout::<BigRational>(a, b));
        }

        #[test]
        fn doubles_survive(a in finite()) {
            prop_assert_eq!(<Rational as Number>::from_f64(a).expect("finite").nearest(), a);
            prop_assert_eq!(<BigRational as Number>::from_f64(a).expect("finite").nearest(), a);
        }

        #[test]
        fn enclosures_are_tight(a in -4.0..4.0, b in 1.0..9.0) {
            let value = <Rational as Number>::from_f64(a).expect("finite") / Rational::from_f64(b).expect("finite");
            let around = value.enclosure();
            prop_assert!(Rational::from_f64(around.lo()).expect("finite") <= value);
            prop_assert!(Rational::from_f64(around.hi()).expect("finite") >= value);
            prop_assert!(around.hi() <= around.lo().next_up());
        }
    }

    #[test]
    fn nearest_breaks_ties_to_even_and_overflows() {
        let ulp = Rational::from((1, 1u64 << 52));
        let half = Rational::from(&ulp / 2);
        let one = Rational::from(1);
        assert_eq!(Rational::from(&one + &half).nearest(), 1.0);
        assert_eq!((one + &ulp + half).nearest(), 1.0 + 2.0 * f64::EPSILON);
        let large = <Rational as Number>::from_f64(f64::MAX).expect("finite");
        assert_eq!(Rational::from(&large * 2).nearest(), f64::INFINITY);
        assert_eq!(<Rational as Number>::from_f64(f64::NAN), None);
    }
}
