//! Exact set operations on polygonal regions (memo D): the operands are two layers of one set of curves, and the truth
//! table of the operation selects by the two winding numbers. Returns the closure of the selected cells' interior.
//!
//! Loops in normal form wind once around the interior of their region and not at all around the rest (far away an
//! unbounded region starts from 1), so w(A) and w(B) are 0 or 1 off the boundaries and tell who is inside. In one layer,
//! with the numbers added up, the same sets are
//!
//! * union: w(A) + w(B) > 0, one of the two is 1;
//! * intersection: w(A) + w(B) > 1, both are;
//! * difference, the loops of B reversed: w(A) - w(B) > 0, only if w(A) = 1 and w(B) = 0;
//! * symmetric difference, likewise: w(A) - w(B) is not 0.
//!
//! The tests hold the layers against these sums.

use crate::arrange::boundaries;
use crate::curves::Curves;
use crate::error::{Budget, OracleError};
use crate::number::Number;
use crate::region::ExactRegion;

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
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Union, Self::Intersection, Self::Difference, Self::SymmetricDifference];

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

    /// The same for the winding numbers of two layers.
    fn table(self) -> fn(&[i32; 2]) -> bool {
        match self {
            Self::Union => |w| w[0] > 0 || w[1] > 0,
            Self::Intersection => |w| w[0] > 0 && w[1] > 0,
            Self::Difference => |w| w[0] > 0 && w[1] <= 0,
            Self::SymmetricDifference => |w| (w[0] > 0) != (w[1] > 0),
        }
    }
}

/// The result of a set operation, in input units.
///
/// # Errors
/// [`OracleError::BadNumber`] for coordinates too large for doubles.
pub fn combine<Q: Number>(
    operation: Operation,
    a: &ExactRegion<Q>,
    b: &ExactRegion<Q>,
) -> Result<ExactRegion<Q>, OracleError> {
    let curves = Curves::of_regions([a, b]);
    let base = [a, b].map(|region| i32::from(region.unbounded()));
    let [edges] = boundaries(&curves, base, [operation.table()], Budget::NONE)?;
    ExactRegion::from_edges(edges, operation.holds(a.unbounded(), b.unbounded()))
}

#[cfg(test)]
mod tests {
    use super::Operation;

    #[test]
    fn winding_numbers_follow_the_truth_table() {
        for operation in Operation::ALL {
            for w in [[0, 0], [0, 1], [1, 0], [1, 1]] {
                assert_eq!(operation.table()(&w), operation.holds(w[0] > 0, w[1] > 0), "{operation:?} of {w:?}");
            }
        }
    }
}
