//! Backward errors of set operations, against errors planted by construction and against their definition point by point.

use crate::common::{cells, complement, exact, inside, radial, rectangle};
use arcsum_oracle::backward;
use arcsum_oracle::boolean::{Operation, combine};
use arcsum_oracle::interval::Interval;
use arcsum_oracle::locate::Locator;
use arcsum_oracle::measure::{Bracket, Direction, reach};
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::point::{Place, Point};
use arcsum_oracle::region::ExactRegion;
use num_rational::BigRational;
use proptest::prelude::*;
use rug::Rational;

type Region = ExactRegion<Rational>;

const TIGHT: f64 = 1.04;

fn measure(operation: Operation, a: &PlainRegion, b: &PlainRegion, result: &PlainRegion) -> Bracket {
    backward::error::<Rational>(operation, &exact(a), &exact(b), &exact(result), 1.0).expect("finite")
}

fn assert_is(found: Bracket, distance: f64, direction: Direction) {
    assert!(found.lo <= distance && distance <= found.hi, "{found:?} is not around {distance}");
    assert!(found.hi <= TIGHT * found.lo, "{found:?} is loose");
    assert_eq!(found.direction, direction);
}

fn rectangles(all: &[[f64; 4]]) -> PlainRegion {
    let loops = all.iter().map(|&[x0, y0, x1, y1]| rectangle(x0, y0, x1, y1)).collect();
    PlainRegion { loops, unbounded: false }
}

/// A rectangle with a rectangular hole.
fn pierced(outer: [f64; 4], [x0, y0, x1, y1]: [f64; 4]) -> PlainRegion {
    let mut region = rectangles(&[outer]);
    region.loops.extend(complement(&rectangles(&[[x0, y0, x1, y1]])).loops);
    region
}

/// The cost of a point by definition: the least, over all memberships that give what the result has there, of the greatest
/// distance to the boundary of an operand whose membership was changed.
fn cost(operation: Operation, a: &Region, b: &Region, has: bool, p: &Point<Rational>) -> Interval {
    let truth = [inside(a, p), inside(b, p)];
    let place = Place::from(p.clone());
    let distance = [a, b].map(|region| Locator::new(region).expect("finite").nearest(&place).0);
    let price = |changed: [bool; 2]| {
        let paid = distance.iter().zip(changed).filter(|(_, changed)| *changed).map(|(d, _)| *d);
        paid.fold(Interval::ZERO, Interval::max)
    };
    let ways = [[false, false], [false, true], [true, false], [true, true]];
    let right = ways.into_iter().filter(|[f, s]| operation.holds(*f != truth[0], *s != truth[1]) == has);
    right.map(price).fold(Interval::point(f64::INFINITY), Interval::min)
}

fn any_operation() -> impl Strategy<Value = Operation> {
    prop::sample::select(&Operation::ALL)
}

/// Grids, random polygons and their complements.
fn any_region() -> impl Strategy<Value = PlainRegion> {
    (prop_oneof![cells(3), radial(3..10)], any::<bool>())
        .prop_map(|(region, turn)| if turn { complement(&region) } else { region })
}

/// A region whose corners are moved by up to 2^-k.
fn disturbed(region: &PlainRegion, noise: &[f64], k: i32) -> PlainRegion {
    let mut region = region.clone();
    for (corner, step) in region.loops.iter_mut().flatten().zip(noise.chunks(2)) {
        corner.x += step[0] * 2f64.powi(-k);
        corner.y += step[1] * 2f64.powi(-k);
    }
    region
}

proptest! {
    #![proptest_config(crate::common::cases(200))]

    #[test]
    fn exact_results_have_no_error(operation in any_operation(), a in any_region(), b in any_region()) {
        let (a, b): (Region, Region) = (exact(&a), exact(&b));
        let truth = combine(operation, &a, &b).expect("finite");
        let found = backward::error(operation, &a, &b, &truth, 1.0).expect("finite");
        prop_assert_eq!((found.lo, found.hi), (0.0, 0.0));
    }

    #[test]
    fn results_of_moved_operands_have_at_most_the_way_they_moved(
        operation in any_operation(), a in radial(3..10), b in radial(3..10), k in 4i32..=50,
        noise in prop::collection::vec(-1.0..1.0f64, 40)
    ) {
        let moved = disturbed(&a, &noise, k);
        let wrong: Region = combine(operation, &exact(&moved), &exact(&b)).expect("finite");
        // Each corner moved by less than 2^-k along each axis, and by a rounding.
        let found = backward::error(operation, &exact(&a), &exact(&b), &wrong, 1.0).expect("finite");
        prop_assert!(found.hi <= TIGHT * 2f64.sqrt() * 2f64.powi(-k) * 1.01, "{found:?}");
    }

    #[test]
    fn brackets_hold_for_sampled_points(
        operation in any_operation(), a in any_region(), b in any_region(), other in any_region(),
        samples in prop::collection::vec((-30i64..30, -30i64..30), 40)
    ) {
        let (a, b, result): (Region, Region, Region) = (exact(&a), exact(&b), exact(&other));
        let found = backward::error(operation, &a, &b, &result, 1.0).expect("finite");
        prop_assert!(found.lo <= found.hi);
        for (x, y) in samples {
            let p = Point { x: Rational::from((x, 7)) + Rational::from((1, 1009)), y: Rational::from((y, 7)) + Rational::from((1, 2003)) };
            let cost = cost(operation, &a, &b, inside(&result, &p), &p);
            prop_assert!(cost.lo() <= found.hi, "{p:?} costs {cost:?}, more than {found:?}");
        }
    }

    #[test]
    fn witnesses_attain_the_lower_end(operation in any_operation(), a in radial(3..9), b in radial(3..9), result in radial(3..9)) {
        let found = measure(operation, &a, &b, &result);
        let (a, b): (Region, Region) = (exact(&a), exact(&b));
        prop_assume!(found.lo > 0.0);
        let p = Point::<Rational>::from_f64(found.witness.0, found.witness.1).expect("finite");
        // The witness may be a corner of a cell, where membership is undecided: any neighbour has about its cost.
        let has = found.direction == Direction::FromResult;
        let near = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1)].map(|(x, y)| {
            let step = |k: i32| Rational::from((k, 1u64 << 40));
            cost(operation, &a, &b, has, &p.plus(&Point { x: step(x), y: step(y) })).mid()
        });
        let most = near.into_iter().fold(0.0, f64::max);
        prop_assert!(most >= found.lo - 2f64.powi(-38), "{most} at the witness of {found:?}");
    }

    #[test]
    fn it_is_at_most_the_distance_from_the_exact_boundary(
        operation in any_operation(), a in any_region(), b in any_region(), other in any_region()
    ) {
        let (a, b, result): (Region, Region, Region) = (exact(&a), exact(&b), exact(&other));
        let truth = combine(operation, &a, &b).expect("finite");
        let (too_much, _) = reach(&result, &truth, 1e-18).expect("finite");
        let outside = |region: &Region| region.complement().expect("closed");
        let (too_little, _) = reach(&outside(&result), &outside(&truth), 1e-18).expect("finite");
        let found = backward::error(operation, &a, &b, &result, 1.0).expect("finite");
        prop_assert!(found.lo <= too_much.hi().max(too_little.hi()), "{found:?} {too_much:?} {too_little:?}");
    }

    #[test]
    fn backends_agree(operation in any_operation(), a in any_region(), b in any_region(), other in any_region()) {
        let gmp = measure(operation, &a, &b, &other);
        let pure = backward::error::<BigRational>(operation, &exact(&a), &exact(&b), &exact(&other), 1.0).expect("finite");
        prop_assert_eq!((gmp.lo, gmp.hi, gmp.direction), (pure.lo, pure.hi, pure.direction));
    }

    #[test]
    fn a_shifted_edge(k in 3i32..=50) {
        let delta = 2f64.powi(-k);
        let (a, b) = (rectangles(&[[0.0, 0.0, 2.0, 2.0]]), rectangles(&[[1.0, 0.0, 3.0, 2.0]]));
        let cases = [
            (Operation::Union, [0.0, 0.0, 3.0 + delta, 2.0], Direction::FromResult),
            (Operation::Union, [0.0, 0.0, 3.0 - delta, 2.0], Direction::FromSum),
            (Operation::Intersection, [1.0 - delta, 0.0, 2.0, 2.0], Direction::FromResult),
            (Operation::Intersection, [1.0 + delta, 0.0, 2.0, 2.0], Direction::FromSum),
            (Operation::Difference, [0.0, 0.0, 1.0 + delta, 2.0], Direction::FromResult),
            (Operation::Difference, [0.0, 0.0, 1.0 - delta, 2.0], Direction::FromSum),
        ];
        for (operation, result, direction) in cases {
            assert_is(measure(operation, &a, &b, &rectangles(&[result])), delta, direction);
        }
    }

    #[test]
    fn slivers_cost_their_width_wherever_they_are(k in 3i32..=45) {
        let width = 2f64.powi(-k);
        let (left, far) = ([0.0, 0.0, 1.0, 1.0], [5.0, 5.0, 6.0, 6.0]);
        let sliver = |x: f64| rectangles(&[[x, 0.0, x + width, 1.0]]);
        let nothing = PlainRegion::default();
        // Overlapping by a sliver: the middle of it is half its width from each boundary, and either excuses it.
        let over = rectangles(&[[1.0 - width, 0.0, 2.0, 1.0]]);
        assert_is(measure(Operation::Intersection, &rectangles(&[left]), &over, &nothing), width / 2.0, Direction::FromSum);
        // Apart by a sliver that the result has: the far side of it is its width from the other boundary, and both have to move.
        let apart = rectangles(&[[1.0 + width, 0.0, 2.0, 1.0]]);
        assert_is(measure(Operation::Intersection, &rectangles(&[left]), &apart, &sliver(1.0)), width, Direction::FromResult);
        assert_is(measure(Operation::Difference, &rectangles(&[left]), &rectangles(&[left]), &sliver(1.0)), width, Direction::FromResult);
        // The rest of the result, far away, makes no difference.
        let (both, with_far) = (rectangles(&[left, far]), PlainRegion {
            loops: [sliver(1.0).loops, rectangles(&[far]).loops].concat(), unbounded: false,
        });
        let apart = PlainRegion { loops: [apart.loops, rectangles(&[far]).loops].concat(), unbounded: false };
        assert_is(measure(Operation::Intersection, &both, &apart, &with_far), width, Direction::FromResult);
    }
}

#[test]
fn only_boundaries_whose_flip_helps_excuse() {
    let (a, b) = (rectangles(&[[0.0, 0.0, 8.0, 8.0]]), rectangles(&[[4.0, 0.0, 12.0, 8.0]]));
    // A hole around (6, 4) where both operands are: the boundary of each is 2 away at its middle, and up to 3 at its sides.
    let holed = pierced([0.0, 0.0, 12.0, 8.0], [5.0, 3.0, 7.0, 5.0]);
    assert_is(measure(Operation::Union, &a, &b, &holed), 3.0, Direction::FromSum);
    // The same hole in the intersection: either excuses.
    let holed = pierced([4.0, 0.0, 8.0, 8.0], [5.0, 3.0, 7.0, 5.0]);
    assert_is(measure(Operation::Intersection, &a, &b, &holed), 2.0, Direction::FromSum);
    // In a difference the boundary of A, close to the patch, excuses nothing where B covers it.
    let patched = rectangles(&[[0.0, 0.0, 4.0, 8.0], [7.0, 3.0, 8.0, 5.0]]);
    assert_is(measure(Operation::Difference, &a, &b, &patched), 4.0, Direction::FromResult);
    // In a symmetric difference it does.
    let patched = rectangles(&[[0.0, 0.0, 4.0, 8.0], [8.0, 0.0, 12.0, 8.0], [7.0, 3.0, 8.0, 5.0]]);
    assert_is(measure(Operation::SymmetricDifference, &a, &b, &patched), 1.0, Direction::FromResult);
}

#[test]
fn wrong_operations_are_far_off() {
    let (a, b) = (rectangles(&[[0.0, 0.0, 4.0, 4.0]]), rectangles(&[[2.0, 0.0, 6.0, 4.0]]));
    for wrong in Operation::ALL {
        let result: Region = combine(wrong, &exact(&a), &exact(&b)).expect("finite");
        for operation in Operation::ALL.into_iter().filter(|right| *right != wrong) {
            let found = measure(operation, &a, &b, &result.to_plain());
            assert!(found.lo >= 0.99, "{wrong:?} for {operation:?}: {found:?}");
        }
    }
}

#[test]
fn what_nothing_excuses_is_infinitely_wrong() {
    let (square, nothing) = (rectangles(&[[0.0, 0.0, 1.0, 1.0]]), PlainRegion::default());
    let infinite = |operation, a: &_, b: &_, result: &_| {
        let found = measure(operation, a, b, result);
        assert_eq!((found.lo, found.hi), (f64::INFINITY, f64::INFINITY));
    };
    infinite(Operation::Union, &nothing, &nothing, &square);
    infinite(Operation::Intersection, &square, &nothing, &square);
    infinite(Operation::Union, &square, &square, &complement(&nothing));
    infinite(Operation::Difference, &complement(&nothing), &square, &nothing);
    assert_is(measure(Operation::Union, &square, &nothing, &nothing), 0.5, Direction::FromSum);
}

#[test]
fn lengths_are_in_units_of_the_box() {
    let (square, shifted) = (rectangles(&[[0.0, 0.0, 1.0, 1.0]]), rectangles(&[[0.0, 0.0, 1.5, 1.0]]));
    let found = backward::error::<Rational>(Operation::Union, &exact(&square), &exact(&square), &exact(&shifted), 4.0);
    assert_is(found.expect("finite"), 0.125, Direction::FromResult);
}
