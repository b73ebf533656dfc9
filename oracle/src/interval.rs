//! Intervals of doubles with outward rounding: the filter in front of every exact decision.
//!
//! Each operation returns an interval that contains every result its operands allow. The rounding error of a single
//! operation is recovered exactly (TwoSum, fused multiply-add), so an endpoint moves outward only when the operation
//! was inexact: on small integers the intervals stay points and decide ties without rational arithmetic.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Below this size a product or quotient may lose its error term to underflow, so it is widened without asking.
const TINY: f64 = 1e-280;

/// A closed interval of reals, possibly with infinite ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

impl Interval {
    /// The whole line.
    pub const ALL: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
    /// The number zero.
    pub const ZERO: Self = Self { lo: 0.0, hi: 0.0 };

    /// The interval from `lo` to `hi`; the whole line if they are not in order or not numbers.
    #[must_use]
    pub fn new(lo: f64, hi: f64) -> Self {
        if lo <= hi { Self { lo, hi } } else { Self::ALL }
    }

    /// The interval of one number.
    #[must_use]
    pub fn point(x: f64) -> Self {
        Self::new(x, x)
    }

    /// The lower end.
    #[must_use]
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// The upper end.
    #[must_use]
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// A double inside, near the middle.
    #[must_use]
    pub fn mid(self) -> f64 {
        (0.5 * self.lo + 0.5 * self.hi).clamp(self.lo, self.hi)
    }

    /// The sign of every number inside, if they agree.
    #[must_use]
    pub fn sign(self) -> Option<Ordering> {
        if self.lo > 0.0 {
            Some(Ordering::Greater)
        } else if self.hi < 0.0 {
            Some(Ordering::Less)
        } else if self.lo == 0.0 && self.hi == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    /// How every number inside compares with every number of `other`, if they agree.
    #[must_use]
    pub fn compare(self, other: Self) -> Option<Ordering> {
        if self.lo > other.hi {
            Some(Ordering::Greater)
        } else if self.hi < other.lo {
            Some(Ordering::Less)
        } else if self.lo == self.hi && self == other {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    /// The smallest interval containing both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The maximum of a number from each.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The minimum of a number from each.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.min(other.hi) }
    }

    /// The squares.
    #[must_use]
    pub fn square(self) -> Self {
        let (small, large) = if self.lo >= 0.0 {
            (self.lo, self.hi)
        } else if self.hi <= 0.0 {
            (-self.hi, -self.lo)
        } else {
            (0.0, self.hi.max(-self.lo))
        };
        Self { lo: mul_down(small, small), hi: -mul_down(-large, large) }
    }

    /// The square roots of the part that is not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        Self { lo: sqrt_down(self.lo.max(0.0)), hi: sqrt_up(self.hi.max(0.0)) }
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { lo: add_down(self.lo, other.lo), hi: -add_down(-self.hi, -other.hi) }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let corners = [(self.lo, other.lo), (self.lo, other.hi), (self.hi, other.lo), (self.hi, other.hi)];
        let mut lo = f64::INFINITY;
        let mut minus_hi = f64::INFINITY;
        for (a, b) in corners {
            lo = lo.min(mul_down(a, b));
            minus_hi = minus_hi.min(mul_down(-a, b));
        }
        Self { lo, hi: 0.0 - minus_hi }
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.lo <= 0.0 && other.hi >= 0.0 {
            return Self::ALL;
        }
        let corners = [(self.lo, other.lo), (self.lo, other.hi), (self.hi, other.lo), (self.hi, other.hi)];
        let mut lo = f64::INFINITY;
        let mut minus_hi = f64::INFINITY;
        for (a, b) in corners {
            lo = lo.min(div_down(a, b));
            minus_hi = minus_hi.min(div_down(-a, b));
        }
        Self { lo, hi: 0.0 - minus_hi }
    }
}

/// A lower bound of a+b: the sum itself when it is exact or was rounded down.
fn add_down(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if !sum.is_finite() {
        return lower_of_overflow(sum);
    }
    let part = sum - a;
    let error = (a - (sum - part)) + (b - part);
    if error >= 0.0 { sum } else { sum.next_down() }
}

/// A lower bound of a*b, where 0 times an unbounded end is 0.
fn mul_down(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        return 0.0;
    }
    let product = a * b;
    if !product.is_finite() {
        return lower_of_overflow(product);
    }
    if product.abs() >= TINY && a.mul_add(b, -product) >= 0.0 { product } else { product.next_down() }
}

/// A lower bound of a/b for b not 0.
fn div_down(a: f64, b: f64) -> f64 {
    if a == 0.0 {
        return 0.0;
    }
    let quotient = a / b;
    if !quotient.is_finite() {
        return lower_of_overflow(quotient);
    }
    if quotient.abs() < TINY || a.abs() < TINY {
        return quotient.next_down();
    }
    let rest = (-quotient).mul_add(b, a);
    if rest == 0.0 || (rest > 0.0) == (b > 0.0) { quotient } else { quotient.next_down() }
}

fn sqrt_down(x: f64) -> f64 {
    let root = x.sqrt();
    if x >= TINY && x.is_finite() && (-root).mul_add(root, x) >= 0.0 { root } else { root.next_down().max(0.0) }
}

fn sqrt_up(x: f64) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    let root = x.sqrt();
    if x >= TINY && x.is_finite() && (-root).mul_add(root, x) <= 0.0 { root } else { root.next_up() }
}

/// A lower bound where rounding gave an infinity or not a number.
fn lower_of_overflow(x: f64) -> f64 {
    if x == f64::INFINITY { f64::MAX } else { f64::NEG_INFINITY }
}

#[cfg(test)]
mod tests {
    use super::Interval;
    use proptest::prelude::*;
    use rug::Rational;

    fn exact(x: f64) -> Rational {
        Rational::from_f64(x).expect("finite")
    }

    fn contains(i: Interval, x: &Rational) -> bool {
        (i.lo().is_infinite() || exact(i.lo()) <= *x) && (i.hi().is_infinite() || exact(i.hi()) >= *x)
    }

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            -4.0..4.0,
            (-8i32..8).prop_map(f64::from),
            prop::num::f64::NORMAL,
            prop::num::f64::SUBNORMAL,
            Just(0.0)
        ]
    }

    proptest! {
        #[test]
        fn results_contain_the_exact_value(a in number(), b in number()) {
            let (x, y) = (Interval::point(a), Interval::point(b));
            let (p, q) = (exact(a), exact(b));
            prop_assert!(contains(x + y, &Rational::from(&p + &q)));
            prop_assert!(contains(x - y, &Rational::from(&p - &q)));
            prop_assert!(contains(x * y, &Rational::from(&p * &q)));
            prop_assert!(contains(x.square(), &Rational::from(&p * &p)));
            if b != 0.0 {
                prop_assert!(contains(x / y, &Rational::from(&p / &q)));
            }
            let root = Interval::point(a.abs()).sqrt();
            let size = exact(a.abs());
            prop_assert!(exact(root.lo()).square() <= size && size <= exact(root.hi()).square());
        }

        #[test]
        fn products_of_wide_intervals_contain_products_of_members(
            a in -9.0..9.0f64, b in 0.0..3.0f64, c in -9.0..9.0f64, d in 0.0..3.0f64, s in 0.0..=1.0f64, t in 0.0..=1.0f64
        ) {
            let (x, y) = (Interval::new(a, a + b), Interval::new(c, c + d));
            let (p, q) = ((a + s * b).clamp(x.lo(), x.hi()), (c + t * d).clamp(y.lo(), y.hi()));
            prop_assert!(contains(x * y, &(exact(p) * exact(q))));
            prop_assert!(contains(x - y, &(exact(p) - exact(q))));
            prop_assert!(contains(x.square(), &exact(p).square()));
            if y.sign().is_some() && q != 0.0 {
                prop_assert!(contains(x / y, &(exact(p) / exact(q))));
            }
        }

        #[test]
        fn small_integers_stay_points(a in -1000i32..1000, b in -1000i32..1000) {
            let (x, y) = (Interval::point(a.into()), Interval::point(b.into()));
            prop_assert_eq!(x * y - y * x, Interval::ZERO);
            prop_assert_eq!((x + y).lo(), (x + y).hi());
        }
    }
}
