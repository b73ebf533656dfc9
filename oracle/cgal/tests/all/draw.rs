//! Random polygons with holes: one component each, with coincidences in abundance.

use crate::common::Loops;
use arcsum_oracle::parts::parts;
use arcsum_oracle::point::Point;
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;
use rug::Rational;

/// The largest component of a region: its outer loop and its holes. They touch at most at points.
fn largest(region: &ExactRegion<Rational>) -> Option<Loops> {
    let parts = parts(region).expect("a region in normal form");
    let rings = parts.into_iter().map(|part| part.outer.into_iter().chain(part.holes).collect::<Vec<_>>());
    let loops = rings.map(|rings| {
        rings.into_iter().map(|ring| ring.into_iter().map(|place| place.exact).collect()).collect::<Loops>()
    });
    loops.max_by_key(|loops| loops.iter().map(Vec::len).sum::<usize>())
}

/// What a closed walk over a small grid winds around an odd number of times: slanted edges, slivers, corners at fractions.
pub fn walk(corners: std::ops::Range<usize>) -> impl Strategy<Value = Loops> {
    prop::collection::vec((-7i64..8, -7i64..8), corners).prop_filter_map("nothing inside", |walk| {
        let point = |(x, y)| Point { x: Rational::from(x), y: Rational::from(y) };
        let ring = walk.into_iter().map(point).collect();
        largest(&ExactRegion::from_rings(vec![ring], false, |w| w[0] % 2 != 0).expect("small integers"))
    })
}

/// Cells of a sheared grid, each empty, full or half: equal directions, collinear edges, holes that touch.
pub fn cells(side: usize) -> impl Strategy<Value = Loops> {
    let kinds = prop::collection::vec(prop_oneof![2 => Just(0usize), 4 => Just(4), 1 => 0usize..4], side * side);
    (kinds, -1i64..=1).prop_filter_map("nothing inside", move |(kinds, shear)| {
        let ring = |(k, kind): (usize, usize)| {
            let (x, y) = ((k % side) as i64, (k / side) as i64);
            let corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
            // A fifth corner to leave out is none.
            let kept = corners.into_iter().enumerate().filter(|(i, _)| *i != kind).map(|(_, corner)| corner);
            kept.map(|(x, y)| Point { x: Rational::from(x + shear * y), y: Rational::from(y) }).collect::<Vec<_>>()
        };
        let rings = kinds.into_iter().enumerate().filter(|(_, kind)| *kind != 0).map(ring).collect();
        largest(&ExactRegion::from_rings(rings, false, |w| w[0] != 0).expect("small integers"))
    })
}

/// A frame with a slit of width 1 in it, which most parts close: the sum has a hole though the frame has none.
fn slit_frame() -> impl Strategy<Value = Loops> {
    (2i64..6, 14i64..19, 2i64..9, 2i64..9, 12i64..19, 7i64..12).prop_map(|(left, right, low, lower, high, slit)| {
        let outside = [(0, 20), (0, 0), (20, 0), (20, 20)];
        let inside = [(slit + 1, 20), (slit + 1, high), (right, high), (right, low), (left, lower), (left, high)];
        let ring = outside.into_iter().chain(inside).chain([(slit, high), (slit, 20)]);
        vec![ring.map(|(x, y)| Point { x: Rational::from(x), y: Rational::from(y) }).collect()]
    })
}

/// The region made smaller.
fn shrunk(loops: Loops, by: i64) -> Loops {
    let factor = Rational::from((1, by));
    loops.iter().map(|ring| ring.iter().map(|p| p.times(&factor)).collect()).collect()
}

/// A pair of operands; in half of them one is so small that holes remain.
pub fn pair() -> impl Strategy<Value = (Loops, Loops)> {
    let part = || prop_oneof![walk(3..7), cells(3)].prop_map(|part| shrunk(part, 16));
    prop_oneof![
        (walk(4..10), walk(3..7)),
        (cells(4), cells(3)),
        (walk(4..9), cells(3)),
        (cells(5), walk(3..6)),
        (walk(5..12), part()),
        (part(), walk(5..12)),
        (cells(5), part()),
        (cells(6), part()),
        (slit_frame(), walk(3..7).prop_map(|part| shrunk(part, 4))),
    ]
}
