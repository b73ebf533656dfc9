//! Exact set operations: the laws of set algebra, measures, a second algorithm, and their definition point by point.

use crate::common::{cells, complement, digits, exact, inside, plain, radial};
use arcsum_oracle::boolean::{Operation, combine};
use arcsum_oracle::error::Budget;
use arcsum_oracle::number::Number;
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::point::Point;
use arcsum_oracle::region::ExactRegion;
use arcsum_oracle::trapezoid::trapezoids;
use arcsum_oracle::union;
use num_rational::BigRational;
use proptest::prelude::*;
use rug::Rational;

type Region = ExactRegion<Rational>;

fn of<Q: Number>(operation: Operation, a: &ExactRegion<Q>, b: &ExactRegion<Q>) -> ExactRegion<Q> {
    combine(operation, a, b).expect("finite")
}

fn joined(a: &Region, b: &Region) -> Region {
    of(Operation::Union, a, b)
}

fn common(a: &Region, b: &Region) -> Region {
    of(Operation::Intersection, a, b)
}

fn without(a: &Region, b: &Region) -> Region {
    of(Operation::Difference, a, b)
}

fn either_of(a: &Region, b: &Region) -> Region {
    of(Operation::SymmetricDifference, a, b)
}

fn outside(a: &Region) -> Region {
    a.complement().expect("closed")
}

fn bounded() -> impl Strategy<Value = PlainRegion> {
    prop_oneof![cells(4), radial(3..12)]
}

/// Grids, random polygons and their complements.
fn any_region() -> impl Strategy<Value = PlainRegion> {
    (bounded(), any::<bool>()).prop_map(|(region, turn)| if turn { complement(&region) } else { region })
}

/// The four operations in one layer of winding numbers, as [`arcsum_oracle::boolean`] derives them for bounded regions.
fn in_one_layer(operation: Operation, a: &Region, b: &Region) -> Region {
    let reverses = matches!(operation, Operation::Difference | Operation::SymmetricDifference);
    let ring = |ring: &Vec<Point<Rational>>| {
        if reverses { ring.iter().rev().cloned().collect() } else { ring.clone() }
    };
    let rings = a.loops().iter().cloned().chain(b.loops().iter().map(ring)).collect();
    let selects: fn(&[i32; 1]) -> bool = match operation {
        Operation::Union | Operation::Difference => |w| w[0] > 0,
        Operation::Intersection => |w| w[0] > 1,
        Operation::SymmetricDifference => |w| w[0] != 0,
    };
    Region::from_rings(rings, false, selects).expect("finite")
}

/// The union by clipping the edges of trapezoids against each other, without winding numbers.
fn by_pieces(a: &Region, b: &Region) -> Region {
    let pieces = |region: &Region| trapezoids(region.edges().map(|(p, q)| (p.clone(), q.clone())).collect());
    let all: Vec<_> = pieces(a).into_iter().chain(pieces(b)).collect();
    Region::from_edges(union::boundary(&all, Budget::NONE).expect("no budget"), false).expect("closed")
}

/// Whether a point belongs to the result just where the truth table says.
fn check_points<Q: Number>(a: &PlainRegion, b: &PlainRegion, probes: &[(i64, i64)]) -> Result<(), TestCaseError> {
    let (a, b): (ExactRegion<Q>, ExactRegion<Q>) = (exact(a), exact(b));
    for operation in Operation::ALL {
        let result = of(operation, &a, &b);
        for &(x, y) in probes {
            // Off the integer lines of the grids.
            let at =
                |k: i64, off: i64| Q::from_i64(k).over(&Q::from_i64(7)).plus(&Q::from_i64(1).over(&Q::from_i64(off)));
            let p = Point { x: at(x, 1009), y: at(y, 2003) };
            let expected = operation.holds(inside(&a, &p), inside(&b, &p));
            prop_assert_eq!(inside(&result, &p), expected, "{:?} at {:?}", operation, p);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(crate::common::cases(300))]

    #[test]
    fn layers_agree_with_sums_of_winding_numbers(a in bounded(), b in bounded()) {
        let (a, b): (Region, Region) = (exact(&a), exact(&b));
        for operation in Operation::ALL {
            prop_assert_eq!(of(operation, &a, &b), in_one_layer(operation, &a, &b), "{:?}", operation);
        }
    }

    #[test]
    fn unions_agree_with_clipped_pieces(a in bounded(), b in bounded()) {
        let (a, b): (Region, Region) = (exact(&a), exact(&b));
        prop_assert_eq!(joined(&a, &b), by_pieces(&a, &b));
    }

    #[test]
    fn points_belong_by_the_truth_table(
        a in any_region(), b in any_region(), probes in prop::collection::vec((-40i64..40, -40i64..40), 12)
    ) {
        check_points::<Rational>(&a, &b, &probes)?;
        check_points::<BigRational>(&a, &b, &probes)?;
    }

    #[test]
    fn backends_agree_to_the_digit(a in any_region(), b in any_region()) {
        for operation in Operation::ALL {
            let gmp = of::<Rational>(operation, &exact(&a), &exact(&b));
            let pure = of::<BigRational>(operation, &exact(&a), &exact(&b));
            prop_assert_eq!(digits(&gmp), digits(&pure));
            prop_assert_eq!(gmp.unbounded(), pure.unbounded());
        }
    }

    #[test]
    fn de_morgan(a in any_region(), b in any_region()) {
        let (a, b): (Region, Region) = (exact(&a), exact(&b));
        prop_assert_eq!(outside(&joined(&a, &b)), common(&outside(&a), &outside(&b)));
        prop_assert_eq!(outside(&common(&a, &b)), joined(&outside(&a), &outside(&b)));
        prop_assert_eq!(without(&a, &b), common(&a, &outside(&b)));
        prop_assert_eq!(either_of(&a, &b), joined(&without(&a, &b), &without(&b, &a)));
    }

    #[test]
    fn areas_obey_inclusion_and_exclusion(a in any_region(), b in any_region()) {
        // Also of unbounded regions, whose area is minus what they lack.
        let (a, b): (Region, Region) = (exact(&a), exact(&b));
        let (all, both) = (joined(&a, &b).area(), common(&a, &b).area());
        prop_assert_eq!(a.area() + b.area(), Rational::from(&all + &both));
        prop_assert_eq!(without(&a, &b).area() + &both, a.area());
        prop_assert_eq!(either_of(&a, &b).area(), all - both);
    }

    #[test]
    fn a_region_with_itself_and_its_complement(a in any_region()) {
        let a: Region = exact(&a);
        for same in [joined(&a, &a), common(&a, &a), without(&a, &outside(&a))] {
            prop_assert_eq!(&same, &a);
        }
        for nothing in [without(&a, &a), either_of(&a, &a), common(&a, &outside(&a))] {
            prop_assert_eq!(nothing, Region::empty());
        }
        for all in [joined(&a, &outside(&a)), either_of(&a, &outside(&a))] {
            prop_assert_eq!(all, Region::plane());
        }
    }

    #[test]
    fn nothing_and_everything(a in any_region()) {
        let a: Region = exact(&a);
        prop_assert_eq!(&joined(&a, &Region::empty()), &a);
        prop_assert_eq!(&common(&a, &Region::plane()), &a);
        prop_assert_eq!(common(&a, &Region::empty()), Region::empty());
        prop_assert_eq!(without(&Region::plane(), &a), outside(&a));
    }

    #[test]
    fn operations_distribute(a in bounded(), b in bounded(), c in any_region()) {
        let (a, b, c): (Region, Region, Region) = (exact(&a), exact(&b), exact(&c));
        prop_assert_eq!(common(&joined(&a, &b), &c), joined(&common(&a, &c), &common(&b, &c)));
        prop_assert_eq!(either_of(&either_of(&a, &b), &c), either_of(&a, &either_of(&b, &c)));
        prop_assert_eq!(joined(&a, &common(&a, &b)), a);
    }
}

#[test]
fn squares_that_overlap_touch_or_share_an_edge() {
    let square =
        |x: f64, y: f64| -> Region { exact(&plain(&[&[(x, y), (x + 2.0, y), (x + 2.0, y + 2.0), (x, y + 2.0)]])) };
    let area = |operation, x, y| of(operation, &square(0.0, 0.0), &square(x, y)).area();
    let areas = |x, y| Operation::ALL.map(|operation| area(operation, x, y));
    assert_eq!(areas(1.0, 1.0), [7, 1, 3, 6]);
    assert_eq!(areas(2.0, 1.0), [8, 0, 4, 8]);
    assert_eq!(areas(2.0, 2.0), [8, 0, 4, 8]);
    assert_eq!(joined(&square(0.0, 0.0), &square(2.0, 0.0)).vertices(), 4);
    assert_eq!(joined(&square(0.0, 0.0), &square(2.0, 2.0)).loops().len(), 2);
    assert!(common(&square(0.0, 0.0), &square(2.0, 0.0)).is_empty());
}
