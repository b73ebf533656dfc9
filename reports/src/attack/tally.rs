//! What a search has done, kind by kind.

use super::What;
use crate::row::Row;
use serde::Serialize;
use std::collections::BTreeMap;

/// A kind of pairs: a line of `attack.csv`. Ratios are of the lower bound of the separation to mu_hi.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Line {
    /// The kind.
    pub kind: String,
    /// Pairs that were summed.
    pub cases: u64,
    /// Free points that were put through the sieve.
    pub probes: u64,
    /// Of these, how many passed.
    pub suspects: u64,
    /// Of these, ones strictly inside of a free cell.
    pub suspects_inside: u64,
    /// Swaps against the convolution order.
    pub conflicts: u64,
    /// Cases put to the references.
    pub measured: u64,
    /// Cases like those with suspects that were not measured, because there are many.
    pub unmeasured: u64,
    /// Measured cases without a certified answer.
    pub undecided: u64,
    /// Cases with rho > mu strictly inside of a free cell in spite of 2 mu separation,
    pub inside: u64,
    /// ones with rho > mu on the boundary of free cells only,
    pub boundary: u64,
    /// and without it.
    pub unseparated: u64,
    /// The least separation over mu where rho > mu,
    pub least_ratio: Option<f64>,
    /// the greatest one,
    pub greatest_ratio: Option<f64>,
    /// and the least one where a swap was against the order.
    pub least_ratio_of_conflicts: Option<f64>,
    /// The greatest rho where rho > mu, in unit-box lengths.
    pub greatest_rho: Option<f64>,
}

/// The lines of a search.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    lines: BTreeMap<String, Line>,
}

impl Tally {
    /// The line of a kind.
    pub fn of(&mut self, kind: &str) -> &mut Line {
        self.lines.entry(kind.to_owned()).or_insert_with(|| Line { kind: kind.to_owned(), ..Line::default() })
    }

    /// All lines, by kind.
    pub fn lines(&self) -> impl Iterator<Item = &Line> {
        self.lines.values()
    }

    /// The probes of all kinds.
    #[must_use]
    pub fn probes(&self) -> u64 {
        self.lines().map(|line| line.probes).sum()
    }

    /// The pairs of all kinds.
    #[must_use]
    pub fn cases(&self) -> u64 {
        self.lines().map(|line| line.cases).sum()
    }
}

impl Line {
    /// Enters a measured case; what it shows, if it shows anything.
    pub fn enter(&mut self, row: &Row) -> Option<What> {
        self.measured += 1;
        let (Some(mu), Some(separation)) = (row.mu_hi, row.separation_lo) else {
            self.undecided += 1;
            return None;
        };
        let least = |known: Option<f64>, ratio: f64| Some(known.map_or(ratio, |known| known.min(ratio)));
        let most = |known: Option<f64>, ratio: f64| Some(known.map_or(ratio, |known| known.max(ratio)));
        let ratio = separation / mu;
        if row.order_conflict.is_some_and(|count| count > 0) {
            self.least_ratio_of_conflicts = least(self.least_ratio_of_conflicts, ratio);
        }
        let what = what(row)?;
        if what != What::Conflict {
            self.inside += u64::from(what == What::Inside);
            self.boundary += u64::from(what == What::Boundary);
            self.unseparated += u64::from(what == What::Unseparated);
            self.least_ratio = least(self.least_ratio, ratio);
            self.greatest_ratio = most(self.greatest_ratio, ratio);
            self.greatest_rho = most(self.greatest_rho, row.rho_lo.unwrap_or(0.0));
        }
        Some(what)
    }
}

/// What a row shows.
#[must_use]
pub fn what(row: &Row) -> Option<What> {
    let mu = row.mu_hi?;
    if row.falsely_free.is_some_and(|count| count > 0) {
        let separated = row.separation_lo.is_some_and(|separation| separation >= 2.0 * mu);
        let inside = [row.bubbles, row.cracks].into_iter().flatten().sum::<u64>() > 0;
        return Some(match (separated, inside) {
            (false, _) => What::Unseparated,
            (true, true) => What::Inside,
            (true, false) => What::Boundary,
        });
    }
    row.order_conflict.is_some_and(|count| count > 0).then_some(What::Conflict)
}
