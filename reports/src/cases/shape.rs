//! Small constructors shared by the generators: rectangles, regular polygons, discs, rings of points.

use arcsum::region::{Curve, Node, Region};
use libm::{cos, sin};
use std::f64::consts::TAU;

/// A point in input units.
pub type Point = [f64; 2];

/// A loop of lines through the points, in their order.
#[must_use]
pub fn lines(points: &[Point]) -> Vec<Node> {
    points.iter().map(|&[x, y]| Node::line(x, y)).collect()
}

/// The same loop of lines the other way round, as a hole wants it.
#[must_use]
pub fn backwards(points: &[Point]) -> Vec<Node> {
    points.iter().rev().map(|&[x, y]| Node::line(x, y)).collect()
}

/// The bounded region with these loops.
#[must_use]
pub fn region(loops: Vec<Vec<Node>>) -> Region {
    Region { name: None, loops, unbounded: false }
}

/// The simple polygon through the points, counter-clockwise.
#[must_use]
pub fn polygon(points: &[Point]) -> Region {
    region(vec![lines(points)])
}

/// The corners of the rectangle from `lo` to `hi`, counter-clockwise.
#[must_use]
pub fn rectangle(lo: Point, hi: Point) -> Vec<Point> {
    vec![lo, [hi[0], lo[1]], hi, [lo[0], hi[1]]]
}

/// The point at this radius and angle (radians) around the origin.
#[must_use]
pub fn polar(radius: f64, angle: f64) -> Point {
    [radius * cos(angle), radius * sin(angle)]
}

/// The corners of a regular polygon around the origin, counter-clockwise, the first at `phase` radians.
#[must_use]
pub fn regular(corners: u32, radius: f64, phase: f64) -> Vec<Point> {
    (0..corners).map(|i| polar(radius, phase + TAU * f64::from(i) / f64::from(corners))).collect()
}

/// The points moved by `by`.
#[must_use]
pub fn moved(points: &[Point], by: Point) -> Vec<Point> {
    points.iter().map(|p| [p[0] + by[0], p[1] + by[1]]).collect()
}

/// A disc around the origin: two half circles.
#[must_use]
pub fn disc(radius: f64) -> Region {
    let half = |x: f64| Node { x, y: 0.0, curve: Curve::Bulge(1.0) };
    region(vec![vec![half(radius), half(-radius)]])
}

/// The larger side of the bounding box of the vertices. Arcs may reach beyond it: good for choosing sizes only.
#[must_use]
pub fn extent(region: &Region) -> f64 {
    let nodes = || region.loops.iter().flatten();
    let side = |f: fn(&Node) -> f64| {
        let (lo, hi) = nodes().map(f).fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v), hi.max(v)));
        hi - lo
    };
    if nodes().next().is_none() { 0.0 } else { side(|n| n.x).max(side(|n| n.y)) }
}
