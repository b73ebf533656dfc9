//! A real number known to lie in an interval, of doubles or of MPFR floats rounded outward (memo I4).
//!
//! Operations of two precisions give the finer one, so constants can be doubles.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use rug::float::Round;
use rug::ops::{AddAssignRound, DivAssignRound, MulAssignRound, SubAssignRound};
use rug::{Float, Rational};

use super::precision::Precision;
use crate::interval::Interval;

/// A real number between two known bounds.
#[derive(Clone, Debug)]
pub enum Real {
    /// Bounds that are doubles.
    Double(Interval),
    /// Lower and upper bound.
    Long(Box<[Float; 2]>),
}

impl Real {
    /// This double, exactly, so that operations on it have the given precision.
    #[must_use]
    pub fn new(x: f64, precision: Precision) -> Self {
        if precision == Precision::DOUBLE {
            return Self::Double(Interval::point(x));
        }
        let float = Float::with_val(precision.bits(), x);
        Self::Long(Box::new([float.clone(), float]))
    }

    /// A rational number known to a precision.
    #[must_use]
    pub fn rational(exact: &Rational, precision: Precision) -> Self {
        let round = |way| Float::with_val_round(precision.bits(), exact, way).0;
        Self::Long(Box::new([round(Round::Down), round(Round::Up)])).rounded(precision)
    }

    /// The greatest double not above any number inside.
    #[must_use]
    pub fn lo(&self) -> f64 {
        match self {
            Self::Double(interval) => interval.lo(),
            Self::Long(bounds) => bounds[0].to_f64_round(Round::Down),
        }
    }

    /// The least double not below any number inside.
    #[must_use]
    pub fn hi(&self) -> f64 {
        match self {
            Self::Double(interval) => interval.hi(),
            Self::Long(bounds) => bounds[1].to_f64_round(Round::Up),
        }
    }

    /// Both bounds as floats of at least this precision.
    #[must_use]
    pub fn floats(&self, precision: Precision) -> [Float; 2] {
        match self {
            Self::Double(interval) => [interval.lo(), interval.hi()].map(|end| Float::with_val(precision.bits(), end)),
            Self::Long(bounds) => {
                bounds.as_ref().each_ref().map(|end| Float::with_val(precision.bits().max(end.prec()), end))
            }
        }
    }

    /// A double near the middle.
    #[must_use]
    pub fn mid(&self) -> f64 {
        Interval::new(self.lo(), self.hi()).mid()
    }

    /// Doubles around it.
    #[must_use]
    pub fn enclosure(&self) -> Interval {
        Interval::new(self.lo(), self.hi())
    }

    /// The sign of every number inside, if they agree.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        match self {
            Self::Double(interval) => interval.sign(),
            Self::Long(bounds) => {
                let [lo, hi] = bounds.as_ref().each_ref().map(|end| end.cmp0());
                match (lo?, hi?) {
                    (Ordering::Greater, _) => Some(Ordering::Greater),
                    (_, Ordering::Less) => Some(Ordering::Less),
                    (Ordering::Equal, Ordering::Equal) => Some(Ordering::Equal),
                    _ => None,
                }
            }
        }
    }

    /// Whether it is certainly positive.
    #[must_use]
    pub fn is_positive(&self) -> bool {
        self.sign() == Some(Ordering::Greater)
    }

    /// Whether it is certainly negative.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.sign() == Some(Ordering::Less)
    }

    /// Whether it is certainly less.
    #[must_use]
    pub fn is_below(&self, other: &Self) -> bool {
        (other - self).is_positive()
    }

    /// Whether its distance to 0 is certainly less than 2^exponent.
    #[must_use]
    pub fn is_within(&self, exponent: i32) -> bool {
        match self {
            Self::Double(interval) => {
                let limit = f64::from(exponent).exp2();
                interval.hi() < limit && interval.lo() > -limit
            }
            // The exponent of a float x is e with |x| in [2^(e-1), 2^e).
            Self::Long(bounds) => {
                bounds.iter().all(|end| end.is_zero() || end.get_exp().is_some_and(|e| e <= exponent))
            }
        }
    }

    /// Bounds of this precision, rounded outward, if it is known more finely than that.
    #[must_use]
    pub fn rounded(&self, precision: Precision) -> Self {
        match self {
            Self::Long(bounds) if precision == Precision::DOUBLE || bounds[0].prec() > precision.bits() => {
                if precision == Precision::DOUBLE {
                    return Self::Double(self.enclosure());
                }
                let [lo, hi] = bounds.as_ref();
                let round = |x, way| Float::with_val_round(precision.bits(), x, way).0;
                Self::Long(Box::new([round(lo, Round::Down), round(hi, Round::Up)]))
            }
            _ => self.clone(),
        }
    }

    /// The square.
    #[must_use]
    pub fn square(&self) -> Self {
        match self {
            Self::Double(interval) => Self::Double(interval.square()),
            Self::Long(_) => {
                let size = self.abs();
                &size * &size
            }
        }
    }

    /// The distance to 0.
    #[must_use]
    pub fn abs(&self) -> Self {
        match self {
            Self::Double(interval) => {
                let other = -*interval;
                Self::Double(Interval::new(interval.lo().max(other.lo()).max(0.0), interval.hi().max(other.hi())))
            }
            Self::Long(bounds) => {
                let [lo, hi] = bounds.as_ref();
                if *lo >= 0 {
                    return self.clone();
                }
                let least = if *hi <= 0 { Float::clone(hi).abs() } else { Float::new(hi.prec()) };
                let greatest = lo.clone().abs().max(hi);
                Self::Long(Box::new([least, greatest]))
            }
        }
    }

    /// The square root of the part that is not negative.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        match self {
            Self::Double(interval) => Self::Double(interval.sqrt()),
            Self::Long(bounds) => {
                let [mut lo, mut hi] = bounds.as_ref().clone();
                let zero = Float::new(lo.prec());
                lo = lo.max(&zero);
                hi = hi.max(&zero);
                lo.sqrt_round(Round::Down);
                hi.sqrt_round(Round::Up);
                Self::Long(Box::new([lo, hi]))
            }
        }
    }

    /// The smaller of a number from each.
    #[must_use]
    pub fn min(&self, other: &Self) -> Self {
        -&(-self).max(&-other)
    }

    /// The larger of a number from each.
    #[must_use]
    pub fn max(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Double(a), Self::Double(b)) => Self::Double(a.max(*b)),
            (Self::Long(a), Self::Long(b)) => Self::Long(Box::new([0, 1].map(|i| a[i].clone().max(&b[i])))),
            _ => {
                let (a, b) = self.level(other);
                a.max(&b)
            }
        }
    }

    /// The smallest interval around both.
    #[must_use]
    pub fn hull(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Double(a), Self::Double(b)) => Self::Double(a.hull(*b)),
            (Self::Long(a), Self::Long(b)) => Self::Long(Box::new([a[0].clone().min(&b[0]), a[1].clone().max(&b[1])])),
            _ => {
                let (a, b) = self.level(other);
                a.hull(&b)
            }
        }
    }

    /// Both at the finer precision.
    fn level(&self, other: &Self) -> (Self, Self) {
        let bits = |x: &Self| match x {
            Self::Double(_) => 0,
            Self::Long(bounds) => bounds[0].prec(),
        };
        let finer = bits(self).max(bits(other));
        let raise = |x: &Self| match x {
            Self::Double(interval) => {
                Self::Long(Box::new([interval.lo(), interval.hi()].map(|end| Float::with_val(finer, end))))
            }
            Self::Long(bounds) => Self::Long(bounds.clone()),
        };
        (raise(self), raise(other))
    }
}

impl From<f64> for Real {
    fn from(x: f64) -> Self {
        Self::Double(Interval::point(x))
    }
}

impl From<Float> for Real {
    fn from(x: Float) -> Self {
        Self::Long(Box::new([x.clone(), x]))
    }
}

impl Neg for &Real {
    type Output = Real;
    fn neg(self) -> Real {
        match self {
            Real::Double(interval) => Real::Double(-*interval),
            Real::Long(bounds) => {
                let [lo, hi] = bounds.as_ref().clone();
                Real::Long(Box::new([-hi, -lo]))
            }
        }
    }
}

/// The finer of two precisions, in bits.
fn finer(a: &[Float; 2], b: &[Float; 2]) -> u32 {
    a[0].prec().max(b[0].prec())
}

/// A copy of this precision; exact, since precisions only grow.
fn copy(x: &Float, bits: u32) -> Float {
    Float::with_val(bits, x)
}

fn add_long(a: &[Float; 2], b: &[Float; 2]) -> [Float; 2] {
    let bits = finer(a, b);
    let [mut lo, mut hi] = [copy(&a[0], bits), copy(&a[1], bits)];
    lo.add_assign_round(&b[0], Round::Down);
    hi.add_assign_round(&b[1], Round::Up);
    [lo, hi]
}

fn sub_long(a: &[Float; 2], b: &[Float; 2]) -> [Float; 2] {
    let bits = finer(a, b);
    let [mut lo, mut hi] = [copy(&a[0], bits), copy(&a[1], bits)];
    lo.sub_assign_round(&b[1], Round::Down);
    hi.sub_assign_round(&b[0], Round::Up);
    [lo, hi]
}

/// The bounds of x*y for x and y among these ends.
fn times(bits: u32, down: (&Float, &Float), up: (&Float, &Float)) -> [Float; 2] {
    let [mut lo, mut hi] = [copy(down.0, bits), copy(up.0, bits)];
    lo.mul_assign_round(down.1, Round::Down);
    hi.mul_assign_round(up.1, Round::Up);
    [lo, hi]
}

fn mul_long(a: &[Float; 2], b: &[Float; 2]) -> [Float; 2] {
    let bits = finer(a, b);
    let ([al, ah], [bl, bh]) = (a, b);
    let zero = |x: &Float| *x >= 0;
    match (zero(al), *ah <= 0, zero(bl), *bh <= 0) {
        (true, _, true, _) => times(bits, (al, bl), (ah, bh)),
        (true, _, _, true) => times(bits, (ah, bl), (al, bh)),
        (true, ..) => times(bits, (ah, bl), (ah, bh)),
        (_, true, true, _) => times(bits, (al, bh), (ah, bl)),
        (_, true, _, true) => times(bits, (ah, bh), (al, bl)),
        (_, true, ..) => times(bits, (al, bh), (al, bl)),
        (_, _, true, _) => times(bits, (al, bh), (ah, bh)),
        (_, _, _, true) => times(bits, (ah, bl), (al, bl)),
        _ => {
            let [lo, hi] = times(bits, (al, bh), (al, bl));
            let [lo2, hi2] = times(bits, (ah, bl), (ah, bh));
            [lo.min(&lo2), hi.max(&hi2)]
        }
    }
}

fn div_long(a: &[Float; 2], b: &[Float; 2]) -> [Float; 2] {
    let bits = finer(a, b);
    if b[0] <= 0 && b[1] >= 0 {
        let infinity = Float::with_val(bits, f64::INFINITY);
        return [-infinity.clone(), infinity];
    }
    let ends = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| {
        let [mut lo, mut hi] = [copy(&a[i], bits), copy(&a[i], bits)];
        lo.div_assign_round(&b[j], Round::Down);
        hi.div_assign_round(&b[j], Round::Up);
        [lo, hi]
    });
    let [first, rest @ ..] = ends;
    rest.into_iter().fold(first, |[lo, hi], [l, h]| [lo.min(&l), hi.max(&h)])
}

macro_rules! operator {
    ($trait:ident, $method:ident, $long:ident, $sign:tt) => {
        impl $trait<&Real> for &Real {
            type Output = Real;
            fn $method(self, other: &Real) -> Real {
                match (self, other) {
                    (Real::Double(a), Real::Double(b)) => Real::Double(*a $sign *b),
                    (Real::Long(a), Real::Long(b)) => Real::Long(Box::new($long(a, b))),
                    _ => {
                        let (a, b) = self.level(other);
                        &a $sign &b
                    }
                }
            }
        }
        impl $trait<Real> for Real {
            type Output = Real;
            fn $method(self, other: Real) -> Real {
                &self $sign &other
            }
        }
        impl $trait<&Real> for Real {
            type Output = Real;
            fn $method(self, other: &Real) -> Real {
                &self $sign other
            }
        }
        impl $trait<Real> for &Real {
            type Output = Real;
            fn $method(self, other: Real) -> Real {
                self $sign &other
            }
        }
        impl $trait<f64> for &Real {
            type Output = Real;
            fn $method(self, other: f64) -> Real {
                self $sign &Real::from(other)
            }
        }
        impl $trait<f64> for Real {
            type Output = Real;
            fn $method(self, other: f64) -> Real {
                &self $sign &Real::from(other)
            }
        }
    };
}

operator!(Add, add, add_long, +);
operator!(Sub, sub, sub_long, -);
operator!(Mul, mul, mul_long, *);
operator!(Div, div, div_long, /);

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use rug::Rational;

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![-4.0..4.0f64, (-8..9i32).prop_map(f64::from), (-4.0..4.0f64).prop_map(|x| x * 1e-20)]
    }

    /// An interval of each precision with both ends given, and the ends.
    fn interval(ends: (f64, f64), precision: Precision) -> Real {
        Real::new(ends.0.min(ends.1), precision).hull(&Real::new(ends.0.max(ends.1), precision))
    }

    fn contains(real: &Real, exact: &Rational) -> bool {
        match real {
            Real::Double(i) => {
                Rational::from_f64(i.lo()).unwrap() <= *exact && Rational::from_f64(i.hi()).unwrap() >= *exact
            }
            Real::Long(bounds) => bounds[0] <= *exact && bounds[1] >= *exact,
        }
    }

    proptest! {
        #[test]
        fn results_of_members_are_members(
            a in (number(), number()), b in (number(), number()), s in 0.0..=1.0f64, t in 0.0..=1.0f64, rung in 0usize..3
        ) {
            let precision = Precision::LADDER[rung];
            let (x, y) = (interval(a, precision), interval(b, precision));
            let member = |(p, q): (f64, f64), s: f64| {
                let [p, q, s] = [p, q, s].map(|z| Rational::from_f64(z).unwrap());
                Rational::from(&q - &p) * s + p
            };
            let (p, q) = (member(a, s), member(b, t));
            prop_assert!(contains(&(&x + &y), &Rational::from(&p + &q)));
            prop_assert!(contains(&(&x - &y), &Rational::from(&p - &q)));
            prop_assert!(contains(&(&x * &y), &Rational::from(&p * &q)));
            prop_assert!(contains(&-&x, &Rational::from(-&p)));
            prop_assert!(contains(&x.abs(), &p.clone().abs()));
            prop_assert!(contains(&x.square(), &Rational::from(&p * &p)));
            prop_assert!(contains(&x.max(&y), &p.clone().max(q.clone())));
            prop_assert!(contains(&x.min(&y), &p.clone().min(q.clone())));
            let root = x.square().sqrt();
            prop_assert!(contains(&root, &p.clone().abs()));
            if q != 0 && y.sign().is_some() {
                prop_assert!(contains(&(&x / &y), &Rational::from(&p / &q)));
            }
            if let Some(sign) = x.sign() {
                prop_assert_eq!(sign, p.cmp0());
            }
        }

        #[test]
        fn operations_on_one_number_are_sharp(a in number(), b in number()) {
            let precision = Precision::LADDER[2];
            let (x, y) = (Real::new(a, precision), Real::new(b, precision));
            // Doubles of this range have exact sums and products of 256 bits.
            for exact in [&x + &y, &x - &y, &x * &y] {
                let Real::Long(bounds) = exact else { panic!("long operands") };
                prop_assert!(bounds[0] == bounds[1]);
            }
            if b != 0.0 {
                let quotient = &x / &y;
                prop_assert!((&(&quotient * &y) - &x).is_within(-240));
            }
        }
    }

    #[test]
    fn a_mixed_operation_is_as_fine_as_its_finer_operand() {
        let third = Real::new(1.0, Precision::LADDER[3]) / 3.0;
        assert!((&third * 3.0 - 1.0).is_within(-500));
        assert!(!(Real::from(1.0) / 3.0 * 3.0 - 1.0).is_within(-60));
    }
}
