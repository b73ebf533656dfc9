//! Circle segments: half sweep, end angles and points by normal angle (MS 4.1; memo A3, A5).
//!
//! MS take asin of half chord over radius, which loses eight digits near half circles (memo fact 3), and a coordinate
//! formula that loses everything near vertical chords (memo A5). Here the half sweep comes from atan2 with an exact
//! radicand, and points by rotating and shrinking the chord.

use crate::angle::{Ang, FRAC_PI_2_LOW};
use crate::sum3::Rounding;
use crate::twofold::{square_terms, threefold_sum, two_sum, twofold_atan, twofold_sqrt};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// How much longer than the diameter a chord may be, in eps = 2^-53 of the diameter, before it is an error and not the
/// rounding of a half circle whose radius was printed with 15 digits.
const CHORD_SLACK: f64 = 16.0;

/// Why an arc cannot be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ArcError {
    /// A coordinate, radius or bulge is infinite or not a number, or their use overflows.
    #[error("a coordinate, radius or bulge is not finite")]
    NotFinite,
    /// Tail and head coincide.
    #[error("the two ends coincide")]
    ZeroChord,
    /// The radius or bulge is zero.
    #[error("the circle segment has no curvature")]
    ZeroSweep,
    /// The chord is longer than the diameter.
    #[error("the chord is longer than the diameter")]
    ChordTooLong,
}

/// A directed circle segment of less than 360 degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    tail: DVec2,
    head: DVec2,
    a: Ang,
    b: Ang,
    delta: f64,
    /// Sine of `delta`, kept apart because near full circles it cannot be had from `delta`.
    sine: f64,
}

/// Half the sweep, signed like `r`, of the minor arc of signed radius `r` (memo A3), to 4 eps of itself.
///
/// tan delta = L / sqrt(4 r^2 - L^2), both in twofold precision. A chord up to [`CHORD_SLACK`] eps longer than the
/// diameter counts as a half circle.
///
/// # Errors
/// [`ArcError`], as its variants say.
pub fn half_sweep_of_radius(tail: DVec2, head: DVec2, r: f64) -> Result<f64, ArcError> {
    let chord = chord(tail, head)?;
    if !r.is_finite() {
        return Err(ArcError::NotFinite);
    }
    if r == 0.0 {
        return Err(ArcError::ZeroSweep);
    }
    // Units in which the squares of comparable numbers neither overflow nor underflow.
    let exponent = -libm::frexp(chord.abs().max_element()).1;
    let scaled = |x: f64| libm::ldexp(x, exponent);
    let difference = |h: f64, t: f64| {
        let (difference, error) = two_sum(h, -t);
        (scaled(difference), scaled(error))
    };
    let chord = [difference(head.x, tail.x), difference(head.y, tail.y)];
    let delta = half_sweep(chord, scaled(r.abs())).ok_or(ArcError::ChordTooLong)?;
    Ok(libm::copysign(delta, r))
}

/// The half sweep to a chord with coordinates of about 1 and a positive radius; `None` if the chord is too long.
fn half_sweep([x, y]: [(f64, f64); 2], r: f64) -> Option<f64> {
    let length = twofold_sqrt(threefold_sum(&mut [square_terms(x, 1.0), square_terms(y, 1.0)].concat()));
    // Beyond this ratio the chord no longer shows in the radicand: relative error (L/2r)^2/2 < 2^-61.
    if r >= length.0 * f64::from(1 << 30) {
        return Some(twofold_atan(length, ((2.0 * r).min(f64::MAX), 0.0)));
    }
    let diameter = square_terms((r, 0.0), 4.0);
    let radicand = threefold_sum(&mut [diameter, square_terms(x, -1.0), square_terms(y, -1.0)].concat());
    if radicand.0 < -CHORD_SLACK * f64::EPSILON * diameter[0] {
        return None;
    }
    let rest = twofold_sqrt(radicand);
    if length.0 <= rest.0 {
        return Some(twofold_atan(length, rest));
    }
    let (delta, error) = two_sum(FRAC_PI_2, -twofold_atan(rest, length));
    Some(delta + (error + FRAC_PI_2_LOW))
}

/// Half the sweep of the arc with this bulge, 2 atan(bulge), in (-pi, pi), to 2 eps of itself.
///
/// # Errors
/// [`ArcError::NotFinite`], [`ArcError::ZeroSweep`].
pub fn half_sweep_of_bulge(bulge: f64) -> Result<f64, ArcError> {
    check_bulge(bulge)?;
    Ok(2.0 * libm::atan(bulge))
}

/// The signed radius of the arc with this bulge, L (1 + b^2) / (4 b), to 8 eps of itself; infinite if it overflows.
///
/// # Errors
/// [`ArcError`], as its variants say.
pub fn radius_of_bulge(tail: DVec2, head: DVec2, bulge: f64) -> Result<f64, ArcError> {
    check_bulge(bulge)?;
    let chord = chord(tail, head)?;
    Ok(libm::hypot(chord.x, chord.y) / (2.0 * sine_of_bulge(bulge)))
}

impl Arc {
    /// The minor arc of signed radius `r`.
    ///
    /// # Errors
    /// [`ArcError`], as its variants say.
    pub fn with_radius(tail: DVec2, head: DVec2, r: f64) -> Result<Self, ArcError> {
        let delta = half_sweep_of_radius(tail, head, r)?;
        let gamma = Ang::of_line(tail, head).ok_or(ArcError::ZeroChord)?;
        Ok(Self::minor(tail, head, gamma.plus(-delta), gamma.plus(delta), r < 0.0))
    }

    /// The arc of this bulge.
    ///
    /// # Errors
    /// [`ArcError`], as its variants say.
    pub fn with_bulge(tail: DVec2, head: DVec2, bulge: f64) -> Result<Self, ArcError> {
        let delta = half_sweep_of_bulge(bulge)?;
        chord(tail, head)?;
        let gamma = Ang::of_line(tail, head).ok_or(ArcError::ZeroChord)?;
        if bulge.abs() <= 1.0 {
            return Ok(Self::minor(tail, head, gamma.plus(-delta), gamma.plus(delta), bulge < 0.0));
        }
        // The rest of the circle has the same ends and bulge -1/b; its small half sweep is the more accurate one.
        let rest = -2.0 * libm::atan(1.0 / bulge);
        let gamma = gamma.opposite();
        let (a, b) = (gamma.plus(-rest), gamma.plus(rest));
        Ok(Self { tail, head, a, b, delta, sine: sine_of_bulge(bulge) })
    }

    /// The arc of at most 180 degrees from `tail` to `head` with the normal angles `a` and `b` there, counter-clockwise
    /// or clockwise. The angles rule: the half sweep is (b - a)/2 of the angles as given (memo A1).
    #[must_use]
    pub fn minor(tail: DVec2, head: DVec2, a: Ang, b: Ang, clockwise: bool) -> Self {
        let delta = half_turn(a, b, clockwise);
        Self { tail, head, a, b, delta, sine: libm::sin(delta) }
    }

    /// The same arc with its end angles changed a little. Beyond a half circle the half sweep and its sine stay, as
    /// they are known better than the angles tell.
    #[must_use]
    pub(crate) fn turned(self, a: Ang, b: Ang) -> Self {
        if self.delta.abs() > FRAC_PI_2 {
            Self { a, b, ..self }
        } else {
            Self::minor(self.tail, self.head, a, b, self.sine < 0.0)
        }
    }

    /// Tail.
    #[must_use]
    pub fn tail(&self) -> DVec2 {
        self.tail
    }

    /// Head.
    #[must_use]
    pub fn head(&self) -> DVec2 {
        self.head
    }

    /// Rightward normal angle at the tail.
    #[must_use]
    pub fn a(&self) -> Ang {
        self.a
    }

    /// Rightward normal angle at the head.
    #[must_use]
    pub fn b(&self) -> Ang {
        self.b
    }

    /// Half the sweep in radians, positive counter-clockwise.
    #[must_use]
    pub fn delta(&self) -> f64 {
        self.delta
    }

    /// The point at normal angle `theta` between `a` and `b`, as its nearer end and the way from there (memo A5), right
    /// to 6 eps of the chord if the arc is monotone. Exactly an end and zero if `theta` is an end angle.
    #[must_use]
    pub fn offset(&self, theta: Ang) -> (DVec2, DVec2) {
        if theta == self.a {
            return (self.tail, DVec2::ZERO);
        }
        if theta == self.b {
            return (self.head, DVec2::ZERO);
        }
        let clockwise = self.sine < 0.0;
        let u = half_turn(self.a, theta, clockwise);
        let v = half_turn(theta, self.b, clockwise);
        let chord = self.head - self.tail;
        if u == v && u.abs() <= FRAC_PI_4 {
            // Halfway the chord and the sagitta are better: exact on half circles.
            let tan_u = self.sine / (1.0 + libm::cos(self.delta));
            (self.tail, (chord - chord.perp() * tan_u) / 2.0)
        } else if u.abs() <= v.abs() {
            (self.tail, rotated(chord, -v) * (libm::sin(u) / self.sine))
        } else {
            (self.head, rotated(chord, u) * (-libm::sin(v) / self.sine))
        }
    }

    /// The point at normal angle `theta` plus `q`, rounded as asked (memo A6), of an x- and y-monotone arc. Stays in
    /// the box of the two ends plus `q`, so rounding breaks no monotonicity.
    #[must_use]
    pub fn point_plus(&self, theta: Ang, q: DVec2, rounding: Rounding) -> DVec2 {
        self.moved(self.offset(theta), q, rounding)
    }

    /// The same for a point given by its [`Arc::offset`].
    #[must_use]
    pub fn moved(&self, (end, way): (DVec2, DVec2), q: DVec2, rounding: Rounding) -> DVec2 {
        let (tail, head) = (self.tail + q, self.head + q);
        rounding.sum_points(end, way, q).max(tail.min(head)).min(tail.max(head))
    }

    /// The axis normals strictly inside the sweep, in the order of traversal, and the points there: up to four. The
    /// points cut the arc into x- and y-monotone pieces even after rounding.
    #[must_use]
    pub fn cuts(&self) -> Vec<(Ang, DVec2)> {
        let angles = self.axes_inside();
        let mut points: Vec<DVec2> = angles.iter().map(|&angle| self.point(angle)).collect();
        for (i, angle) in angles.iter().enumerate() {
            let before = if i == 0 { self.tail } else { points[i - 1] };
            let after = points.get(i + 1).copied().unwrap_or(self.head);
            points[i] = extreme(*angle, self.sine < 0.0, points[i], (before, after));
        }
        angles.into_iter().zip(points).collect()
    }

    fn point(&self, theta: Ang) -> DVec2 {
        let (end, way) = self.offset(theta);
        end + way
    }

    /// Equal end angles mean a full circle but for rounding, unless the arc is minor.
    fn axes_inside(&self) -> Vec<Ang> {
        if self.a == self.b && self.delta.abs() <= FRAC_PI_2 {
            return Vec::new();
        }
        let clockwise = self.sine < 0.0;
        let (lo, hi) = if clockwise { (self.b, self.a) } else { (self.a, self.b) };
        let first = usize::from(lo.axis()) + usize::from(lo.offset() >= 0.0);
        let mut inside: Vec<Ang> =
            (first..first + 4).map(|k| Ang::AXES[k % 4]).take_while(|&x| strictly_inside(lo, x, hi)).collect();
        if clockwise {
            inside.reverse();
        }
        inside
    }
}

/// Whether x comes strictly between lo and hi counter-clockwise; all of the circle but lo if the two are equal.
fn strictly_inside(lo: Ang, x: Ang, hi: Ang) -> bool {
    if lo < hi { lo < x && x < hi } else { lo < x || x < hi }
}

/// Half the turn from one angle to the other in the given sense, in [0, pi) or (-pi, 0].
fn half_turn(from: Ang, to: Ang, clockwise: bool) -> f64 {
    let half = from.turn_to(to) / 2.0;
    if clockwise && half > 0.0 {
        half - PI
    } else if !clockwise && half < 0.0 {
        half + PI
    } else {
        half
    }
}

/// The cut point of an arc at an axis normal, moved outwards and between its neighbours where rounding left it inside
/// or beyond them.
fn extreme(axis: Ang, clockwise: bool, p: DVec2, (before, after): (DVec2, DVec2)) -> DVec2 {
    let (lo, hi) = (before.min(after), before.max(after));
    let between = p.max(lo).min(hi);
    let outwards = if matches!(axis.axis(), 0 | 1) == clockwise { p.min(lo) } else { p.max(hi) };
    if axis.axis().is_multiple_of(2) { DVec2::new(outwards.x, between.y) } else { DVec2::new(between.x, outwards.y) }
}

fn rotated(v: DVec2, angle: f64) -> DVec2 {
    let (s, c) = libm::sincos(angle);
    DVec2::new(c * v.x - s * v.y, s * v.x + c * v.y)
}

fn chord(tail: DVec2, head: DVec2) -> Result<DVec2, ArcError> {
    let chord = head - tail;
    if !chord.is_finite() {
        Err(ArcError::NotFinite)
    } else if chord == DVec2::ZERO {
        Err(ArcError::ZeroChord)
    } else {
        Ok(chord)
    }
}

fn check_bulge(bulge: f64) -> Result<(), ArcError> {
    if !bulge.is_finite() {
        Err(ArcError::NotFinite)
    } else if bulge == 0.0 {
        Err(ArcError::ZeroSweep)
    } else {
        Ok(())
    }
}

/// sin(2 atan b) = 2b / (1 + b^2), without overflow.
fn sine_of_bulge(bulge: f64) -> f64 {
    let b = if bulge.abs() <= 1.0 { bulge } else { 1.0 / bulge };
    2.0 * b / (1.0 + b * b)
}
