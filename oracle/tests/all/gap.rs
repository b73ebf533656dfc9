//! Distances and crossings of pieces, against a branch and bound over pairs of points in plain doubles.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

use crate::common::hull;
use arcsum_oracle::certified::crossing::crosses;
use arcsum_oracle::certified::gap::gap;
use arcsum_oracle::certified::piece::{Circle, Piece};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use proptest::prelude::*;

/// How far branch and bound goes: equidistant curves have as many nearest pairs as fit.
const FINE: f64 = 1e-4;
const FINER: Precision = Precision::LADDER[2];

/// One piece of a segment, at both precisions.
#[derive(Clone, Debug)]
struct Both {
    rough: Piece,
    fine: Piece,
}

fn pieces(from: (f64, f64), to: (f64, f64), bend: Bend) -> Vec<Both> {
    let loops = vec![vec![Corner { x: from.0, y: from.1, bend }, Corner { x: to.0, y: to.1, bend: Bend::Line }]];
    let shape = Shape::new(&PlainRegion { loops, unbounded: false }).expect("a sound segment");
    let both = |curve: &arcsum_oracle::certified::curve::Curve| Both {
        rough: curve.rough().clone(),
        fine: curve.at(FINER).clone(),
    };
    shape.sides().filter(|side| side.vertex == 0).map(|side| both(&side.curve)).collect()
}

/// A full circle's quarters.
fn circle(x: f64, y: f64, r: f64) -> Vec<Both> {
    let half = |s: f64| pieces((x - s * r, y), (x + s * r, y), Bend::Bulge(1.0));
    [half(1.0), half(-1.0)].concat()
}

/// Coordinates that coincide often, and some that never do.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![2 => (-4..=4i32).prop_map(|k| f64::from(k) / 4.0), 1 => -1.0..1.0f64]
}

fn bend() -> impl Strategy<Value = Bend> {
    let signed = |x: f64, left: bool| if left { x } else { -x };
    prop_oneof![
        2 => Just(Bend::Line),
        2 => any::<bool>().prop_map(move |left| Bend::Bulge(signed(1.0, left))),
        2 => (0.05..3.0f64, any::<bool>()).prop_map(move |(bulge, left)| Bend::Bulge(signed(bulge, left))),
        1 => (1.5..4.0f64, any::<bool>()).prop_map(move |(radius, left)| Bend::Radius(signed(radius, left))),
    ]
}

fn piece() -> impl Strategy<Value = Both> {
    ((coordinate(), coordinate()), (coordinate(), coordinate()), bend(), any::<prop::sample::Index>())
        .prop_filter("ends that differ", |(from, to, ..)| from != to)
        .prop_map(|(from, to, bend, which)| which.get(&pieces(from, to, bend)).clone())
}

/// A piece as a curve over [0, 1] run through at constant speed.
struct Track {
    from: (f64, f64),
    to: (f64, f64),
    /// Centre, radius, angle of the start and sweep.
    arc: Option<((f64, f64), f64, f64, f64)>,
}

impl Track {
    fn new(piece: &Piece) -> Self {
        let (from, to) = (piece.from.nearest(), piece.to.nearest());
        let arc = piece.circle.as_ref().map(|circle| {
            let c = circle.centre.nearest();
            let (p, q) = ((from.0 - c.0, from.1 - c.1), (to.0 - c.0, to.1 - c.1));
            let sweep = (p.0 * q.1 - p.1 * q.0).atan2(p.0 * q.0 + p.1 * q.1);
            (c, circle.radius.mid(), p.1.atan2(p.0), sweep)
        });
        Self { from, to, arc }
    }

    fn length(&self) -> f64 {
        match self.arc {
            None => (self.to.0 - self.from.0).hypot(self.to.1 - self.from.1),
            Some((_, radius, _, sweep)) => radius * sweep.abs(),
        }
    }

    fn at(&self, s: f64) -> (f64, f64) {
        match self.arc {
            None => (self.from.0 + s * (self.to.0 - self.from.0), self.from.1 + s * (self.to.1 - self.from.1)),
            Some((c, radius, start, sweep)) => {
                let (sin, cos) = (start + s * sweep).sin_cos();
                (c.0 + radius * cos, c.1 + radius * sin)
            }
        }
    }
}

/// A cell of pairs of parameters: a lower bound of the distance there, the middles and the half width.
#[derive(PartialEq)]
struct Cell {
    bound: f64,
    at: (f64, f64),
    half: f64,
}

impl Eq for Cell {}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound)
    }
}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Lower and upper bound of the distance, at most [`FINE`] apart, up to rounding.
fn searched(a: &Piece, b: &Piece) -> (f64, f64) {
    let (a, b) = (Track::new(a), Track::new(b));
    let lengths = a.length() + b.length();
    let distance = |(s, t): (f64, f64)| {
        let (p, q) = (a.at(s), b.at(t));
        (p.0 - q.0).hypot(p.1 - q.1)
    };
    let mut best = f64::INFINITY;
    let mut cells = BinaryHeap::from([Cell { bound: 0.0, at: (0.5, 0.5), half: 0.5 }]);
    while let Some(Cell { bound, at, half }) = cells.pop() {
        if best - bound <= FINE {
            return (bound, best);
        }
        let half = 0.5 * half;
        for (i, j) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
            let at = (at.0 + i * half, at.1 + j * half);
            let middle = distance(at);
            best = best.min(middle);
            cells.push(Cell { bound: (middle - half * lengths).max(0.0), at, half });
        }
    }
    unreachable!("cells are only ever split")
}

/// Whether an interval may contain the distance of the pieces.
fn agrees(found: &Real, a: &Piece, b: &Piece) -> bool {
    let (lo, hi) = searched(a, b);
    found.lo() <= hi + 1e-12 && found.hi() >= lo - 1e-12
}

/// What the distance would be if inner points of both were forgotten.
fn between_ends(a: &Piece, b: &Piece) -> Real {
    let first = b.distance(&a.from).min(&b.distance(&a.to));
    first.min(&a.distance(&b.from)).min(&a.distance(&b.to))
}

/// A piece of which only this is known: that it lies somewhere between two positions.
fn smeared(here: &Piece, there: &Piece) -> Piece {
    let circle = here.circle.as_ref().zip(there.circle.as_ref());
    let circle = circle.map(|(c, d)| Circle { centre: hull(&c.centre, &d.centre), ..c.clone() });
    Piece { from: hull(&here.from, &there.from), to: hull(&here.to, &there.to), circle }
}

proptest! {
    #![proptest_config(crate::common::cases(1500))]

    #[test]
    fn the_gap_is_the_least_distance_of_points(a in piece(), b in piece()) {
        let (rough, fine) = (gap(&a.rough, &b.rough), gap(&a.fine, &b.fine));
        prop_assert!(agrees(&rough, &a.rough, &b.rough), "{rough:?}");
        prop_assert!(agrees(&fine, &a.rough, &b.rough), "{fine:?}");
        prop_assert!(fine.lo() >= rough.lo() && fine.hi() <= rough.hi());
        // An interval that is not sharp means that the pieces touch or overlap, unless they are tiny.
        prop_assert!(rough.hi() - rough.lo() < 1e-6, "{rough:?}");
        prop_assert!((&fine - &Real::from(fine.mid())).is_within(-50), "{fine:?}");
    }

    #[test]
    fn crossing_agrees_with_the_distance_and_with_finer_numbers(a in piece(), b in piece()) {
        let (rough, fine) = (crosses(&a.rough, &b.rough), crosses(&a.fine, &b.fine));
        let (lo, hi) = searched(&a.rough, &b.rough);
        prop_assert!(rough.is_none() || rough == fine);
        prop_assert!(fine != Some(true) || lo == 0.0);
        prop_assert!(lo < 1e-9 || rough == Some(false));
        // At a touch that is not a crossing the distance is exactly 0 and stays open at every precision.
        prop_assert!(fine.is_some() || hi <= FINE);
        prop_assert_eq!(crosses(&b.fine, &a.fine), fine);
        let reversed = (gap(&b.rough.reversed(), &a.rough), gap(&a.rough, &b.rough));
        prop_assert!((reversed.0.mid() - reversed.1.mid()).abs() < 1e-6);
    }

    #[test]
    fn numbers_known_badly_give_answers_that_hold_for_all_of_them(
        a in piece(), b in piece(), size in 0.0..0.5f64, step in (-1.0..1.0f64, -1.0..1.0f64), parts in prop::collection::vec(0.0..=1.0f64, 6)
    ) {
        let step = |part: f64| Vector::new(part * size * step.0, part * size * step.1, Precision::DOUBLE);
        let a = a.rough;
        let vague = smeared(&a, &a.moved(&step(1.0)));
        let (distance, crossing) = (gap(&vague, &b.rough), crosses(&vague, &b.rough));
        for part in parts {
            let member = a.moved(&step(part));
            let (one, crosses) = (gap(&member, &b.rough), crosses(&member, &b.rough));
            prop_assert!(distance.lo() <= one.hi() && one.lo() <= distance.hi(), "{distance:?} is not {one:?}");
            prop_assert!(crossing.is_none() || crosses.is_none() || crossing == crosses);
        }
    }

    #[test]
    fn circles_are_apart_by_their_radii(x in -2.0..2.0f64, y in -2.0..2.0f64, r in 0.1..1.0f64, s in 0.1..1.0f64) {
        let (first, second) = (circle(0.0, 0.0, r), circle(x, y, s));
        let all = || first.iter().flat_map(|a| second.iter().map(move |b| (a, b)));
        let apart = x.hypot(y);
        let expected = (apart - r - s).max((r - s).abs() - apart).max(0.0);
        let found = all().map(|(a, b)| gap(&a.rough, &b.rough).mid()).fold(f64::INFINITY, f64::min);
        prop_assert!((found - expected).abs() < 1e-14, "{found} instead of {expected}");
        // Two quarters can cross twice.
        let crossings = all().filter(|(a, b)| crosses(&a.rough, &b.rough) == Some(true)).count();
        prop_assert_eq!(expected == 0.0, (1..=2).contains(&crossings));
    }

    #[test]
    fn concentric_arcs_keep_their_distance(x in coordinate(), y in coordinate(), r in 0.1..1.0f64, s in 0.1..1.0f64) {
        prop_assume!((r - s).abs() > 1e-9);
        let (first, second) = (circle(x, y, r), circle(x, y, s));
        for (a, b) in first.iter().zip(&second) {
            // The ends of the discs' half circles are rounded, so they are not quite concentric.
            prop_assert!((gap(&a.rough, &b.rough).mid() - (r - s).abs()).abs() < 1e-14);
            prop_assert_eq!(crosses(&a.rough, &b.rough), Some(false));
        }
    }
}

#[test]
fn forgetting_inner_points_is_noticed() {
    // Beside each other, a line beside an arc, and nested, the nearest points inside every time.
    let turned = |x: f64| pieces((x, 0.0), (0.0, x), Bend::Bulge((PI / 8.0).tan()));
    let facing = pieces((3.0, 2.0), (2.0, 3.0), Bend::Bulge(-(PI / 8.0).tan()));
    let line = pieces((0.2, 1.6), (1.8, 0.2), Bend::Line);
    let inner = pieces((0.8, 0.3), (0.3, 0.8), Bend::Bulge(0.4));
    for (a, b) in [(&turned(1.0), &facing), (&turned(1.0), &line), (&turned(1.2), &inner)] {
        let (a, b) = (&a[0].rough, &b[0].rough);
        assert!(agrees(&gap(a, b), a, b) && !agrees(&between_ends(a, b), a, b));
    }
}

#[test]
fn touches_are_never_decided() {
    // Circles tangent at the ends of quarters and inside them, from outside and from inside.
    let circles = [(5.0, 0.0, 2.5), (1.25, 0.0, 1.25), (3.0, 4.0, 2.5), (0.75, 1.0, 1.25)];
    for (x, y, r) in circles {
        let (first, second) = (circle(0.0, 0.0, 2.5), circle(x, y, r));
        let answers: Vec<_> = first.iter().flat_map(|a| second.iter().map(|b| crosses(&a.fine, &b.fine))).collect();
        assert!(answers.contains(&None) && !answers.contains(&Some(true)));
    }
    // The tangent of the circle of radius 5 at (3, 4).
    let tangent = pieces((-1.0, 7.0), (7.0, 1.0), Bend::Line);
    let answers: Vec<_> = circle(0.0, 0.0, 5.0).iter().map(|a| crosses(&a.fine, &tangent[0].fine)).collect();
    assert!(answers.contains(&None) && !answers.contains(&Some(true)));
    // A quarter upon itself, and lines that end on each other.
    let quarter = &circle(0.0, 0.0, 0.5)[0];
    assert_eq!(crosses(&quarter.fine, &quarter.fine.reversed()), None);
    let line = |from, to| pieces(from, to, Bend::Line)[0].fine.clone();
    assert_eq!(crosses(&line((0.0, 0.0), (1.0, 1.0)), &line((1.0, 1.0), (2.0, 0.0))), None);
    assert_eq!(crosses(&line((0.0, 0.0), (2.0, 2.0)), &line((1.0, 1.0), (2.0, 0.0))), None);
    assert_eq!(crosses(&line((0.0, 0.0), (2.0, 2.0)), &line((0.0, 2.0), (2.0, 0.0))), Some(true));
}
