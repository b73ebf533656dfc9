//! Membership in the sum by rational numbers, against the exact sum, against the intersection itself where edges touch, and
//! against the certified membership.

use crate::common::{cells, complement, exact, radial};
use arcsum_oracle::boolean::{Operation, combine};
use arcsum_oracle::certified::membership::{Membership, State};
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::convolve;
use arcsum_oracle::error::Budget;
use arcsum_oracle::locate::{Location, Locator};
use arcsum_oracle::overlap::Overlap;
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::point::{Place, Point};
use proptest::prelude::*;
use rug::Rational;

/// Places on a grid of halves, where edges touch, and places in general position.
fn places() -> impl Strategy<Value = Vec<Point<Rational>>> {
    let place = (-20i32..40, -20i32..40, any::<bool>()).prop_map(|(x, y, on_grid)| {
        let number = |k: i32, d: i32| if on_grid { Rational::from((k, 2)) } else { Rational::from((300 * k + 1, d)) };
        Point { x: number(x, 1009), y: number(y, 1013) }
    });
    prop::collection::vec(place, 20)
}

fn check(a: &PlainRegion, b: &PlainRegion, places: &[Point<Rational>]) -> Result<[usize; 3], TestCaseError> {
    let [first, second] = [exact(a), exact(b)];
    let sum = convolve::sum(&first, &second, Budget::NONE).expect("no budget");
    let (locator, overlap) =
        (Locator::new(&sum).expect("small"), Overlap::new(first.clone(), second.clone()).expect("small"));
    let membership = Membership::new(&Shape::new(a).expect("finite"), &Shape::new(b).expect("finite"));
    let mut counts = [0; 3];
    for t in places {
        let state = overlap.state(t).expect("small");
        counts[state as usize] += 1;
        let moved = second.scaled(&Rational::from(-1)).translated(t);
        let common = combine(Operation::Intersection, &first, &moved).expect("small");
        prop_assert_eq!(state == State::Blocked, !common.is_empty(), "{:?}", t);
        match locator.locate(&Place::from(t.clone())) {
            Location::Inside => prop_assert_ne!(state, State::Free, "{:?}", t),
            Location::Outside => prop_assert_ne!(state, State::Blocked, "{:?}", t),
            // Both interiors unbounded, there is no boundary.
            Location::Boundary => prop_assert_eq!(state, State::Undecided, "{:?}", t),
        }
        let certified = membership.state(&Spot::rational(t));
        prop_assert!(certified == state || certified == State::Undecided, "{:?}: {:?} {:?}", t, state, certified);
    }
    Ok(counts)
}

proptest! {
    #![proptest_config(crate::common::cases(150))]

    #[test]
    fn degenerate_grids(a in cells(4), b in cells(3), places in places()) {
        check(&a, &b, &places)?;
    }

    #[test]
    fn complements_of_grids(a in cells(4), b in cells(2), places in places()) {
        check(&complement(&a), &b, &places)?;
        check(&b, &complement(&a), &places)?;
    }

    #[test]
    fn random_polygons(a in radial(3..30), b in radial(3..30), places in places()) {
        let [_, _, undecided] = check(&a, &b, &places)?;
        let on_grid = places.iter().filter(|t| *t.x.denom() <= 2).count();
        prop_assert!(undecided <= on_grid, "{} touch", undecided);
    }
}

#[test]
fn touching_is_neither_blocked_nor_free() {
    let square = PlainRegion { loops: vec![crate::common::rectangle(0.0, 0.0, 2.0, 2.0)], unbounded: false };
    let overlap = Overlap::new(exact(&square), exact(&square)).expect("small");
    let state = |x: i32, y: i32| overlap.state(&Point { x: Rational::from(x), y: Rational::from(y) }).expect("small");
    assert_eq!([state(4, 4), state(4, 1), state(0, 0)], [State::Undecided; 3]);
    assert_eq!([state(2, 2), state(3, 3)], [State::Blocked; 2]);
    assert_eq!([state(5, 1), state(-1, 2)], [State::Free; 2]);
}

/// Walls on one line, one above the other by less than doubles can tell.
#[test]
fn collinear_walls_apart_are_free() {
    let square = PlainRegion { loops: vec![crate::common::rectangle(0.0, 0.0, 2.0, 2.0)], unbounded: false };
    let overlap = Overlap::new(exact(&square), exact(&square)).expect("small");
    let bit = Rational::from((1, 1u64 << 60));
    let state = |x: i32, y: i32, by: &Rational| {
        overlap.state(&Point { x: Rational::from(x), y: Rational::from(y) + by }).expect("small")
    };
    assert_eq!([state(4, 4, &bit), state(0, 4, &bit), state(2, 0, &Rational::from(-&bit))], [State::Free; 3]);
    assert_eq!([state(4, 0, &bit), state(0, 4, &Rational::from(-&bit))], [State::Undecided; 2]);
}
