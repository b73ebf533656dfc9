//! Regions of several components: fat grids of bars, robots among convex obstacles, islands with lakes (memo J5, A8).

use super::radial::{noise, star};
use super::rng::Rng;
use super::shape::{Point, backwards, lines, moved, polar, polygon, rectangle, region};
use arcsum::region::Region;
use std::f64::consts::TAU;

/// A fat grid: both operands are p upright and p level thin bars. Upright plus level bars are fat and cover the middle;
/// upright plus upright and level plus level are thin and cross all of it.
#[must_use]
pub fn fat_grid(p: u32) -> (Region, Region) {
    let (length, width) = (10.0, 0.05);
    let aside = f64::from(p + 1);
    let bars = |pitch: f64| {
        let at = |i: u32| f64::from(i) * pitch;
        let upright = (0..p).map(move |i| rectangle([at(i), 0.0], [at(i) + width, length]));
        let level = (0..p).map(move |i| rectangle([aside, at(i)], [aside + length, at(i) + width]));
        region(upright.chain(level).map(|r| lines(&r)).collect())
    };
    // Different pitches, so that the sums of equal bars do not coincide.
    (bars(1.0), bars(0.77))
}

/// A star-shaped robot, mirrored as for motion planning, among p * p random convex obstacles in the cells of a grid.
pub fn robot(p: u32, rng: &mut Rng) -> (Region, Region) {
    let robot = polygon(&star(4, rng)).negated();
    let pitch = 3.0;
    let obstacles = grid(p).map(|at| lines(&moved(&convex(rng), [at[0] * pitch, at[1] * pitch]))).collect();
    (region(obstacles), Region { name: None, ..robot })
}

/// Islands with a lake each, p * p of them, with noisy shores, and a small noisy polygon.
pub fn islands(p: u32, rng: &mut Rng) -> (Region, Region) {
    let mut loops = Vec::new();
    for at in grid(p) {
        let at = [2.5 * at[0], 2.5 * at[1]];
        let shore = noise(9, rng);
        // Half the shore about a point it is star-shaped from: inside it.
        let lake: Vec<Point> = shore.iter().map(|q| [q[0] * 0.5, q[1] * 0.5]).collect();
        loops.push(lines(&moved(&shore, at)));
        loops.push(backwards(&moved(&lake, at)));
    }
    let size = rng.between(0.05, 0.6);
    let part: Vec<Point> = noise(7, rng).iter().map(|q| [q[0] * size, q[1] * size]).collect();
    (region(loops), polygon(&part))
}

fn grid(p: u32) -> impl Iterator<Item = Point> {
    (0..p).flat_map(move |i| (0..p).map(move |j| [f64::from(i), f64::from(j)]))
}

/// A convex polygon of 3 to 8 vertices inscribed in a circle of radius 0.3 to 1, the vertices in equal sectors.
fn convex(rng: &mut Rng) -> Vec<Point> {
    let corners = 3 + rng.below(6) as u32;
    let radius = rng.between(0.3, 1.0);
    let sector = TAU / f64::from(corners);
    (0..corners).map(|i| polar(radius, sector * (f64::from(i) + rng.between(0.0, 0.7)))).collect()
}
