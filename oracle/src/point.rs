//! Exact points and the predicates on them, each decided by intervals where they suffice and exactly otherwise.

use std::cmp::Ordering;

use crate::interval::Interval;
use crate::number::Number;

/// A point with exact coordinates, in input units; ordered by abscissa, then ordinate.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Point<Q> {
    /// Abscissa.
    pub x: Q,
    /// Ordinate.
    pub y: Q,
}

impl<Q: Number> Point<Q> {
    /// The point of two finite doubles; `None` if one is not finite.
    #[must_use]
    pub fn from_f64(x: f64, y: f64) -> Option<Self> {
        Some(Self { x: Q::from_f64(x)?, y: Q::from_f64(y)? })
    }

    /// `self + other` as vectors.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self { x: self.x.plus(&other.x), y: self.y.plus(&other.y) }
    }

    /// `self - other` as vectors.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        Self { x: self.x.minus(&other.x), y: self.y.minus(&other.y) }
    }

    /// The vector scaled by `factor`.
    #[must_use]
    pub fn times(&self, factor: &Q) -> Self {
        Self { x: self.x.times(factor), y: self.y.times(factor) }
    }

    /// The cross product `self.x * other.y - self.y * other.x`.
    #[must_use]
    pub fn cross(&self, other: &Self) -> Q {
        self.x.times(&other.y).minus(&self.y.times(&other.x))
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(&self, other: &Self) -> Q {
        self.x.times(&other.x).plus(&self.y.times(&other.y))
    }

    /// The point `self + t (to - self)`.
    #[must_use]
    pub fn toward(&self, to: &Self, t: &Q) -> Self {
        self.plus(&to.minus(self).times(t))
    }

    /// The nearest doubles.
    #[must_use]
    pub fn nearest(&self) -> (f64, f64) {
        (self.x.nearest(), self.y.nearest())
    }
}

/// An exact point together with intervals around its coordinates.
#[derive(Clone, Debug)]
pub struct Place<Q> {
    /// The point.
    pub exact: Point<Q>,
    /// An interval around the abscissa.
    pub x: Interval,
    /// An interval around the ordinate.
    pub y: Interval,
}

impl<Q: Number> From<Point<Q>> for Place<Q> {
    fn from(exact: Point<Q>) -> Self {
        Self { x: exact.x.enclosure(), y: exact.y.enclosure(), exact }
    }
}

impl<Q: Number> Place<Q> {
    /// How the places compare by abscissa, then ordinate.
    #[must_use]
    pub fn order(&self, other: &Self) -> Ordering {
        let x = self.x.compare(other.x).unwrap_or_else(|| self.exact.x.cmp(&other.exact.x));
        x.then_with(|| self.compare_y(other))
    }

    /// How the ordinates compare.
    #[must_use]
    pub fn compare_y(&self, other: &Self) -> Ordering {
        self.y.compare(other.y).unwrap_or_else(|| self.exact.y.cmp(&other.exact.y))
    }

    /// An interval around the vector to `head`.
    #[must_use]
    pub fn step(&self, head: &Self) -> (Interval, Interval) {
        (head.x - self.x, head.y - self.y)
    }
}

/// An interval around twice the signed area of the triangle a, b, c.
#[must_use]
pub fn area_interval<Q: Number>(a: &Place<Q>, b: &Place<Q>, c: &Place<Q>) -> Interval {
    let ((bx, by), (cx, cy)) = (a.step(b), a.step(c));
    bx * cy - by * cx
}

/// Twice the signed area of the triangle a, b, c.
#[must_use]
pub fn area_exact<Q: Number>(a: &Point<Q>, b: &Point<Q>, c: &Point<Q>) -> Q {
    b.minus(a).cross(&c.minus(a))
}

/// On which side of the line from a to b the point c lies: `Greater` on the left.
#[must_use]
pub fn orient<Q: Number>(a: &Place<Q>, b: &Place<Q>, c: &Place<Q>) -> Ordering {
    area_interval(a, b, c).sign().unwrap_or_else(|| area_exact(&a.exact, &b.exact, &c.exact).sign())
}

/// The sign of the cross product of the vectors a→b and c→d.
#[must_use]
pub fn cross_sign<Q: Number>(a: &Place<Q>, b: &Place<Q>, c: &Place<Q>, d: &Place<Q>) -> Ordering {
    let ((ux, uy), (vx, vy)) = (a.step(b), c.step(d));
    let exact = || b.exact.minus(&a.exact).cross(&d.exact.minus(&c.exact)).sign();
    (ux * vy - uy * vx).sign().unwrap_or_else(exact)
}

/// The sign of the scalar product of the vectors a→b and c→d.
#[must_use]
pub fn dot_sign<Q: Number>(a: &Place<Q>, b: &Place<Q>, c: &Place<Q>, d: &Place<Q>) -> Ordering {
    let ((ux, uy), (vx, vy)) = (a.step(b), c.step(d));
    let exact = || b.exact.minus(&a.exact).dot(&d.exact.minus(&c.exact)).sign();
    (ux * vx + uy * vy).sign().unwrap_or_else(exact)
}
