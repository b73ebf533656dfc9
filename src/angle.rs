//! Angles of normals as an axis and an offset from it (memo A2).
//!
//! Radians in [0, 2 pi) lose the relative accuracy that the realization of MS 4.2 needs near 180 and 360 degrees (memo
//! fact 4); the offset from the nearest axis keeps it everywhere. All functions go through `libm`, so results do not
//! depend on the platform. Errors are given in eps = 2^-53.

use crate::twofold::{two_sum, twofold_atan};
use glam::DVec2;
use std::cmp::Ordering;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4};
use std::hash::{Hash, Hasher};

/// pi/2 minus its nearest double.
pub(crate) const FRAC_PI_2_LOW: f64 = 6.123_233_995_736_766e-17;

/// The angle of a rightward normal: the nearest axis and the signed offset from it.
///
/// `k` counts axes +x, +y, -x, -y as 0 to 3; the half of axis 0 below it is stored as 4, so the lexicographic
/// order is the order of angles on [0, 360) degrees. Canonical: `off` in (-pi/4, pi/4], never -0.0, and (4, 0) is (0,
/// 0); equality is therefore equality of the pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ang {
    k: u8,
    off: f64,
}

impl Ang {
    /// The normal (1, 0), 0 degrees.
    pub const RIGHT: Self = Self { k: 0, off: 0.0 };
    /// The normal (0, 1), 90 degrees.
    pub const UP: Self = Self { k: 1, off: 0.0 };
    /// The normal (-1, 0), 180 degrees.
    pub const LEFT: Self = Self { k: 2, off: 0.0 };
    /// The normal (0, -1), 270 degrees.
    pub const DOWN: Self = Self { k: 3, off: 0.0 };
    /// The four axes, counter-clockwise from [`Ang::RIGHT`].
    pub const AXES: [Self; 4] = [Self::RIGHT, Self::UP, Self::LEFT, Self::DOWN];

    /// The angle of the direction (nx, ny), to 3 eps of the offset unless that falls below 2^-1022. `None` for the zero
    /// vector and for coordinates that are not finite.
    #[must_use]
    pub fn of_normal(nx: f64, ny: f64) -> Option<Self> {
        Self::of_twofold((nx, 0.0), (ny, 0.0))
    }

    /// The angle of the rightward normal (dy, -dx) of the line from tail to head (memo fact 1, MS 4.1 corrected), as
    /// accurate as [`Ang::of_normal`]: the rounding of the differences is made up for. `None` if the two are equal or
    /// not finite.
    #[must_use]
    pub fn of_line(tail: DVec2, head: DVec2) -> Option<Self> {
        Self::of_twofold(two_sum(head.y, -tail.y), two_sum(tail.x, -head.x))
    }

    fn of_twofold(x: (f64, f64), y: (f64, f64)) -> Option<Self> {
        if !(x.0.is_finite() && y.0.is_finite()) || (x.0 == 0.0 && y.0 == 0.0) {
            return None;
        }
        let minus = |(high, low): (f64, f64)| (-high, -low);
        let (axis, minor, major) = match (x.0.abs() >= y.0.abs(), x.0 > 0.0, y.0 > 0.0) {
            (true, true, _) => (0, y, x),
            (true, false, _) => (2, minus(y), minus(x)),
            (false, _, true) => (1, minus(x), y),
            (false, _, false) => (3, x, minus(y)),
        };
        Some(Self::canonical(axis, twofold_atan(minor, major)))
    }

    /// Axis, 0 to 4.
    #[must_use]
    pub fn axis(self) -> u8 {
        self.k
    }

    /// Offset from the axis in radians.
    #[must_use]
    pub fn offset(self) -> f64 {
        self.off
    }

    /// Whether this is one of [`Ang::AXES`].
    #[must_use]
    pub fn is_axis(self) -> bool {
        self.off == 0.0
    }

    /// This angle plus 180 degrees. Exact.
    #[must_use]
    pub fn opposite(self) -> Self {
        Self::canonical(i32::from(self.k) + 2, self.off)
    }

    /// This angle plus `d` radians, |d| <= pi, the offset right to 2 eps of itself plus 2^-105. Adding a negative `d`
    /// subtracts.
    #[must_use]
    pub fn plus(self, d: f64) -> Self {
        let (sum, error) = two_sum(self.off, d);
        // For the multiples -2 to 2 that occur, the product with pi/2 and (by Sterbenz) the difference are exact.
        let offset = |quarters: f64| (sum - quarters * FRAC_PI_2) + (error - quarters * FRAC_PI_2_LOW);
        let mut quarters = libm::rint(sum * FRAC_2_PI).clamp(-4.0, 4.0);
        if offset(quarters) > FRAC_PI_4 {
            quarters += 1.0;
        } else if offset(quarters) < -FRAC_PI_4 {
            quarters -= 1.0;
        }
        Self::canonical(i32::from(self.k) + quarters as i32, offset(quarters))
    }

    /// The signed turn from this angle to the other in radians, counter-clockwise positive, in (-pi, pi], right to 2
    /// eps of itself plus 2^-105. Exactly pi for opposite angles; the sign is right even where the value rounds to pi.
    #[must_use]
    pub fn turn_to(self, other: Self) -> f64 {
        let (sum, error) = two_sum(other.off, -self.off);
        let quarters = match (other.k + 8 - self.k) % 4 {
            0 => return sum,
            1 => 1.0,
            2 if sum > 0.0 => -2.0,
            2 => 2.0,
            _ => -1.0,
        };
        let (turn, turn_error) = two_sum(quarters * FRAC_PI_2, sum);
        turn + (turn_error + (error + quarters * FRAC_PI_2_LOW))
    }

    /// Half the sum of the two angles taken in [0, 2 pi) (memo A2): the direction halfway between them, or its opposite
    /// when they lie more than 180 degrees apart. The offset is right to 2 eps of itself plus 2^-105, so sines and
    /// cosines stay relatively accurate near all multiples of 90 degrees.
    #[must_use]
    pub fn half_sum(self, other: Self) -> Self {
        let (sum, error) = two_sum(self.off, other.off);
        let eighths = i32::from(self.k) + i32::from(other.k);
        if eighths % 2 == 0 {
            return Self::canonical(eighths / 2, sum / 2.0);
        }
        // An odd multiple of 45 degrees: measure from the nearer of its two axes.
        let (axis, quarter) = if sum > 0.0 { ((eighths + 1) / 2, -1.0) } else { (eighths / 2, 1.0) };
        let (double, double_error) = two_sum(quarter * FRAC_PI_2, sum);
        let offset = (double + (double_error + (error + quarter * FRAC_PI_2_LOW))) / 2.0;
        Self::canonical(axis, offset)
    }

    /// Sine and cosine, each right to 2 eps of itself.
    #[must_use]
    pub fn sin_cos(self) -> (f64, f64) {
        let (s, c) = libm::sincos(self.off);
        match self.k {
            1 => (c, -s),
            2 => (-s, -c),
            3 => (-c, s),
            _ => (s, c),
        }
    }

    /// The unit normal, (cos, sin).
    #[must_use]
    pub fn normal(self) -> DVec2 {
        let (s, c) = self.sin_cos();
        DVec2::new(c, s)
    }

    /// What is left of this angle when it is stored in radians in [0, 2 pi] (memo fact 4): the baseline without the offsets.
    /// Axes stay, and the order of angles, but different ones may become equal.
    #[must_use]
    pub fn rounded_to_radians(self) -> Self {
        Self::canonical(i32::from(self.k), self.radians() - f64::from(self.k) * FRAC_PI_2)
    }

    /// The angle in radians in [0, 2 pi].
    #[must_use]
    pub fn radians(self) -> f64 {
        f64::from(self.k) * FRAC_PI_2 + self.off
    }

    /// The angle at `off` from an axis counted modulo 4, |off| <= pi/4; anything beyond, or NaN, is forced into range.
    fn canonical(axis: i32, off: f64) -> Self {
        let axis = axis.rem_euclid(4) as u8;
        if off > -FRAC_PI_4 {
            let off = off.min(FRAC_PI_4);
            // Adding 0.0 turns -0.0 into +0.0.
            return if axis == 0 && off < 0.0 { Self { k: 4, off } } else { Self { k: axis, off: off + 0.0 } };
        }
        if off.is_nan() { Self { k: axis, off: 0.0 } } else { Self { k: (axis + 3) % 4, off: FRAC_PI_4 } }
    }
}

impl Eq for Ang {}

impl Ord for Ang {
    fn cmp(&self, other: &Self) -> Ordering {
        self.k.cmp(&other.k).then(self.off.total_cmp(&other.off))
    }
}

impl PartialOrd for Ang {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Hash for Ang {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.k.hash(state);
        self.off.to_bits().hash(state);
    }
}
