//! The built-in cases: every region is valid whatever the seed, and a case depends on the seed and its name alone.

use arcsum::validate::validate;
use arcsum_reports::cases::family::{FAMILIES, Family};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    #[test]
    fn every_region_is_valid(seed: u64) {
        for case in FAMILIES.iter().flat_map(|f| f.cases(seed)) {
            for (operand, region) in [("A", &case.a), ("B", &case.b)] {
                if let Err(e) = validate(region) {
                    return Err(TestCaseError::fail(format!("{} {operand}: {e}", case.name)));
                }
            }
        }
    }

    #[test]
    fn sizes_not_listed_are_valid_too(seed: u64, size in 4_u32..30) {
        for name in ["fork", "covered", "combs", "star", "radial", "twoopt", "orthogonal", "holed", "chamfered", "arcs",
            "bulges", "gear", "offset", "mixed", "rounded"] {
            let cases = Family::named(name).map(|f| f.cases_of_size(size, seed)).unwrap_or_default();
            prop_assert!(!cases.is_empty());
            for case in cases {
                prop_assert!(validate(&case.a).is_ok() && validate(&case.b).is_ok(), "{}", case.name);
            }
        }
    }

    #[test]
    fn a_case_is_the_same_alone_and_among_others(seed: u64) {
        for family in FAMILIES {
            let all = family.cases(seed);
            let alone: Vec<_> = family.sizes.iter().rev().flat_map(|&s| family.cases_of_size(s, seed)).collect();
            for case in &all {
                prop_assert!(alone.contains(case), "{}", case.name);
            }
        }
    }
}

#[test]
fn names_are_unique() {
    let mut names: Vec<String> = FAMILIES.iter().flat_map(|f| f.cases(1)).map(|c| c.name).collect();
    let count = names.len();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), count);
}

#[test]
fn random_families_follow_the_seed() {
    for name in ["star", "twoopt", "orthogonal", "islands", "mixed"] {
        let draw = |seed| Family::named(name).map(|f| f.cases(seed)).unwrap_or_default();
        let (one, other) = (draw(1), draw(2));
        assert_eq!(one.len(), other.len());
        assert!(one.iter().zip(&other).any(|(a, b)| a.a != b.a), "{name}");
    }
}
