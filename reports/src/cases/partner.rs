//! Whom a single region is summed with when nobody named a partner: its own negative (contact everywhere), and for
//! regions with arcs a disc of 1% and one of 10% of its size (offsets).

use super::shape::{disc, extent};
use arcsum::region::Region;

/// The partners of a region, each with a label for the case's name.
#[must_use]
pub fn partners(region: &Region) -> Vec<(&'static str, Region)> {
    // A region and its negative are both unbounded or neither; two unbounded operands sum to the plane.
    let mut all = vec![("negative", region.negated())];
    if !region.is_polygonal() {
        let size = extent(region);
        all.push(("disc1", disc(0.005 * size)));
        all.push(("disc10", disc(0.05 * size)));
    }
    all
}
