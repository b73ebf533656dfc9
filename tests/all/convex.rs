//! The convex convolution (MS 3; memo M17, M17b, M18): in general position, where no rounding opens a gap between its segments,
//! its sum is the exact one. Elsewhere it may be wrong by any amount, where the monotonic one is right. And the sizes of
//! Fig. 8.

use arcsum::arrangement::cross::EPS;
use arcsum::boolean::{Operation, combine};
use arcsum::frame::Frame;
use arcsum::overlap::Overlap;
use arcsum::region::Region;
use arcsum::smooth::Smooth;
use arcsum::sum::{Convolution, Options, Sum, sum};
use arcsum_oracle::measure::{Bracket, hausdorff};
use arcsum_oracle::polygon;
use arcsum_reports::bridge::{plain, unit};
use arcsum_reports::cases::fig8::fig8;
use arcsum_reports::cases::place::{moved, turned};
use arcsum_reports::cases::shape::polygon as polygon_of;
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, any_region, holed, simple};
use glam::DVec2;
use proptest::prelude::*;

fn summed(convolution: Convolution, a: &Region, b: &Region) -> Sum {
    sum(a, b, &Options { convolution, ..Options::default() }).expect("valid")
}

/// The distance of the sum by a convolution from the exact one.
fn error(convolution: Convolution, a: &Region, b: &Region) -> Bracket {
    let exact = polygon::sum(&plain(a), &plain(b)).expect("within budget");
    hausdorff(&plain(&summed(convolution, a, b).region), &exact, unit(a, b)).expect("measurable")
}

/// As for the other convolutions, see [`crate::exact`].
const BOUND: f64 = 20.0 * EPS;

/// On a grid so fine that no end of a sum segment lies on another segment by chance.
fn general() -> impl Strategy<Value = Region> {
    let lattice = Lattice::Integers(100_000);
    prop_oneof![simple(10, 0.0, lattice), holed(10, 0.0, lattice)]
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn polygons_in_general_position(a in general(), b in general()) {
        let found = error(Convolution::Convex, &a, &b);
        prop_assert!(found.hi <= BOUND, "{found:?}");
    }

    #[test]
    fn complements_in_general_position(a in simple(8, 0.0, Lattice::Integers(100_000)), b in simple(8, 0.0, Lattice::Integers(9000))) {
        let found = error(Convolution::Convex, &a.complement(), &b);
        prop_assert!(found.hi <= BOUND, "{found:?}");
    }

    /// The test that decides cells against the set operation, which goes another way. No random pair is within a rounding of
    /// contact.
    #[test]
    fn overlaps_are_intersections(a in any_region(), b in any_region(), x in -1.5..1.5_f64, y in -1.5..1.5_f64) {
        let frames = Frame::pair(&a, &b);
        let smooth = [(&a, &frames.0), (&b, &frames.1)].map(|(region, frame)| Smooth::new(region, frame).expect("valid"));
        let t = DVec2::new(x, y);
        let place = frames.0.sum_to_input(&frames.1, t);
        let placed = moved(&b.negated(), [place.x, place.y]);
        let common = combine(Operation::Intersection, &a, &placed).expect("valid");
        let meet = common.unbounded || !common.loops.is_empty();
        prop_assert_eq!(Overlap::new(&smooth[0], &smooth[1]).at(t), meet);
    }
}

/// A triangle and a polygon with corners on a small grid, turned so that the coincidences of the grid are rounded.
fn turned_grid() -> [Region; 2] {
    let a = polygon_of(&[[2.0, 0.0], [-1.0, 0.0], [1.0, -1.0]]);
    let b = polygon_of(&[[1.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.0, 1.0], [-1.0, 0.0], [2.0, -2.0]]);
    [a, b].map(|region| turned(&region, 962.0))
}

/// An end of a segment lies on another one but for rounding. Where it stays a rounding short, inside and outside are one
/// cell, and all of the sum is lost.
#[test]
fn a_gap_of_one_rounding_loses_the_sum() {
    let [a, b] = turned_grid();
    assert!(error(Convolution::Convex, &a, &b).lo > 0.1);
    for convolution in [Convolution::Kinetic, Convolution::Monotonic] {
        assert!(error(convolution, &a, &b).hi <= BOUND);
    }
}

/// MS Fig. 8: a convex part in a convex container of n corners.
#[test]
fn only_the_kinetic_convolution_has_a_cell_a_corner() {
    for corners in [8, 16, 64, 256] {
        let (a, b) = fig8(corners);
        let [kinetic, monotonic, convex] = [Convolution::Kinetic, Convolution::Monotonic, Convolution::Convex]
            .map(|convolution| summed(convolution, &a, &b).arrangement.graph.windings.len());
        assert!(kinetic >= corners as usize && monotonic <= 4 && convex <= 4, "{kinetic} {monotonic} {convex}");
    }
}
