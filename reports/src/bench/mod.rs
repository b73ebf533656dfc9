//! How long sums take: engines against each other, and against the time the same machine needs, in the same run, to sort as
//! many pairs of doubles as the arrangement has vertices (MS 8; memo M17, M38).
//!
//! Sorting is what any sweep must at least do; ratios can be compared between machines, times cannot. A round runs every
//! engine once on one thread, each next to its sort, so that a machine that slows down slows down all of them. [`time`]
//! returns a row an engine; [`comparison`] sums up the rows of a run.

pub mod comparison;
mod middle;
mod runs;
pub mod suite;
pub mod timing;

use crate::cases::Case;
use crate::engine::{Engine, EngineError};
use runs::Runs;
use std::time::{Duration, Instant};
use timing::Timing;

/// A case takes no longer than about this an engine, however many rounds were asked for.
const PATIENCE: Duration = Duration::from_secs(20);

/// The fewest rounds.
const LEAST: usize = 3;

/// Why an engine has no row for a case.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Missing {
    /// It cannot sum such regions.
    #[error("it cannot sum such regions")]
    Unable,
    /// Its arrangement is larger than what was asked for.
    #[error("its arrangement has {0} vertices")]
    TooLarge(u64),
    /// It gave no sum.
    #[error("it gave no sum: {0}")]
    Failed(#[from] EngineError),
}

/// Times engines on a case in turn, `rounds` times after one round to warm up; fewer when it takes long, never below three.
/// Arrangements may have up to `most` vertices. The ratios of a row are to the first engine, if it has a row.
pub fn time(case: &Case, engines: &mut [Box<dyn Engine>], rounds: usize, most: u64) -> Vec<Result<Timing, Missing>> {
    let started = Instant::now();
    let patience = PATIENCE * engines.len() as u32;
    let mut all: Vec<Result<Runs, Missing>> = engines.iter_mut().map(|e| Runs::warm(e.as_mut(), case, most)).collect();
    let mut round = 0;
    while round < rounds.max(1) && (round < LEAST || started.elapsed() < patience) {
        for (engine, runs) in engines.iter_mut().zip(&mut all) {
            let failure = runs.as_mut().ok().and_then(|runs| runs.add(engine.as_mut(), case).err());
            if let Some(failure) = failure {
                *runs = Err(failure.into());
            }
        }
        round += 1;
    }
    let first: Vec<Duration> = all.first().and_then(|runs| runs.as_ref().ok()).map(Runs::totals).unwrap_or_default();
    let timed = engines.iter().zip(all);
    timed.map(|(engine, runs)| runs.map(|runs| Timing::new(case, engine.name(), &runs, &first))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::registry::engine;
    use suite::Suite;

    fn engines(names: &[&str]) -> Vec<Box<dyn Engine>> {
        names.iter().map(|name| engine(name).unwrap()).collect()
    }

    #[test]
    fn a_timing_counts_its_rounds_and_pairs_them() {
        let case = &Suite::Growth.cases(1)[0];
        let rows = time(case, &mut engines(&["kinetic", "monotonic"]), 4, u64::MAX);
        let [kinetic, monotonic] = &rows.into_iter().collect::<Result<Vec<_>, _>>().unwrap()[..] else { panic!() };
        assert_eq!((kinetic.engine.as_str(), monotonic.engine.as_str()), ("kinetic", "monotonic"));
        for row in [kinetic, monotonic] {
            assert_eq!(row.runs, 4);
            assert!(row.ratio_min <= row.ratio && row.ratio <= row.ratio_max && row.min_ms > 0.0);
            assert!(row.to_first_min <= row.to_first && row.to_first <= row.to_first_max);
            let stages = row.t_convolution.unwrap() + row.t_arrangement.unwrap() + row.t_extraction.unwrap();
            assert!(stages > 0.5 * row.min_ms && row.sums > Some(0) && row.cells > Some(0), "{row:?}");
        }
        assert_eq!([kinetic.to_first, kinetic.to_first_min, kinetic.to_first_max], [Some(1.0); 3]);
        assert_ne!(monotonic.to_first, Some(1.0));
    }

    #[test]
    fn what_is_not_timed_says_why() {
        let case = &Suite::Growth.cases(1)[0];
        let names = ["kinetic", "monotonic", "cmd:false"];
        let rows = time(case, &mut engines(&names), 3, u64::MAX);
        let most = rows[1].as_ref().unwrap().vertices.unwrap();
        assert!(matches!(rows[2], Err(Missing::Failed(_))), "{:?}", rows[2]);
        let rows = time(case, &mut engines(&names), 3, most);
        assert!(matches!(rows[0], Err(Missing::TooLarge(vertices)) if vertices > most), "{:?}", rows[0]);
        assert_eq!(rows[1].as_ref().unwrap().to_first, None);
    }
}
