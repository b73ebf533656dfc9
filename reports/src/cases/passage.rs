//! Tight places (memo J5, F): a room whose corridor fits a square robot exactly or within 2^-k, containers for parts,
//! regions far from the origin, and polygons against nearly themselves.

use super::place::{moved, scaled, turned};
use super::radial::noise;
use super::rng::Rng;
use super::shape::{Point, backwards, lines, polygon, rectangle, region, regular};
use arcsum::region::Region;

/// How the width of a corridor compares to the robot of width 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    /// The same.
    Exact,
    /// Wider by 2^-k.
    Wider(u32),
    /// Narrower by 2^-k.
    Narrower(u32),
}

/// A room of two chambers joined by a corridor, and the mirrored unit square that wants through.
#[must_use]
pub fn passage(fit: Fit) -> (Region, Region) {
    let width = match fit {
        Fit::Exact => 1.0,
        Fit::Wider(k) => 1.0 + libm::scalbn(1.0, -(k as i32)),
        Fit::Narrower(k) => 1.0 - libm::scalbn(1.0, -(k as i32)),
    };
    let walls = rectangle([0.0, 0.0], [12.0, 6.0]);
    // The lower chamber walls, the corridor from x = 5 to 7, and back along the upper walls.
    let free: Vec<Point> = vec![
        [1.0, 1.0],
        [5.0, 1.0],
        [5.0, 2.0],
        [7.0, 2.0],
        [7.0, 1.0],
        [11.0, 1.0],
        [11.0, 5.0],
        [7.0, 5.0],
        [7.0, 2.0 + width],
        [5.0, 2.0 + width],
        [5.0, 5.0],
        [1.0, 5.0],
    ];
    let robot = Region { name: None, ..polygon(&rectangle([0.0, 0.0], [1.0, 1.0])).negated() };
    (region(vec![lines(&walls), backwards(&free)]), robot)
}

/// The plane without a container, and the mirrored part to be put in: a noisy polygon in a box just wide enough
/// (`slack` 1), too narrow (below), or roomy.
pub fn container(slack: f64, rng: &mut Rng) -> (Region, Region) {
    let part = noise(12, rng);
    let bound = |k: usize, pick: fn(f64, f64) -> f64| part.iter().map(|p| p[k]).reduce(pick).unwrap_or(0.0);
    let lo = [bound(0, f64::min), bound(1, f64::min)];
    let hi = [bound(0, f64::max), bound(1, f64::max)];
    let box_hi = [lo[0] + slack * (hi[0] - lo[0]), lo[1] + slack * (hi[1] - lo[1])];
    let outside = polygon(&rectangle(lo, box_hi)).complement();
    (outside, Region { name: None, ..polygon(&part).negated() })
}

/// Two noisy polygons of ten vertices, the first 2^k away from the origin.
pub fn far(k: u32, rng: &mut Rng) -> (Region, Region) {
    let away = libm::scalbn(1.0, k as i32);
    (moved(&polygon(&noise(10, rng)), [away, -away]), polygon(&noise(10, rng)))
}

/// A regular 24-gon and its mirror image turned by 2^-k radians: all edges nearly parallel in pairs.
#[must_use]
pub fn nearly(k: u32) -> (Region, Region) {
    let one = polygon(&regular(24, 1.0, 0.05));
    let other = turned(&one.negated(), libm::scalbn(1.0, -(k as i32)));
    (one, Region { name: None, ..other })
}

/// A noisy polygon of twenty vertices against one 2^-k its size.
pub fn tiny(k: u32, rng: &mut Rng) -> (Region, Region) {
    let small = scaled(&polygon(&noise(20, rng)), libm::scalbn(1.0, -(k as i32)));
    (polygon(&noise(20, rng)), small)
}
