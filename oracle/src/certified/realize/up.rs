//! The direction in which chains are adjusted and lifted: what is vertical in MS 4.2.
//!
//! MS take the y axis. Any direction serves Theorem 2, and most serve it better: heads are adjusted along it by the
//! error of the angle over the sine of the angle between piece and direction. A line's stored angle is relatively
//! accurate next to the axes, so lines do not care; a circle segment next to a vertical tangent does.

use std::cmp::Ordering;
use std::f64::consts::PI;

use rug::Float;
use rug::float::Round;

use super::stored::{Angle, StoredRegion};
use crate::certified::precision::Precision;
use crate::certified::real::Real;
use crate::certified::vector::Vector;

/// The direction that plays the vertical's part. Vectors in its frame have the abscissa to its right and the ordinate
/// along it, both times its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Up {
    x: f64,
    y: f64,
}

impl Up {
    /// The y axis, as MS 4.2 has it.
    pub const VERTICAL: Self = Self { x: 0.0, y: 1.0 };

    /// A direction in the middle of the widest gap between those of all lines and of the ends of all circle segments,
    /// so that nothing is parallel to it and no end of a circle segment is near to it.
    #[must_use]
    pub fn clear_of(region: &StoredRegion) -> Self {
        let ends = region.loops.iter().flatten().flat_map(|piece| [piece.start, piece.end]);
        let mut normals: Vec<f64> = ends.map(|angle| angle.radians().rem_euclid(PI)).collect();
        normals.sort_by(f64::total_cmp);
        let after = |i: usize| normals.get(i + 1).copied().unwrap_or(normals[0] + PI);
        let widest = (0..normals.len()).max_by(|&i, &j| (after(i) - normals[i]).total_cmp(&(after(j) - normals[j])));
        let Some(i) = widest else { return Self::VERTICAL };
        let (sine, cosine) = (0.5 * (normals[i] + after(i))).sin_cos();
        // Turned left: the direction of a piece with this normal.
        Self { x: -sine, y: cosine }
    }

    /// The square of its length.
    #[must_use]
    pub fn square(self, precision: Precision) -> Real {
        Vector::new(self.x, self.y, precision).square()
    }

    /// A vector in the frame.
    #[must_use]
    pub fn to_frame(self, v: &Vector) -> Vector {
        Vector { x: &v.x * self.y - &v.y * self.x, y: &v.x * self.x + &v.y * self.y }
    }

    /// A vector of the frame in input coordinates.
    #[must_use]
    pub fn from_frame(self, v: &Vector, precision: Precision) -> Vector {
        let square = self.square(precision);
        Vector { x: (&v.x * self.y + &v.y * self.x) / &square, y: (&v.y * self.y - &v.x * self.x) / &square }
    }

    /// The unit normal at an angle, in the frame.
    #[must_use]
    pub fn normal(self, angle: Angle, precision: Precision) -> Vector {
        self.to_frame(&normal(angle, precision))
    }
}

/// The unit normal at an angle. The precision must not be [`Precision::DOUBLE`].
#[must_use]
pub fn normal(angle: Angle, precision: Precision) -> Vector {
    let offset = Float::with_val(precision.bits(), angle.offset);
    let bounds = |round: fn(&mut Float, Round) -> Ordering| {
        let both = [Round::Down, Round::Up].map(|direction| {
            let mut value = offset.clone();
            round(&mut value, direction);
            value
        });
        Real::Long(Box::new(both))
    };
    let cosine = bounds(Float::cos_round);
    let sine = bounds(Float::sin_round);
    match angle.quarter % 4 {
        0 => Vector { x: cosine, y: sine },
        1 => Vector { x: -&sine, y: cosine },
        2 => Vector { x: -&cosine, y: -&sine },
        _ => Vector { x: sine, y: -&cosine },
    }
}
