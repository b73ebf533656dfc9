//! The curves of a boundary near a place.

use std::sync::Arc;

use super::curve::Curve;
use super::precision::Precision;
use super::real::Real;
use super::vector::Vector;
use crate::boxes::{Boxes, Extent};
use crate::error::OracleError;

/// The precision at which lengths are compared: errors far below 2^-100 for coordinates near 1.
pub const FINE: Precision = Precision::LADDER[2];

/// The curves of a boundary, indexed.
pub struct Nearest<'a> {
    curves: &'a [Arc<Curve>],
    boxes: Option<Boxes>,
}

impl<'a> Nearest<'a> {
    /// Indexes the curves.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn new(curves: &'a [Arc<Curve>]) -> Result<Self, OracleError> {
        let extents: Vec<Extent> = curves.iter().map(|curve| Extent { ends: curve.rough().bounds() }).collect();
        let boxes = if extents.is_empty() { None } else { Some(Boxes::new(&extents)?) };
        Ok(Self { curves, boxes })
    }

    /// One of the curves.
    #[must_use]
    pub fn curve(&self, index: usize) -> &Arc<Curve> {
        &self.curves[index]
    }

    /// The distance to the nearest curve and the curves that may be nearest, the most likely one first; `None` without
    /// curves.
    #[must_use]
    pub fn distance(&self, point: &Vector) -> Option<(Real, Vec<usize>)> {
        let rough = Vector { x: point.x.rounded(Precision::DOUBLE), y: point.y.rounded(Precision::DOUBLE) };
        let (x, y) = point.nearest();
        // The query is at a double; the point is this far from it at most.
        let slack = 4.0 * f64::EPSILON * (1.0 + x.abs() + y.abs());
        let mut bound = f64::INFINITY;
        let mut near: Vec<(f64, usize)> = Vec::new();
        self.boxes.as_ref()?.visit_nearest(x, y, |i, least| {
            if least - slack > bound {
                return false;
            }
            let distance = self.curves[i].rough().distance(&rough);
            bound = bound.min(distance.hi());
            near.push((distance.lo(), i));
            true
        });
        near.retain(|&(least, _)| least <= bound);
        let measured = |(_, i): (f64, usize)| (self.curves[i].at(FINE).distance(point), i);
        let mut fine: Vec<(Real, usize)> = near.into_iter().map(measured).collect();
        fine.sort_by(|a, b| a.0.mid().total_cmp(&b.0.mid()));
        let least = fine.iter().skip(1).fold(fine.first()?.0.clone(), |least, (distance, _)| least.min(distance));
        let hi = least.hi();
        fine.retain(|(distance, _)| distance.lo() <= hi);
        Some((least, fine.into_iter().map(|(_, i)| i).collect()))
    }
}
