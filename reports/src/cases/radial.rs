//! Star-shaped polygons around the origin (memo J5): stars with jitter, noisy radii, and rounded ones with circle segments
//! for edges.

use super::rng::Rng;
use super::shape::{Point, polar, polygon, region};
use arcsum::region::{Curve, Node, Region};
use std::f64::consts::TAU;

/// Two stars of n points: radii 1 and 0.4 in turn, each off by up to 5%, at slightly uneven angles.
pub fn stars(n: u32, rng: &mut Rng) -> (Region, Region) {
    (polygon(&star(n, rng)), polygon(&star(n, rng)))
}

/// Two polygons of n vertices with random radii in [0.3, 1] at sorted random angles.
pub fn noisy(n: u32, rng: &mut Rng) -> (Region, Region) {
    (polygon(&noise(n, rng)), polygon(&noise(n, rng)))
}

/// A star of 2n vertices.
pub fn star(n: u32, rng: &mut Rng) -> Vec<Point> {
    let corner = |i: u32| {
        let radius = if i.is_multiple_of(2) { 1.0 } else { 0.4 };
        let angle = TAU * (f64::from(i) + rng.between(-0.2, 0.2)) / f64::from(2 * n);
        polar(radius * rng.between(0.95, 1.05), angle)
    };
    (0..2 * n).map(corner).collect()
}

/// A star-shaped polygon of n vertices with noisy radii: one vertex in each of n equal sectors.
pub fn noise(n: u32, rng: &mut Rng) -> Vec<Point> {
    let corner = |i: u32| {
        let angle = TAU * (f64::from(i) + rng.between(0.1, 0.9)) / f64::from(n);
        polar(rng.between(0.3, 1.0), angle)
    };
    (0..n).map(corner).collect()
}

/// How the arcs of [`bulging`] bend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bending {
    /// All outwards.
    Out,
    /// Outwards and inwards by turns.
    InTurn,
    /// At random outwards, inwards or straight.
    AtRandom,
}

/// A region of n circle segments over the edges of a polygon inscribed in the unit circle.
///
/// Simple by construction: an arc stays in the triangle over its chord whose base angles are half its sweep; inwards
/// these are kept below half the angle of the polygon at each end, so the bisectors there keep neighbours apart.
pub fn bulging(n: u32, bending: Bending, rng: &mut Rng) -> Region {
    let step = TAU / f64::from(n);
    let corner = |i: u32| {
        // Gaps between vertices stay below 1.4 steps, so every angle of the polygon is above pi - 1.4 step.
        let p = polar(1.0, step * (f64::from(i) + rng.between(-0.2, 0.2)));
        let half_angle = 0.5 * (0.5 * TAU - 1.4 * step);
        let half_sweep = half_angle.max(0.1) * rng.between(0.2, 0.8);
        let sign = match bending {
            Bending::Out => 1.0,
            Bending::InTurn => [1.0, -1.0][i as usize % 2],
            Bending::AtRandom => [1.0, -1.0, 0.0][rng.below(3)],
        };
        let bulge = sign * libm::tan(half_sweep / 2.0);
        let curve = if bulge == 0.0 { Curve::Line } else { Curve::Bulge(bulge) };
        Node { x: p[0], y: p[1], curve }
    };
    region(vec![(0..n).map(corner).collect()])
}
