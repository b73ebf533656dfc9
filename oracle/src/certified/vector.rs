//! Points and vectors with interval coordinates.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use super::precision::Precision;
use super::real::Real;

/// A point or vector, in input units.
#[derive(Clone, Debug)]
pub struct Vector {
    /// Abscissa.
    pub x: Real,
    /// Ordinate.
    pub y: Real,
}

impl Vector {
    /// The vector of two doubles, exactly, for operations of this precision.
    #[must_use]
    pub fn new(x: f64, y: f64, precision: Precision) -> Self {
        Self { x: Real::new(x, precision), y: Real::new(y, precision) }
    }

    /// The cross product `self.x * other.y - self.y * other.x`.
    #[must_use]
    pub fn cross(&self, other: &Self) -> Real {
        &self.x * &other.y - &self.y * &other.x
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(&self, other: &Self) -> Real {
        &self.x * &other.x + &self.y * &other.y
    }

    /// The squared length.
    #[must_use]
    pub fn square(&self) -> Real {
        self.x.square() + self.y.square()
    }

    /// The length.
    #[must_use]
    pub fn length(&self) -> Real {
        self.square().sqrt()
    }

    /// The vector of length 1 in this direction.
    #[must_use]
    pub fn unit(&self) -> Self {
        let length = self.length();
        Self { x: &self.x / &length, y: &self.y / &length }
    }

    /// Turned left by a right angle.
    #[must_use]
    pub fn left(&self) -> Self {
        Self { x: -&self.y, y: self.x.clone() }
    }

    /// The distance to a point.
    #[must_use]
    pub fn distance(&self, other: &Self) -> Real {
        (self - other).length()
    }

    /// The point `self + t (to - self)`.
    #[must_use]
    pub fn toward(&self, to: &Self, t: &Real) -> Self {
        self + &(&(to - self) * t)
    }

    /// Doubles near both coordinates.
    #[must_use]
    pub fn nearest(&self) -> (f64, f64) {
        (self.x.mid(), self.y.mid())
    }

    /// How the directions of two vectors within half a turn compare: `Greater` if `other` is to the left.
    #[must_use]
    pub fn turn(&self, other: &Self) -> Option<Ordering> {
        self.cross(other).sign()
    }
}

impl Add for &Vector {
    type Output = Vector;
    fn add(self, other: Self) -> Vector {
        Vector { x: &self.x + &other.x, y: &self.y + &other.y }
    }
}

impl Sub for &Vector {
    type Output = Vector;
    fn sub(self, other: Self) -> Vector {
        Vector { x: &self.x - &other.x, y: &self.y - &other.y }
    }
}

impl Neg for &Vector {
    type Output = Vector;
    fn neg(self) -> Vector {
        Vector { x: -&self.x, y: -&self.y }
    }
}

impl Mul<&Real> for &Vector {
    type Output = Vector;
    fn mul(self, factor: &Real) -> Vector {
        Vector { x: &self.x * factor, y: &self.y * factor }
    }
}

/// The sector of a vector by the signs of its coordinates: twice the index of an axis (right, up, left, down) for the axis
/// itself, one more for the open quadrant after it. The vector 0 counts as right.
#[must_use]
pub fn sector(x: Ordering, y: Ordering) -> usize {
    use Ordering::{Equal, Greater, Less};
    match (x, y) {
        (Greater | Equal, Equal) => 0,
        (Greater, Greater) => 1,
        (Equal, Greater) => 2,
        (Less, Greater) => 3,
        (Less, Equal) => 4,
        (Less, Less) => 5,
        (Equal, Less) => 6,
        (Greater, Less) => 7,
    }
}
