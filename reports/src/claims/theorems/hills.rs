//! Regions with one upper chain and one lower chain.

use crate::cases::rng::Rng;
use crate::cases::shape::{Point, polygon, region};
use arcsum::region::{Curve, Node, Region};
use libm::scalbn;
use std::f64::consts::FRAC_PI_2;

/// Abscissas at random from 0 to 1, and heights at random above and below. If the step is below 1, a line above rises
/// or falls by a third or more over so much.
pub(super) fn hills(n: usize, step: f64, rng: &mut Rng) -> Region {
    let columns = (n / 2).max(2);
    let row = |rng: &mut Rng, lo: f64| -> Vec<Point> {
        let place = |k: usize| (k as f64 + 0.8 * rng.unit()) / columns as f64;
        let xs: Vec<f64> = (1..columns - 1).map(place).collect();
        let ends = [0.0].into_iter().chain(xs).chain([1.0]);
        ends.map(|x| [x, rng.between(lo, lo + 0.3)]).collect()
    };
    let (bottom, mut top) = (row(rng, 0.0), row(rng, 0.4));
    if step < 1.0 {
        // High on one side of the step, low on the other.
        let at = 1 + rng.below(top.len() - 2);
        let high = rng.below(2) == 0;
        for (i, corner) in top.iter_mut().enumerate() {
            corner[1] += if (i <= at) == high { 0.0 } else { 0.3 };
        }
        let foot = [top[at][0] + step, if high { 0.75 } else { 0.35 }];
        top.insert(at + 1, foot);
    }
    top.reverse();
    polygon(&[bottom, top].concat())
}

/// A level bottom from 0 to 1, and above it circle segments, most of nearly this radius, to either
/// side, or as good as upright at one end.
pub(super) fn domes(columns: usize, radius: f64, rng: &mut Rng) -> Region {
    let place = |k: usize, rng: &mut Rng| (k as f64 + 0.5 * rng.unit()) / columns as f64;
    let inner: Vec<f64> = (1..columns).map(|k| place(k, rng)).collect();
    let top: Vec<Point> = [0.0].into_iter().chain(inner).chain([1.0]).map(|x| [x, rng.between(0.4, 0.5)]).collect();
    let mut nodes = vec![Node::line(0.0, 0.0), Node::line(1.0, 0.0)];
    for pair in top.windows(2).rev() {
        let ([to_x, to_y], [x, y]) = (pair[0], pair[1]);
        let (length, slope) = (libm::hypot(x - to_x, y - to_y), libm::atan(((y - to_y) / (x - to_x)).abs()));
        let steepest = length / (2.0 * libm::sin(FRAC_PI_2 - slope));
        let sign = if rng.below(3) == 0 { -1.0 } else { 1.0 };
        let close = radius * (1.0 + scalbn(rng.between(-1.0, 1.0), -(20 + rng.below(34) as i32)));
        let curve = match rng.below(8) {
            0 => Curve::Line,
            1 => Curve::Radius(sign * steepest * (1.0 + scalbn(1.0, -(2 + rng.below(45) as i32)))),
            _ if close.abs() > 1.01 * steepest => Curve::Radius(sign * close),
            _ => Curve::Line,
        };
        nodes.push(Node { x, y, curve });
    }
    nodes.push(Node::line(top[0][0], top[0][1]));
    region(vec![nodes])
}
