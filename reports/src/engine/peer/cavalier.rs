//! `cavalier`: the sum with a disc as Cavalier Contours' parallel offset of a shape, holes included.
//!
//! The crate takes and gives arcs of at most half a circle, by their bulges, and compares positions by absolute lengths,
//! 1e-5 and 1e-4 by default. Those are left as they are, and the unit box is 1024 wide: a drawing in millimetres. Its time is
//! that of the offset with the box indices it takes, not of bringing regions to it.

use super::curves::without_repeats;
use super::{Abilities, EngineError, Loops, Offset, Peer, Way};
use arcsum::arc::Arc;
use arcsum::region::{Curve, Node};
use cavalier_contours::polyline::{PlineCreation, PlineSource, PlineSourceMut, PlineVertex, Polyline};
use cavalier_contours::shape_algorithms::{Shape, ShapeOffsetOptions};
use glam::DVec2;
use std::time::Instant;

/// The parallel offset.
pub const OFFSET: Peer = Peer {
    name: "cavalier",
    version: "0.9.0",
    abilities: Abilities { unbounded: false, discs_only: true, ..Abilities::ALL },
    way: Way::Offset { bits: 10, offset },
};

fn offset(loops: &Loops, radius: f64) -> Result<Offset, EngineError> {
    let given = loops.iter().map(|nodes| polyline(nodes)).collect::<Result<Vec<_>, _>>()?;
    let start = Instant::now();
    // Outwards is negative, to the right of the boundary.
    let grown = Shape::from_plines(given).parallel_offset(-radius, &ShapeOffsetOptions::new());
    let time = start.elapsed();
    let loops = grown.ccw_plines.iter().chain(&grown.cw_plines).map(|indexed| nodes(&indexed.polyline)).collect();
    Ok(Offset { loops, time })
}

fn polyline(nodes: &[Node]) -> Result<Polyline<f64>, EngineError> {
    let mut line = Polyline::with_capacity(nodes.len(), true);
    for (i, node) in nodes.iter().enumerate() {
        let next = &nodes[(i + 1) % nodes.len()];
        let (tail, head) = (DVec2::new(node.x, node.y), DVec2::new(next.x, next.y));
        let bulge = bulge(tail, head, node.curve).ok_or_else(|| EngineError::Invalid("an arc cannot be".into()))?;
        if bulge.abs() <= 1.0 {
            line.add(tail.x, tail.y, bulge);
        } else {
            halves(&mut line, tail, head, bulge)?;
        }
    }
    Ok(line)
}

/// The bulge of a curve between two points; none for an arc that cannot be.
fn bulge(tail: DVec2, head: DVec2, curve: Curve) -> Option<f64> {
    match curve {
        Curve::Line => Some(0.0),
        Curve::Bulge(bulge) => Some(bulge),
        Curve::Radius(r) => Arc::with_radius(tail, head, r).ok().map(|arc| libm::tan(arc.delta() / 2.0)),
    }
}

/// Adds an arc beyond half a circle as two.
fn halves(line: &mut Polyline<f64>, tail: DVec2, head: DVec2, bulge: f64) -> Result<(), EngineError> {
    let arc = Arc::with_bulge(tail, head, bulge).map_err(|error| EngineError::Invalid(error.to_string()))?;
    let (end, way) = arc.offset(arc.a().plus(arc.delta()));
    let (middle, half) = (end + way, libm::tan(libm::atan(bulge) / 2.0));
    line.add(tail.x, tail.y, half);
    line.add(middle.x, middle.y, half);
    Ok(())
}

fn nodes(line: &Polyline<f64>) -> Vec<Node> {
    let node = |v: PlineVertex<f64>| {
        let curve = if v.bulge == 0.0 { Curve::Line } else { Curve::Bulge(v.bulge) };
        Node { x: v.x, y: v.y, curve }
    };
    without_repeats(line.iter_vertexes().map(node).collect())
}
