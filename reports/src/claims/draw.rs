//! Pairs of regions to measure on, drawn at random.

use super::input::Input;
use crate::attack::pairs;
use crate::cases::Case;
use crate::cases::rng::Rng;
use arcsum::region::Region;

/// A pair under the name of its kind.
#[must_use]
pub fn input(kind: &str, a: Region, b: Region) -> Input {
    Input::pair(Case { name: kind.into(), family: kind.into(), a, b, seed: None, golden: None })
}

/// A small pair of any kind, often nearly degenerate, with arcs or without.
#[must_use]
pub fn pair(rng: &mut Rng, _: usize) -> Input {
    let (kind, a, b) = pairs::pair(rng);
    input(kind, a, b)
}

/// The same, but polygons only.
#[must_use]
pub fn polygons(rng: &mut Rng, _: usize) -> Input {
    loop {
        let (kind, a, b) = pairs::pair(rng);
        if a.is_polygonal() && b.is_polygonal() {
            return input(kind, a, b);
        }
    }
}
