//! Chains and turning points of the engine's polygons, by the oracle's definition.

pub use arcsum_oracle::chains::{Chain, Point, chains, concave, convolved, extreme, winding};

use arcsum::region::Region;
use arcsum_reports::bridge::plain;

/// The rings of a polygon with doubles for coordinates.
///
/// # Panics
/// If a segment is bent or a coordinate is not finite.
#[must_use]
pub fn rings(region: &Region) -> Vec<Vec<Point>> {
    arcsum_oracle::chains::rings(&plain(region))
}
