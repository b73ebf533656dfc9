//! Rng valid regions that shrink: loops around a point, bent at will, with holes.

use arcsum::region::{Curve, Node, Region};
use arcsum::validate::validate;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;
use rug::Rational;
use std::f64::consts::TAU;

/// How a coordinate is made of a number in [-1, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lattice {
    /// As it is.
    Fine,
    /// Rounded to integers up to this.
    Integers(i32),
}

impl Lattice {
    fn place(self, x: f64) -> f64 {
        match self {
            Self::Fine => x,
            Self::Integers(n) => (x * f64::from(n)).round(),
        }
    }
}

/// A loop around a centre: gaps between directions, radii, bulges.
fn loop_around(corners: std::ops::Range<usize>, bend: f64) -> impl Strategy<Value = Vec<(f64, f64, f64)>> {
    let bulge = if bend == 0.0 { Just(0.0).boxed() } else { prop_oneof![Just(0.0), (-bend..bend)].boxed() };
    prop::collection::vec((0.2..1.0, 0.25..1.0, bulge), corners)
}

fn nodes(spokes: &[(f64, f64, f64)], centre: (f64, f64), size: f64, lattice: Lattice) -> Vec<Node> {
    let total: f64 = spokes.iter().map(|s| s.0).sum();
    let mut angle = 0.0;
    let mut out = Vec::new();
    for &(gap, radius, bulge) in spokes {
        let x = lattice.place(centre.0 + size * radius * f64::cos(angle));
        let y = lattice.place(centre.1 + size * radius * f64::sin(angle));
        let curve = if bulge == 0.0 { Curve::Line } else { Curve::Bulge(bulge) };
        out.push(Node { x, y, curve });
        angle += TAU * gap / total;
    }
    out
}

/// A valid region of one loop with up to `most` corners; `bend` is the largest bulge.
pub fn simple(most: usize, bend: f64, lattice: Lattice) -> impl Strategy<Value = Region> {
    loop_around(3..most + 1, bend).prop_filter_map("not simple", move |spokes| {
        let region = Region { loops: vec![nodes(&spokes, (0.0, 0.0), 1.0, lattice)], ..Region::default() };
        validate(&region).is_ok().then_some(region)
    })
}

/// A valid region with up to three holes.
pub fn holed(most: usize, bend: f64, lattice: Lattice) -> impl Strategy<Value = Region> {
    let hole = (loop_around(3..6, bend), -0.5..0.5, -0.5..0.5, 0.05..0.4);
    (loop_around(5..most + 1, bend), prop::collection::vec(hole, 0..4)).prop_filter_map(
        "not valid",
        move |(outer, holes)| {
            let mut region = Region { loops: vec![nodes(&outer, (0.0, 0.0), 1.0, lattice)], ..Region::default() };
            validate(&region).ok()?;
            for (spokes, x, y, size) in holes {
                let bounded = Region { loops: vec![nodes(&spokes, (x, y), size, lattice)], ..Region::default() };
                region.loops.extend(bounded.complement().loops);
                if validate(&region).is_err() {
                    region.loops.pop();
                }
            }
            Some(region)
        },
    )
}

/// Any of the above.
pub fn any_region() -> impl Strategy<Value = Region> {
    prop_oneof![
        simple(8, 0.0, Lattice::Fine),
        simple(8, 0.4, Lattice::Fine),
        simple(8, 0.0, Lattice::Integers(4)),
        holed(8, 0.3, Lattice::Fine),
        holed(8, 0.0, Lattice::Integers(12)),
    ]
}

/// A number moved by some units in its last place, or in that of 1/16 if it is smaller.
fn nudged(x: f64, by: i8) -> f64 {
    let size = x.abs().max(0.0625);
    x + f64::from(by) * (size.next_up() - size)
}

/// A bar: its lowest and highest ordinate, nudges of its coordinates, slants of its ends.
type Bar = (f64, f64, [i8; 8], [f64; 4]);

fn bar(index: usize, (low, high, ulps, slants): &Bar, upright: bool) -> Vec<Node> {
    let (left, right) = (f64::from(2 * index as u32) / 17.0, f64::from(2 * index as u32 + 1) / 17.0);
    let corners = [(left, -low), (right, -low), (right, *high), (left, *high)];
    let node = |k: usize| {
        let (x, y) = (nudged(corners[k].0, ulps[2 * k]), nudged(corners[k].1 + slants[k], ulps[2 * k + 1]));
        if upright { Node::line(x, y) } else { Node::line(-y, x) }
    };
    (0..4).map(node).collect()
}

/// Parallel bars, upright or lying, whose coordinates are a few units in the last place off: nearly vertical and nearly
/// horizontal lines everywhere.
pub fn bars() -> impl Strategy<Value = Region> {
    let one = (0.1..2.0, 0.1..2.0, prop::array::uniform8(-3..=3_i8), prop::array::uniform4(-0.3..0.3));
    (prop::collection::vec(one, 1..5), any::<bool>()).prop_filter_map("not valid", |(bars, upright)| {
        let loops = bars.iter().enumerate().map(|(i, b)| bar(i, b, upright)).collect();
        let region = Region { loops, ..Region::default() };
        validate(&region).is_ok().then_some(region)
    })
}

/// A region whose coordinates are a few units in the last place off integers.
pub fn nudged_integers(most: usize, lattice: i32) -> impl Strategy<Value = Region> {
    let ulps = prop::collection::vec((-3..=3_i8, -3..=3_i8), most);
    (simple(most, 0.0, Lattice::Integers(lattice)), ulps).prop_filter_map("not valid", |(mut region, ulps)| {
        for (node, (x, y)) in region.loops[0].iter_mut().zip(ulps) {
            (node.x, node.y) = (nudged(node.x, x), nudged(node.y, y));
        }
        validate(&region).is_ok().then_some(region)
    })
}

/// A region and a copy of it whose coordinates are up to three units in the last place off.
pub fn nudged_copies(region: impl Strategy<Value = Region>) -> impl Strategy<Value = (Region, Region)> {
    let ulps = prop::collection::vec((-3..=3_i8, -3..=3_i8), 1..30);
    (region, ulps).prop_filter_map("not valid", |(region, ulps)| {
        let mut copy = region.clone();
        for (node, (x, y)) in copy.loops.iter_mut().flatten().zip(ulps.iter().cycle()) {
            (node.x, node.y) = (nudged(node.x, *x), nudged(node.y, *y));
        }
        validate(&copy).is_ok().then_some((region, copy))
    })
}

/// A region and a copy of it turned about one of its vertices by 2^-k for some k: nearly parallel edges that cross at
/// or near their ends.
pub fn turned_copies(region: impl Strategy<Value = Region>) -> impl Strategy<Value = (Region, Region)> {
    (region, 4..54_i32, any::<prop::sample::Index>()).prop_filter_map("not valid", |(region, k, index)| {
        let (s, c) = 2_f64.powi(-k).sin_cos();
        let pivot = *index.get(&region.loops[0]);
        let mut copy = region.clone();
        for node in copy.loops.iter_mut().flatten() {
            let (x, y) = (node.x - pivot.x, node.y - pivot.y);
            (node.x, node.y) = (pivot.x + (c * x - s * y), pivot.y + (s * x + c * y));
        }
        validate(&copy).is_ok().then_some((region, copy))
    })
}

/// A valid region of grid cells, each empty, full or, with `halves`, cut along a diagonal: holes, parts and pinches,
/// coinciding edges.
pub fn cells(side: usize, halves: bool) -> impl Strategy<Value = Region> {
    let missing = (0..if halves { 11 } else { 7_usize }).prop_map(|k| match k {
        0..=2 => None,
        3..=6 => Some(4),
        _ => Some(k - 7),
    });
    prop::collection::vec(missing, side * side).prop_filter_map("not valid", move |missing| {
        let cell = |(k, missing): (usize, &Option<usize>)| missing.map(|corner| cell(k % side, k / side, corner));
        let loops = missing.iter().enumerate().filter_map(cell).collect();
        let outline: ExactRegion<Rational> = ExactRegion::from_plain(&PlainRegion { loops, unbounded: false }).ok()?;
        let nodes = |l: &Vec<Corner>| l.iter().map(|c| Node::line(c.x, c.y)).collect();
        let region = Region { loops: outline.to_plain().loops.iter().map(nodes).collect(), ..Region::default() };
        validate(&region).is_ok().then_some(region)
    })
}

/// The cell at these coordinates without one of its corners, counted from the lowest left one; 4 for the whole.
fn cell(x: usize, y: usize, missing: usize) -> Vec<Corner> {
    let corner = |(i, j)| Corner { x: (x + i) as f64, y: (y + j) as f64, bend: Bend::Line };
    let corners = [(0, 0), (1, 0), (1, 1), (0, 1)].into_iter().enumerate();
    corners.filter(|(k, _)| *k != missing).map(|(_, c)| corner(c)).collect()
}
