//! Making a case smaller while it shows the same.

use crate::cases::Case;
use arcsum::region::Region;
use arcsum::validate::validate;

/// Leaves out vertices one by one as long as `same` measures that the case still shows the same.
pub fn shrink<T>(mut case: Case, mut row: T, same: impl Fn(&Case) -> Option<T>) -> (Case, T) {
    let mut place = 0;
    while place < vertices(&case.a) + vertices(&case.b) {
        match without(&case, place).and_then(|smaller| same(&smaller).map(|row| (smaller, row))) {
            Some(smaller) => (case, row) = smaller,
            None => place += 1,
        }
    }
    (case, row)
}

fn vertices(region: &Region) -> usize {
    region.loops.iter().map(Vec::len).sum()
}

/// The case without the vertex of this number, if that is a case.
fn without(case: &Case, place: usize) -> Option<Case> {
    let mut smaller = case.clone();
    let in_a = vertices(&case.a);
    let (region, mut place) = if place < in_a { (&mut smaller.a, place) } else { (&mut smaller.b, place - in_a) };
    for nodes in &mut region.loops {
        if place < nodes.len() {
            nodes.remove(place);
            return (nodes.len() > 1 && validate(region).is_ok()).then_some(smaller);
        }
        place -= nodes.len();
    }
    None
}
