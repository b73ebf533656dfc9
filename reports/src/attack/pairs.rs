//! Pairs of regions to search among: small shapes of many kinds against themselves, nearly themselves and others, with
//! coordinates a few units in the last place off, edges that nearly are vertical, and slits of hardly any width.

use crate::cases::place::{moved, quarter_turned, turned};
use crate::cases::radial::{Bending, bulging, noise};
use crate::cases::rng::Rng;
use crate::cases::shape::{Point, disc, polar, polygon, region, regular};
use crate::cases::{parts, twoopt};
use arcsum::region::{Curve, Node, Region};
use arcsum::validate::validate;
use libm::scalbn;
use std::f64::consts::{PI, TAU};

/// The most units in the last place by which a coordinate is moved.
const ULPS: usize = 3;

/// A shape by the name of its kind.
type Shape = (&'static str, fn(&mut Rng) -> Region);

const SHAPES: [Shape; 11] = [
    ("noise", |rng| polygon(&noise(3 + rng.below(6) as u32, rng))),
    ("bulging", |rng| {
        let bending = [Bending::Out, Bending::InTurn, Bending::AtRandom][rng.below(3)];
        bulging(3 + rng.below(4) as u32, bending, rng)
    }),
    ("simple", |rng| twoopt::simple(4 + rng.below(7) as u32, rng)),
    ("integers", integers),
    ("star", |rng| {
        let (n, inner) = (3 + rng.below(5), rng.between(0.3, 0.9));
        let corner = |i: usize| polar(if i.is_multiple_of(2) { 1.0 } else { inner }, TAU * i as f64 / (2 * n) as f64);
        polygon(&(0..2 * n).map(corner).collect::<Vec<_>>())
    }),
    ("gear", |rng| region(vec![parts::gear(3 + rng.below(3) as u32)])),
    ("comb", comb),
    ("c", c_shape),
    ("dart", dart),
    ("slit", slit),
    ("disc", |rng| if rng.below(2) == 0 { disc(rng.between(0.1, 1.0)) } else { polygon(&regular(12, 0.5, 0.1)) }),
];

/// A valid pair, after the name of its kind.
pub fn pair(rng: &mut Rng) -> (&'static str, Region, Region) {
    loop {
        let (kind, shape) = SHAPES[rng.below(SHAPES.len())];
        let a = placed(shape(rng), rng);
        let b = partner(&a, rng);
        let [a, b] = [a, b].map(|region| perturbed(region, rng));
        if validate(&a).is_ok() && validate(&b).is_ok() {
            return (kind, a, b);
        }
    }
}

/// A region for another one: itself, its negative, nearly that, or another shape.
fn partner(a: &Region, rng: &mut Rng) -> Region {
    let tiny = |rng: &mut Rng| scalbn(rng.between(-1.0, 1.0), -(rng.below(52) as i32));
    match rng.below(8) {
        0 => a.clone(),
        1 => a.negated(),
        2 => turned(a, tiny(rng)),
        3 => turned(&a.negated(), tiny(rng)),
        4 => quarter_turned(a),
        5 => turned(a, rng.angle()),
        6 => disc(rng.between(0.05, 1.0)),
        _ => {
            let shape = SHAPES[rng.below(SHAPES.len())].1(rng);
            placed(shape, rng)
        }
    }
}

/// As it is, turned by a multiple of 90 degrees, or turned and moved anyhow.
fn placed(region: Region, rng: &mut Rng) -> Region {
    match rng.below(4) {
        0 => region,
        1 => quarter_turned(&region),
        2 => turned(&region, rng.angle()),
        _ => moved(&turned(&region, rng.angle()), [rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)]),
    }
}

/// The region with some coordinates moved by units in the last place, and some edges made nearly vertical.
fn perturbed(mut region: Region, rng: &mut Rng) -> Region {
    let (ulps, vertical) = (rng.below(3) > 0, rng.below(6) == 0);
    for nodes in &mut region.loops {
        for i in 0..nodes.len() {
            if vertical && rng.below(3) == 0 {
                nodes[i].x = nodes[(i + 1) % nodes.len()].x;
            }
            if ulps || vertical {
                nodes[i].x = jittered(nodes[i].x, rng);
                nodes[i].y = jittered(nodes[i].y, rng);
            }
        }
    }
    region
}

/// A number some units in the last place off; those of small numbers count as those of 1/16.
fn jittered(x: f64, rng: &mut Rng) -> f64 {
    let steps = rng.below(2 * ULPS + 1) as f64 - ULPS as f64;
    let unit = x.abs().max(0.0625);
    x + steps * (unit.next_up() - unit)
}

/// A star-shaped polygon with corners in small integers and some bends, so that many sum segments meet in one point.
fn integers(rng: &mut Rng) -> Region {
    let size = 2.0 + rng.below(4) as f64;
    let corner = |p: &Point, rng: &mut Rng| {
        let bulge = if rng.below(3) == 0 { rng.between(-0.6, 0.9) } else { 0.0 };
        let curve = if bulge == 0.0 { Curve::Line } else { Curve::Bulge(bulge) };
        Node { x: (size * p[0]).round(), y: (size * p[1]).round(), curve }
    };
    let corners = noise(3 + rng.below(6) as u32, rng);
    let mut nodes: Vec<Node> = corners.iter().map(|p| corner(p, rng)).collect();
    nodes.dedup_by(|p, q| (p.x, p.y) == (q.x, q.y));
    region(vec![nodes])
}

/// A width of 0 to 16 eps, or any.
fn width(rng: &mut Rng) -> f64 {
    match rng.below(3) {
        0 => rng.between(0.0, 16.0) * 0.5 * f64::EPSILON,
        1 => scalbn(rng.between(0.5, 1.0), -(rng.below(52) as i32)),
        _ => rng.between(0.05, 0.5),
    }
}

/// Teeth with gaps of some width between them, to the right.
fn comb(rng: &mut Rng) -> Region {
    let (teeth, gap, height) = (2 + rng.below(3), width(rng), rng.between(0.1, 0.4));
    let mut points: Vec<Point> = Vec::new();
    let mut y = 0.0;
    for i in 0..teeth {
        let reach = rng.between(0.5, 1.0);
        points.extend([[reach, y], [reach, y + height]]);
        y += height;
        if i + 1 < teeth {
            points.extend([[0.25, y], [0.25, y + gap]]);
            y += gap;
        }
    }
    points.extend([[0.0, y], [0.0, 0.0]]);
    polygon(&points)
}

/// A ring with an opening: two arcs out, two in, and two ends.
fn c_shape(rng: &mut Rng) -> Region {
    let (inner, from, opening) = (rng.between(0.3, 0.95), rng.angle(), rng.between(0.05, 0.8) * PI);
    let half = 0.5 * (TAU - opening);
    let bulge = libm::tan(0.25 * half);
    let at = |radius: f64, angle: f64, bulge: f64| {
        let [x, y] = polar(radius, from + angle);
        Node { x, y, curve: if bulge == 0.0 { Curve::Line } else { Curve::Bulge(bulge) } }
    };
    region(vec![vec![
        at(1.0, 0.0, bulge),
        at(1.0, half, bulge),
        at(1.0, 2.0 * half, 0.0),
        at(inner, 2.0 * half, -bulge),
        at(inner, half, -bulge),
        at(inner, 0.0, 0.0),
    ]])
}

/// A dart: a triangle with a dent, the partner of discs in Fig. 12 of MS.
fn dart(rng: &mut Rng) -> Region {
    let corners = [
        [rng.between(0.2, 0.6), 0.0],
        [rng.between(-0.5, -0.2), rng.between(0.3, 1.0)],
        [rng.between(-0.25, 0.1), rng.between(-0.1, 0.16)],
        [rng.between(-0.5, -0.2), rng.between(-1.0, -0.2)],
    ];
    polygon(&corners)
}

/// A block with a slit whose walls are parallel to the x axis or not, and a hook in one of them.
fn slit(rng: &mut Rng) -> Region {
    let (w, rise) = (width(rng), rng.between(-0.2, 0.2));
    let mut points = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 0.4 + rise], [0.3, 0.4]];
    if rng.below(2) == 0 {
        points.extend([[0.5, 0.35 + 0.2 * rise], [0.2, 0.3], [0.2, 0.6]]);
    }
    points.extend([[0.3, 0.4 + w], [1.0, 0.4 + rise + w], [1.0, 0.9], [0.0, 0.9]]);
    polygon(&points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn pairs_are_valid_and_of_every_kind() {
        let mut rng = Rng::new(1, "pairs");
        let mut kinds = BTreeSet::new();
        for _ in 0..2_000 {
            let (kind, a, b) = pair(&mut rng);
            kinds.insert(kind);
            assert!(validate(&a).is_ok() && validate(&b).is_ok());
        }
        assert_eq!(kinds.len(), SHAPES.len(), "{kinds:?}");
    }
}
