//! Tidied results: any result of the engine can be an operand again, and tidying changes it only within the stated distance
//! of its boundary, by the exact oracle. Where the result is a sum, which is nowhere thin, that is the Hausdorff distance.

use arcsum::boolean::{Operation, combine};
use arcsum::frame::Frame;
use arcsum::region::Region;
use arcsum::sum::{Convolution, Options, sum};
use arcsum::tidy::{MOVES, tidied};
use arcsum::validate::validate;
use arcsum_oracle::measure::{hausdorff, reach};
use arcsum_oracle::region::ExactRegion;
use arcsum_reports::bridge::plain;
use arcsum_tests::cases;
use arcsum_tests::shapes::{
    Lattice, any_region, bars, cells, holed, nudged_copies, nudged_integers, simple, turned_copies,
};
use proptest::prelude::*;
use rug::Rational;

const OPERATIONS: [Operation; 4] =
    [Operation::Union, Operation::Intersection, Operation::Difference, Operation::SymmetricDifference];

fn exact(region: &Region) -> ExactRegion<Rational> {
    ExactRegion::from_plain(&plain(region)).expect("polygonal and finite")
}

fn polygons(lattice: Lattice) -> impl Strategy<Value = Region> {
    prop_oneof![simple(10, 0.0, lattice), holed(10, 0.0, lattice)]
}

/// The sums by both convolutions.
fn sums(a: &Region, b: &Region) -> Result<[Region; 2], TestCaseError> {
    let one = |convolution| {
        let sum = sum(a, b, &Options { convolution, ..Options::default() });
        sum.map(|sum| sum.region).map_err(|e| TestCaseError::fail(e.to_string()))
    };
    Ok([one(Convolution::Kinetic)?, one(Convolution::Monotonic)?])
}

/// A result with what tidying makes of it, and the distance it may move by.
fn tidy(result: &Region) -> Result<(Region, f64), TestCaseError> {
    let (tidied, tolerance) = tidied(result).ok_or_else(|| TestCaseError::fail("no tolerance is enough"))?;
    prop_assert_eq!(tidied.unbounded, result.unbounded);
    if tidied.is_polygonal() && tidied.segments() > 0 {
        prop_assert_eq!(validate(&tidied), Ok(()));
    }
    Ok((tidied, MOVES * tolerance))
}

/// Tidying gains nothing farther from the result and loses nothing deeper in it than the distance.
fn check_near(result: &Region) -> Result<(), TestCaseError> {
    let (tidied, distance) = tidy(result)?;
    for (from, to) in [(&tidied, result), (&tidied.complement(), &result.complement())] {
        let (reach, _) = reach(&exact(from), &exact(to), distance / 1024.0).expect("finite");
        prop_assert!(reach.hi() <= distance, "{reach:?} above {distance}");
    }
    Ok(())
}

/// Sums of a and b can be summed again; their tidied forms are within the distance of them.
fn check_sums(a: &Region, b: &Region) -> Result<(), TestCaseError> {
    for result in sums(a, b)? {
        let (tidied, distance) = tidy(&result)?;
        let unit = libm::ldexp(1.0, Frame::shared(&[&result]).exp);
        let bracket = hausdorff(&plain(&tidied), &exact(&result), unit).expect("finite");
        prop_assert!(bracket.hi * unit <= distance, "{bracket:?}");
        check_near(&result)?;
        sums(&result, b)?;
        sums(&a.negated(), &result)?;
    }
    Ok(())
}

/// Results of set operations can be summed, and their tidied forms are near them.
fn check_operations(a: &Region, b: &Region) -> Result<(), TestCaseError> {
    for operation in OPERATIONS {
        let result = combine(operation, a, b).expect("finite");
        check_near(&result)?;
        sums(&result, b)?;
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(100))]

    #[test]
    fn sums_in_general_position(a in polygons(Lattice::Fine), b in polygons(Lattice::Fine)) {
        check_sums(&a, &b)?;
    }

    #[test]
    fn sums_with_the_negative(a in polygons(Lattice::Fine)) {
        check_sums(&a, &a.negated())?;
    }

    #[test]
    fn sums_of_copies_a_few_roundings_off((a, b) in nudged_copies(polygons(Lattice::Fine))) {
        check_sums(&a, &b)?;
        check_sums(&a, &b.negated())?;
    }

    #[test]
    fn sums_of_nearly_parallel_edges((a, b) in turned_copies(polygons(Lattice::Fine))) {
        check_sums(&a, &b)?;
    }

    #[test]
    fn sums_of_integers(a in polygons(Lattice::Integers(4)), b in polygons(Lattice::Integers(4))) {
        check_sums(&a, &b)?;
        check_sums(&a.complement(), &b)?;
    }

    #[test]
    fn sums_of_cells(a in cells(4, true), b in cells(3, true)) {
        check_sums(&a, &b)?;
    }

    #[test]
    fn sums_of_nearly_integers(a in nudged_integers(10, 3), b in nudged_integers(10, 3)) {
        check_sums(&a, &b)?;
    }

    #[test]
    fn sums_of_bars(a in bars(), b in bars()) {
        check_sums(&a, &b)?;
    }

    #[test]
    fn operations_in_general_position(a in polygons(Lattice::Fine), b in polygons(Lattice::Fine)) {
        check_operations(&a, &b)?;
    }

    #[test]
    fn operations_on_copies_a_few_roundings_off((a, b) in nudged_copies(polygons(Lattice::Fine))) {
        check_operations(&a, &b)?;
    }

    #[test]
    fn operations_on_integers_and_copies_off((a, b) in nudged_copies(polygons(Lattice::Integers(3)))) {
        check_operations(&a, &b)?;
    }

    #[test]
    fn operations_on_nearly_parallel_edges((a, b) in turned_copies(polygons(Lattice::Fine))) {
        check_operations(&a, &b)?;
    }

    #[test]
    fn operations_on_bars(a in bars(), b in bars()) {
        check_operations(&a, &b)?;
    }

    #[test]
    fn arcs_can_be_operands_again((a, b) in nudged_copies(any_region()), c in any_region()) {
        for result in sums(&a, &b)?.into_iter().chain(sums(&a, &b.negated())?).chain(sums(&a, &c)?) {
            tidy(&result)?;
            for twice in sums(&result, &c)? {
                sums(&twice, &c)?;
            }
        }
        for operation in OPERATIONS {
            for other in [&b, &c] {
                sums(&combine(operation, &a, other).expect("finite"), &c)?;
            }
        }
    }
}
