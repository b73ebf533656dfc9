//! Boundaries of sums against exact sums of polygons, offsets built independently, and the laws of sums.

use std::sync::Arc;

use crate::common::{cells, complement, exact, plain, radial, ring};
use arcsum_oracle::certified::boundary::{Boundary, Edge, boundary};
use arcsum_oracle::certified::curve::Curve;
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::convolve;
use arcsum_oracle::error::{Budget, OracleError};
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::point::Point;
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;
use rug::Rational;

const FINE: Precision = Precision::LADDER[2];

fn shape(region: &PlainRegion) -> Shape {
    Shape::new(region).expect("valid numbers")
}

fn walk(a: &PlainRegion, b: &PlainRegion) -> Boundary {
    let boundary = boundary(&shape(a), &shape(b), Budget::NONE).expect("no budget");
    boundary.check_closed().expect("closed");
    boundary
}

fn rational(real: &Real) -> Rational {
    match real {
        Real::Double(interval) => Rational::from_f64(interval.lo()).expect("finite"),
        Real::Long(ends) => ends[0].to_rational().expect("finite"),
    }
}

fn point(v: &Vector) -> Point<Rational> {
    Point { x: rational(&v.x), y: rational(&v.y) }
}

/// Whether this part of an edge is shorter than 2^-80.
fn is_small(part: Rational, edge: &[Point<Rational>; 2]) -> bool {
    let step = edge[1].minus(&edge[0]);
    part.square() * step.dot(&step) < Rational::from((1, 1u128 << 80)).square()
}

/// How far along an edge a point lies, and how far off it, in units of its length.
fn place(edge: &[Point<Rational>; 2], p: &Point<Rational>) -> (Rational, Rational) {
    let (step, arm) = (edge[1].minus(&edge[0]), p.minus(&edge[0]));
    let square = step.dot(&step);
    (arm.dot(&step) / &square, step.cross(&arm).abs() / square)
}

/// Checks that the edges of a boundary cover those of the exact region, each point once, and nothing else.
fn compare(found: &Boundary, expected: &ExactRegion<Rational>) -> Result<(), TestCaseError> {
    prop_assert!(found.undecided.is_empty());
    let edges: Vec<[Point<Rational>; 2]> = expected.edges().map(|(p, q)| [p.clone(), q.clone()]).collect();
    let mut covers: Vec<Vec<[Rational; 2]>> = vec![Vec::new(); edges.len()];
    let zero = Rational::new();
    let one = Rational::from(1);
    for edge in &found.edges {
        let piece = edge.curve.at(FINE);
        let ends = [point(&piece.from), point(&piece.to)];
        let middle = ends[0].plus(&ends[1]).times(&Rational::from((1, 2)));
        // Short edges lie near several lines; the one they come from is the nearest by far.
        let off = |exact: &[Point<Rational>; 2]| {
            let (along, off) = place(exact, &middle);
            let forward = exact[1].minus(&exact[0]).dot(&ends[1].minus(&ends[0])) > zero;
            let step = exact[1].minus(&exact[0]);
            let fits = forward && is_small(off.clone(), exact) && along > zero && along < one;
            fits.then(|| off.square() * step.dot(&step))
        };
        let fits = edges.iter().enumerate().filter_map(|(index, exact)| Some((off(exact)?, index)));
        let index = fits.min().map(|(_, index)| index);
        prop_assert!(
            index.is_some(),
            "an edge from {:?} to {:?} of sum {}",
            piece.from.nearest(),
            piece.to.nearest(),
            edge.sum
        );
        let index = index.expect("just checked");
        covers[index].push(ends.each_ref().map(|end| place(&edges[index], end).0));
    }
    for (edge, mut cover) in edges.iter().zip(covers) {
        cover.sort();
        let starts = cover.iter().map(|c| &c[0]).chain([&one]);
        let ends = [&zero].into_iter().chain(cover.iter().map(|c| &c[1]));
        for (start, end) in starts.zip(ends) {
            let gap = Rational::from(start - end).abs();
            prop_assert!(is_small(gap, edge), "{:?} is covered by {:?}", edge, cover);
        }
    }
    Ok(())
}

fn check(a: &PlainRegion, b: &PlainRegion) -> Result<(), TestCaseError> {
    let expected = convolve::sum(&exact::<Rational>(a), &exact(b), Budget::NONE).expect("no budget");
    compare(&walk(a, b), &expected)
}

/// Columns of integer height up and down.
fn columns() -> impl Strategy<Value = PlainRegion> {
    prop::collection::vec((1i32..4, 1i32..4), 1..5).prop_map(|columns| {
        let at = |i: usize| i as f64 + 1.0;
        let below = columns.iter().enumerate().flat_map(|(i, &(down, _))| [(at(i), 5 - down), (at(i + 1), 5 - down)]);
        let above = columns.iter().enumerate().rev().flat_map(|(i, &(_, up))| [(at(i + 1), 5 + up), (at(i), 5 + up)]);
        let mut points: Vec<_> = below.chain(above).map(|(x, y)| (x, f64::from(y))).collect();
        points.dedup();
        PlainRegion { loops: vec![ring(points)], unbounded: false }
    })
}

/// The region with every coordinate moved by a few units in the last place of numbers between 4 and 8.
fn shaken(region: &PlainRegion, shakes: &[i8]) -> PlainRegion {
    let mut shakes = shakes.iter().cycle().map(|&k| f64::from(k) * f64::from(-50).exp2());
    let mut region = region.clone();
    for corner in region.loops.iter_mut().flatten() {
        corner.x += shakes.next().expect("endless");
        corner.y += shakes.next().expect("endless");
    }
    region
}

fn mirrored(region: &PlainRegion) -> PlainRegion {
    exact::<Rational>(region).scaled(&Rational::from(-1)).to_plain()
}

/// A square with a small step in its lower side, at the origin.
fn stepped(step: f64) -> PlainRegion {
    plain(&[&[(-0.5, 0.0), (0.0, 0.0), (0.0, step), (0.5, step), (0.5, 1.0), (-0.5, 1.0)]])
}

/// Lines that run along each other within the zone are neither taken for one nor passed over in silence.
#[test]
fn lines_within_the_zone_are_undecided() {
    let b = plain(&[&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]]);
    let two = |k: i32| {
        let low = f64::from(k).exp2();
        let (left, right) =
            ([(-1.0, 0.0), (-0.5, 0.0), (-0.5, 0.5), (-1.0, 0.5)], [(0.0, low), (0.5, low), (0.5, 0.5), (0.0, 0.5)]);
        walk(&plain(&[&left, &right]), &b)
    };
    assert!(two(-250).undecided.is_empty() && !two(-380).undecided.is_empty() && two(-480).undecided.is_empty());
    assert!(two(-380).undecided.iter().any(|edge| edge.curve.rough().chord().length().lo() > 0.4));
}

#[test]
fn work_beyond_the_budget_is_declined() {
    let [a, b] = [stepped(0.125), stepped(0.25)].map(|region| shape(&region));
    let effort = boundary(&a, &b, Budget::NONE).expect("no budget");
    let budget = Budget { segments: effort.sums.len() as u64, meetings: effort.effort.meetings };
    assert!(boundary(&a, &b, budget).is_ok());
    for less in [Budget { segments: budget.segments - 1, ..budget }, Budget { meetings: budget.meetings - 1, ..budget }]
    {
        assert!(matches!(boundary(&a, &b, less), Err(OracleError::TooCostly { .. })));
    }
}

#[test]
fn regions_without_a_boundary_have_sums_without_one() {
    let square = plain(&[&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]]);
    let (empty, whole) = (PlainRegion::default(), PlainRegion { loops: Vec::new(), unbounded: true });
    for [a, b] in [[&square, &empty], [&whole, &square], [&complement(&square), &complement(&square)]] {
        assert!(walk(a, b).edges.is_empty() && walk(a, b).undecided.is_empty());
    }
}

/// The check can fail: with an edge too many, one too few, one the other way.
#[test]
fn a_wrong_boundary_does_not_compare() {
    let (a, b) = (stepped(0.125), stepped(0.25));
    let expected = convolve::sum(&exact::<Rational>(&a), &exact(&b), Budget::NONE).expect("no budget");
    let right = walk(&a, &b);
    assert!(compare(&right, &expected).is_ok());
    for k in 0..right.edges.len() {
        let mut wrong = right.clone();
        let edge = wrong.edges.remove(k);
        assert!(compare(&wrong, &expected).is_err());
        let [piece, double] = [edge.curve.rough().reversed(), edge.curve.rough().clone()];
        for piece in [piece, double] {
            let mut wrong = right.clone();
            wrong.edges.push(Edge { curve: Arc::new(Curve::new(move |_| piece.clone())), ..edge.clone() });
            assert!(compare(&wrong, &expected).is_err());
        }
    }
}

proptest! {
    #![proptest_config(crate::common::cases(100))]

    #[test]
    fn random_polygons_agree(a in radial(3..12), b in radial(3..12), outside in any::<bool>()) {
        let a = if outside { complement(&a) } else { a };
        check(&a, &b)?;
    }

    /// Edges that nearly continue or cover each other, and vertices that nearly lie on edges.
    #[test]
    fn near_coincidences_agree(a in columns(), b in columns(), shakes in prop::collection::vec(-2i8..=2, 24)) {
        let shaken = shaken(&b, &shakes);
        check(&shaken, &b)?;
        check(&a, &shaken)?;
        check(&shaken, &mirrored(&b))?;
    }

    /// A step of a size far below the resolution of doubles near 1.
    #[test]
    fn steps_at_the_origin_agree(b in prop_oneof![columns(), radial(3..6)], k in 20i32..86, up in any::<bool>()) {
        let step = f64::from(-k).exp2() * if up { 1.0 } else { -1.0 };
        check(&stepped(step), &b)?;
        check(&b, &mirrored(&stepped(step)))?;
    }

    /// A slit between two rectangles and something small that passes through it or fills it, wherever it is.
    #[test]
    fn slits_agree(b in prop_oneof![columns(), radial(3..6)], k in 4i32..70, size in 0.1..1.5f64) {
        let slit = f64::from(-k).exp2();
        let left = [(-1.0, -0.5), (-slit, -0.5), (-slit, 0.75), (-1.0, 0.75)];
        let right = [(slit, -0.75), (0.5, -0.75), (0.5, 0.5), (slit, 0.5)];
        let slit = plain(&[&left, &right]);
        let mut small = b.clone();
        for corner in small.loops.iter_mut().flatten() {
            (corner.x, corner.y) = (f64::from(-k).exp2() * size * corner.x, f64::from(-k).exp2() * size * corner.y);
        }
        check(&slit, &small)?;
        check(&complement(&small), &slit)?;
    }

    #[test]
    fn grids_agree(a in cells(3), b in cells(2), outside in any::<bool>()) {
        let a = if outside { complement(&a) } else { a };
        check(&a, &b)?;
    }
}
