//! Tidied results: any result of the engine can be an operand again, and tidying changes it only within the stated distance
//! of its boundary, by the exact oracle. Where the result is a sum, which is nowhere thin, that is the Hausdorff distance.

use arcsum::arrangement::cross::EPS;
use arcsum::boolean::{Operation, combine};
use arcsum::frame::Frame;
use arcsum::region::{Curve, Node, Region};
use arcsum::sum::{Convolution, Options, sum};
use arcsum::tidy::{MOVES, TOLERANCES, tidied};
use arcsum::validate::{Invalid, validate};
use arcsum_oracle::certified::hausdorff::{Outline, between as certified};
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::measure::{Bracket, hausdorff, reach};
use arcsum_oracle::region::ExactRegion;
use arcsum_reports::bridge::plain;
use arcsum_tests::boundary::away;
use arcsum_tests::cases;
use arcsum_tests::shapes::{
    Lattice, any_region, bars, cells, holed, nudged_copies, nudged_integers, simple, turned_copies,
};
use glam::DVec2;
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
        // Loops that are drawn together at several vertices may close a ring. Sums take such regions.
        let valid = validate(&tidied);
        prop_assert!(matches!(valid, Ok(()) | Err(Invalid::CutInterior { .. })), "{valid:?}");
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

/// The certified distance of a tidied region with arcs from the region, if it can be decided.
fn arc_distance(tidied: &Region, result: &Region) -> Option<Bracket> {
    let outline = |region| Outline::from(&Shape::new(&plain(region)).expect("finite"));
    Some(certified(&outline(tidied), &outline(result)).expect("finite")?.bracket)
}

proptest! {
    #![proptest_config(cases(60))]

    /// No bound for the Hausdorff distance: sums with arcs do come out with slivers no wider than a rounding, which go.
    #[test]
    fn arcs_stay_in_place((a, b) in nudged_copies(simple(8, 0.4, Lattice::Fine)), negate: bool) {
        let b = if negate { b.negated() } else { b };
        for result in sums(&a, &b)? {
            let twice = sums(&result, &b)?;
            for result in twice.into_iter().chain([result]) {
                let (tidied, distance) = tidy(&result)?;
                let [from, to] = [&tidied, &result].map(|r| Shape::new(&plain(r)).expect("finite"));
                prop_assert!(away(&from, &to) <= distance, "{} above {distance}", away(&from, &to));
                let lost = (tidied.area() - result.area()).abs();
                prop_assert!(lost <= 2.0 * distance * result.perimeter(), "{lost}");
            }
        }
    }

    /// A vertex planted next to the beginning of a long arc does not bend the rest of it. Of an arc nearer to a half circle
    /// the beginning is a spike on the line before it, too thin to stay.
    #[test]
    fn arcs_are_led_without_bending(bulge in 0.05..0.8_f64, digits in 3.0..14.0_f64, off in -1.0..1.0_f64, outwards: bool) {
        let bulge = if outwards { bulge } else { -bulge };
        let least = TOLERANCES[0] * EPS;
        // The arc from (1, 0) to (0, 0), and a triangle below with its tip next to the arc.
        let (delta, share) = (2.0 * libm::atan(bulge), 10_f64.powf(-digits));
        let way = DVec2::new(-libm::cos(delta), libm::sin(delta)) * share;
        let tip = DVec2::new(1.0, 0.0) + way + off * least * way.perp().normalize();
        let arc = Node { curve: Curve::Bulge(bulge), ..Node::line(1.0, 0.0) };
        let lower = vec![Node::line(0.0, 0.0), Node::line(0.0, -4.0), Node::line(1.0, -4.0), arc];
        let upper = vec![Node::line(tip.x, tip.y), Node::line(3.0, 3.0), Node::line(2.9, 3.1)];
        let planted = Region { loops: vec![lower, upper], ..Region::default() };
        let (tidied, distance) = tidy(&planted)?;
        let bracket = arc_distance(&tidied, &planted);
        prop_assume!(bracket.is_some());
        prop_assert!(bracket.is_some_and(|b| b.hi <= distance), "{bracket:?} above {distance}");
    }

    #[test]
    fn tidied_regions_stay_as_they_are(a in any_region(), b in any_region()) {
        for result in sums(&a, &b)? {
            let (once, _) = tidy(&result)?;
            let (twice, _) = tidy(&once)?;
            prop_assert_eq!(once.segments(), twice.segments());
            if once.is_polygonal() {
                prop_assert_eq!(once, twice);
            }
        }
    }
}

/// A loop of vertices with the bulges of the edges that leave them.
fn bent(nodes: &[(f64, f64, f64)]) -> Region {
    let node = |&(x, y, bulge): &(f64, f64, f64)| Node { x, y, curve: Curve::Bulge(bulge) };
    Region { loops: vec![nodes.iter().map(node).collect()], ..Region::default() }
}

/// The sum of two copies a few roundings apart makes a curl to the left and one to the right, an ulp in size. Its turning
/// number is 1 all the same.
#[test]
fn curls_that_cancel_are_no_part_of_the_next_sum() {
    let a = bent(&[
        (0.3209479160944163, 0.0, -0.07004867159568623),
        (0.43805190427287055, 0.4924906070180961, 0.0),
        (0.04765088011203649, 0.24541677535276257, 0.0),
        (-0.0905160092146184, 0.23303830602683998, 0.0),
        (-0.6523749493345723, 0.18384522801649292, 0.0),
        (-0.22858307359313437, -0.1737092167882132, 0.0),
        (-0.09327655862567434, -0.5210823271976421, 0.0),
        (0.5202258873660798, -0.7761729834019465, -0.3563879898485325),
    ]);
    let b = bent(&[
        (0.3209479160944164, 0.0, -0.07004867159568623),
        (0.4380519042728705, 0.49249060701809605, 0.0),
        (0.04765088011203649, 0.24541677535276257, 0.0),
        (-0.0905160092146184, 0.23303830602683998, 0.0),
        (-0.6523749493345723, 0.18384522801649292, 0.0),
        (-0.2285830735931344, -0.1737092167882131, 0.0),
        (-0.09327655862567431, -0.5210823271976421, 0.0),
        (0.5202258873660797, -0.7761729834019466, -0.3563879898485325),
    ]);
    let corners = [(9.0, 0.0, 0.0), (7.0, 6.0, 0.0), (0.0, 3.0, 0.0), (0.0, -3.0, 0.0), (3.0, -3.0, 0.0)];
    let c = bent(&corners);
    for result in sums(&a, &b).expect("can be summed") {
        let twice = sums(&result, &c).expect("can be summed again");
        let least = twice.iter().map(Region::area).fold(f64::INFINITY, f64::min);
        for sum in &twice {
            assert!((sum.area() - least).abs() < 1e-12 * least, "{} {least}", sum.area());
            sums(sum, &c).expect("and again");
        }
    }
}

/// A square with side 1 whose upper side has these vertices between (1, 1) and (0, 1).
fn square_with(between: &[(f64, f64)]) -> Region {
    let corners = [&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)], between, &[(0.0, 1.0)]].concat();
    let nodes = corners.iter().map(|&(x, y)| Node::line(x, y)).collect();
    Region { loops: vec![nodes], ..Region::default() }
}

/// What is planted below the least tolerance goes, on the spot; what is clearly larger stays.
#[test]
fn planted_flaws_go_and_features_stay() {
    let least = TOLERANCES[0] * EPS;
    let plain = square_with(&[]);
    let flaws: [&[(f64, f64)]; 4] = [
        // A vertex off a straight side, a spike there and back, a crack that crosses itself, a repeated vertex.
        &[(0.5, 1.0 - 0.4 * least)],
        &[(0.5, 1.0), (0.5, 1.3), (0.5, 1.0 + 0.5 * least)],
        &[(0.5, 1.0), (0.5 - 0.5 * least, 0.7), (0.5 - 0.25 * least, 1.0)],
        &[(0.5, 1.0), (0.5, 1.0)],
    ];
    for flaw in flaws {
        assert_eq!(tidied(&square_with(flaw)).map(|(region, _)| region).as_ref(), Some(&plain), "{flaw:?}");
    }
    let features: [&[(f64, f64)]; 2] = [&[(0.5, 1.0 - 4.0 * least)], &[(0.6, 1.0), (0.5, 1.3), (0.4, 1.0)]];
    for feature in features {
        assert_eq!(tidied(&square_with(feature)).map(|(region, _)| region), Some(square_with(feature)), "{feature:?}");
    }
}

/// Tidying is for roundings: a loop that really crosses itself is still refused.
#[test]
fn a_real_crossing_is_refused() {
    let nodes = [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| Node::line(x, y));
    let tie = Region { loops: vec![nodes.to_vec()], ..Region::default() };
    assert_eq!(tidied(&tie), None);
    let square = square_with(&[]);
    assert!(sum(&tie, &square, &Options::default()).is_err() && sum(&square, &tie, &Options::default()).is_err());
}
