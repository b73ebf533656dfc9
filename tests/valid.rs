//! Regions that are valid by construction, as proptest strategies.

use arcsum::region::{Curve, Node, Region};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// A region of one loop.
#[must_use]
pub fn single(nodes: Vec<Node>) -> Region {
    Region { name: None, loops: vec![nodes], unbounded: false }
}

/// A loop of lines through these points.
#[must_use]
pub fn polygon(points: &[(f64, f64)]) -> Vec<Node> {
    points.iter().map(|&(x, y)| Node::line(x, y)).collect()
}

/// The counter-clockwise square between two corners.
#[must_use]
pub fn square(min: f64, max: f64) -> Vec<Node> {
    polygon(&[(min, min), (max, min), (max, max), (min, max)])
}

/// The vertices in opposite order, for loops of lines.
#[must_use]
pub fn backwards(mut nodes: Vec<Node>) -> Vec<Node> {
    nodes.reverse();
    nodes
}

/// Polygons of 5 to 60 vertices that are star-shaped around the origin: angles increase by less than half a turn, radii are
/// between 1 and 10.
pub fn stars() -> impl Strategy<Value = Vec<Node>> {
    prop::collection::vec((0.0..0.9, 1.0..10.0), 5..60).prop_map(|polar| {
        let n = polar.len() as f64;
        let point = |(i, (jitter, radius)): (usize, (f64, f64))| {
            let angle = TAU * (i as f64 + jitter) / n;
            Node::line(radius * libm::cos(angle), radius * libm::sin(angle))
        };
        polar.into_iter().enumerate().map(point).collect()
    })
}

/// Loops of 8 to 60 circle segments and lines between points on a circle. The tangents leave the chords by at most 33
/// degrees, so neighbours, at more than 135 degrees, keep apart.
pub fn petals() -> impl Strategy<Value = Vec<Node>> {
    let curve = prop_oneof![
        (-0.3..0.3).prop_map(Curve::Bulge),
        Just(Curve::Line),
        (1.9..9.0).prop_map(Curve::Radius),
        (1.9..9.0).prop_map(|r: f64| Curve::Radius(-r)),
    ];
    (prop::collection::vec(curve, 8..60), 0.0..TAU).prop_map(|(curves, turn)| {
        let (n, radius) = (curves.len() as f64, 4.5);
        let node = |(i, curve)| {
            let angle = TAU * i as f64 / n + turn;
            Node { x: radius * libm::cos(angle), y: radius * libm::sin(angle), curve }
        };
        curves.into_iter().enumerate().map(node).collect()
    })
}
