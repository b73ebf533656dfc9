//! The exact sum of two regions with arcs as a reference: its boundary, and the certified distance of a result to it.
//!
//! Everything is done in the unit box: coordinates and radii are divided by its side, a power of two, which is exact or
//! refused. The lower bound is confirmed where it is attained by a point of the result: the distance of that point to the
//! sum is measured once more from the operands alone, without the boundary.

use std::sync::Arc;

use super::boundary::{Edge, boundary};
use super::depth::Summed;
use super::hausdorff::{Found, Outline, between};
use super::membership::Membership;
use super::nearest::FINE;
use super::shape::Shape;
use super::spot::Spot;
use super::strips::Span;
use super::vector::Vector;
use crate::error::{Budget, OracleError};
use crate::measure::{Bracket, Direction};
use crate::plain::{Bend, Corner, PlainRegion};

/// What the measures of a witness may differ by, besides the blur of the boundary.
const SLACK: f64 = 1.0 / (1u128 << 80) as f64;

/// The sum of two regions.
pub struct Reference {
    membership: Membership,
    sum: Outline,
    summed: Summed,
    unit: f64,
    undecided: usize,
    bits: u32,
    loops: Option<usize>,
}

impl Reference {
    /// The sum of two regions; `unit` is the unit box's side in input units, a power of two.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for numbers that are no regions or not representable in the unit box,
    /// [`OracleError::TooCostly`] beyond the budget.
    pub fn new(a: &PlainRegion, b: &PlainRegion, unit: f64, budget: Budget) -> Result<Self, OracleError> {
        let [first, second] = [a, b].map(|region| scaled(region, unit).and_then(|region| Shape::new(&region)));
        Self::of_shapes(&first?, &second?, unit, budget)
    }

    /// The sum of two shapes whose coordinates are in the unit box; `unit` is its side in input units.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn of_shapes(a: &Shape, b: &Shape, unit: f64, budget: Budget) -> Result<Self, OracleError> {
        let boundary = boundary(a, b, budget)?;
        boundary.check_closed()?;
        let span = |edge: &Edge| Span { curve: Arc::clone(&edge.curve), ends: edge.ends.clone() };
        let pieces = boundary.edges.iter().map(span).collect();
        let curves = boundary.edges.iter().map(|edge| Arc::clone(&edge.curve)).collect();
        let is_empty = |shape: &Shape| shape.sides().next().is_none() && !shape.unbounded;
        let unbounded = (a.unbounded || b.unbounded) && !is_empty(a) && !is_empty(b);
        Ok(Self {
            membership: Membership::new(a, b),
            sum: Outline { pieces, unbounded },
            summed: Summed::new([a.clone(), b.clone()], curves, boundary.blur),
            unit,
            undecided: boundary.undecided.len(),
            bits: boundary.effort.bits,
            loops: boundary.loops()?,
        })
    }

    /// The boundary of the sum, in the unit box.
    #[must_use]
    pub fn sum(&self) -> &Outline {
        &self.sum
    }

    /// The regions and the boundary of their sum, in the unit box, to measure overlaps with ([`super::depth`]).
    #[must_use]
    pub fn summed(&self) -> &Summed {
        &self.summed
    }

    /// The number of stretches of sum curves of which it is undecided whether they bound the sum.
    #[must_use]
    pub fn undecided(&self) -> usize {
        self.undecided
    }

    /// The most bits that it took to tell how two sum curves meet.
    #[must_use]
    pub fn bits(&self) -> u32 {
        self.bits
    }

    /// The number of loops of the sum, if no two of them touch.
    #[must_use]
    pub fn loops(&self) -> Option<usize> {
        self.loops
    }

    /// A certified bracket of the distance between a result and the sum, in unit-box lengths, its witness in input units;
    /// `None` if something about the boundary is undecided.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for a result that is no region, [`OracleError::Inconsistent`] if the lower bound is not
    /// confirmed.
    pub fn measure(&self, result: &PlainRegion) -> Result<Option<Bracket>, OracleError> {
        if self.undecided > 0 {
            return Ok(None);
        }
        let result = Outline::from(&Shape::new(&scaled(result, self.unit)?)?);
        let Some(found) = between(&result, &self.sum)? else { return Ok(None) };
        self.confirm(&found)?;
        let mut bracket = found.bracket.widened(self.summed.blur());
        bracket.witness = (bracket.witness.0 * self.unit, bracket.witness.1 * self.unit);
        Ok(Some(bracket))
    }

    /// Checks that a witness in the result is as far from the sum as the bracket says.
    fn confirm(&self, Found { bracket, place }: &Found) -> Result<(), OracleError> {
        let Some(place) = place.clone().filter(|_| bracket.direction == Direction::FromResult) else { return Ok(()) };
        let spot = Spot::new(move |precision| Vector { x: place.x.rounded(precision), y: place.y.rounded(precision) });
        let distance = self.membership.distance(&spot, FINE);
        let slack = SLACK + self.summed.blur();
        if distance.hi() < bracket.lo - slack || distance.lo() > bracket.hi + slack {
            return Err(OracleError::Inconsistent("a distance to the boundary of the sum is not the one to the sum"));
        }
        Ok(())
    }
}

/// The region in units of `unit`, a power of two.
pub(crate) fn scaled(region: &PlainRegion, unit: f64) -> Result<PlainRegion, OracleError> {
    let mut result = region.clone();
    for (ring, corners) in result.loops.iter_mut().enumerate() {
        for (vertex, corner) in corners.iter_mut().enumerate() {
            *corner = scaled_corner(*corner, unit).ok_or(OracleError::BadNumber {
                ring,
                vertex,
                reason: "too small or too large for the unit box",
            })?;
        }
    }
    Ok(result)
}

fn scaled_corner(corner: Corner, unit: f64) -> Option<Corner> {
    let exact = |x: f64| Some(x / unit).filter(|y| y * unit == x);
    let bend = match corner.bend {
        Bend::Radius(radius) => Bend::Radius(exact(radius)?),
        bend => bend,
    };
    Some(Corner { x: exact(corner.x)?, y: exact(corner.y)?, bend })
}
