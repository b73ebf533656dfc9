//! Suites: the cases that engines are timed on when none are named.

use crate::cases::Case;
use crate::cases::family::Family;
use clap::ValueEnum;

/// Cases that belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Suite {
    /// Families of growing size, dense and sparse: from ten to a hundred thousand segments of the kinetic convolution.
    Growth,
    /// The nine parts with their negatives and discs, and convex parts in convex containers (MS 8, Fig. 8).
    Parts,
    /// What the engines of others are compared on: the families of memo J5, the nine parts, random polygons, arcs.
    Peers,
}

/// A family and the sizes that are taken of it.
type Sizes = (&'static str, &'static [u32]);

/// The families and sizes of [`Suite::Growth`].
const GROWTH: &[Sizes] = &[
    ("fork", &[1, 2, 4, 7, 13, 22, 50]),
    ("combs", &[2, 5, 15, 50, 160]),
    ("star", &[3, 5, 10, 20, 35, 60, 160]),
    ("radial", &[4, 8, 20, 40, 70, 110, 400]),
    ("twoopt", &[4, 8, 20, 50, 120, 200, 500]),
    ("arcs", &[4, 8, 16, 40, 80, 140, 280]),
];

/// The families of [`Suite::Parts`], at their own sizes.
const PARTS: &[Sizes] = &[("parts", &[]), ("fig8", &[])];

/// The families and sizes of [`Suite::Peers`]; without sizes, their own.
const PEERS: &[Sizes] = &[
    ("fork", &[2, 4, 8, 16]),
    ("covered", &[2, 4, 8]),
    ("combs", &[5, 40, 150]),
    ("comb_polygon", &[5, 20, 100]),
    ("star", &[5, 20, 50]),
    ("radial", &[10, 50, 100]),
    ("fat_grid", &[2, 6, 12]),
    ("robot", &[2, 4, 6]),
    ("islands", &[2, 4]),
    ("orthogonal", &[20, 150]),
    ("holed", &[24, 100]),
    ("twoopt", &[50, 100, 200, 500, 1000]),
    ("twoopt_small", &[100, 200]),
    ("fig8", &[32, 256]),
    ("parts", &[]),
    ("arcs", &[32, 96]),
    ("bulges", &[32, 96]),
    ("gear", &[32, 96]),
    ("offset", &[32, 96, 1000]),
    ("mixed", &[12, 24]),
    ("rounded", &[10]),
];

impl Suite {
    /// Its cases; of families that draw several of one size, the first.
    #[must_use]
    pub fn cases(self, seed: u64) -> Vec<Case> {
        self.families().iter().flat_map(|(name, sizes)| taken(name, sizes, seed)).collect()
    }

    fn families(self) -> &'static [Sizes] {
        match self {
            Self::Growth => GROWTH,
            Self::Parts => PARTS,
            Self::Peers => PEERS,
        }
    }
}

/// The cases of a family at these sizes. Where a size has pairs of several kinds, all of the first draw.
fn taken(name: &str, sizes: &[u32], seed: u64) -> Vec<Case> {
    let Some(family) = Family::named(name) else { return Vec::new() };
    if sizes.is_empty() {
        return family.cases(seed);
    }
    sizes.iter().flat_map(|size| family.first_of_size(*size, seed)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::size::sum_segments;

    #[test]
    fn no_family_or_size_is_missing() {
        for suite in [Suite::Growth, Suite::Parts, Suite::Peers] {
            for (name, sizes) in suite.families() {
                assert!(Family::named(name).is_some(), "{name}");
                for size in *sizes {
                    // Random simple polygons of many vertices take their time to untangle.
                    let found = *size > 200 || !taken(name, &[*size], 1).is_empty();
                    assert!(found, "{name} {size}");
                }
            }
        }
        let parts = Suite::Parts.cases(1);
        assert_eq!(parts.iter().filter(|case| case.family == "parts").count(), 54);
        assert!(parts.iter().any(|case| case.family == "fig8"));
    }

    /// Every family reaches a hundred thousand segments, from as few as it can have.
    #[test]
    fn growth_spans_four_decades() {
        let span = |(name, sizes): &Sizes| {
            let ends = [sizes[0], sizes[sizes.len() - 1]];
            ends.map(|size| sum_segments(&taken(name, &[size], 1)[0]).unwrap())
        };
        let spans: Vec<[u64; 2]> = GROWTH.iter().map(span).collect();
        assert!(spans.iter().all(|[least, most]| *least <= 60 && *most >= 100_000), "{spans:?}");
        assert!(spans.iter().any(|[least, _]| *least <= 10), "{spans:?}");
    }
}
