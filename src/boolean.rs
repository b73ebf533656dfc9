//! Set operations: both operands in one arrangement, a winding number for each, a predicate selects (memo D).
//!
//! A point is inside an operand where that operand's winding number is not 0, because operands that come from approximate
//! output may have loops that cross by a few eps.

use crate::arrangement::arrange;
use crate::boundary::Boundary;
use crate::extract::{outline, region};
use crate::frame::Frame;
use crate::piece::Pieces;
use crate::region::Region;
use crate::smooth::SmoothError;

/// A regularised set operation on two regions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// Points in either.
    Union,
    /// Points in both.
    Intersection,
    /// Points in the first but not the second.
    Difference,
    /// Points in exactly one.
    SymmetricDifference,
}

impl Operation {
    /// Whether a point belongs to the result, given whether it belongs to the operands.
    #[must_use]
    pub fn holds(self, first: bool, second: bool) -> bool {
        match self {
            Self::Union => first || second,
            Self::Intersection => first && second,
            Self::Difference => first && !second,
            Self::SymmetricDifference => first != second,
        }
    }
}

/// The result of a set operation on two regions, valid or results themselves, in input units. The complement of a region
/// needs no arrangement: [`Region::complement`].
///
/// # Errors
/// [`SmoothError`] if a segment has no geometry.
pub fn combine(operation: Operation, a: &Region, b: &Region) -> Result<Region, SmoothError> {
    let frame = Frame::shared(&[a, b]);
    let mut pieces = Pieces::default();
    for (operand, region) in [a, b].into_iter().enumerate() {
        add(&mut pieces, &Boundary::new(region, &frame)?, operand as u8);
        pieces.base[operand] = i32::from(region.unbounded);
    }
    let arrangement = arrange(&pieces);
    let loops = outline(&arrangement, &pieces, |w| operation.holds(w[0] != 0, w[1] != 0));
    Ok(region(&loops, operation.holds(a.unbounded, b.unbounded), |p| frame.to_input(p)))
}

/// Adds the boundary of a region as pieces of one operand.
fn add(pieces: &mut Pieces, boundary: &Boundary, operand: u8) {
    let first = pieces.points.len() as u32;
    pieces.points.extend(&boundary.points);
    pieces.pieces.extend(boundary.pieces(operand).into_iter().map(|mut piece| {
        piece.tail += first;
        piece.head += first;
        piece.whole = piece.whole.map(|vertex| vertex + first);
        piece.source.second = u32::from(operand);
        piece
    }));
}
