//! Pairs of polygons for claims about exact ordinates, and the abscissas at which these are compared.

use crate::cases::combs::combs;
use crate::cases::rng::Rng;
use crate::cases::shape::{Point, polygon};
use crate::cases::twoopt;
use crate::claims::draw;
use crate::claims::input::Input;
use arcsum::region::Region;
use arcsum::validate::validate;
use rug::Rational;

/// A pair of polygons: of corners on a small lattice mostly, so that abscissas and directions coincide, else combs and
/// anything that is nearly degenerate.
pub(super) fn pair(rng: &mut Rng, number: usize) -> Input {
    match number % 8 {
        6 => draw::polygons(rng, number),
        7 => {
            let (a, b) = combs(2 + rng.below(3) as u32);
            draw::input("combs", a, b)
        }
        _ => {
            let side = 3 + rng.below(4);
            draw::input("lattice", lattice(rng, side, 4), lattice(rng, side, 4))
        }
    }
}

/// A polygon with so many corners and up to eight more on a lattice with so many steps to a side.
pub(super) fn lattice(rng: &mut Rng, side: usize, corners: u32) -> Region {
    loop {
        let random = twoopt::simple(corners + rng.below(9) as u32, rng);
        let nodes = &random.loops[0];
        let greatest = nodes.iter().map(|node| node.x.abs().max(node.y.abs())).fold(0.0, f64::max);
        let step = |x: f64| (x / greatest * side as f64).round();
        let mut corners: Vec<Point> = nodes.iter().map(|node| [step(node.x), step(node.y)]).collect();
        corners.dedup();
        let region = polygon(&corners);
        if validate(&region).is_ok() {
            return region;
        }
    }
}

/// Abscissas between two others, among them ones close to either end: no double, nor a sum of few, is there.
pub(super) fn between([from, to]: [&Rational; 2]) -> Vec<Rational> {
    let width = Rational::from(to - from);
    [(1, 9_973), (1_999, 9_973), (5_003, 9_973), (8_009, 9_973), (9_972, 9_973)]
        .map(|part| &width * Rational::from(part) + from)
        .into()
}

/// How far the first ordinate is above the second, as a double with the right sign.
pub(super) fn excess([lower, upper]: &[Rational; 2]) -> f64 {
    Rational::from(lower - upper).to_f64()
}
