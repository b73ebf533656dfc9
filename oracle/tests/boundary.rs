//! Boundaries of sums against exact sums of polygons, offsets built independently, and the laws of sums.

mod common;

use arcsum_oracle::certified::boundary::{Boundary, boundary};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::convolve;
use arcsum_oracle::error::Budget;
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::point::Point;
use arcsum_oracle::region::ExactRegion;
use common::{cells, complement, exact, radial};
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

fn tolerance() -> Rational {
    Rational::from((1, 1u128 << 80))
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
        let fits = |exact: &[Point<Rational>; 2]| {
            let (along, off) = place(exact, &middle);
            let forward = exact[1].minus(&exact[0]).dot(&ends[1].minus(&ends[0])) > zero;
            forward && off < tolerance() && along > zero && along < one
        };
        let index = edges.iter().position(fits);
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
            prop_assert!(gap < tolerance(), "{:?} is covered by {:?}", edge, cover);
        }
    }
    Ok(())
}

fn check(a: &PlainRegion, b: &PlainRegion) -> Result<(), TestCaseError> {
    let expected = convolve::sum(&exact::<Rational>(a), &exact(b), Budget::NONE).expect("no budget");
    compare(&walk(a, b), &expected)
}

proptest! {
    #![proptest_config(common::cases(100))]

    #[test]
    fn random_polygons_agree(a in radial(3..12), b in radial(3..12), outside in any::<bool>()) {
        let a = if outside { complement(&a) } else { a };
        check(&a, &b)?;
    }

    #[test]
    fn grids_agree(a in cells(3), b in cells(2), outside in any::<bool>()) {
        let a = if outside { complement(&a) } else { a };
        check(&a, &b)?;
    }
}
