//! Defects that show in one number, one segment or one loop alone (memo A4 step 2). Returns the grid of the coordinates.

use super::{Invalid, MAX_VERTICES, Place};
use crate::exact::Grid;
use crate::region::{Curve, Node, Region};

/// 2^1000, the greatest coordinate.
const FARTHEST: f64 = f64::from_bits((1000 + 1023) << 52);

/// The share of the coordinates and the diameter by which a chord may exceed the diameter and still count as a half
/// circle: half an ulp in each of the four coordinates and the radius, twice.
const CHORD_SLACK: f64 = f64::EPSILON;

/// Checks numbers, segments and loops one by one.
pub fn check(region: &Region) -> Result<Grid, Invalid> {
    match region.segments() {
        0 if region.loops.is_empty() && !region.unbounded => return Err(Invalid::NoLoops),
        vertices if vertices > MAX_VERTICES => return Err(Invalid::TooManyVertices(vertices)),
        _ => {}
    }
    for (place, node, _) in segments(region) {
        check_numbers(place, node)?;
    }
    for (loop_index, nodes) in region.loops.iter().enumerate() {
        let only_lines = nodes.iter().all(|n| n.curve == Curve::Line);
        if nodes.len() < 2 || (nodes.len() == 2 && only_lines) {
            return Err(Invalid::OpenLoop { loop_index, vertices: nodes.len() });
        }
    }
    for (place, node, next) in segments(region) {
        check_segment(place, node, next)?;
    }
    grid(region)
}

/// All segments: the place and node each one leaves and the node it reaches.
fn segments(region: &Region) -> impl Iterator<Item = (Place, &Node, &Node)> {
    region.loops.iter().enumerate().flat_map(|(loop_index, nodes)| {
        let heads = nodes.iter().cycle().skip(1);
        nodes
            .iter()
            .zip(heads)
            .enumerate()
            .map(move |(vertex, (tail, head))| (Place { loop_index, vertex }, tail, head))
    })
}

fn check_numbers(place: Place, node: &Node) -> Result<(), Invalid> {
    let shape = match node.curve {
        Curve::Line => 0.0,
        Curve::Radius(r) | Curve::Bulge(r) => r,
    };
    if ![node.x, node.y, shape].iter().all(|v| v.is_finite()) {
        return Err(Invalid::NotFinite(place));
    }
    if node.x.abs().max(node.y.abs()) > FARTHEST {
        return Err(Invalid::TooFar(place));
    }
    Ok(())
}

fn check_segment(place: Place, tail: &Node, head: &Node) -> Result<(), Invalid> {
    if tail.x == head.x && tail.y == head.y {
        return Err(Invalid::ZeroLength(place));
    }
    if farthest(tail, head) > FARTHEST {
        return Err(Invalid::TooFar(place));
    }
    let Curve::Radius(radius) = tail.curve else { return Ok(()) };
    let (chord, diameter) = (chord(tail, head), 2.0 * radius.abs());
    let sum = tail.x.abs() + tail.y.abs() + head.x.abs() + head.y.abs() + diameter;
    if chord - diameter > CHORD_SLACK * sum {
        return Err(Invalid::LongChord { place, chord, diameter });
    }
    Ok(())
}

/// The distance of the ends, in input units.
pub fn chord(tail: &Node, head: &Node) -> f64 {
    libm::hypot(head.x - tail.x, head.y - tail.y)
}

/// A bound on the coordinates of the segment.
pub fn farthest(tail: &Node, head: &Node) -> f64 {
    let ends = tail.x.abs().max(tail.y.abs()).max(head.x.abs()).max(head.y.abs());
    match tail.curve {
        Curve::Line => ends,
        // A minor segment keeps within half its chord of its ends, a bulge b of at least 1 within its diameter,
        // which is at most b chords.
        Curve::Radius(_) => ends + chord(tail, head),
        Curve::Bulge(bulge) => ends + bulge.abs() * chord(tail, head),
    }
}

/// The grid of the coordinates, with room for how far the circle segments reach.
fn grid(region: &Region) -> Result<Grid, Invalid> {
    let reach = segments(region).map(|(_, tail, head)| farthest(tail, head)).fold(0.0, f64::max);
    // One bit says how far; the bits below it would only widen the spread.
    let reach = f64::from_bits(reach.to_bits() & (0x7ff << 52));
    let coordinates = region.loops.iter().flatten().flat_map(|n| [n.x, n.y]);
    Grid::of(coordinates.chain([reach])).map_err(Invalid::TooWide)
}
