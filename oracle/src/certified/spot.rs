//! A point that is computed when it is asked for, at the precision that is asked for.

use std::fmt;
use std::sync::Arc;

use super::precision::Precision;
use super::real::Real;
use super::vector::Vector;
use crate::point::Point;
use rug::Rational;

/// Intervals of doubles this short are as good as any: coordinates are about 1.
const SHORT: f64 = 1e-12;

/// How a point follows from the numbers of the case.
type Recipe = Arc<dyn Fn(Precision) -> Vector + Send + Sync>;

/// A point at every precision of the ladder. Nothing is kept, so ask once per question and precision.
#[derive(Clone)]
pub struct Spot {
    recipe: Recipe,
}

impl Spot {
    /// The point that this recipe gives. At every precision it must be the same point of the plane.
    pub fn new(recipe: impl Fn(Precision) -> Vector + Send + Sync + 'static) -> Self {
        Self { recipe: Arc::new(recipe) }
    }

    /// The point of these two doubles.
    #[must_use]
    pub fn exact(x: f64, y: f64) -> Self {
        Self::new(move |p| Vector::new(x, y, p))
    }

    /// The point of these two rational numbers.
    #[must_use]
    pub fn rational(point: &Point<Rational>) -> Self {
        let Point { x, y } = point.clone();
        Self::new(move |p| Vector { x: Real::rational(&x, p), y: Real::rational(&y, p) })
    }

    /// The point in intervals of doubles, computed as finely as it takes to make them short: a direction within it may not
    /// be known in doubles at all.
    #[must_use]
    pub fn rough(&self) -> Vector {
        let rough = |precision| {
            let place = self.at(precision);
            Vector { x: place.x.rounded(Precision::DOUBLE), y: place.y.rounded(Precision::DOUBLE) }
        };
        let is_short = |x: &Real| x.hi() - x.lo() < SHORT;
        let [first, second, third, ..] = Precision::LADDER;
        let short = [first, second].into_iter().map(rough).find(|place| is_short(&place.x) && is_short(&place.y));
        short.unwrap_or_else(|| rough(third))
    }

    /// The point known to this precision.
    #[must_use]
    pub fn at(&self, precision: Precision) -> Vector {
        (self.recipe)(precision)
    }
}

impl fmt::Debug for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.at(Precision::DOUBLE).fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spot_is_as_fine_as_it_is_asked_for() {
        let unit = Spot::new(|p| Vector::new(2.0, 1.0, p).unit());
        let excess = |p| unit.at(p).square() - 1.0;
        assert!(excess(Precision::LADDER[2]).is_within(-240) && !excess(Precision::DOUBLE).is_within(-60));
        // The direction of a chord of 2^-70 from 1/3 to 1/3 + 2^-70 is lost in doubles.
        let third = |p| Real::new(1.0, p) / Real::new(3.0, p);
        let step = Spot::new(move |p| {
            let chord = (third(p) + f64::from(-70).exp2()) - third(p);
            Vector { x: chord.clone(), y: chord }.unit()
        });
        assert!(!step.at(Precision::DOUBLE).x.hi().is_finite() && step.rough().x.is_within(0));
        let exact = Spot::exact(0.1, -3.0).at(Precision::LADDER[1]);
        assert_eq!((exact.x.lo(), exact.x.hi(), exact.y.lo()), (0.1, 0.1, -3.0));
    }
}
