//! Formulas about vectors and circle segments in MPFR arithmetic, to measure the errors of others against (memo A3, A5).
//!
//! Not certified: at [`PRECISION`] bits their own errors are hundreds of bits below those that are measured.

use rug::float::Constant;
use rug::ops::Pow;
use rug::{Assign, Float};

/// Precision in bits: enough that no cancellation in the tests leaves fewer than 100.
pub const PRECISION: u32 = 600;

/// The double as it is.
#[must_use]
pub fn big(x: f64) -> Float {
    Float::with_val(PRECISION, x)
}

/// pi.
#[must_use]
pub fn pi() -> Float {
    Float::with_val(PRECISION, Constant::Pi)
}

/// So many quarters of a turn and an offset, in radians.
#[must_use]
pub fn angle(quarters: u8, offset: f64) -> Float {
    pi() * quarters / 2u32 + big(offset)
}

/// The angle reduced to (-pi, pi] by whole turns.
#[must_use]
pub fn reduced(angle: &Float) -> Float {
    let turns = Float::with_val(PRECISION, angle / (pi() * 2u32)).round();
    Float::with_val(PRECISION, angle - turns * pi() * 2u32)
}

/// |error| in eps = 2^-53 of `unit`; infinite if the error is not a number.
#[must_use]
pub fn in_eps(error: &Float, unit: &Float) -> f64 {
    if error.is_nan() {
        return f64::INFINITY;
    }
    if error.is_zero() {
        return 0.0;
    }
    (Float::with_val(PRECISION, error / unit).abs() << 53u32).to_f64()
}

/// The relative error of a computed double in eps = 2^-53.
#[must_use]
pub fn relative(computed: f64, exact: &Float) -> f64 {
    in_eps(&(big(computed) - exact), exact)
}

/// A plane vector.
#[derive(Clone, Debug)]
pub struct Vector {
    /// Abscissa.
    pub x: Float,
    /// Ordinate.
    pub y: Float,
}

impl Vector {
    /// The point as it is.
    #[must_use]
    pub fn of(p: [f64; 2]) -> Self {
        Self { x: big(p[0]), y: big(p[1]) }
    }

    /// The unit vector at an angle.
    #[must_use]
    pub fn at(angle: &Float) -> Self {
        Self { x: angle.clone().cos(), y: angle.clone().sin() }
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        Self { x: Float::with_val(PRECISION, &self.x - &other.x), y: Float::with_val(PRECISION, &self.y - &other.y) }
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self { x: Float::with_val(PRECISION, &self.x + &other.x), y: Float::with_val(PRECISION, &self.y + &other.y) }
    }

    /// The multiple.
    #[must_use]
    pub fn times(&self, factor: &Float) -> Self {
        Self { x: Float::with_val(PRECISION, &self.x * factor), y: Float::with_val(PRECISION, &self.y * factor) }
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(&self, other: &Self) -> Float {
        Float::with_val(PRECISION, &self.x * &other.x) + Float::with_val(PRECISION, &self.y * &other.y)
    }

    /// Turned counter-clockwise.
    #[must_use]
    pub fn rotated(&self, angle: &Float) -> Self {
        let (s, c) = angle.clone().sin_cos(Float::new(PRECISION));
        let x = Float::with_val(PRECISION, &c * &self.x) - Float::with_val(PRECISION, &s * &self.y);
        let y = Float::with_val(PRECISION, &s * &self.x) + Float::with_val(PRECISION, &c * &self.y);
        Self { x, y }
    }

    /// The length.
    #[must_use]
    pub fn length(&self) -> Float {
        self.dot(self).sqrt()
    }

    /// The angle in (-pi, pi].
    #[must_use]
    pub fn angle(&self) -> Float {
        self.y.clone().atan2(&self.x)
    }
}

/// A circle segment in MPFR arithmetic.
#[derive(Clone, Debug)]
pub struct Circular {
    /// Tail.
    pub tail: Vector,
    /// From tail to head.
    pub chord: Vector,
    /// Angle of the rightward normal of the chord.
    pub gamma: Float,
    /// Half the sweep, signed.
    pub delta: Float,
}

impl Circular {
    /// With the half sweep as given.
    #[must_use]
    pub fn new(tail: [f64; 2], head: [f64; 2], delta: Float) -> Self {
        let tail = Vector::of(tail);
        let chord = Vector::of(head).minus(&tail);
        let gamma = Vector { x: chord.y.clone(), y: -chord.x.clone() }.angle();
        Self { tail, chord, gamma, delta }
    }

    /// With this signed radius; `None` if the chord is longer than the diameter.
    #[must_use]
    pub fn with_radius(tail: [f64; 2], head: [f64; 2], r: f64) -> Option<Self> {
        let mut arc = Self::new(tail, head, big(0.0));
        let radicand = Float::with_val(PRECISION, big(r).pow(2u32) * 4u32) - arc.chord.dot(&arc.chord);
        if radicand < 0 {
            return None;
        }
        let delta = arc.chord.length().atan2(&radicand.sqrt());
        arc.delta.assign(if r < 0.0 { -delta } else { delta });
        Some(arc)
    }

    /// With this bulge.
    #[must_use]
    pub fn with_bulge(tail: [f64; 2], head: [f64; 2], bulge: f64) -> Self {
        Self::new(tail, head, big(bulge).atan() * 2u32)
    }

    /// The signed radius, L / (2 sin delta).
    #[must_use]
    pub fn radius(&self) -> Float {
        self.chord.length() / (self.delta.clone().sin() * 2u32)
    }

    /// The centre.
    #[must_use]
    pub fn centre(&self) -> Vector {
        let a = Float::with_val(PRECISION, &self.gamma - &self.delta);
        self.tail.minus(&Vector::at(&a).times(&self.radius()))
    }

    /// The point whose chord from the tail takes up the half sweep `u`.
    #[must_use]
    pub fn at_half_sweep(&self, u: &Float) -> Vector {
        let ratio = Float::with_val(PRECISION, u.clone().sin() / self.delta.clone().sin());
        let turn = Float::with_val(PRECISION, u - &self.delta);
        self.tail.plus(&self.chord.rotated(&turn).times(&ratio))
    }

    /// How far the point lies outside of the circle, by n.w + |w|^2 / (2r) with w from the tail: exact to second order
    /// in the distance over the radius.
    #[must_use]
    pub fn off_circle(&self, p: [f64; 2]) -> Float {
        let a = Float::with_val(PRECISION, &self.gamma - &self.delta);
        let way = Vector::of(p).minus(&self.tail);
        Vector::at(&a).dot(&way) + way.dot(&way) / (self.radius() * 2u32)
    }
}
