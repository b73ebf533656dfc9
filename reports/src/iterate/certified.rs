//! Certified errors of single steps, added up.

use super::{Reference, Step, Verdict};
use crate::cases::Case;
use crate::row::Status;
use crate::worker::parent::{Worker, WorkerError};
use crate::worker::{Ask, Task};
use std::sync::atomic::AtomicBool;

/// The error so far. References of regions with arcs may run for hours, so a worker with a time limit asks them.
pub(super) struct Certified<'a> {
    worker: &'a mut Worker,
    stop: &'a AtomicBool,
    /// The upper bound so far in input units, or why there is none.
    total: Result<f64, String>,
}

impl<'a> Certified<'a> {
    /// Starts a chain.
    pub(super) fn new(worker: &'a mut Worker, stop: &'a AtomicBool) -> Self {
        Self { worker, stop, total: Ok(0.0) }
    }

    /// The certified bounds of the error of one step, in unit-box lengths, or why there are none.
    fn step(&mut self, step: &Step) -> Result<Result<[f64; 2], String>, WorkerError> {
        let case = Case {
            name: "step".into(),
            family: "iterated".into(),
            a: step.before.clone(),
            b: step.added.clone(),
            seed: None,
            golden: None,
        };
        let task = Task { case, engine: "none".into(), claim: Some(step.after.clone()), sampling: None, ask: Ask::All };
        let outcome = self.worker.measure(&task, self.stop)?;
        if let Some((_, note)) = outcome.failure {
            return Ok(Err(note));
        }
        Ok(match outcome.judgement.map(|found| (found.status, found.mu_lo, found.mu_hi, found.note)) {
            Some((Status::Ok, Some(lo), Some(hi), _)) => Ok([lo, hi]),
            Some((_, _, _, note)) => Err(note),
            None => Err("the reference said nothing".into()),
        })
    }
}

impl Reference for Certified<'_> {
    fn name(&self) -> &'static str {
        "steps"
    }

    fn judge(&mut self, step: &Step) -> Result<Verdict, WorkerError> {
        let before = match &self.total {
            Ok(total) => *total,
            Err(note) => return Ok(Verdict { note: note.clone(), ..Verdict::default() }),
        };
        Ok(match self.step(step)? {
            Ok([lo, hi]) => {
                let total = before + hi * step.unit;
                self.total = Ok(total);
                Verdict { mu: Some([(lo - before / step.unit).max(0.0), total / step.unit]), ..Verdict::default() }
            }
            Err(note) => {
                self.total = Err("an earlier step is undecided".into());
                Verdict { note, ..Verdict::default() }
            }
        })
    }
}
