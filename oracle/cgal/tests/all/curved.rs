//! Offsets and set operations on regions of line and circle segments: areas that are known, and points that must lie at the
//! offset's distance.

use crate::common::{Ring, child, loops, rectangle, reversed, square};
use arcsum_cgal::curved::{Combine, Coordinate, Offset};
use arcsum_cgal::error::CgalError;
use arcsum_oracle::boolean::Operation;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use rug::Rational;
use std::f64::consts::PI;

fn offset(region: &[Ring], radius: i64, error: f64) -> Offset {
    Offset { region: loops(region), radius: Rational::from(radius), error }
}

/// A disc as two half circles.
fn disc(x: f64, y: f64, r: f64) -> PlainRegion {
    let corner = |x| Corner { x, y, bend: Bend::Bulge(1.0) };
    PlainRegion { loops: vec![vec![corner(x - r), corner(x + r)]], unbounded: false }
}

fn polygon(rings: &[Ring]) -> PlainRegion {
    let corner = |&(x, y): &(i64, i64)| Corner { x: x as f64, y: y as f64, bend: Bend::Line };
    PlainRegion { loops: rings.iter().map(|ring| ring.iter().map(corner).collect()).collect(), unbounded: false }
}

/// The area that a disc of radius r adds to a convex polygon is the perimeter times r and the disc; a hole shrinks.
#[test]
fn offsets_have_the_area_of_steiner() {
    if !arcsum_cgal::built_in() {
        return;
    }
    let triangle: Ring = vec![(0, 0), (4, 0), (0, 3)];
    let frame = [square(20), reversed(&rectangle(5, 5, 15, 15))];
    let (disc, mut child) = (PI * 4.0, child());
    for error in [1e-2, 1e-4, 1e-6] {
        for (region, area, perimeter) in [
            (vec![triangle.clone()], 6.0 + 24.0 + disc, 12.0),
            (vec![square(5)], 25.0 + 40.0 + disc, 20.0),
            (frame.to_vec(), 400.0 + 160.0 + disc - 36.0, 104.0),
        ] {
            let found = child.ask(&offset(&region, 2, error)).expect("a valid region").area();
            // A boundary that is off by the error moves the area by its length times that.
            let length = perimeter + 4.0 * PI;
            assert!((found - area).abs() <= error * length + 1e-9, "{region:?} {error}: {found} {area}");
        }
    }
}

#[test]
fn two_discs_meet_in_a_lens() {
    if !arcsum_cgal::built_in() {
        return;
    }
    // Unit discs at distance 1: the lens has the area 2 pi/3 - sqrt(3)/2, its corners are (1/2, ± sqrt(3)/2).
    let (a, b) = (disc(0.0, 0.0, 1.0), disc(1.0, 0.0, 1.0));
    let lens = 2.0 * PI / 3.0 - 0.75_f64.sqrt();
    let mut child = child();
    for (operation, area) in [
        (Operation::Intersection, lens),
        (Operation::Union, 2.0 * PI - lens),
        (Operation::Difference, PI - lens),
        (Operation::SymmetricDifference, 2.0 * (PI - lens)),
    ] {
        let found = child.ask(&Combine::new(operation, &a, &b).expect("bulges")).expect("valid regions");
        assert!((found.area() - area).abs() < 1e-12, "{operation:?}: {} {area}", found.area());
        let corners = found.loops.iter().flatten().map(|edge| edge.tail.each_ref().map(Coordinate::to_f64));
        assert_eq!(corners.filter(|[x, y]| *x == 0.5 && y.abs() == 0.75_f64.sqrt()).count() % 2, 0);
    }
}

#[test]
fn a_disc_cut_out_of_a_square_is_a_hole() {
    if !arcsum_cgal::built_in() {
        return;
    }
    let (plate, hole) = (polygon(&[square(10)]), disc(5.0, 5.0, 2.0));
    let cut = child().ask(&Combine::new(Operation::Difference, &plate, &hole).expect("bulges")).expect("valid");
    assert_eq!(cut.loops.len(), 2);
    assert!((cut.area() - (100.0 - 4.0 * PI)).abs() < 1e-12);
}

#[test]
fn bad_regions_and_numbers_are_refused() {
    if !arcsum_cgal::built_in() {
        return;
    }
    let mut child = child();
    let bow: Ring = vec![(0, 0), (4, 4), (4, 0), (0, 4)];
    for bad in [
        offset(&[square(4)], 0, 1e-3),
        offset(&[square(4)], -1, 1e-3),
        offset(&[square(4)], 1, 0.0),
        offset(&[square(4)], 1, f64::NAN),
        offset(std::slice::from_ref(&bow), 1, 1e-3),
        offset(&[], 1, 1e-3),
    ] {
        let answer = child.ask(&bad);
        assert!(matches!(answer, Err(CgalError::Refused(_))), "{bad:?} {answer:?}");
    }
    let good = disc(0.0, 0.0, 1.0);
    for bad in [
        polygon(&[]),
        polygon(&[vec![(0, 0)]]),
        polygon(&[vec![(0, 0), (0, 0), (1, 0)]]),
        polygon(&[bow]),
        polygon(&[reversed(&square(4))]),
        polygon(&[square(4), reversed(&rectangle(6, 0, 8, 2))]),
    ] {
        let answer = child.ask(&Combine::new(Operation::Union, &bad, &good).expect("lines"));
        assert!(matches!(answer, Err(CgalError::Refused(_))), "{bad:?} {answer:?}");
    }
    let radius =
        PlainRegion { loops: vec![vec![Corner { x: 0.0, y: 0.0, bend: Bend::Radius(2.0) }; 3]], unbounded: false };
    assert!(Combine::new(Operation::Union, &radius, &good).is_err());
}
