//! Iterated sums A + B, A + 2 B, ... measured step by step (MS 8.1; memo M46): how the error and the number of segments grow
//! when each result, tidied, is an operand of the next sum.
//!
//! [`chain`] hands out a row a depth. Polygons are judged by the exact sum of exact sums. For arcs there is no such chain:
//! every step is measured against the certified sum of its two operands as stored, and the errors are added up, which bounds
//! the error of the whole because sums are 1-Lipschitz.

pub mod cases;
mod certified;
mod exact;

use crate::bridge::unit;
use crate::cases::Case;
use crate::engine::Engine;
use crate::row::{Status, number};
use crate::worker::parent::{Worker, WorkerError};
use arcsum::region::Region;
use arcsum::tidy::tidy;
use certified::Certified;
use exact::Exact;
use serde::Serialize;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

/// A row of `iterated.csv`: an engine's A + depth B.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The case.
    pub case: String,
    /// The engine.
    pub engine: String,
    /// How often B was added.
    pub depth: usize,
    /// What became of the step; `undecided` where the reference took too long, here or before.
    pub status: Status,
    /// Certified lower bound of the distance to the exact sum of them all, in lengths of the step's unit box.
    #[serde(with = "number")]
    pub mu_lo: Option<f64>,
    /// Certified upper bound.
    #[serde(with = "number")]
    pub mu_hi: Option<f64>,
    /// -log2(mu_hi).
    #[serde(with = "number")]
    pub bits: Option<f64>,
    /// `chain` for the exact sum of exact sums, `steps` for errors of steps added up.
    pub reference: &'static str,
    /// Segments of the result.
    pub segments: Option<usize>,
    /// Edges of the exact sum; polygons only.
    pub exact_segments: Option<usize>,
    /// Time of the sum and of tidying it.
    pub ms: Option<f64>,
    /// One sentence, or nothing.
    pub note: String,
}

/// One step of a chain.
struct Step<'a> {
    before: &'a Region,
    added: &'a Region,
    after: &'a Region,
    /// The side of the unit box of the two operands, in input units.
    unit: f64,
}

/// What a reference says about a step.
#[derive(Default)]
struct Verdict {
    /// Bounds of the error of the whole; none if undecided.
    mu: Option<[f64; 2]>,
    exact_segments: Option<usize>,
    note: String,
}

/// A reference that follows a chain.
trait Reference {
    /// Its name in the table.
    fn name(&self) -> &'static str;

    /// The verdict on the next step. Once undecided, it stays so.
    fn judge(&mut self, step: &Step) -> Result<Verdict, WorkerError>;
}

/// Measures an engine's sums up to a depth and hands out each row as soon as it is known. A chain ends early when the engine
/// fails, or takes longer than the limit for a step whose error is undecided.
///
/// # Errors
/// [`WorkerError`] when stopped, or when no worker can be started.
pub fn chain(
    case: &Case,
    engine: &mut dyn Engine,
    worker: &mut Worker,
    (depth, limit): (usize, Duration),
    stop: &AtomicBool,
    each: &mut dyn FnMut(Row),
) -> Result<(), WorkerError> {
    let mut reference: Box<dyn Reference + '_> =
        if case.is_polygonal() { Box::new(Exact::new(case, limit)) } else { Box::new(Certified::new(worker, stop)) };
    let name = engine.name().to_owned();
    let mut before = case.a.clone();
    for depth in 1..=depth {
        let empty = Row { depth, ..Row::empty(case, &name, reference.name()) };
        let start = Instant::now();
        let after = match engine.sum(&before, &case.b) {
            Ok(answer) => tidy(&answer.region),
            Err(error) => {
                each(Row { status: Status::Invalid, note: error.to_string(), ..empty });
                return Ok(());
            }
        };
        let took = start.elapsed();
        let step = Step { before: &before, added: &case.b, after: &after, unit: unit(&before, &case.b) };
        let verdict = reference.judge(&step)?;
        let decided = verdict.mu.is_some();
        each(Row { segments: Some(after.segments()), ms: Some(took.as_secs_f64() * 1e3), ..empty }.with(verdict));
        if !decided && took > limit {
            return Ok(());
        }
        before = after;
    }
    Ok(())
}

impl Row {
    fn empty(case: &Case, engine: &str, reference: &'static str) -> Self {
        Self {
            case: case.name.clone(),
            engine: engine.to_owned(),
            depth: 0,
            status: Status::Undecided,
            mu_lo: None,
            mu_hi: None,
            bits: None,
            reference,
            segments: None,
            exact_segments: None,
            ms: None,
            note: String::new(),
        }
    }

    fn with(self, verdict: Verdict) -> Self {
        let Verdict { mu, exact_segments, note } = verdict;
        let [mu_lo, mu_hi] = mu.map_or([None; 2], |mu| mu.map(Some));
        let status = if mu.is_some() { Status::Ok } else { Status::Undecided };
        Self { status, mu_lo, mu_hi, bits: mu_hi.map(|mu| -libm::log2(mu)), exact_segments, note, ..self }
    }
}

#[cfg(test)]
mod tests;
