//! Sums whose answer is known by construction.

use crate::common::{complement, exact, fork, plain, rectangle};
use arcsum_oracle::error::{Budget, OracleError};
use arcsum_oracle::number::Number;
use arcsum_oracle::plain::{Bend, PlainRegion};
use arcsum_oracle::point::Point;
use arcsum_oracle::polygon;
use arcsum_oracle::region::{ExactRegion, ring_area};
use rug::Rational;

const SQUARE: &[(f64, f64)] = &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];

fn sum(a: &PlainRegion, b: &PlainRegion) -> ExactRegion<Rational> {
    polygon::sum(a, b).expect("within the budget")
}

fn region(rings: &[&[(f64, f64)]]) -> ExactRegion<Rational> {
    exact(&plain(rings))
}

#[test]
fn squares_add_their_sides() {
    let doubled: &[_] = &[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
    assert_eq!(sum(&plain(&[SQUARE]), &plain(&[SQUARE])), region(&[doubled]));
}

#[test]
fn a_hole_shrinks_and_vanishes_when_the_part_fits_exactly() {
    let outer: &[_] = &[(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (0.0, 6.0)];
    let large: &[_] = &[(2.0, 2.0), (2.0, 4.0), (4.0, 4.0), (4.0, 2.0)];
    let small: &[_] = &[(2.0, 2.0), (2.0, 3.0), (3.0, 3.0), (3.0, 2.0)];
    let grown: &[_] = &[(0.0, 0.0), (7.0, 0.0), (7.0, 7.0), (0.0, 7.0)];
    let shrunk: &[_] = &[(3.0, 3.0), (3.0, 4.0), (4.0, 4.0), (4.0, 3.0)];
    assert_eq!(sum(&plain(&[outer, large]), &plain(&[SQUARE])), region(&[grown, shrunk]));
    // The degenerate hole is a single point: contact, not free space.
    assert_eq!(sum(&plain(&[outer, small]), &plain(&[SQUARE])), region(&[grown]));
}

#[test]
fn an_annulus_against_a_larger_part_has_no_false_hole() {
    // The Euler characteristic of the intersection is 0 where the part covers the annulus (memo fact 6).
    let outer: &[_] = &[(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)];
    let hole: &[_] = &[(1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0)];
    let part: &[_] = &[(0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (0.0, 5.0)];
    let whole: &[_] = &[(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)];
    assert_eq!(sum(&plain(&[outer, hole]), &plain(&[part])), region(&[whole]));
    assert_eq!(sum(&plain(&[outer, hole]), &plain(&[outer, hole])).holes(), 0);
}

#[test]
fn a_corridor_of_exactly_the_part_closes() {
    let room: &[_] = &[(0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (3.0, 4.0), (3.0, 1.0), (2.0, 1.0), (2.0, 4.0), (0.0, 4.0)];
    let closed: &[_] = &[(0.0, 0.0), (6.0, 0.0), (6.0, 5.0), (0.0, 5.0)];
    assert_eq!(sum(&plain(&[room]), &plain(&[SQUARE])), region(&[closed]));
}

#[test]
fn sums_of_separate_parts_may_touch_at_a_vertex() {
    let a = PlainRegion { loops: vec![rectangle(0.0, 0.0, 1.0, 1.0), rectangle(2.0, 2.0, 3.0, 3.0)], unbounded: false };
    let first: &[_] = &[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
    let second: &[_] = &[(2.0, 2.0), (4.0, 2.0), (4.0, 4.0), (2.0, 4.0)];
    assert_eq!(sum(&a, &plain(&[SQUARE])), region(&[first, second]));
}

#[test]
fn a_container_frees_what_the_part_can_reach() {
    let container = complement(&plain(&[&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]]));
    let free: &[_] = &[(1.0, 1.0), (4.0, 1.0), (4.0, 3.0), (1.0, 3.0)];
    assert_eq!(Ok(sum(&container, &plain(&[SQUARE]))), region(&[free]).complement());
    // Too large a part, or one that fits without play, leaves nothing.
    let large = plain(&[&[(0.0, 0.0), (5.0, 0.0), (5.0, 1.0), (0.0, 1.0)]]);
    let tight = plain(&[&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]]);
    assert_eq!(sum(&container, &large), ExactRegion::plane());
    assert_eq!(sum(&container, &tight), ExactRegion::plane());
    assert_eq!(sum(&container, &container), ExactRegion::plane());
    assert_eq!(sum(&container, &PlainRegion::default()), ExactRegion::empty());
}

#[test]
fn forks_have_the_predicted_number_of_holes() {
    // The (p²-1)² holes of the grid and those between its border and the spines: the memo's counts by rectangles.
    for (p, expected) in [(2, 9 + 3), (3, 64 + 8), (4, 225 + 15), (5, 576 + 24)] {
        let (a, b, pitch) = fork(p);
        let sum = sum(&a, &b);
        let pitch = <Rational as Number>::from_f64(pitch).expect("finite");
        let span = |ring: &[Point<Rational>], value: fn(&Point<Rational>) -> &Rational| {
            let values = || ring.iter().map(value);
            Rational::from(values().max().expect("a vertex") - values().min().expect("a vertex"))
        };
        let small = |ring: &&Vec<Point<Rational>>| {
            ring_area(ring).sign().is_lt() && span(ring, |p| &p.x) <= pitch && span(ring, |p| &p.y) <= pitch
        };
        let holes = sum.loops().iter().filter(small).count();
        assert_eq!(holes, expected, "p = {p}");
    }
}

#[test]
fn input_that_is_no_polygon_or_too_large_is_refused() {
    let square = plain(&[SQUARE]);
    let mut arc = square.clone();
    arc.loops[0][2].bend = Bend::Bulge(0.5);
    assert_eq!(polygon::sum(&arc, &square), Err(OracleError::NotPolygonal { ring: 0, vertex: 2 }));
    let mut endless = square.clone();
    endless.loops[0][1].y = f64::INFINITY;
    assert!(matches!(polygon::sum(&square, &endless), Err(OracleError::BadNumber { ring: 0, vertex: 1, .. })));
    let (a, b, _) = fork(3);
    let few = Budget { segments: 100, ..Budget::default() };
    assert!(matches!(polygon::sum_within(&a, &b, few), Err(OracleError::TooCostly { limit: 100, .. })));
    let few = Budget { meetings: 1000, ..Budget::default() };
    assert!(matches!(polygon::sum_within(&a, &b, few), Err(OracleError::TooCostly { limit: 1000, .. })));
}
