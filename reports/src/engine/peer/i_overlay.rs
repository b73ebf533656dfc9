//! `i_overlay` and `i_overlay:i64`: the union of iOverlay in its two widths of integers.

use super::{Outcome, Peer, Ring, UNITES, Way};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::integer::OverlayInt;
use i_overlay::core::overlay::Overlay;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;

/// The version of the crate.
const VERSION: &str = "9.1.0";

/// With 32 bits, the crate's default: coordinates may need 30.
pub const NARROW: Peer =
    Peer { name: "i_overlay", version: VERSION, abilities: UNITES, way: Way::Union { bits: 28, unite: unite_narrow } };

/// With 64 bits: coordinates may need 62.
pub const WIDE: Peer = Peer {
    name: "i_overlay:i64",
    version: VERSION,
    abilities: UNITES,
    way: Way::Union { bits: 60, unite: unite_wide },
};

fn unite_narrow(rings: &[Ring]) -> Outcome {
    unite(rings, |x| x as i32, i64::from)
}

fn unite_wide(rings: &[Ring]) -> Outcome {
    unite(rings, |x| x, |x| x)
}

/// The union, between two ways to change integers.
fn unite<I: OverlayInt>(rings: &[Ring], to: fn(i64) -> I, from: fn(I) -> i64) -> Outcome {
    let given = |ring: &Ring| ring.iter().map(|&[x, y]| IntPoint { x: to(x), y: to(y) }).collect();
    let contours: Vec<Vec<IntPoint<I>>> = rings.iter().map(given).collect();
    let shapes = Overlay::from_subj(&contours).overlay(OverlayRule::Subject, FillRule::NonZero);
    let taken = |ring: Vec<IntPoint<I>>| ring.into_iter().map(|p| [from(p.x), from(p.y)]).collect();
    Ok(shapes.into_iter().flatten().map(taken).collect())
}
