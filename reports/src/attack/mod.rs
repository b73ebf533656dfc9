//! The search for falsely free points that MS, Theorem 4, says are not there: random and nearly degenerate pairs of regions,
//! a cheap [`sieve`] over the points that memo F names, and the references' word on what passes it.

pub mod pairs;
pub mod shrink;
pub mod sieve;
pub mod tally;

use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::engine::own::Own;
use crate::engine::{Engine, registry::NoSuchEngine};
use crate::judge::{judge, separation};
use crate::row::Row;
use crate::run::plan::Plan;
use crate::run::record::assemble;
use crate::worker::Outcome;
use sieve::Sieved;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tally::Tally;

/// Regions whose chains are at least this far apart, in unit-box lengths, are expected to be 2 mu separated.
const APART: f64 = 1e-14;

/// As many are kept of a kind and of what they show.
const KEPT: usize = 1;

/// What to search and how long.
#[derive(Clone, Debug)]
pub struct Search {
    /// The engine, one of this project's.
    pub engine: String,
    /// The seed of the pairs.
    pub seed: u64,
    /// Probes after which the search ends,
    pub probes: u64,
    /// and the time after which it does.
    pub time: Duration,
}

/// A measured case.
#[derive(Clone, Debug)]
pub struct Found {
    /// The case.
    pub case: Case,
    /// What was measured.
    pub row: Row,
    /// What it shows.
    pub what: What,
}

/// What a measured case shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum What {
    /// A falsely free point strictly inside of a free cell, in spite of 2 mu separation: Theorem 4 does not hold.
    Inside,
    /// Likewise, but on the boundary of free cells only, as far as doubles tell.
    Boundary,
    /// A falsely free point in regions that are not separated by 2 mu for certain.
    Unseparated,
    /// A swap against the convolution order and no falsely free point.
    Conflict,
}

/// The most telling thing that the sieve saw in a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Seen {
    Conflict,
    Boundary,
    Inside,
}

impl Seen {
    /// As many cases of a kind are put to the reference, which takes its time.
    fn most(self) -> usize {
        match self {
            Self::Inside => 12,
            Self::Boundary => 3,
            Self::Conflict => 6,
        }
    }
}

/// The running search.
pub struct Attack {
    search: Search,
    engine: Own,
    rng: Rng,
    /// How many cases have been measured, by kind, by whether their regions are far apart, and by what the sieve saw.
    measured: BTreeMap<(String, bool, Seen), usize>,
    /// How many have been kept.
    kept: BTreeMap<(String, What), usize>,
    /// What has been done.
    pub tally: Tally,
}

impl Attack {
    /// Before the first pair.
    ///
    /// # Errors
    /// When the engine is not one of this project's: others do not show their cells.
    pub fn new(search: Search) -> Result<Self, NoSuchEngine> {
        let engine = Own::named(&search.engine).ok_or_else(|| NoSuchEngine(search.engine.clone()))?;
        let rng = Rng::new(search.seed, "falsely-free");
        Ok(Self { search, engine, rng, measured: BTreeMap::new(), kept: BTreeMap::new(), tally: Tally::default() })
    }

    /// Searches on. Every measured case that shows something is handed to `keep` at once.
    pub fn run<E>(&mut self, stop: &AtomicBool, mut keep: impl FnMut(Found) -> Result<(), E>) -> Result<(), E> {
        let start = Instant::now();
        while self.tally.probes() < self.search.probes && start.elapsed() < self.search.time {
            if stop.load(Ordering::Relaxed) {
                break;
            }
            let (kind, a, b) = pairs::pair(&mut self.rng);
            let name = format!("{kind}_{}", self.tally.cases());
            let case = Case { name, family: kind.into(), a, b, seed: Some(self.search.seed), golden: None };
            if let Some(found) = self.attack(case) {
                keep(found)?;
            }
        }
        Ok(())
    }

    /// Searches one case.
    fn attack(&mut self, case: Case) -> Option<Found> {
        let sieved = sieve::sieve(&case, self.engine.options())?;
        let seen = self.enter(&case.family, &sieved)?;
        let separation = separation::measure(&case).ok().and_then(|found| found.lo)?;
        let measured = self.measured.entry((case.family.clone(), separation >= APART, seen)).or_default();
        *measured += 1;
        if *measured > seen.most() {
            self.tally.of(&case.family).unmeasured += 1;
            return None;
        }
        let row = self.measure(&case);
        let what = self.tally.of(&case.family).enter(&row)?;
        let kept = self.kept.entry((case.family.clone(), what)).or_default();
        *kept += 1;
        if *kept > KEPT {
            return None;
        }
        let same = |case: &Case| Some(self.measure(case)).filter(|row| tally::what(row) == Some(what));
        let (case, row) = shrink::shrink(case, row, same);
        Some(Found { case, row, what })
    }

    /// Enters what the sieve found; the most telling of it, if there is anything.
    fn enter(&mut self, kind: &str, sieved: &Sieved) -> Option<Seen> {
        let line = self.tally.of(kind);
        line.cases += 1;
        line.probes += sieved.probes;
        line.suspects += sieved.suspects;
        line.suspects_inside += sieved.inside;
        line.conflicts += sieved.order_conflict;
        let seen =
            [(Seen::Inside, sieved.inside), (Seen::Boundary, sieved.suspects), (Seen::Conflict, sieved.order_conflict)];
        seen.into_iter().find(|(_, count)| *count > 0).map(|(seen, _)| seen)
    }

    /// The references' word on a case.
    fn measure(&self, case: &Case) -> Row {
        let mut engine = Own::named(&self.search.engine).unwrap_or_else(|| Own::new(self.engine.options().convolution));
        let answer = engine.sum(&case.a, &case.b).ok();
        let judgement = answer.as_ref().map(|answer| judge(case, &self.search.engine, answer));
        let plan = Plan::new(vec![case.clone()], std::slice::from_ref(&self.search.engine));
        let outcome = Outcome { answer, judgement, failure: None };
        assemble(&plan.expect("the engine is known"), 0, outcome).row
    }
}
