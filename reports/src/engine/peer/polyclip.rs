//! `polyclip` and `polyclip:minkowski`: the union and the sum of polyclip, which snap to the grid.

use super::{Abilities, EngineError, Outcome, Peer, Ring, UNITES, Way};
use polyclip::{FillRule, Point, Polygon, PolygonSet, minkowski_sum, union_all};

/// The version of the crate.
const VERSION: &str = "0.0.6";

/// Its coordinates may need 40 bits.
const BITS: i32 = 38;

/// The union.
pub const UNION: Peer =
    Peer { name: "polyclip", version: VERSION, abilities: UNITES, way: Way::Union { bits: BITS, unite } };

/// Its own sum, of two polygons with holes.
pub const MINKOWSKI: Peer = Peer {
    name: "polyclip:minkowski",
    version: VERSION,
    abilities: Abilities { holes: true, ..Abilities::NONE },
    way: Way::Minkowski { bits: BITS, sum },
};

fn unite(rings: &[Ring]) -> Outcome {
    let rings: Vec<polyclip::Ring> = rings.iter().map(given).collect();
    union_all(&rings, FillRule::NonZero).map(taken).map_err(failed)
}

fn sum(a: &[Ring], b: &[Ring]) -> Outcome {
    minkowski_sum(&polygon(a)?, &polygon(b)?).map(taken).map_err(failed)
}

/// One polygon: its loop that runs counter-clockwise, and the others as its holes.
fn polygon(loops: &[Ring]) -> Result<Polygon, EngineError> {
    let (outer, holes): (Vec<_>, Vec<_>) = loops.iter().map(given).partition(polyclip::Ring::is_ccw);
    let [outer] = <[polyclip::Ring; 1]>::try_from(outer)
        .map_err(|outer| EngineError::Invalid(format!("{} loops on the grid are outer ones", outer.len())))?;
    Ok(Polygon::new(outer, holes))
}

fn given(ring: &Ring) -> polyclip::Ring {
    ring.iter().map(|&[x, y]| Point::new(x, y)).collect()
}

fn taken(polygons: PolygonSet) -> Vec<Ring> {
    polygons.iter().flat_map(Polygon::rings).map(|ring| ring.iter().map(|p| [p.x, p.y]).collect()).collect()
}

fn failed(error: polyclip::Error) -> EngineError {
    EngineError::Invalid(error.to_string())
}
