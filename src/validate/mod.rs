//! Whether a region is what the engine may assume (memo A1, A4, A8; design of the file formats): finite, closed, simple,
//! oriented and properly nested. Returns nothing, or the first defect found as an [`Invalid`].
//!
//! Between lines every answer is exact ([`crate::exact`]). Where a circle segment takes part the answer is floating
//! point: only clear defects count, those that a displacement by the tolerance [`boundary::Boundary::tolerance`], 2^-40
//! times the largest coordinate, cannot undo. Contacts closer than that pass between different loops and are defects
//! within one loop, where they pinch the region off; so may be corners between curves that are sharper than 2^-22 radians.
//!
//! Different loops may touch in isolated points as long as each connected part of the region keeps a connected interior:
//! among an outer loop and its holes no ring of touching loops may close. Loops of different parts may touch at will.

mod arc;
mod boundary;
mod boxes;
mod contacts;
mod invalid;
mod line;
mod nesting;
mod shape;
mod sweep;
mod touch;

pub use invalid::{Contact, Invalid, Meeting, Place};

use crate::region::Region;
use boundary::Boundary;
use nesting::Nesting;

/// The greatest number of vertices of a region.
pub const MAX_VERTICES: usize = 1_000_000;

/// Checks a region of n segments in O(n log n) for lines, plus the number of pairs of a circle segment and another segment
/// whose bounding boxes meet, plus the number of segments that horizontal rays from one vertex a loop meet.
pub fn validate(region: &Region) -> Result<(), Invalid> {
    let grid = shape::check(region)?;
    let boundary = Boundary::new(region, grid);
    let clockwise = nesting::directions(&boundary)?;
    let tree = contacts::tree(&boundary);
    let touches = contacts::check(&boundary, &tree)?;
    let nesting = Nesting::new(&boundary, &tree, &clockwise, &touches, region.unbounded)?;
    touch::check(&boundary, &touches, &nesting)
}
