//! The exact orientation of three points, by floating-point expansions behind an error bound (Shewchuk, *Adaptive
//! precision floating-point arithmetic and fast robust geometric predicates*, 1997).
//!
//! # Range
//!
//! The predicate is exact for points on a [`Grid`]: every coordinate is a multiple of 2^-480 and smaller than 2^420.
//! Then differences are multiples of 2^-480 below 2^421, products of two of them are zero or at least 2^-960 and below
//! 2^842, and the sum of six such products stays below 2^845: nothing overflows. Nothing underflows either: a product of
//! two grid numbers and its rounding error are multiples of 2^-960, above the 2^-969 that [`two_product`] asks for, and
//! the filter's bound, at least 2^-960 times 2^-52, is a normal number. A set of coordinates whose bits spread over at
//! most [`MAX_SPREAD`] binary digits is brought onto the grid by one power of two, exactly.

use crate::twofold::{two_product, two_sum};
use glam::DVec2;
use std::cmp::Ordering;

/// The greatest number of binary digits from the highest to the lowest bit of a set of coordinates.
pub const MAX_SPREAD: i32 = 900;

/// The exponent of the finest bit a coordinate on the grid may have.
const FINEST: i32 = -480;

/// A power of two that brings coordinates into the range where [`orientation`] is exact. Where possible it brings them
/// into the unit box, so that floating-point work on them is far from overflow as well.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    shift: i32,
}

impl Grid {
    /// The grid of these finite coordinates; `Err` is the number of binary digits they spread over, when these are more
    /// than [`MAX_SPREAD`].
    pub fn of(coordinates: impl IntoIterator<Item = f64>) -> Result<Self, i32> {
        let nonzero = coordinates.into_iter().filter(|&c| c != 0.0);
        let bits = nonzero.map(bits).reduce(|(low, top), (l, t)| (low.min(l), top.max(t)));
        let (low, top) = bits.unwrap_or((0, 0));
        match top - low {
            spread if spread > MAX_SPREAD => Err(spread),
            _ => Ok(Self { shift: (-top).max(FINEST - low) }),
        }
    }

    /// The coordinate on the grid. Exact for the coordinates the grid was made of.
    #[must_use]
    pub fn scale(self, coordinate: f64) -> f64 {
        libm::ldexp(coordinate, self.shift)
    }

    /// The point on the grid, likewise.
    #[must_use]
    pub fn scale_point(self, x: f64, y: f64) -> DVec2 {
        // Adding zero turns -0.0 into 0.0, so that equal points have equal bits.
        DVec2::new(self.scale(x) + 0.0, self.scale(y) + 0.0)
    }

    /// The point in the units the grid was made from.
    #[must_use]
    pub fn unscale_point(self, point: DVec2) -> DVec2 {
        DVec2::new(libm::ldexp(point.x, -self.shift), libm::ldexp(point.y, -self.shift))
    }
}

/// The exponent of the lowest set bit of a nonzero finite number, and one more than that of the highest.
fn bits(value: f64) -> (i32, i32) {
    let biased = ((value.to_bits() >> 52) & 0x7ff) as i32;
    let fraction = value.to_bits() & ((1 << 52) - 1);
    let (mantissa, exponent) = if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
    (exponent + mantissa.trailing_zeros() as i32, exponent + 64 - mantissa.leading_zeros() as i32)
}

/// On which side of the line from `a` to `b` the point `c` lies: `Greater` on the left, `Less` on the right, `Equal` on
/// the line. Exact for points on one [`Grid`].
#[must_use]
pub fn orientation(a: DVec2, b: DVec2, c: DVec2) -> Ordering {
    // Shewchuk's ccwerrboundA, (3 + 16 eps) eps.
    const BOUND: f64 = 3.330_669_073_875_471_6e-16;
    let left = (a.x - c.x) * (b.y - c.y);
    let right = (a.y - c.y) * (b.x - c.x);
    let det = left - right;
    if det.abs() > BOUND * (left.abs() + right.abs()) { sign(det) } else { exact_orientation(a, b, c) }
}

/// The sign of a.x b.y - a.x c.y - c.x b.y - a.y b.x + a.y c.x + c.y b.x, in which the products of c by itself cancelled.
fn exact_orientation(a: DVec2, b: DVec2, c: DVec2) -> Ordering {
    let products = [(a.x, b.y), (-a.x, c.y), (-c.x, b.y), (-a.y, b.x), (a.y, c.x), (c.y, b.x)];
    let mut expansion = Expansion::default();
    for (x, y) in products {
        let (p, error) = two_product(x, y);
        expansion.add(error);
        expansion.add(p);
    }
    expansion.sign()
}

/// A sum of up to twelve doubles, exact: nonoverlapping components from least to greatest (Shewchuk, theorem 10).
#[derive(Default)]
struct Expansion {
    components: [f64; 12],
    len: usize,
}

impl Expansion {
    fn add(&mut self, term: f64) {
        let mut carry = term;
        for component in &mut self.components[..self.len] {
            (carry, *component) = two_sum(carry, *component);
        }
        self.components[self.len] = carry;
        self.len += 1;
    }

    /// The sign of the greatest nonzero component, which exceeds the sum of all smaller ones.
    fn sign(&self) -> Ordering {
        self.components.iter().rev().find(|&&c| c != 0.0).map_or(Ordering::Equal, |&c| sign(c))
    }
}

fn sign(value: f64) -> Ordering {
    value.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}
