//! A monotone line or circle segment as exact numbers: its ordinate over an abscissa and the distance of a point from it,
//! as certified intervals. No centre and no radius are formed, so nothing is lost where it is nearly straight (memo C1).

use crate::certified::precision::Precision;
use crate::certified::real::Real;
use rug::Float;
use rug::float::Round;

/// The finest precision that is needed: doubles cancel to no more than 2^-150 here.
pub const FINE: Precision = Precision::LADDER[2];

/// An x- and y-monotone curve whose ends and half sweep are taken literally.
#[derive(Clone, Debug)]
pub struct Strand {
    /// The left end.
    pub left: [f64; 2],
    /// The right end.
    pub right: [f64; 2],
    /// Half the sweep from left to right in radians, positive if it bends upwards, 0 for a line.
    pub half_sweep: f64,
    /// Sine and cosine of the half sweep, in doubles and finely.
    coarse: [Real; 2],
    fine: [Real; 2],
}

impl Strand {
    /// The curve with these ends and this half sweep.
    #[must_use]
    pub fn new(left: [f64; 2], right: [f64; 2], half_sweep: f64) -> Self {
        let fine = [Float::sin_round as fn(&mut Float, Round) -> _, Float::cos_round].map(|of| {
            let bound = |way| {
                let mut value = Float::with_val(FINE.bits(), half_sweep);
                of(&mut value, way);
                value
            };
            Real::Long(Box::new([bound(Round::Down), bound(Round::Up)]))
        });
        let coarse = fine.each_ref().map(|value| value.rounded(Precision::DOUBLE));
        Self { left, right, half_sweep, coarse, fine }
    }

    /// Least and greatest ordinate.
    #[must_use]
    pub fn heights(&self) -> [f64; 2] {
        [self.left[1].min(self.right[1]), self.left[1].max(self.right[1])]
    }

    /// The ordinate over an abscissa between those of the ends (memo C1). A vertical has none.
    #[must_use]
    pub fn height(&self, x: f64, precision: Precision) -> Real {
        let is_left = x - self.left[0] <= self.right[0] - x;
        let (near, far) = if is_left { (self.left, self.right) } else { (self.right, self.left) };
        if x == near[0] {
            return Real::new(near[1], precision);
        }
        let real = |value: f64| Real::new(value, precision);
        let [cx, cy] = [0, 1].map(|i| real(far[i]) - real(near[i]));
        let away = real(x) - real(near[0]);
        if self.half_sweep == 0.0 {
            return real(near[1]) + away * cy / cx;
        }
        let [sin, cos] = self.turn(precision);
        let sin = if is_left { sin.clone() } else { -sin };
        let b = &sin * &cy + cos * &cx;
        let free = cos * &(&away * &cy) - &sin * &(&away * &(&cx - &away));
        let root = (b.square() - real(4.0) * (&sin * &free)).sqrt();
        let below = if is_left { &b + &root } else { &b - &root };
        real(near[1]) + real(2.0) * free / below
    }

    /// The distance of a point from the curve.
    #[must_use]
    pub fn distance(&self, x: f64, y: &Real, precision: Precision) -> Real {
        let real = |value: f64| Real::new(value, precision);
        let chord = [0, 1].map(|i| real(self.right[i]) - real(self.left[i]));
        let from_left = [real(x) - real(self.left[0]), y - &real(self.left[1])];
        let from_right = [real(x) - real(self.right[0]), y - &real(self.right[1])];
        let [sin, cos] = self.turn(precision);
        let length = length(&chord);
        let bend = sin / &length;
        let normal =
            [&(cos * &chord[1] - sin * &chord[0]) / &length, &(-&(cos * &chord[0] + sin * &chord[1])) / &length];
        let twice = &bend * &real(2.0);
        let last = [0, 1].map(|i| &normal[i] + &(&twice * &chord[i]));
        // Positive before the left end, or beyond the right one.
        let before = &normal[1] * &from_left[0] - &normal[0] * &from_left[1];
        let beyond = &last[0] * &from_right[1] - &last[1] * &from_right[0];
        if before.is_positive() {
            return self::length(&from_left);
        }
        if beyond.is_positive() {
            return self::length(&from_right);
        }
        let off = dot(&normal, &from_left) + bend.clone() * (from_left[0].square() + from_left[1].square());
        let root = (real(1.0) + real(4.0) * bend * off.clone()).sqrt();
        let inside = (real(2.0) * off / (real(1.0) + root)).abs();
        let ends = [(&before, &from_left), (&beyond, &from_right)];
        ends.into_iter()
            .filter(|(sign, _)| !sign.is_negative() && sign.sign().is_none())
            .fold(inside, |known, (_, way)| known.hull(&self::length(way)))
    }

    /// The slope over an abscissa as a direction, roughly: for the place where two curves are parallel.
    #[must_use]
    pub fn direction(&self, x: f64) -> [f64; 2] {
        let [cx, cy] = [self.right[0] - self.left[0], self.right[1] - self.left[1]];
        let [sin, cos] = self.coarse.each_ref().map(Real::mid);
        let y = self.height(x, Precision::DOUBLE).mid();
        let way = [x - self.left[0], y - self.left[1]];
        let gradient = [cos * cy - sin * cx + 2.0 * sin * way[0], -cos * cx - sin * cy + 2.0 * sin * way[1]];
        [-gradient[1], gradient[0]]
    }

    fn turn(&self, precision: Precision) -> &[Real; 2] {
        if precision == Precision::DOUBLE { &self.coarse } else { &self.fine }
    }
}

fn dot(v: &[Real; 2], w: &[Real; 2]) -> Real {
    &v[0] * &w[0] + &v[1] * &w[1]
}

fn length(v: &[Real; 2]) -> Real {
    (v[0].square() + v[1].square()).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_4;

    /// The upper left quarter of the unit circle around (1, 0), but for the rounding of pi/4.
    fn quarter() -> Strand {
        Strand::new([0.0, 0.0], [1.0, 1.0], -FRAC_PI_4)
    }

    fn near(value: &Real, expected: f64) -> bool {
        value.lo() - 1e-15 <= expected && expected <= value.hi() + 1e-15 && value.hi() - value.lo() < 1e-12
    }

    #[test]
    fn heights_are_those_of_the_circle() {
        for x in [0.0, 0.1, 0.4, 0.5, 0.7, 0.9, 1.0_f64] {
            let expected = (1.0 - (1.0 - x) * (1.0 - x)).sqrt();
            for precision in [Precision::DOUBLE, FINE] {
                assert!(near(&quarter().height(x, precision), expected), "{x}");
            }
        }
        let line = Strand::new([0.0, 1.0], [4.0, 3.0], 0.0);
        assert!(near(&line.height(1.0, FINE), 1.5) && near(&line.height(3.0, Precision::DOUBLE), 2.5));
    }

    #[test]
    fn distances_end_at_the_ends() {
        let distance = |curve: &Strand, x: f64, y: f64| curve.distance(x, &Real::new(y, FINE), FINE);
        assert!(near(&distance(&quarter(), 1.0, 0.0), 1.0));
        assert!(near(&distance(&quarter(), 0.4, 0.8), 0.0));
        assert!(near(&distance(&quarter(), -3.0, -4.0), 5.0) && near(&distance(&quarter(), 2.0, 1.0), 1.0));
        let line = Strand::new([0.0, 0.0], [4.0, 3.0], 0.0);
        assert!(near(&distance(&line, 1.0, 2.0), 1.0) && near(&distance(&line, 7.0, 7.0), 5.0));
    }
}
