//! Laws every Minkowski sum obeys, and its definition, checked by a direct test of its own.

use std::cmp::Ordering;

use crate::common::{cells, complement, exact, inside, radial, ring, side};
use arcsum_oracle::error::Budget;
use arcsum_oracle::locate::{Location, Locator};
use arcsum_oracle::number::Number;
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::point::{Place, Point};
use arcsum_oracle::region::{ExactRegion, ring_area};
use arcsum_oracle::{convolve, polygon};
use proptest::prelude::*;
use rug::Rational;

type Region = ExactRegion<Rational>;

fn sum(a: &Region, b: &Region) -> Region {
    convolve::sum(a, b, Budget::NONE).expect("no budget")
}

fn union(a: &Region, b: &Region) -> Region {
    let rings = a.loops().iter().chain(b.loops()).cloned().collect();
    Region::from_rings(rings, false, |w| w[0] > 0).expect("finite")
}

fn point(x: f64, y: f64) -> Point<Rational> {
    Point::from_f64(x, y).expect("finite")
}

fn either() -> impl Strategy<Value = PlainRegion> {
    prop_oneof![cells(3), radial(3..10)]
}

/// Whether A and t-B have a point in common: some edges meet, or a vertex of one is inside the other.
fn meets(a: &Region, b: &Region, t: &Point<Rational>) -> bool {
    let b = b.scaled(&Rational::from(-1)).translated(t);
    let crosses = |(p, q): (&Point<Rational>, &Point<Rational>)| b.edges().any(|(r, s)| segments_meet(p, q, r, s));
    let holds = |region: &Region, other: &Region| other.loops().iter().any(|ring| inside(region, &ring[0]));
    a.edges().any(crosses) || holds(a, &b) || holds(&b, a)
}

fn segments_meet(p: &Point<Rational>, q: &Point<Rational>, r: &Point<Rational>, s: &Point<Rational>) -> bool {
    let boxes =
        |v: fn(&Point<Rational>) -> &Rational| v(p).max(v(q)) >= v(r).min(v(s)) && v(r).max(v(s)) >= v(p).min(v(q));
    let apart = |a: Ordering, b: Ordering| a == b && a != Ordering::Equal;
    boxes(|p| &p.x) && boxes(|p| &p.y) && !apart(side(p, q, r), side(p, q, s)) && !apart(side(r, s, p), side(r, s, q))
}

proptest! {
    #![proptest_config(crate::common::cases(150))]

    #[test]
    fn the_order_of_operands_does_not_matter(a in either(), b in either(), outside in any::<bool>()) {
        let a = if outside { complement(&a) } else { a };
        let (a, b) = (exact(&a), exact(&b));
        prop_assert_eq!(sum(&a, &b), sum(&b, &a));
    }

    #[test]
    fn sums_move_scale_and_turn_with_their_operands(
        a in either(), b in either(), x in -2.0..2.0f64, y in -2.0..2.0f64, p in 1i64..9, q in 1i64..9, turn in any::<bool>()
    ) {
        let (a, b): (Region, Region) = (exact(&a), exact(&b));
        let whole = sum(&a, &b);
        prop_assert_eq!(sum(&a.translated(&point(x, y)), &b), whole.translated(&point(x, y)));
        let factor = Rational::from((if turn { -p } else { p }, q));
        prop_assert_eq!(sum(&a.scaled(&factor), &b.scaled(&factor)), whole.scaled(&factor));
    }

    #[test]
    fn more_input_gives_more_sum_and_unions_distribute(a in either(), b in either(), c in either()) {
        let (a, b, c): (Region, Region, Region) = (exact(&a), exact(&b), exact(&c));
        let both = sum(&union(&a, &c), &b);
        prop_assert_eq!(union(&sum(&a, &b), &both), both.clone());
        prop_assert_eq!(union(&sum(&a, &b), &sum(&c, &b)), both);
    }

    #[test]
    fn sums_associate(a in cells(2), b in cells(2), c in cells(2)) {
        let (a, b, c): (Region, Region, Region) = (exact(&a), exact(&b), exact(&c));
        prop_assert_eq!(sum(&sum(&a, &b), &c), sum(&a, &sum(&b, &c)));
    }

    #[test]
    fn a_point_is_in_the_sum_if_the_regions_meet(
        a in either(), b in either(), outside in any::<bool>(),
        probes in prop::collection::vec((-40i64..40, -40i64..40), 12)
    ) {
        let a: Region = exact(&if outside { complement(&a) } else { a });
        let b: Region = exact(&b);
        prop_assume!(!a.is_empty() && !b.is_empty());
        let locator = Locator::new(&sum(&a, &b)).expect("finite");
        for (x, y) in probes {
            // Off the small integer lines on which the grids' contacts happen.
            let t = Point { x: Rational::from((x, 7)) + Rational::from((1, 1009)), y: Rational::from((y, 7)) + Rational::from((1, 2003)) };
            let expected = if meets(&a, &b, &t) { Location::Inside } else { Location::Outside };
            prop_assert_eq!(locator.locate(&Place::from(t)), expected);
        }
    }

    #[test]
    fn areas_of_convex_sums_are_quadratic(n in 3usize..9, m in 3usize..9, scale in 1i64..5) {
        // area(A + kA') is a polynomial of degree two in k with the two areas at its ends.
        let round = |n: usize| {
            let corner = |k: usize| (k as f64 / n as f64 * std::f64::consts::TAU).sin_cos();
            exact::<Rational>(&PlainRegion { loops: vec![ring((0..n).rev().map(corner))], unbounded: false })
        };
        let (a, b) = (round(n), round(m));
        prop_assert!(a.area() > 0 && b.area() > 0);
        let area = |k: i64| sum(&a, &b.scaled(&Rational::from(k))).area();
        let mixed = (area(1) - a.area() - b.area()) / 2;
        let k = Rational::from(scale);
        let expected = a.area() + Rational::from(&k * &mixed) * 2 + Rational::from(&k * &k) * b.area();
        prop_assert_eq!(area(scale), expected);
        let perimeter = sum(&a, &b).perimeter();
        let added = a.perimeter() + b.perimeter();
        prop_assert!(perimeter.lo() <= added.hi() && added.lo() <= perimeter.hi());
    }

    #[test]
    fn regions_in_normal_form_keep_their_form(a in cells(4)) {
        let region: Region = exact(&a);
        prop_assert_eq!(&exact::<Rational>(&region.to_plain()), &region);
        let outside = region.complement().expect("closed");
        prop_assert_eq!(&exact::<Rational>(&complement(&a)), &outside);
        prop_assert_eq!(outside.complement().expect("closed"), region.clone());
        prop_assert_eq!(region.area(), -outside.area());
        for ring in region.loops() {
            prop_assert!(ring_area(ring).sign() != Ordering::Equal);
            prop_assert!(ring.iter().skip(1).all(|p| *p > ring[0]));
            for (i, p) in ring.iter().enumerate() {
                prop_assert!(!ring[i + 1..].contains(p));
            }
        }
    }
}

#[test]
fn the_default_sum_reads_crossing_loops_by_their_winding() {
    let bow = crate::common::plain(&[&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]]);
    let dot = crate::common::plain(&[&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]]);
    let halves: Region =
        exact(&crate::common::plain(&[&[(0.0, 0.0), (1.0, 1.0), (0.0, 2.0)], &[(1.0, 1.0), (2.0, 0.0), (2.0, 2.0)]]));
    assert_eq!(exact::<Rational>(&bow), halves);
    assert_eq!(polygon::sum(&bow, &dot).expect("small"), sum(&halves, &exact(&dot)));
}
