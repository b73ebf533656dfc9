//! `clipper2:union`, `clipper2:flat-1e-3`, `clipper2:flat-1e-6` and `clipper2:minkowski`: Angus Johnson's C++ library by its
//! binding of the same name.
//!
//! The flat ones take chords for arcs, with a sagitta of at most so many unit-box lengths.
//! Its own sum is that of the two boundaries: it has a hole where one operand fits inside the other.

use super::{Abilities, EngineError, Outcome, Peer, Ring, UNITES, UNITES_ARCS, Way};
use clipper2::{ClipperError, FillRule, One, Path, Paths, Point, minkowski_sum, union};

/// The versions of the crate and of what it binds.
const VERSION: &str = "0.6.0 (Clipper2 2.0.1)";

/// It finds crossings in doubles, so integers should be exact as such: 52 bits.
const BITS: i32 = 50;

/// The union.
pub const UNION: Peer =
    Peer { name: "clipper2:union", version: VERSION, abilities: UNITES, way: Way::Union { bits: BITS, unite } };

/// The union, arcs flattened coarsely.
pub const COARSE: Peer = Peer {
    name: "clipper2:flat-1e-3",
    version: VERSION,
    abilities: UNITES_ARCS,
    way: Way::Flat { sagitta: 1e-3, bits: BITS, unite },
};

/// The union, arcs flattened finely.
pub const FINE: Peer = Peer {
    name: "clipper2:flat-1e-6",
    version: VERSION,
    abilities: UNITES_ARCS,
    way: Way::Flat { sagitta: 1e-6, bits: BITS, unite },
};

/// Its own sum, of two paths.
pub const MINKOWSKI: Peer = Peer {
    name: "clipper2:minkowski",
    version: VERSION,
    abilities: Abilities::NONE,
    way: Way::Minkowski { bits: BITS, sum },
};

fn unite(rings: &[Ring]) -> Outcome {
    let failed = |error: ClipperError| EngineError::Invalid(error.to_string());
    union::<One>(given(rings), Paths::new(Vec::new()), FillRule::NonZero).map(taken).map_err(failed)
}

fn sum(a: &[Ring], b: &[Ring]) -> Outcome {
    let [pattern] = a else { return Err(EngineError::Invalid("the first operand is not one path".into())) };
    Ok(taken(minkowski_sum::<One>(path(pattern), given(b), true)))
}

fn given(rings: &[Ring]) -> Paths<One> {
    rings.iter().map(path).collect()
}

fn path(ring: &Ring) -> Path<One> {
    Path::new(ring.iter().map(|&[x, y]| Point::from_scaled(x, y)).collect())
}

fn taken(paths: Paths<One>) -> Vec<Ring> {
    paths.iter().map(|path| path.iter().map(|p| [p.x_scaled(), p.y_scaled()]).collect()).collect()
}
