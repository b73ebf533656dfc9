//! Planted errors: regions with arcs and holes, changed so that the distance is known by construction. The bracket has to
//! contain it, tightly, in both directions and for errors from 2^-10 to 2^-50 of the unit box.

mod plate;
mod truth;

use crate::common::{disc, rectangle};
use arcsum_oracle::certified::hausdorff::{Outline, between};
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::error::Budget;
use arcsum_oracle::measure::{Bracket, Direction};
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use plate::{Error, Plate, errors, plates};
use proptest::prelude::*;
use rug::Float;
use truth::{Truth, at_least, at_most, root};

/// The bracket between two regions.
fn measured(result: &PlainRegion, truth: &PlainRegion) -> Bracket {
    let [result, truth] = [result, truth].map(|region| Outline::from(&Shape::new(region).expect("valid")));
    between(&result, &truth).expect("closed").expect("decided").bracket
}

/// Whether a bracket contains a number and is as narrow as it says.
fn holds(found: &Bracket, truth: &Float) -> Result<(), TestCaseError> {
    prop_assert!(at_most(found.lo, truth) && at_least(found.hi, truth), "{found:?} does not contain {truth:.20}");
    prop_assert!(found.hi <= 1.04 * found.lo || found.hi - found.lo < 2f64.powi(-58), "{found:?} is loose");
    Ok(())
}

/// The bracket contains the distance whichever of the two regions is the result.
fn holds_both_ways(changed: &PlainRegion, region: &PlainRegion, truth: &Truth) -> Result<(), TestCaseError> {
    let (there, back) = (measured(changed, region), measured(region, changed));
    holds(&there, truth.distance())?;
    holds(&back, truth.distance())?;
    if let Some(surplus) = truth.direction() {
        let [forth, from] = if surplus {
            [Direction::FromResult, Direction::FromSum]
        } else {
            [Direction::FromSum, Direction::FromResult]
        };
        prop_assert_eq!((there.direction, back.direction), (forth, from));
    }
    Ok(())
}

/// One error of a kind in a random plate.
fn one(plate: &Plate, error: Error) -> Result<(), TestCaseError> {
    let Some((changed, truth)) = plate.with(&[error]) else {
        return Err(TestCaseError::reject("not an error of this kind"));
    };
    holds_both_ways(&changed, &plate.region(), &truth)
}

proptest! {
    #![proptest_config(crate::common::cases(150))]

    #[test]
    fn a_vertex_moved(plate in plates(), error in errors::vertex()) {
        one(&plate, error)?;
    }

    #[test]
    fn an_arc_flipped_or_bent(plate in plates(), error in errors::arc()) {
        one(&plate, error)?;
    }

    #[test]
    fn a_hole_dropped_or_moved_or_resized(plate in plates(), error in errors::hole()) {
        one(&plate, error)?;
    }

    #[test]
    fn a_bubble_or_a_slit_or_an_island(plate in plates(), error in errors::bubble()) {
        one(&plate, error)?;
    }

    /// The greatest of several errors counts.
    #[test]
    fn several_errors(
        plate in plates(), first in errors::vertex(), second in errors::arc(), third in errors::hole(), fourth in errors::bubble(),
        kept in 3u8..16
    ) {
        let all = [first, second, third, fourth];
        let some: Vec<Error> = (0..4).filter(|i| kept >> i & 1 == 1).map(|i| all[i].clone()).collect();
        let Some((changed, truth)) = plate.with(&some) else { return Err(TestCaseError::reject("not such errors")) };
        holds_both_ways(&changed, &plate.region(), &truth)?;
    }

    #[test]
    fn discs_moved_and_resized(
        ends in (-1.0..-0.5f64, 0.5..1.0f64), y in -1.0..1.0f64, moves in [-9i32..9, -9..9, -9..9], k in 10i32..=50
    ) {
        let unit = 2f64.powi(-k);
        let [a, b, c] = moves.map(|i| f64::from(i) * unit);
        let moved = (ends.0 + a, ends.1 + b);
        let region = |(left, right): (f64, f64), y| {
            let corner = |x| Corner { x, y, bend: Bend::Bulge(1.0) };
            PlainRegion { loops: vec![vec![corner(left), corner(right)]], unbounded: false }
        };
        let reaches = truth::discs((ends.0, ends.1, y), (moved.0, moved.1, y + c));
        let truth = Truth::none().and(reaches);
        let (first, second) = (region(ends, y), region(moved, y + c));
        holds_both_ways(&crate::common::complement(&second), &crate::common::complement(&first), &truth)?;
        holds(&measured(&first, &second), truth.distance())?;
    }
}

/// A plate with a square and a round hole, all in sixteenths, and the disc it is added to: centre and radius.
#[derive(Clone, Debug)]
struct Operands {
    disc: (f64, f64, f64),
    square: f64,
    round: f64,
}

fn operands() -> impl Strategy<Value = Operands> {
    let sixteenths = |range: std::ops::Range<i32>| range.prop_map(|i| f64::from(i) / 16.0);
    let radius = prop_oneof![Just(1.0 / 16.0), Just(2f64.powi(-20)), Just(3.0 / 64.0)];
    ((sixteenths(-8..8), sixteenths(-8..8), radius), sixteenths(3..6), sixteenths(2..4))
        .prop_map(|(disc, square, round)| Operands { disc, square, round })
}

impl Operands {
    fn reference(&self) -> Reference {
        let plate = self.plate(0.0, (0.0, 0.0), [0, 1]);
        let (x, y, r) = self.disc;
        let disc = PlainRegion { loops: vec![disc(x, y, r)], unbounded: false };
        Reference::new(&plate, &disc, 1.0, Budget::NONE).expect("small and valid")
    }

    /// The plate grown by `by` and moved, with some of its holes.
    fn plate(&self, by: f64, (x, y): (f64, f64), holes: impl IntoIterator<Item = usize>) -> PlainRegion {
        let rounded = |x: f64, y: f64, bend: Bend| Corner { x, y, bend };
        let quarter = Bend::Radius(by);
        let mut loops = if by == 0.0 {
            vec![rectangle(x, y, 1.0 + x, 1.0 + y)]
        } else {
            let (right, top) = (x + 1.0, y + 1.0);
            vec![vec![
                rounded(x, y - by, Bend::Line),
                rounded(right, y - by, quarter),
                rounded(right + by, y, Bend::Line),
                rounded(right + by, top, quarter),
                rounded(right, top + by, Bend::Line),
                rounded(x, top + by, quarter),
                rounded(x - by, top, Bend::Line),
                rounded(x - by, y, quarter),
            ]]
        };
        for hole in holes {
            let (side, radius) = (self.square - by, self.round - by);
            loops.push(if hole == 0 {
                let mut square = rectangle(x + 0.125 + by, y + 0.125 + by, x + 0.125 + side, y + 0.125 + side);
                square.reverse();
                square
            } else {
                disc(x + 0.75, y + 0.75, -radius)
            });
        }
        PlainRegion { loops, unbounded: false }
    }

    /// The sum as it is, moved, with some holes.
    fn sum(&self, (x, y): (f64, f64), holes: impl IntoIterator<Item = usize>) -> PlainRegion {
        let (cx, cy, r) = self.disc;
        self.plate(r, (cx + x, cy + y), holes)
    }
}

fn bracket(reference: &Reference, result: &PlainRegion) -> Bracket {
    reference.measure(result).expect("confirmed").expect("decided")
}

fn float(x: f64) -> Float {
    truth::float(x)
}

proptest! {
    #![proptest_config(crate::common::cases(40))]

    /// Against the certified sum of a plate with holes and a disc.
    #[test]
    fn errors_of_a_sum(operands in operands(), k in 10i32..=50, moves in (-4i32..5, 1i32..5), pick in 0usize..5) {
        let reference = operands.reference();
        let (unit, (x, y, r)) = (2f64.powi(-k), operands.disc);
        holds(&bracket(&reference, &operands.sum((0.0, 0.0), [0, 1])), &float(0.0))?;
        let (a, b) = (f64::from(moves.0) * unit, f64::from(moves.1) * unit);
        let square = 0.5 * (operands.square - 2.0 * r);
        let (result, truth) = match pick {
            0 => (operands.sum((a, b), [0, 1]), root(float(a).square() + float(b).square())),
            1 => (operands.sum((0.0, 0.0), [1]), float(square)),
            2 => (operands.sum((0.0, 0.0), [0]), float(operands.round - r)),
            3 => {
                let mut result = operands.sum((0.0, 0.0), [0, 1]);
                result.loops[0][1].bend = Bend::Radius(-r);
                (result, (2 - root(float(2.0))) * r)
            }
            _ => {
                let mut result = operands.sum((0.0, 0.0), [0, 1]);
                result.loops.push(disc(x + 0.75, y + 0.25, -unit));
                result.loops.push(disc(x - r - 2.0 * unit, y + 0.25, unit));
                (result, float(3.0) * unit)
            }
        };
        holds(&bracket(&reference, &result), &truth)?;
    }
}
