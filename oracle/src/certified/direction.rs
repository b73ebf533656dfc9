//! Outward normal directions of a region, and their order within a quadrant.
//!
//! The plane of directions has eight sectors: twice the index of an axis (right, up, left, down) for the axis itself, one
//! more for the open quadrant after it. Directions that 1024 bits cannot tell apart count as equal, and those that 1024
//! bits cannot tell from an axis as that axis: an error below 2^-900, far below the zone.

use std::cmp::Ordering;
use std::sync::Arc;

use super::curve::Curve;
use super::meet::LIMIT;
use super::piece::Circle;
use super::precision::Precision;
use super::real::Real;
use super::vector::{Vector, sector};

/// Which end of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The start.
    From,
    /// The end.
    To,
}

/// An outward normal direction.
#[derive(Clone, Debug)]
pub struct Direction {
    /// The piece and the end at which it is the normal; none for an axis.
    source: Option<(Arc<Curve>, End)>,
    /// In doubles, of any length.
    rough: Vector,
    /// Where it points.
    sector: usize,
}

impl Direction {
    /// The outward normal of a boundary piece, interior on the left, at one of its ends.
    #[must_use]
    pub fn normal(curve: &Arc<Curve>, end: End) -> Self {
        let sign = |coordinate: fn(&Vector) -> &Real| {
            let sign = LIMIT.decide(|p| coordinate(&normal(curve, end, p)).sign());
            sign.unwrap_or(Ordering::Equal)
        };
        match sector(sign(|v| &v.x), sign(|v| &v.y)) {
            sector if sector.is_multiple_of(2) => Self::axis(sector / 2),
            sector => {
                Self { source: Some((Arc::clone(curve), end)), rough: normal(curve, end, Precision::DOUBLE), sector }
            }
        }
    }

    /// An axis: right, up, left, down for 0, 1, 2, 3, and on from there.
    #[must_use]
    pub fn axis(index: usize) -> Self {
        let index = index % 4;
        Self { source: None, rough: axis(index, Precision::DOUBLE), sector: 2 * index }
    }

    /// The vector at a precision, of any length.
    #[must_use]
    pub fn at(&self, precision: Precision) -> Vector {
        match &self.source {
            None => axis(self.sector / 2, precision),
            Some(_) if precision == Precision::DOUBLE => self.rough.clone(),
            Some((curve, end)) => normal(curve, *end, precision),
        }
    }

    /// The sector, 0 to 7.
    #[must_use]
    pub fn sector(&self) -> usize {
        self.sector
    }

    fn is_axis(&self) -> bool {
        self.source.is_none()
    }

    /// The place in the closed quadrant from one axis to the next: 0 on the first axis, 1 between them, 2 on the next;
    /// none outside.
    #[must_use]
    pub fn rank(&self, quadrant: usize) -> Option<usize> {
        Some((self.sector + 8 - 2 * quadrant) % 8).filter(|&rank| rank <= 2)
    }

    /// Whether it comes before or after another one of the same closed quadrant, counter-clockwise.
    #[must_use]
    pub fn order(&self, other: &Self, quadrant: usize) -> Ordering {
        let ranks = self.rank(quadrant).cmp(&other.rank(quadrant));
        if ranks.is_ne() || self.is_axis() { ranks } else { self.turn_to(other).reverse() }
    }

    /// To which side the shorter turn to another direction goes: `Greater` for left, `Equal` for directions that are
    /// equal or opposite.
    #[must_use]
    pub fn turn_to(&self, other: &Self) -> Ordering {
        LIMIT.decide(|p| self.at(p).turn(&other.at(p))).unwrap_or(Ordering::Equal)
    }
}

fn axis(index: usize, precision: Precision) -> Vector {
    let (x, y) = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][index];
    Vector::new(x, y, precision)
}

fn normal(curve: &Curve, end: End, precision: Precision) -> Vector {
    let piece = curve.at(precision);
    let point = match end {
        End::From => &piece.from,
        End::To => &piece.to,
    };
    match &piece.circle {
        None => -&piece.chord().left(),
        Some(Circle { centre, left: true, .. }) => point - centre,
        Some(Circle { centre, left: false, .. }) => centre - point,
    }
}
