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
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tally::Tally;

/// Regions whose chains are at least this far apart, in unit-box lengths, are put to the reference whenever they pass the
/// sieve: 2 mu is less than this in all that has been measured.
const APART: f64 = 1e-14;

/// Of other ones, as many of a kind are put to it.
const OTHERS: u64 = 25;

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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// A falsely free point in spite of 2 mu separation: Theorem 4 does not hold for the engine.
    Separated,
    /// A falsely free point in regions that are not separated by 2 mu for certain.
    Unseparated,
    /// A swap against the convolution order and no falsely free point.
    Conflict,
}

/// The running search.
pub struct Attack {
    search: Search,
    engine: Own,
    rng: Rng,
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
        Ok(Self { search, engine, rng, tally: Tally::default() })
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
        let Sieved { probes, suspects, order_conflict } = sieve::sieve(&case, self.engine.options())?;
        let line = self.tally.of(&case.family);
        line.cases += 1;
        line.probes += probes;
        line.suspects += suspects;
        line.conflicts += order_conflict;
        if suspects == 0 && order_conflict == 0 {
            return None;
        }
        let apart = separation::measure(&case).ok().and_then(|found| found.lo)? >= APART;
        if !apart && line.measured_unseparated >= OTHERS {
            line.unmeasured += 1;
            return None;
        }
        let row = self.measure(&case);
        let line = self.tally.of(&case.family);
        line.measured_unseparated += u64::from(!apart);
        let what = line.enter(&row)?;
        let same = |case: &Case| Some(self.measure(case)).filter(|row| tally::what(row) == Some(what));
        let (case, row) = shrink::shrink(case, row, same);
        Some(Found { case, row, what })
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
