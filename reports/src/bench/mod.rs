//! How long sums take: engines against each other, and against the time the same machine needs, in the same run, to sort as
//! many pairs of doubles as the arrangement has vertices (MS 8; memo M17, M38); what memory and how many instructions they
//! take, and whether they are right.
//!
//! Sorting is what any sweep must at least do; ratios can be compared between machines, times cannot. Every engine is first
//! looked at in a process of its own ([`look`]). Then a round runs every engine that came through once on one thread, each
//! next to its sort, so that a machine that slows down slows down all of them. [`time`] returns a row an engine, also for
//! those that gave no sum; [`comparison`] and [`goals`] sum up the rows of a run.

mod attempt;
pub mod comparison;
pub mod fate;
pub mod goals;
pub mod instructions;
pub mod look;
pub(crate) mod middle;
pub mod right;
mod runs;
pub mod size;
pub mod suite;
pub mod timing;

use crate::cases::Case;
use crate::engine::Engine;
use crate::worker::parent::WorkerError;
use attempt::Attempt;
use instructions::Counter;
use look::Looks;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};
use timing::Timing;

/// A case takes no longer than about this an engine, however many rounds were asked for.
const PATIENCE: Duration = Duration::from_secs(20);

/// The fewest rounds.
const LEAST: usize = 3;

/// What is measured.
#[derive(Clone, Copy, Debug)]
pub struct Effort<'a> {
    /// Rounds after the one to warm up; fewer when they take long, never below three.
    pub rounds: usize,
    /// The most vertices an arrangement may have.
    pub most: u64,
    /// What counts instructions, if that is wanted.
    pub counter: Option<&'a Counter>,
}

/// The rows of engines on a case, in turn; none for engines that cannot sum such regions. The ratios of a row are to the
/// first engine, if it has times.
///
/// # Errors
/// When stopped, or when no worker can be started.
pub fn time(
    case: &Case,
    engines: &mut [Box<dyn Engine>],
    effort: Effort<'_>,
    looks: &mut Looks,
    stop: &AtomicBool,
) -> Result<Vec<Option<Timing>>, WorkerError> {
    let size = size::sum_segments(case);
    let mut attempts = Vec::new();
    for engine in engines.iter_mut() {
        let able = engine.abilities().cover(&case.a, &case.b);
        let attempt = able
            .then(|| Attempt::begin(engine.as_mut(), case, size.unwrap_or(0), effort.most, looks, stop))
            .transpose()?;
        attempts.push(attempt);
    }
    go_round(case, engines, &mut attempts, effort.rounds);
    let first = attempts.first().and_then(Option::as_ref);
    let row =
        |(engine, attempt): (&str, &Option<Attempt>)| Some(Timing::new(case, size, engine, attempt.as_ref()?, first));
    let names = engines.iter().map(|engine| engine.name());
    let mut rows: Vec<Option<Timing>> = names.zip(&attempts).map(row).collect();
    if let Some(counter) = effort.counter {
        let here: Vec<bool> = engines.iter().map(|engine| engine.process().is_none()).collect();
        counter.count(case, &mut rows, &here);
    }
    Ok(rows)
}

/// Times rounds of those that came through the first look.
fn go_round(case: &Case, engines: &mut [Box<dyn Engine>], attempts: &mut [Option<Attempt>], rounds: usize) {
    let started = Instant::now();
    let patience = PATIENCE * engines.len() as u32;
    let mut round = 0;
    while round < rounds.max(1) && (round < LEAST || started.elapsed() < patience) {
        for (engine, attempt) in engines.iter_mut().zip(attempts.iter_mut()) {
            if let Some(attempt) = attempt {
                attempt.go_on(engine.as_mut(), case);
            }
        }
        round += 1;
    }
}
