//! Input that is none: refused, or answered right, by every method, without harm to the process.

use crate::common::{self, Ring, ask, child, rectangle, reversed, square};
use arcsum_cgal::child::Child;
use arcsum_cgal::curved::{self, Combine};
use arcsum_cgal::error::CgalError;
use arcsum_cgal::method::Method;
use arcsum_cgal::offset::Offset;
use arcsum_cgal::question::loops;
use arcsum_cgal::sum::Sum;
use arcsum_oracle::boolean::Operation;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use rug::Rational;
use std::time::Duration;

fn bad() -> Vec<(&'static str, Vec<Ring>)> {
    let hole = |x0, y0, x1, y1| reversed(&rectangle(x0, y0, x1, y1));
    vec![
        ("empty", vec![]),
        ("empty loop", vec![vec![]]),
        ("point", vec![vec![(1, 1)]]),
        ("segment", vec![vec![(0, 0), (4, 4)]]),
        ("no area", vec![vec![(0, 0), (4, 4), (2, 2)]]),
        ("one point thrice", vec![vec![(0, 0), (0, 0), (0, 0)]]),
        ("clockwise", vec![reversed(&square(4))]),
        ("bow-tie", vec![vec![(0, 0), (4, 4), (4, 0), (0, 4)]]),
        ("wound twice", vec![[square(4), square(4)].concat()]),
        ("repeated vertex", vec![vec![(0, 0), (4, 0), (4, 0), (4, 4), (0, 4)]]),
        ("spike", vec![vec![(0, 0), (4, 0), (4, 4), (7, 4), (4, 4), (0, 4)]]),
        ("pinch", vec![vec![(0, 0), (2, 2), (4, 0), (4, 4), (2, 2), (0, 4)]]),
        ("hole outside", vec![square(4), hole(6, 0, 8, 2)]),
        ("hole across the boundary", vec![square(4), hole(2, 1, 6, 2)]),
        ("holes that overlap", vec![square(9), hole(1, 1, 5, 5), hole(3, 3, 7, 7)]),
        ("the same hole twice", vec![square(9), hole(1, 1, 5, 5), hole(1, 1, 5, 5)]),
        ("hole around everything", vec![square(4), hole(-1, -1, 6, 6)]),
        ("the whole is a hole", vec![square(4), reversed(&square(4))]),
        ("hole counter-clockwise", vec![square(9), rectangle(1, 1, 5, 5)]),
        ("two pieces", vec![square(4), rectangle(6, 0, 8, 2)]),
        ("hole without a region", vec![hole(0, 0, 4, 4)]),
    ]
}

fn refused(answer: Result<impl std::fmt::Debug, CgalError>, what: &str) {
    assert!(matches!(answer, Err(CgalError::Refused(_))), "{what}: {answer:?}");
}

#[test]
fn bad_operands_are_refused_by_every_method() {
    let mut child: Child = child();
    for method in Method::all().filter(|_| arcsum_cgal::built_in()) {
        for (what, rings) in bad() {
            refused(ask(&mut child, method, &rings, &[square(1)]), what);
            refused(ask(&mut child, method, &[square(1)], &rings), what);
        }
    }
}

fn polygon(rings: &[Ring]) -> PlainRegion {
    let corner = |&(x, y): &(i64, i64)| Corner { x: x as f64, y: y as f64, bend: Bend::Line };
    PlainRegion { loops: rings.iter().map(|ring| ring.iter().map(corner).collect()).collect(), unbounded: false }
}

#[test]
fn bad_regions_are_refused_by_both_offsets() {
    let mut child: Child = child();
    for (what, rings) in bad().into_iter().filter(|_| arcsum_cgal::built_in()) {
        let (region, radius) = (common::loops(&rings), Rational::from(1));
        refused(child.ask(&Offset { region: region.clone(), radius: radius.clone() }), what);
        refused(child.ask(&curved::Offset { region, radius, error: 1e-3 }), what);
    }
    for radius in [0, -1] {
        let question = Offset { region: common::loops(&[square(4)]), radius: Rational::from(radius) };
        assert!(!arcsum_cgal::built_in() || matches!(child.ask(&question), Err(CgalError::Refused(_))));
    }
}

#[test]
fn bad_operands_of_set_operations_are_refused() {
    let mut child: Child = child();
    let good = polygon(&[square(4)]);
    for (what, rings) in bad().into_iter().filter(|_| arcsum_cgal::built_in()) {
        for operation in Operation::ALL {
            for (a, b) in [(&polygon(&rings), &good), (&good, &polygon(&rings))] {
                refused(Combine::new(operation, a, b).and_then(|question| child.ask(&question)), what);
            }
        }
    }
}

/// Arcs that cross another segment or themselves, that run clockwise, or that are none.
#[test]
fn bad_arcs_are_refused() {
    let ring = |corners: &[(f64, f64, f64)]| {
        let corner = |&(x, y, bulge): &(f64, f64, f64)| Corner { x, y, bend: Bend::Bulge(bulge) };
        PlainRegion { loops: vec![corners.iter().map(corner).collect()], unbounded: false }
    };
    let good = polygon(&[square(4)]);
    let mut child: Child = child();
    for (what, bad) in [
        ("clockwise", ring(&[(0.0, 0.0, -1.0), (2.0, 0.0, -1.0)])),
        ("no area", ring(&[(0.0, 0.0, 0.5), (2.0, 0.0, -0.5)])),
        ("across an edge", ring(&[(0.0, 0.0, -4.0), (4.0, 0.0, 0.0), (4.0, 1.0, 0.0), (0.0, 1.0, 0.0)])),
        ("no length", ring(&[(0.0, 0.0, 1.0), (0.0, 0.0, 1.0), (2.0, 0.0, 1.0)])),
        ("not a number", ring(&[(0.0, 0.0, f64::NAN), (2.0, 0.0, 1.0)])),
        ("infinite", ring(&[(0.0, 0.0, 1.0), (f64::INFINITY, 0.0, 1.0)])),
        ("no bulge", ring(&[(0.0, 0.0, f64::INFINITY), (2.0, 0.0, 1.0)])),
    ] {
        let answer = Combine::new(Operation::Union, &bad, &good).and_then(|question| child.ask(&question));
        assert!(matches!(answer, Err(CgalError::Refused(_) | CgalError::NotBuiltIn)), "{what}: {answer:?}");
    }
}

/// An answer that is right, or none.
#[test]
fn extreme_numbers_are_no_harm_to_offsets_and_set_operations() {
    let mut child = Child::new(env!("CARGO_BIN_EXE_arcsum-cgal"), &[], Duration::from_secs(5));
    let (tiny, huge) = (f64::from_bits(1), f64::MAX);
    for (s, r) in [(tiny, tiny), (tiny, huge), (huge, tiny), (huge, huge), (1.0, tiny), (huge, 1.0)] {
        let corner = |x, y| Corner { x, y, bend: Bend::Line };
        let ring = vec![corner(0.0, 0.0), corner(s, 0.0), corner(0.0, s)];
        let triangle = PlainRegion { loops: vec![ring], unbounded: false };
        let region = loops(&triangle).expect("finite");
        let radius = Rational::from_f64(r).expect("finite");
        let question = Offset { region: region.clone(), radius: radius.clone() };
        if let Ok(answer) = child.ask(&question) {
            assert!(question.carriers(&answer).is_ok() && answer.loops[0].len() >= 6, "{s:e} {r:e} {answer:?}");
        }
        if let Ok(answer) = child.ask(&curved::Offset { region, radius, error: r / 8.0 }) {
            assert_eq!(answer.loops.len(), 1, "{s:e} {r:e}");
        }
        let half = |x| Corner { x, y: 0.0, bend: Bend::Bulge(1.0) };
        let disc = PlainRegion { loops: vec![vec![half(-r), half(r)]], unbounded: false };
        let both = Combine::new(Operation::Union, &triangle, &disc).and_then(|question| child.ask(&question));
        assert!(both.is_err() || both.is_ok_and(|both| both.loops.len() == 1), "{s:e} {r:e}");
    }
    let question = Offset { region: common::loops(&[square(4)]), radius: Rational::from(1) };
    assert!(!arcsum_cgal::built_in() || child.ask(&question).is_ok(), "the child is started anew");
}

#[test]
fn what_is_no_polygon_never_reaches_cgal() {
    let corner = |x, bend| Corner { x, y: 0.0, bend };
    for bad in [corner(f64::NAN, Bend::Line), corner(f64::INFINITY, Bend::Line), corner(0.0, Bend::Bulge(0.5))] {
        let region = PlainRegion { loops: vec![vec![bad; 3]], unbounded: false };
        refused(loops(&region), "a corner");
    }
    refused(loops(&PlainRegion { unbounded: true, ..PlainRegion::default() }), "the plane");
}

/// Doubles from the smallest to the largest.
#[test]
fn extreme_numbers_are_no_harm() {
    let triangle = |s: f64| {
        let corner = |x, y| Corner { x, y, bend: Bend::Line };
        let ring = vec![corner(0.0, 0.0), corner(s, 0.0), corner(0.0, s)];
        loops(&PlainRegion { loops: vec![ring], unbounded: false }).expect("finite")
    };
    let (tiny, huge) = (f64::from_bits(1), f64::MAX);
    let mut child = child();
    for method in Method::all().filter(|_| arcsum_cgal::built_in()) {
        let inexact = method.to_string().ends_with(":inexact");
        for (s, t) in [(tiny, tiny), (tiny, huge), (huge, huge)] {
            let answer = child.ask(&Sum { method, a: triangle(s), b: triangle(t) });
            let found = answer.and_then(|a| a.region()).map(|r| r.vertices());
            // With the smallest and the largest double together CGAL 5.5.1 ends its process.
            let gave_up = matches!(found, Err(CgalError::Failed(_) | CgalError::Died(_)));
            // Rounded numbers overflow, and CGAL then says what it likes.
            assert!(inexact || gave_up || found == Ok(3), "{method} {s:e} {t:e}: {found:?}");
        }
    }
}
