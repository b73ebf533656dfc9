//! The certified distance of regions with arcs against the exact one of polygons, on loops of all kinds.

use arcsum_oracle::certified::hausdorff::{Outline, between};
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::measure;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;
use rug::Rational;

type Q = Rational;

fn polygon(loops: &[Vec<(f64, f64)>]) -> PlainRegion {
    let corner = |&(x, y): &(f64, f64)| Corner { x, y, bend: Bend::Line };
    PlainRegion { loops: loops.iter().map(|ring| ring.iter().map(corner).collect()).collect(), unbounded: false }
}

/// Coordinates on a small grid, where nearly everything is degenerate, or anywhere.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![3 => (0..5i32).prop_map(|i| f64::from(i) / 4.0), 1 => 0.0..1.0f64]
}

/// Closed polylines, crossing themselves and each other at will.
fn loops() -> impl Strategy<Value = Vec<Vec<(f64, f64)>>> {
    prop::collection::vec(prop::collection::vec((coordinate(), coordinate()), 3..7), 1..4)
}

/// The loops with every vertex moved by a multiple of a small unit.
fn nudged(loops: &[Vec<(f64, f64)>], moves: &[(i8, i8)], unit: f64) -> Vec<Vec<(f64, f64)>> {
    let mut next = moves.iter().cycle();
    let mut nudge = |&(x, y): &(f64, f64)| {
        let (i, j) = next.next().expect("endless");
        (x + f64::from(*i) * unit, y + f64::from(*j) * unit)
    };
    loops.iter().map(|ring| ring.iter().map(&mut nudge).collect()).collect()
}

fn outline(region: &PlainRegion) -> Outline {
    Outline::from(&Shape::new(region).expect("finite"))
}

fn agree(first: &PlainRegion, second: &PlainRegion) -> Result<(), TestCaseError> {
    let exact = |region| ExactRegion::<Q>::from_plain(region).expect("a polygon");
    let known = measure::between(&exact(first), &exact(second), 1.0).expect("small numbers");
    let found = between(&outline(first), &outline(second)).expect("closed").expect("decided").bracket;
    prop_assert!(found.lo <= known.hi && known.lo <= found.hi, "{found:?} is not {known:?}");
    let tight = found.hi <= found.lo * 1.04 || found.hi - found.lo < 2f64.powi(-58);
    prop_assert!(tight || found.lo.is_infinite(), "{found:?}");
    Ok(())
}

proptest! {
    #![proptest_config(crate::common::cases(120))]

    #[test]
    fn any_two_regions(a in loops(), b in loops()) {
        agree(&polygon(&a), &polygon(&b))?;
    }

    #[test]
    fn a_region_and_nearly_itself(
        a in loops(), moves in prop::collection::vec((-2i8..3, -2i8..3), 1..9), exponent in prop_oneof![Just(-53), -60..-8i32]
    ) {
        agree(&polygon(&nudged(&a, &moves, f64::from(exponent).exp2())), &polygon(&a))?;
    }
}

/// A spike opened to a sliver beside the end of a steep line: the end of the clipped line there is too short to have a
/// direction, and no distance to it was known.
#[test]
fn a_sliver_beside_the_end_of_a_line() -> Result<(), TestCaseError> {
    let triangle = vec![(0.75, 0.25), (0.0, 0.2453490094082054), (0.0, 0.0)];
    let a = [triangle, vec![(0.75, 0.0), (0.75, 0.5), (0.75, 0.0)]];
    agree(&polygon(&nudged(&a, &[(0, -1), (0, 0), (2, 0)], 2f64.powi(-53))), &polygon(&a))
}
