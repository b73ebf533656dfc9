//! The operands and the result of a case in the unit box, and the places of the result's boundary by their length.

use std::sync::Arc;

use crate::certified::curve::Curve;
use crate::certified::piece::Piece;
use crate::certified::reference::scaled;
use crate::certified::shape::{Shape, Side};
use crate::certified::vector::Vector;
use crate::error::OracleError;
use crate::plain::PlainRegion;
use crate::region::ExactRegion;
use rug::Rational;

/// Lengths of direction vectors stay below 1 by this, which is more than their roundings.
const SHORTER: f64 = 1.0 - 4.0 * f64::EPSILON;

/// Two operands and a result.
pub struct Regions {
    pub(super) operands: [Shape; 2],
    pub(super) polygons: Option<[ExactRegion<Rational>; 2]>,
    pub(super) result: Shape,
    pub(super) curves: Vec<Arc<Curve>>,
    pub(super) unit: f64,
    /// For every side of the result the one before it on its loop.
    before: Vec<usize>,
    /// The length of the boundary up to the end of every side, as a float.
    lengths: Vec<f64>,
}

/// A double near the boundary and a direction into the result, a little shorter than 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Base {
    pub(super) place: [f64; 2],
    pub(super) inward: [f64; 2],
}

impl Regions {
    /// Two operands and a result in input units; `unit` is the unit box's side, a power of two.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for numbers that are no regions or not representable in the unit box.
    pub fn new([a, b]: [&PlainRegion; 2], result: &PlainRegion, unit: f64) -> Result<Self, OracleError> {
        let [a, b, result] = [scaled(a, unit)?, scaled(b, unit)?, scaled(result, unit)?];
        let is_polygonal = a.is_polygonal() && b.is_polygonal();
        let polygons = is_polygonal.then(|| Ok([ExactRegion::from_plain(&a)?, ExactRegion::from_plain(&b)?]));
        let result = Shape::new(&result)?;
        let curves: Vec<_> = result.sides().map(|side| Arc::clone(&side.curve)).collect();
        let lengths = curves.iter().scan(0.0, |sum, curve| {
            *sum += curve.rough().chord().length().mid();
            Some(*sum)
        });
        Ok(Self {
            operands: [Shape::new(&a)?, Shape::new(&b)?],
            polygons: polygons.transpose()?,
            before: before(&result.loops),
            lengths: lengths.collect(),
            result,
            curves,
            unit,
        })
    }

    /// The sides of the result.
    #[must_use]
    pub fn sides(&self) -> usize {
        self.curves.len()
    }

    /// The side at a share of the boundary's length, from 0 to 1.
    #[must_use]
    pub fn side_at(&self, share: f64) -> usize {
        let length = share * self.lengths.last().copied().unwrap_or(0.0);
        self.lengths.partition_point(|&end| end <= length).min(self.sides().saturating_sub(1))
    }

    /// The corners of the box around the result, in the unit box; none if it has no boundary.
    pub(super) fn extent(&self) -> Option<[f64; 4]> {
        let boxes = self.curves.iter().map(|curve| curve.rough().bounds());
        boxes.reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])])
    }

    /// The place at a share of a side; its start for a share of 0, where the direction is between those of both sides.
    pub(super) fn base(&self, side: usize, share: f64) -> Base {
        let piece = self.curves[side].rough();
        let (place, normal) = along(piece, share);
        if share > 0.0 {
            return Base { place, inward: unit(normal).unwrap_or([0.0, 0.0]) };
        }
        let (_, other) = along(self.curves[self.before[side]].rough(), 1.0);
        let between = unit(normal).zip(unit(other)).and_then(|(p, q)| unit([p[0] + q[0], p[1] + q[1]]));
        Base { place, inward: between.or_else(|| unit(normal)).unwrap_or([0.0, 0.0]) }
    }
}

/// For every side of the loops the one before it.
fn before(loops: &[Vec<Side>]) -> Vec<usize> {
    let mut before = Vec::new();
    for ring in loops {
        let (first, count) = (before.len(), ring.len());
        before.extend((0..count).map(|i| first + (i + count - 1) % count));
    }
    before
}

/// A double near the place at a share of a piece's chord, and the normal there that points to the left.
fn along(piece: &Piece, share: f64) -> ([f64; 2], [f64; 2]) {
    let [from, to] = [&piece.from, &piece.to].map(doubles);
    let chord = [to[0] - from[0], to[1] - from[1]];
    let place = if share == 1.0 { to } else { [0, 1].map(|i| from[i] + share * chord[i]) };
    let Some(circle) = &piece.circle else { return (place, [-chord[1], chord[0]]) };
    let (centre, radius) = (doubles(&circle.centre), circle.radius.mid());
    let arm = [place[0] - centre[0], place[1] - centre[1]];
    let out = unit(arm).unwrap_or([0.0, 0.0]);
    let normal = if circle.left { [-out[0], -out[1]] } else { out };
    let on_circle = [0, 1].map(|i| centre[i] + radius * out[i]);
    (if share == 0.0 || share == 1.0 { place } else { on_circle }, normal)
}

fn doubles(v: &Vector) -> [f64; 2] {
    [v.x.mid(), v.y.mid()]
}

/// The vector of a length a little below 1 in this direction.
pub(super) fn unit(v: [f64; 2]) -> Option<[f64; 2]> {
    let length = v[0].hypot(v[1]);
    (length > 0.0 && length.is_finite()).then(|| v.map(|c| c / length * SHORTER))
}
