//! The list of all claims, in the order of memo H.

use super::{Claim, convolutions, exact, formulas, free, models, order, sweep, theorems, waits, winding};

/// All claims.
#[must_use]
pub fn claims() -> Vec<Claim> {
    let families = [
        formulas::claims(),
        winding::claims(),
        models::claims(),
        theorems::claims(),
        sweep::claims(),
        convolutions::claims(),
        order::claims(),
        free::claims(),
        exact::claims(),
        waits::claims(),
    ];
    let mut claims: Vec<Claim> = families.into_iter().flatten().collect();
    claims.sort_by_key(|claim: &Claim| rank(claim.id));
    claims
}

/// The claims of this number or id, in any case of letters: `m9` names both readings of M9.
#[must_use]
pub fn named(word: &str) -> Vec<Claim> {
    let is = |name: &str| name.eq_ignore_ascii_case(word) || name.replace(' ', "_").eq_ignore_ascii_case(word);
    claims().into_iter().filter(|claim| is(claim.id) || is(claim.number())).collect()
}

/// M before A before F, each by number, then by letter and reading; printed before corrected.
fn rank(id: &str) -> (usize, usize, bool, &str) {
    let family = "MAF".find(&id[..1]).unwrap_or(3);
    let digits = id[1..].find(|c: char| !c.is_ascii_digit()).map_or(id.len(), |n| n + 1);
    (family, id[1..digits].parse().unwrap_or(0), id.ends_with("corrected"), &id[digits..])
}

#[cfg(test)]
mod tests {
    use super::super::Test;
    use super::super::control::Control;
    use super::*;
    use std::collections::BTreeSet;

    /// The numbers of memo H.
    fn numbers() -> BTreeSet<String> {
        let range = |letter: char, last: usize| (1..=last).map(move |n| format!("{letter}{n}"));
        let with_letters = ["M16b", "M17b"].map(str::to_owned);
        range('M', 51).chain(range('A', 4)).chain(range('F', 16)).chain(with_letters).collect()
    }

    #[test]
    fn every_claim_of_the_memo_has_an_entry() {
        let known: BTreeSet<String> = claims().iter().map(|claim| claim.number().to_owned()).collect();
        assert_eq!(known, numbers());
    }

    #[test]
    fn ids_are_unique_and_in_order() {
        let ids: Vec<&str> = claims().iter().map(|claim| claim.id).collect();
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
        let place = |id| ids.iter().position(|known| *known == id).unwrap();
        assert!(place("M2") < place("M10 printed") && place("M9 printed") < place("M9 corrected"));
        assert!(place("M51 corrected") < place("A2") && place("A2") < place("F1"));
    }

    #[test]
    fn only_what_waits_for_later_steps_is_not_tested() {
        for claim in claims().iter().filter(|claim| matches!(claim.test, Test::Waits(_))) {
            let (letter, number) = (&claim.id[..1], claim.number()[1..].parse().unwrap_or(0));
            let waits = match letter {
                "M" => (36..=48).contains(&number),
                "F" => ![1, 3, 4, 16].contains(&number),
                _ => false,
            };
            assert!(waits, "{}", claim.id);
        }
    }

    #[test]
    fn every_experiment_has_a_control() {
        let all = claims();
        for claim in &all {
            let control = match &claim.test {
                Test::Waits(_) => continue,
                Test::Sup(sup) => sup.control,
                Test::Whole(whole) => whole.control,
            };
            if let Control::Claim(id) = control {
                assert!(all.iter().any(|other| other.id == id), "{}: no claim {id}", claim.id);
            }
        }
    }
}
