//! The two algorithms and the two number backends must give equal regions.

use crate::common::{cells, complement, digits, exact, radial};
use arcsum_oracle::error::Budget;
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::region::ExactRegion;
use arcsum_oracle::{convolve, decompose};
use num_rational::BigRational;
use proptest::prelude::*;
use rug::Rational;

fn both(a: &PlainRegion, b: &PlainRegion) -> [ExactRegion<Rational>; 2] {
    let (a, b) = (exact(a), exact(b));
    let by_winding = convolve::sum(&a, &b, Budget::NONE).expect("no budget");
    let by_union = decompose::sum(&a, &b, Budget::NONE).expect("no budget");
    [by_winding, by_union]
}

proptest! {
    #![proptest_config(crate::common::cases(400))]

    #[test]
    fn algorithms_agree_on_degenerate_grids(a in cells(3), b in cells(3)) {
        let [first, second] = both(&a, &b);
        prop_assert_eq!(first, second);
    }

    #[test]
    fn algorithms_agree_on_complements(a in cells(4), b in cells(2)) {
        let [first, second] = both(&complement(&a), &b);
        prop_assert_eq!(&first, &second);
        prop_assert_eq!(first.unbounded(), !b.loops.is_empty());
        let [swapped, again] = both(&b, &complement(&a));
        prop_assert_eq!(&first, &swapped);
        prop_assert_eq!(swapped, again);
    }
}

proptest! {
    #![proptest_config(crate::common::cases(60))]

    #[test]
    fn algorithms_agree_on_larger_grids(a in cells(5), b in cells(4)) {
        let [first, second] = both(&a, &b);
        prop_assert_eq!(first, second);
    }

    #[test]
    fn algorithms_agree_on_random_polygons(a in radial(3..16), b in radial(3..16)) {
        let [first, second] = both(&a, &b);
        prop_assert_eq!(first, second);
    }

    #[test]
    fn algorithms_agree_on_complements_of_random_polygons(a in radial(3..16), b in radial(3..8)) {
        let [first, second] = both(&complement(&a), &b);
        prop_assert_eq!(first, second);
    }

    #[test]
    fn backends_agree_to_the_digit(a in radial(3..12), b in radial(3..12), c in cells(3), d in cells(3)) {
        for (a, b) in [(a, b), (c, d)] {
            let gmp = convolve::sum::<Rational>(&exact(&a), &exact(&b), Budget::NONE).expect("no budget");
            let pure = convolve::sum::<BigRational>(&exact(&a), &exact(&b), Budget::NONE).expect("no budget");
            prop_assert_eq!(digits(&gmp), digits(&pure));
            let pure = decompose::sum::<BigRational>(&exact(&a), &exact(&b), Budget::NONE).expect("no budget");
            prop_assert_eq!(digits(&gmp), digits(&pure));
        }
    }
}
