//! Loops of integers, and questions about them.

use arcsum_cgal::child::Child;
use arcsum_cgal::error::CgalError;
use arcsum_cgal::method::Method;
use arcsum_cgal::sum::Answer;
use arcsum_cgal::sum::Sum;
use arcsum_oracle::error::Budget;
use arcsum_oracle::point::Point;
use arcsum_oracle::region::ExactRegion;
use arcsum_oracle::{convolve, decompose};
use rug::Rational;
use std::time::Duration;

/// A loop of small integers.
pub type Ring = Vec<(i64, i64)>;
/// Exact loops.
pub type Loops = Vec<Vec<Point<Rational>>>;

/// A square with a corner at the origin, counter-clockwise.
pub fn square(side: i64) -> Ring {
    rectangle(0, 0, side, side)
}

/// A rectangle, counter-clockwise.
pub fn rectangle(x0: i64, y0: i64, x1: i64, y1: i64) -> Ring {
    vec![(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
}

/// The loop the other way around.
pub fn reversed(ring: &[(i64, i64)]) -> Ring {
    ring.iter().rev().copied().collect()
}

/// The loops in exact numbers.
pub fn loops(rings: &[Ring]) -> Loops {
    let point = |&(x, y): &(i64, i64)| Point { x: Rational::from(x), y: Rational::from(y) };
    rings.iter().map(|ring| ring.iter().map(point).collect()).collect()
}

/// The region of the loops in normal form.
pub fn region(rings: &[Ring]) -> ExactRegion<Rational> {
    ExactRegion::from_rings(loops(rings), false, |w| w[0] != 0).expect("small integers")
}

/// The methods with exact numbers that take such holes.
pub fn exact_methods(holes: bool) -> impl Iterator<Item = Method> {
    let exact = |m: &Method| !m.to_string().ends_with(":inexact");
    Method::all().filter(exact).filter(move |m| !holes || m.strategy().takes_holes())
}

/// A child process; no question of these tests takes long.
pub fn child() -> Child {
    Child::new(env!("CARGO_BIN_EXE_arcsum-cgal"), &[], Duration::from_secs(60))
}

/// CGAL's sum, in the child.
pub fn ask(child: &mut Child, method: Method, a: &[Ring], b: &[Ring]) -> Result<Answer, CgalError> {
    child.ask(&Sum { method, a: loops(a), b: loops(b) })
}

/// The sum by both references, which must agree.
pub fn references(a: &ExactRegion<Rational>, b: &ExactRegion<Rational>) -> ExactRegion<Rational> {
    let by_winding = convolve::sum(a, b, Budget::NONE).expect("no budget");
    let by_union = decompose::sum(a, b, Budget::NONE).expect("no budget");
    assert_eq!(by_winding, by_union, "the references disagree");
    by_winding
}
