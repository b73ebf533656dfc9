//! The chains measured when none are named: every part added to itself, and polygons of each kind.

use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::cases::{combs, parts, radial, shape, twoopt};
use arcsum::region::Region;

/// The chains: polygons first, whose references are quick.
#[must_use]
pub fn cases(seed: u64) -> Vec<Case> {
    let case = |(name, (a, b)): (String, (Region, Region))| Case {
        name,
        family: "iterated".into(),
        a,
        b,
        seed: Some(seed),
        golden: None,
    };
    let part = |name: &&str| Some((format!("part_{name}"), twice(parts::part(name)?)));
    polygons(seed).into_iter().chain(parts::NAMES.iter().filter_map(part)).map(case).collect()
}

fn polygons(seed: u64) -> Vec<(String, (Region, Region))> {
    let mut rng = Rng::new(seed, "iterated");
    let teeth: Vec<_> = parts::gear(8).iter().map(|n| [n.x, n.y]).collect();
    let regular = |corners| shape::polygon(&shape::regular(corners, 1.0, 0.1));
    let pairs = [
        ("gear", twice(shape::polygon(&teeth))),
        ("star", radial::stars(6, &mut rng)),
        ("combs", combs::combs(4)),
        ("comb_polygon", combs::comb_and_polygon(4, 8)),
        ("twoopt", (twoopt::simple(12, &mut rng), twoopt::simple(12, &mut rng))),
        ("regular", (regular(5), regular(12))),
    ];
    pairs.map(|(name, pair)| (name.to_owned(), pair)).into()
}

fn twice(region: Region) -> (Region, Region) {
    (region.clone(), region)
}
