//! Inputs for the tests: small regions full of coincidences, random polygons, and the fork of the memo's section J5.

pub mod outline;
pub mod pairs;

use std::cmp::Ordering;

use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::enclose::{Enclosure, enclose};
use arcsum_oracle::number::Number;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::point::Point;
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;

/// So many cases, more on request by `PROPTEST_CASES`; failures are reported with their values, not kept as seeds.
pub fn cases(cases: u32) -> ProptestConfig {
    let asked = ProptestConfig::default().cases;
    let factor = if std::env::var_os("PROPTEST_CASES").is_some() { asked.div_ceil(256) } else { 1 };
    let cases = cases * factor;
    ProptestConfig { cases, max_global_rejects: 8 * cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// A plain ring through these points.
pub fn ring(points: impl IntoIterator<Item = (f64, f64)>) -> Vec<Corner> {
    points.into_iter().map(|(x, y)| Corner { x, y, bend: Bend::Line }).collect()
}

/// A bounded plain region with these loops.
pub fn plain(rings: &[&[(f64, f64)]]) -> PlainRegion {
    PlainRegion { loops: rings.iter().map(|r| ring(r.iter().copied())).collect(), unbounded: false }
}

/// An axis-parallel rectangle, counter-clockwise.
pub fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64) -> Vec<Corner> {
    ring([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
}

/// The region of the doubles.
pub fn exact<Q: Number>(region: &PlainRegion) -> ExactRegion<Q> {
    ExactRegion::from_plain(region).expect("the test's region is polygonal and finite")
}

/// The loops to the digit, the same for all backends.
pub fn digits<Q: Number>(region: &ExactRegion<Q>) -> Vec<Vec<(String, String)>> {
    let point = |p: &Point<Q>| (p.x.digits(), p.y.digits());
    region.loops().iter().map(|ring| ring.iter().map(point).collect()).collect()
}

/// On which side of the line from a to b the point c lies: `Greater` on the left.
pub fn side<Q: Number>(a: &Point<Q>, b: &Point<Q>, c: &Point<Q>) -> Ordering {
    b.minus(a).cross(&c.minus(a)).sign()
}

/// Whether an upward ray from the point crosses the boundary an odd number of times (an even one if unbounded).
pub fn inside<Q: Number>(region: &ExactRegion<Q>, p: &Point<Q>) -> bool {
    let crosses = |(a, b): &(&Point<Q>, &Point<Q>)| {
        (a.x <= p.x) != (b.x <= p.x) && (side(a, b, p) == Ordering::Less) == (a.x < b.x)
    };
    region.unbounded() ^ (region.edges().filter(crosses).count() % 2 == 1)
}

/// Grid cells, each empty, full or cut along a diagonal, then sheared: holes, components, pinches, collinear and
/// coincident edges and equal directions in abundance.
pub fn cells(side: usize) -> impl Strategy<Value = PlainRegion> {
    let kinds = prop::collection::vec(prop_oneof![3 => Just(0u8), 4 => Just(1), 1 => 2u8..6], side * side);
    (kinds, -1i32..=1, -1i32..=1, -3i32..=3).prop_map(move |(kinds, a, b, shift)| {
        let mut region = PlainRegion::default();
        for (k, kind) in kinds.into_iter().enumerate() {
            let (x, y) = ((k % side) as f64, (k / side) as f64);
            let square = [(x, y), (x + 1.0, y), (x + 1.0, y + 1.0), (x, y + 1.0)];
            let corners: Vec<(f64, f64)> = match kind {
                0 => continue,
                1 => square.to_vec(),
                kind => {
                    square.into_iter().enumerate().filter(|(i, _)| *i != kind as usize - 2).map(|(_, p)| p).collect()
                }
            };
            let (a, b) = (f64::from(a), f64::from(b));
            let place = |(x, y): (f64, f64)| (x + a * y + f64::from(shift), y + b * (x + a * y));
            region.loops.push(ring(corners.into_iter().map(place)));
        }
        exact::<rug::Rational>(&region).to_plain()
    })
}

/// A polygon that is star-shaped around a point: `n` vertices at random radii, coordinates with all 53 bits.
pub fn radial(n: std::ops::Range<usize>) -> impl Strategy<Value = PlainRegion> {
    (prop::collection::vec(0.1..1.0f64, n), -1.0..1.0f64, -1.0..1.0f64).prop_map(|(radii, x, y)| {
        let n = radii.len() as f64;
        let corner = |(k, r): (usize, f64)| {
            let angle = (k as f64 + 0.3 * r) / n * std::f64::consts::TAU;
            (x + r * angle.cos(), y + r * angle.sin())
        };
        PlainRegion { loops: vec![ring(radii.into_iter().enumerate().map(corner))], unbounded: false }
    })
}

/// The complement of a region, its loops reversed.
pub fn complement(region: &PlainRegion) -> PlainRegion {
    let reverse = |bend| match bend {
        Bend::Line => Bend::Line,
        Bend::Radius(radius) => Bend::Radius(-radius),
        Bend::Bulge(bulge) => Bend::Bulge(-bulge),
    };
    let back = |ring: &Vec<Corner>| {
        let before = |k: usize| ring[(k + ring.len() - 1) % ring.len()].bend;
        (0..ring.len()).rev().map(|k| Corner { bend: reverse(before(k)), ..ring[k] }).collect()
    };
    PlainRegion { loops: region.loops.iter().map(back).collect(), unbounded: !region.unbounded }
}

/// The fork pair with p teeth each way, scaled to integers, and the pitch of its coarse teeth: the sum has (p²-1)² holes
/// smaller than that pitch, and p²-1 more along the border (memo J5).
pub fn fork(p: u32) -> (PlainRegion, PlainRegion, f64) {
    let p = f64::from(p);
    let unit = 40.0 * p * (p + 1.0);
    let (coarse, fine, width) = (20.0 * (p + 1.0), 20.0, 5.0);
    let low = -1.9 * unit;
    let mut a = vec![
        rectangle(-width, -width, 0.0, 12.0 * unit + (p - 1.0) * coarse + width),
        rectangle(-width, -width, 6.0 * unit + (p - 1.0) * coarse + width, 0.0),
    ];
    let mut b =
        vec![rectangle(-width, low, 0.0, 0.0), rectangle(-width, -width, 6.0 * unit + (p - 1.0) * fine + width, 0.0)];
    for i in 0..p as u32 {
        let i = f64::from(i);
        let (up, right) = (12.0 * unit + i * coarse, 6.0 * unit + i * coarse);
        a.push(rectangle(0.0, up, 10.0 * unit, up + width));
        a.push(rectangle(right, 0.0, right + width, 10.0 * unit));
        let (up, right) = (low + i * fine, 6.0 * unit + i * fine);
        b.push(rectangle(0.0, up, 10.0 * unit, up + width));
        b.push(rectangle(right, 0.0, right + width, 8.0 * unit));
    }
    let region = |loops| PlainRegion { loops, unbounded: false };
    (region(a), region(b), coarse)
}

/// A disc as two half circles; a hole of that shape for a negative radius.
pub fn disc(x: f64, y: f64, r: f64) -> Vec<Corner> {
    let bulge = Bend::Bulge(1f64.copysign(r));
    let corner = |x| Corner { x, y, bend: bulge };
    vec![corner(x - r.abs()), corner(x + r.abs())]
}

/// A ring of random arcs: bulges of both signs over a regular polygon. Each turns away from its chord by less than half of
/// the angle of a triangle, so that neighbours do not cross.
pub fn bulged() -> impl Strategy<Value = PlainRegion> {
    prop::collection::vec(-0.26..0.26f64, 3..9).prop_map(|bulges| {
        let n = bulges.len() as f64;
        let turn = |k: usize| (k as f64 / n * std::f64::consts::TAU).sin_cos();
        let corner = |(k, bulge): (usize, f64)| Corner { x: turn(k).1, y: turn(k).0, bend: Bend::Bulge(bulge) };
        PlainRegion { loops: vec![bulges.into_iter().enumerate().map(corner).collect()], unbounded: false }
    })
}

/// Polygons inside and around a region.
pub fn enclosed(region: &PlainRegion, pieces: usize) -> Enclosure<rug::Rational> {
    enclose(region, pieces).expect("the test's region is sound")
}

/// The box around two points.
pub fn hull(a: &Vector, b: &Vector) -> Vector {
    Vector { x: a.x.hull(&b.x), y: a.y.hull(&b.y) }
}
