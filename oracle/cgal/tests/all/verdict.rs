//! Who is right where CGAL and the references differ: a point where they do, and whether A meets its mirror image of B.

use crate::common::{Loops, references};
use arcsum_cgal::child::Child;
use arcsum_cgal::error::CgalError;
use arcsum_cgal::method::Method;
use arcsum_cgal::sum::Sum;
use arcsum_oracle::boolean::{Operation, combine};
use arcsum_oracle::point::Point;
use arcsum_oracle::region::ExactRegion;
use arcsum_oracle::trapezoid::trapezoids;
use rug::Rational;

/// What is to be said about an answer of CGAL.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The same region.
    Agrees {
        /// Its holes.
        holes: usize,
    },
    /// Another region, which lacks a point of the sum or has one too many: proved by membership.
    Wrong {
        /// Whether the point belongs to the sum.
        belongs: bool,
    },
    /// No region.
    None(CgalError),
}

/// Compares CGAL's sum with the references, as regular closed sets.
///
/// # Panics
/// If the references are wrong or disagree.
pub fn verdict(child: &mut Child, method: Method, a: &Loops, b: &Loops) -> Verdict {
    let answer = child.ask(&Sum { method, a: a.clone(), b: b.clone() }).and_then(|answer| answer.region());
    match answer {
        Err(error) => Verdict::None(error),
        Ok(claimed) => compared(&claimed, &region(a), &region(b)),
    }
}

/// Compares a region that claims to be the sum.
///
/// # Panics
/// If the references are wrong or disagree.
pub fn compared(claimed: &ExactRegion<Rational>, a: &ExactRegion<Rational>, b: &ExactRegion<Rational>) -> Verdict {
    let sum = references(a, b);
    if *claimed == sum {
        return Verdict::Agrees { holes: sum.holes() };
    }
    let differ = combine(Operation::SymmetricDifference, claimed, &sum).expect("numbers of doubles");
    let point = inside(&differ).expect("different regions differ somewhere");
    let belongs = meets(a, b, &point);
    assert_eq!(belongs, contains(&sum, &point), "the references are wrong at {point:?}");
    Verdict::Wrong { belongs }
}

/// The region of the loops in normal form.
pub fn region(loops: &Loops) -> ExactRegion<Rational> {
    ExactRegion::from_rings(loops.clone(), false, |w| w[0] != 0).expect("numbers of doubles")
}

/// Whether A and t - B have inner points in common: then t is an inner point of the sum, and a t off its boundary is only
/// then in it.
fn meets(a: &ExactRegion<Rational>, b: &ExactRegion<Rational>, t: &Point<Rational>) -> bool {
    let moved = b.scaled(&Rational::from(-1)).translated(t);
    !combine(Operation::Intersection, a, &moved).expect("numbers of doubles").is_empty()
}

/// Whether a point off the boundary is inside: an upward ray from it crosses the boundary an odd number of times.
fn contains(region: &ExactRegion<Rational>, t: &Point<Rational>) -> bool {
    let crosses = |(p, q): &(&Point<Rational>, &Point<Rational>)| {
        (p.x <= t.x) != (q.x <= t.x) && q.minus(p).cross(&t.minus(p)).is_negative() == (p.x < q.x)
    };
    region.edges().filter(crosses).count() % 2 == 1
}

/// A point inside a region.
fn inside(region: &ExactRegion<Rational>) -> Option<Point<Rational>> {
    let edges = region.edges().map(|(p, q)| (p.clone(), q.clone())).collect();
    let piece = trapezoids(edges).into_iter().next()?;
    let middle = piece
        .iter()
        .fold(None, |sum: Option<Point<Rational>>, p| Some(sum.map_or(p.exact.clone(), |s| s.plus(&p.exact))));
    middle.map(|sum| sum.times(&Rational::from((1, piece.len() as u64))))
}
