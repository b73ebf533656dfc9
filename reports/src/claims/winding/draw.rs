//! Pairs to count winding numbers on: holes that the partner covers or fits into, containers, parallel edges, arcs of
//! radii that nearly cancel.

use super::super::draw::{cells, input, integers, polygons, rounded_cells};
use super::super::input::Input;
use crate::cases::parts::{gear, rounded};
use crate::cases::place::{moved, quarter_turned, scaled, turned};
use crate::cases::radial::{Bending, bulging, noise};
use crate::cases::rng::Rng;
use crate::cases::shape::{Point, backwards, lines, polygon, rectangle, region, regular};
use crate::cases::{combs, fork, passage, twoopt};
use arcsum::region::{Curve, Node, Region};
use arcsum::validate::validate;

/// A valid pair of polygons of one loop each, often in small integers.
pub(super) fn single(rng: &mut Rng, number: usize) -> Input {
    loop {
        let (kind, a, b) = match number % 6 {
            0 => ("simple", twoopt::simple(4 + rng.below(6) as u32, rng), twoopt::simple(4 + rng.below(5) as u32, rng)),
            1 => ("integers", integers(rng), integers(rng)),
            2 => {
                ("noise", polygon(&noise(3 + rng.below(8) as u32, rng)), polygon(&noise(3 + rng.below(5) as u32, rng)))
            }
            3 => ("cells", cells(3, false, rng), cells(2, false, rng)),
            4 => {
                let (a, b) = if rng.below(2) == 0 { combs::combs(2 + rng.below(2) as u32) } else { fork::fork(1) };
                ("teeth", a, b)
            }
            _ => return polygons(rng, number),
        };
        if is_valid(&a) && is_valid(&b) {
            return input(kind, a, b);
        }
    }
}

/// A valid pair of polygons with holes or without a bound.
pub(super) fn holed(rng: &mut Rng, number: usize) -> Input {
    loop {
        let size = rng.between(0.2, 1.2);
        let small = scaled(&polygon(&noise(3 + rng.below(4) as u32, rng)), size);
        let (kind, a, b) = match number % 5 {
            0 => ("ring", ring(rng), small),
            1 => {
                let slack = rng.between(0.5, 1.5);
                let (a, b) = passage::container(slack, rng);
                ("container", a, b)
            }
            2 => ("cells", cells(5, true, rng), cells(4, true, rng)),
            3 => ("rings", ring(rng), moved(&ring(rng), [0.1, 0.2])),
            _ => ("complement", cells(4, true, rng).complement(), cells(3, true, rng)),
        };
        if is_valid(&a) && is_valid(&b) {
            return input(kind, a, b);
        }
    }
}

/// Pairs with holes and without by turns.
pub(super) fn any(rng: &mut Rng, number: usize) -> Input {
    if number.is_multiple_of(2) { holed(rng, number / 2) } else { single(rng, number / 2) }
}

/// A region of one loop against a copy of itself or its mirror image: every normal meets an equal one.
pub(super) fn parallel(rng: &mut Rng, number: usize) -> Input {
    loop {
        let (kind, a) = match number % 7 {
            0 => ("regular", polygon(&regular(3 + rng.below(10) as u32, 1.0, rng.between(0.0, 1.0)))),
            1 => ("cells", cells(3, false, rng)),
            2 => ("integers", integers(rng)),
            3 => ("teeth", combs::combs(2).0),
            4 => ("rectangle", rounded_rectangle(rng)),
            5 => ("gear", region(vec![gear(3 + rng.below(3) as u32)])),
            _ => ("rounded", rounded_cells(3, rng)),
        };
        let b = match rng.below(5) {
            0 => a.clone(),
            1 => a.negated(),
            2 => quarter_turned(&a),
            3 => scaled(&a, 0.5),
            _ => scaled(&a.negated(), 2.0),
        };
        if is_valid(&a) && is_valid(&b) {
            let swap = rng.below(2) == 0;
            return if swap { input(kind, b, a) } else { input(kind, a, b) };
        }
    }
}

/// Two regions of one loop with arcs of both signs; radii are often nearly the same.
pub(super) fn arcs(rng: &mut Rng, number: usize) -> Input {
    loop {
        let a = arc_shape(rng, number);
        let b = match rng.below(3) {
            0 => turned(&arc_shape(rng, number), rng.angle()),
            1 => turned(&a, rng.angle()),
            // Radii whose sums are a few per cent of them, of either sign.
            _ => scaled(&turned(&arc_shape(rng, number), rng.angle()), 1.0 + rng.between(-0.05, 0.05)),
        };
        if is_valid(&a) && is_valid(&b) {
            return input("arcs", a, b);
        }
    }
}

fn arc_shape(rng: &mut Rng, number: usize) -> Region {
    match number % 4 {
        0 => bulging(3 + rng.below(4) as u32, Bending::InTurn, rng),
        1 => bulging(3 + rng.below(4) as u32, Bending::AtRandom, rng),
        2 => notched(rng),
        _ => rounded_rectangle(rng),
    }
}

/// A block with a bite of radius about 1/2 in one side and a bump of such a radius on the other.
fn notched(rng: &mut Rng) -> Region {
    let (bite, bump) = (rng.between(0.3, 0.6), rng.between(0.3, 0.6));
    let bend = |x: f64, y: f64, r: f64| Node { x, y, curve: Curve::Radius(r) };
    region(vec![vec![
        Node::line(-1.0, -1.0),
        Node::line(1.0, -1.0),
        bend(1.0, -0.25, -bite),
        Node::line(1.0, 0.25),
        Node::line(1.0, 1.0),
        bend(0.25, 1.0, bump),
        Node::line(-0.25, 1.0),
        Node::line(-1.0, 1.0),
    ]])
}

fn rounded_rectangle(rng: &mut Rng) -> Region {
    let radius = [0.125, 0.25, rng.between(0.05, 0.3)][rng.below(3)];
    let corners: Vec<(Point, f64)> =
        rectangle([0.0, 0.0], [2.0, 1.0]).into_iter().map(|corner| (corner, radius)).collect();
    region(vec![rounded(&corners)])
}

fn ring(rng: &mut Rng) -> Region {
    let (outer, inner) = (regular(3 + rng.below(6) as u32, 1.0, rng.between(0.0, 1.0)), rng.between(0.1, 0.45));
    let hole = regular(3 + rng.below(6) as u32, inner, rng.between(0.0, 1.0));
    region(vec![lines(&outer), backwards(&hole)])
}

fn is_valid(region: &Region) -> bool {
    validate(region).is_ok()
}
