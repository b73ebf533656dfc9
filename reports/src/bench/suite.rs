//! Suites: the cases that engines are timed on when none are named.

use crate::cases::Case;
use crate::cases::family::Family;
use clap::ValueEnum;

/// Cases that belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Suite {
    /// Families of growing size: 10^3 to 10^6 vertices of the kinetic arrangement, dense and sparse.
    Growth,
    /// The nine parts with their negatives and discs, and convex parts in convex containers (MS 8, Fig. 8).
    Parts,
}

/// The families and sizes of [`Suite::Growth`].
const GROWTH: &[(&str, &[u32])] = &[
    ("fork", &[4, 7, 13, 22]),
    ("combs", &[15, 50, 150, 450]),
    ("star", &[10, 20, 35, 60]),
    ("radial", &[20, 40, 70, 110]),
    ("twoopt", &[20, 50, 120, 200]),
    ("arcs", &[16, 40, 80, 140]),
];

/// The families of [`Suite::Parts`].
const PARTS: [&str; 2] = ["parts", "fig8"];

impl Suite {
    /// Its cases; of families that draw several of one size, the first.
    #[must_use]
    pub fn cases(self, seed: u64) -> Vec<Case> {
        match self {
            Self::Growth => GROWTH.iter().flat_map(|(name, sizes)| growth(name, sizes, seed)).collect(),
            Self::Parts => PARTS.iter().filter_map(|name| Family::named(name)).flat_map(|f| f.cases(seed)).collect(),
        }
    }
}

fn growth(name: &str, sizes: &[u32], seed: u64) -> Vec<Case> {
    let first = |family: &Family, size: u32| family.cases_of_size(size, seed).into_iter().next();
    Family::named(name).map_or(Vec::new(), |family| sizes.iter().filter_map(|size| first(family, *size)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_family_or_size_is_missing() {
        let sizes = GROWTH.iter().map(|(_, sizes)| sizes.len()).sum::<usize>();
        assert_eq!(Suite::Growth.cases(1).len(), sizes);
        let parts = Suite::Parts.cases(1);
        assert_eq!(parts.iter().filter(|case| case.family == "parts").count(), 54);
        assert!(parts.iter().any(|case| case.family == "fig8"));
    }
}
