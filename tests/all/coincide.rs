//! Lines that coincide: what is left when they are merged has the winding numbers of the whole.

use arcsum::arrangement::arrange;
use arcsum::coincide::merged;
use arcsum::part::Parts;
use arcsum_reports::cases::Case;
use arcsum_reports::cases::family::Family;
use arcsum_tests::winding::{before_and_after, convolutions};

/// Pairs with lines along axes that lie on each other.
fn gridded(seed: u64) -> Vec<Case> {
    let sizes = [("orthogonal", 40), ("holed", 40), ("combs", 10), ("fat_grid", 3), ("rounded", 10)];
    let cases = |(name, size)| Family::named(name).expect("a family").cases_of_size(size, seed);
    sizes.into_iter().flat_map(cases).filter(|case| !case.a.unbounded && !case.b.unbounded).collect()
}

#[test]
fn winding_numbers_stay() {
    let mut fewer = 0;
    for case in (1..3).flat_map(gridded) {
        for whole in convolutions(&case) {
            let Some(Parts { pieces, origins }) = merged(&whole) else { continue };
            assert_eq!(pieces.pieces.len(), origins.len());
            let found = before_and_after(&whole, &pieces, 1);
            assert!(found.len() > 200 && found.iter().all(|[before, after]| before == after), "{}", case.name);
            let [before, after] = [&whole, &pieces].map(|pieces| arrange(pieces).graph);
            assert_eq!((before.winding_conflicts, after.winding_conflicts), (0, 0), "{}", case.name);
            assert_eq!(before.windings.len(), after.windings.len(), "{}: cells", case.name);
            fewer += usize::from(2 * pieces.pieces.len() < whole.pieces.len());
        }
    }
    assert!(fewer > 0, "nothing came to less than half");
}

/// A part that is missing, or has another weight, shows.
#[test]
fn a_wrong_weight_is_noticed() {
    let [whole, _] = convolutions(&gridded(1)[0]);
    let Parts { pieces, .. } = merged(&whole).expect("lines coincide");
    let (missing, heavier) = (&mut pieces.clone(), &mut pieces.clone());
    missing.pieces.pop();
    let last = heavier.pieces.len() - 1;
    heavier.pieces[last].weight += 1;
    for spoiled in [missing, heavier] {
        assert!(arrange(spoiled).graph.winding_conflicts > 0);
    }
}
