//! M1: line and circle segments are closed under Minkowski sums (MS 1, 3; memo B1).

use super::super::control::Control;
use super::super::draw as drawing;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::draw;
use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::cases::place::moved;
use crate::cases::radial::noise;
use crate::cases::rng::Rng;
use crate::cases::shape::polygon;
use crate::kept;
use arcsum::region::{Curve, Region};
use arcsum::sum::{Convolution, Options, sum};
use arcsum::validate::validate;
use arcsum_oracle::certified::bounds;
use arcsum_oracle::certified::piece::{Circle, Piece};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::stretch::along;
use arcsum_oracle::certified::sums::sums;
use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::error::Budget;
use libm::scalbn;

/// The precision of the distances: far finer than they are.
const FINE: Precision = Precision::LADDER[2];
/// The greatest distance in eps.
const BOUND: f64 = 8.0;

/// Sum segments farther from an edge than this, in the unit box, are not what it is part of.
const NEAR: f64 = 1e-9;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "distance of an edge of the engine's sum from the nearest exact line or circle of a sum segment",
        unit: "eps",
        rule: Rule::AtMost(BOUND),
        draws: [600, 40_000],
        draw: drawn,
        measure: |input| farthest(input, 0.0).filter(|found| found.hi <= BOUND || has_sum(input)),
        kept: kept!("M1"),
        control: Control::Measure {
            plants: "the exact sum segments are those of B moved by 2^-48 of the unit box",
            measure: |input| farthest(input, scalbn(1.0, -48)),
        },
    };
    [Claim {
        id: "M1",
        place: "MS 1",
        says: "Line and circle segments are closed under Minkowski sums: every edge of a sum is part of a line or circle \
               segment, moved by a vertex or with the centres and radii added.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

/// Arcs of any kind, of radii that cancel, and of huge ones.
fn drawn(rng: &mut Rng, number: usize) -> Input {
    match number % 4 {
        0 => draw::arcs(rng, number / 4),
        1 => drawing::pair(rng, number),
        2 => draw::parallel(rng, number / 4),
        _ => loop {
            let (a, b) = (nearly_straight(rng), nearly_straight(rng));
            if validate(&a).is_ok() && validate(&b).is_ok() {
                return drawing::input("nearly straight", a, b);
            }
        },
    }
}

fn nearly_straight(rng: &mut Rng) -> Region {
    let mut region = polygon(&noise(3 + rng.below(5) as u32, rng));
    for node in region.loops.iter_mut().flatten() {
        node.curve = Curve::Bulge(scalbn(rng.between(-1.0, 1.0), -(4 + rng.below(46) as i32)));
    }
    region
}

/// The greatest distance over all edges of the sums by both convolutions, where the exact sum segments are of B moved in x by
/// a part of the unit box.
fn farthest(input: &Input, shift: f64) -> Option<Measured> {
    let case = input.as_pair()?;
    let unit = unit(&case.a, &case.b);
    let b = moved(&case.b, [shift * unit, 0.0]);
    let shape = |region: &Region| Shape::new(&plain(region)).ok();
    let [first, second] = [shape(&case.a)?, shape(&b)?];
    let carriers: Vec<Piece> = sums(&first, &second).iter().map(|s| s.curve.at(FINE).clone()).collect();
    let in_eps = |bracket: [f64; 2]| bracket.map(|d| d / (unit * 0.5 * f64::EPSILON));
    let off = |edge: &Piece| {
        let [lo, hi] = in_eps(distance(edge, &carriers, NEAR * unit));
        if hi <= BOUND {
            return Measured::between(lo, hi);
        }
        // An edge of a bubble may be part of a sum segment that bounds no sum.
        let inside = in_eps(distance(edge, &inner(&first, &second), f64::INFINITY));
        Measured::between(lo.min(inside[0]), hi.min(inside[1]))
    };
    let mut worst = Measured::exactly(0.0);
    for convolution in [Convolution::Kinetic, Convolution::Monotonic] {
        let result = sum(&case.a, &case.b, &Options { convolution, ..Options::default() }).ok()?.region;
        for side in shape(&result)?.sides() {
            let edge = side.curve.at(FINE);
            let found = off(edge);
            if (found.lo, found.hi) > (worst.lo, worst.hi) {
                worst = found.at(edge.from.nearest().into());
            }
        }
    }
    Some(worst)
}

/// The lines and circles of all sum segments, also of those that lie inside of the sum because a vertex or an arc is concave, and
/// of more: every side moved by every vertex, every line by the arcs' points with its normal, every two circles together.
fn inner(a: &Shape, b: &Shape) -> Vec<Piece> {
    let edges = |shape: &Shape| shape.sides().map(|side| side.curve.at(FINE).clone()).collect::<Vec<Piece>>();
    let [a, b] = [edges(a), edges(b)];
    let mut all = Vec::new();
    for (f, g) in a.iter().flat_map(|f| b.iter().map(move |g| (f, g))) {
        all.extend([f.moved(&g.from), g.moved(&f.from)]);
        match (&f.circle, &g.circle) {
            (None, None) => {}
            (None, Some(circle)) => all.push(f.moved(&facing(circle, f))),
            (Some(circle), None) => all.push(g.moved(&facing(circle, g))),
            (Some(c), Some(d)) => all.push(Piece { circle: Some(added(c, d)), ..f.clone() }),
        }
    }
    all
}

/// The point of an arc's circle where its outward normal is that of a line.
fn facing(circle: &Circle, line: &Piece) -> Vector {
    let inward = line.chord().unit().left();
    let out = &inward * &circle.radius;
    if circle.left { &circle.centre - &out } else { &circle.centre + &out }
}

/// The centres and the radii added; that of a concave arc is negative.
fn added(c: &Circle, d: &Circle) -> Circle {
    let radius = if c.left == d.left { &c.radius + &d.radius } else { (&c.radius - &d.radius).abs() };
    Circle { centre: &c.centre + &d.centre, radius, left: true }
}

/// Whether the exact sum closes. That of a boundary that crosses itself does not, and [`validate`] lets pass what does so within
/// its tolerance of 2^-40.
fn has_sum(input: &Input) -> bool {
    let sum = |case: &Case| Reference::new(&plain(&case.a), &plain(&case.b), unit(&case.a, &case.b), Budget::default());
    input.as_pair().is_some_and(|case| sum(case).is_ok())
}

/// A bracket of the distance of an edge's ends and middle from the line or circle of the best sum segment.
fn distance(edge: &Piece, carriers: &[Piece], near: f64) -> [f64; 2] {
    let middle = along(edge, &Real::from(0.5));
    let points = [&edge.from, &middle, &edge.to];
    let box_of_edge = edge.bounds();
    let candidates = carriers.iter().filter(|carrier| bounds::distance(&box_of_edge, &carrier.bounds()) <= near);
    let each = candidates.map(|carrier| {
        let distances = points.map(|point| off(point, carrier));
        [Real::lo, Real::hi].map(|end| distances.iter().map(end).fold(0.0, f64::max))
    });
    each.reduce(|best, one| [best[0].min(one[0]), best[1].min(one[1])]).unwrap_or([near, f64::INFINITY])
}

/// The distance of a point from the line or circle of a piece.
fn off(point: &Vector, carrier: &Piece) -> Real {
    match &carrier.circle {
        Some(Circle { centre, radius, .. }) => (point.distance(centre) - radius).abs(),
        None => (carrier.chord().cross(&(point - &carrier.from)) / carrier.chord().length()).abs(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use arcsum::region::Node;

    /// The arc of a notch 3e-12 long crosses the line before it.
    #[test]
    fn what_crosses_itself_within_the_tolerance_is_not_asked_about() {
        let arc = |x, y, bulge| Node { x, y, curve: Curve::Bulge(bulge) };
        let mut b = vec![
            arc(-1.999_999_999_996_874, -1.000_000_000_006_250_8, 0.524_181_044_411_394_7),
            Node::line(3.000_000_000_003_125_5, -3.999_999_999_996_873),
            Node::line(1.999_999_999_990_624_2, -0.999_999_999_990_623_6),
            arc(0.999_999_999_990_623_6, 3.000_000_000_006_252_3, -0.241_702_485_711_056_46),
            arc(0.999_999_999_990_623_5, 3.000_000_000_003_124, -0.244_106_797_589_532_63),
        ];
        let disc = crate::cases::shape::disc(1.0);
        let pair =
            |b: &[Node]| drawing::input("notch", disc.clone(), Region { loops: vec![b.to_vec()], ..Region::default() });
        assert!(validate(&pair(&b).as_pair().unwrap().b).is_ok() && !has_sum(&pair(&b)));
        b.remove(4);
        b[3] = arc(1.0, 3.0, -0.244_106_797_589_532_63);
        assert!(has_sum(&pair(&b)));
    }
}
