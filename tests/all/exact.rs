//! The engine against the exact oracle on polygons: the certified error is a few eps, and on small integers the result
//! is the exact sum itself.

use arcsum::arrangement::cross::EPS;
use arcsum::region::{Node, Region};
use arcsum::sum::{Convolution, Options, sum};
use arcsum_oracle::measure::{Bracket, hausdorff};
use arcsum_oracle::polygon;
use arcsum_reports::bridge::{plain, unit};
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, bars, holed, nudged_integers, simple};
use proptest::prelude::*;

fn polygons(lattice: Lattice) -> impl Strategy<Value = Region> {
    prop_oneof![simple(10, 0.0, lattice), holed(10, 0.0, lattice)]
}

/// The sums by both convolutions, each with its distance from the exact sum, and the number of loops of that.
fn measured(a: &Region, b: &Region) -> ([(Region, Bracket); 2], usize) {
    let exact = polygon::sum(&plain(a), &plain(b)).expect("within budget");
    let measured = [Convolution::Kinetic, Convolution::Monotonic].map(|convolution| {
        let result = sum(a, b, &Options { convolution, ..Options::default() }).expect("valid").region;
        let bracket = hausdorff(&plain(&result), &exact, unit(a, b)).expect("measurable");
        (result, bracket)
    });
    (measured, exact.loops().len())
}

/// Checks that both sums are near the exact one.
fn close(a: &Region, b: &Region) -> Result<(), TestCaseError> {
    for (_, bracket) in measured(a, b).0 {
        prop_assert!(bracket.hi <= BOUND, "{bracket:?}");
    }
    Ok(())
}

/// Checks that both sums are near the exact one and have as many loops.
fn right(a: &Region, b: &Region) -> Result<(), TestCaseError> {
    let (sums, loops) = measured(a, b);
    for (result, bracket) in sums {
        prop_assert!(bracket.hi <= BOUND, "{bracket:?}");
        prop_assert_eq!(sizable(&result), loops);
        prop_assert_eq!(result.unbounded, a.unbounded || b.unbounded);
    }
    Ok(())
}

/// A sum lies in a box of side 2. A crossing is within 4.7 eps of both curves there per unit of size (memo C1), ends closer
/// than 4 eps of the side count as touching, and the end points are rounded: 9.4 + 8 + 2 eps.
const BOUND: f64 = 20.0 * EPS;

/// Loops that bound more than rounding: three lines through one point that is no double leave a bubble of a few eps.
fn sizable(region: &Region) -> usize {
    let area = |l: &Vec<Node>| Region { loops: vec![l.clone()], ..Region::default() }.area().abs();
    region.loops.iter().filter(|l| area(l) > 1e-12).count()
}

proptest! {
    #![proptest_config(cases(6000))]

    #[test]
    fn integers_are_summed_exactly(a in polygons(Lattice::Integers(4)), b in polygons(Lattice::Integers(3))) {
        right(&a, &b)?;
    }

    #[test]
    fn fifty_bits_in_general_position(a in polygons(Lattice::Fine), b in polygons(Lattice::Fine)) {
        right(&a, &b)?;
    }

    #[test]
    fn complements(a in polygons(Lattice::Integers(9)), b in polygons(Lattice::Integers(3))) {
        right(&a.complement(), &b)?;
    }

    #[test]
    fn coarse_grids_full_of_coincidences(a in polygons(Lattice::Integers(2)), b in polygons(Lattice::Integers(2))) {
        right(&a, &b)?;
    }
}

/// Two steep lines cross a rounding of x away from where the lower one is at that x. Once the crossing came before a vertex
/// between the two, which was then sorted to the wrong side.
#[test]
fn vertices_between_steep_lines_stay_in_order() {
    let lines = |loops: [[(f64, f64); 4]; 2]| Region {
        loops: loops.iter().map(|l| l.iter().map(|&(x, y)| Node::line(x, y)).collect()).collect(),
        ..Region::default()
    };
    let a = lines([
        [
            (-2.7755575615628914e-17, -1.2084980637182077),
            (0.05882352941176475, -0.8114318425815052),
            (0.058823529411764705, 0.1),
            (0.0, 0.1),
        ],
        [
            (0.11764705882352945, -0.550305154273441),
            (0.17647058823529413, -0.3776864538939966),
            (0.17647058823529413, 0.1),
            (0.11764705882352945, 0.1),
        ],
    ]);
    let b = lines([
        [
            (-1.3877787807814457e-17, -0.5427509710430628),
            (0.058823529411764705, -0.5129229654901889),
            (0.05882352941176466, 0.711264722802702),
            (0.0, 0.711264722802702),
        ],
        [
            (0.11764705882352941, 0.05794582763062689),
            (0.17647058823529413, 0.16493135966947106),
            (0.17647058823529413, 0.2698899096420917),
            (0.11764705882352941, 0.1),
        ],
    ]);
    close(&a, &b).unwrap();
}

/// Lines whose ends are one unit in the last place of x apart. Once the place of their crossing with others, right in x to
/// that unit and far off in y, was also its time, and vertices at the same x came on the wrong side of it.
#[test]
fn vertices_within_one_rounding_of_x_stay_in_order() {
    let lines = |loops: [[(f64, f64); 4]; 2]| Region {
        loops: loops.iter().map(|l| l.iter().map(|&(x, y)| Node::line(y, -x)).collect()).collect(),
        ..Region::default()
    };
    let a = lines([
        [
            (0.1, 0.0),
            (0.1, 0.058823529411764705),
            (-1.2446682289539894, 0.05882352941176469),
            (-1.2446682289539894, 0.0),
        ],
        [
            (0.09999999999999999, 0.11764705882352941),
            (0.1, 0.17647058823529413),
            (-0.9702013569583222, 0.17647058823529418),
            (-0.8898079036808643, 0.11764705882352941),
        ],
    ]);
    let b = lines([
        [(1.87358773691313, 0.0), (1.9020423056889035, 0.058823529411764705), (-0.1, 0.05882352941176473), (-0.1, 0.0)],
        [
            (0.5465245698359941, 0.11764705882352941),
            (0.5465245698359941, 0.1764705882352942),
            (-0.3383784965691047, 0.17647058823529416),
            (-0.14143408915177472, 0.11764705882352941),
        ],
    ]);
    close(&a, &b).unwrap();
}

// Bars are dear to judge.
proptest! {
    #![proptest_config(cases(1000))]

    /// Lines that rise by much within one unit in the last place of x: no representable point lies between their ends.
    #[test]
    fn nearly_vertical_lines(a in bars(), b in bars()) {
        close(&a, &b)?;
    }

    #[test]
    fn nearly_integers(a in nudged_integers(10, 3), b in nudged_integers(10, 3)) {
        close(&a, &b)?;
    }
}
