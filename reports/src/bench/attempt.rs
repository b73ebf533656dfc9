//! An engine at a case: the first look, then a run to warm up and the runs that are timed.

use super::fate::Fate;
use super::look::{Look, Looks};
use super::runs::Run;
use crate::cases::Case;
use crate::engine::{Counters, Engine, EngineError, Times};
use crate::worker::parent::WorkerError;
use std::sync::atomic::AtomicBool;

/// What came of it.
#[derive(Clone, Debug, Default)]
pub struct Attempt {
    /// The first look; what the runs found is added.
    pub look: Look,
    /// What the engine counted.
    pub counters: Counters,
    /// The runs, without the one to warm up.
    pub runs: Vec<Run>,
    /// Whether more runs are wanted.
    pub open: bool,
}

impl Attempt {
    /// Looks at an engine and warms it up; one that is slow has its only run behind it then. Arrangements may have up to
    /// `most` vertices.
    ///
    /// # Errors
    /// When stopped, or when no worker can be started.
    pub fn begin(
        engine: &mut dyn Engine,
        case: &Case,
        size: u64,
        most: u64,
        looks: &mut Looks,
        stop: &AtomicBool,
    ) -> Result<Self, WorkerError> {
        let look = looks.look(case, size, engine, stop)?;
        let mut attempt = Self { look, ..Self::default() };
        if attempt.look.fate != Fate::Ok {
            return Ok(attempt);
        }
        if attempt.look.time > looks.slow() {
            attempt.runs.push(Run { total: attempt.look.time, times: Times::default(), sort: None });
            return Ok(attempt);
        }
        attempt.warm_up(engine, case);
        if let Some(vertices) = attempt.counters.vertices.filter(|vertices| *vertices > most) {
            attempt.look = Look::skipped(Fate::TooLarge, format!("its arrangement has {vertices} vertices"));
            attempt.open = false;
            looks.give_up(case, size, engine, Fate::TooLarge);
        }
        Ok(attempt)
    }

    fn warm_up(&mut self, engine: &mut dyn Engine, case: &Case) {
        match engine.sum(&case.a, &case.b) {
            Err(error) => self.fail(&error),
            Ok(answer) => {
                self.open = true;
                self.counters = answer.counters;
                // What was judged is not what is timed.
                if self.look.region.take().is_some_and(|region| region != answer.region) {
                    self.look.right = None;
                    self.look.note = "it does not always answer the same".into();
                }
            }
        }
    }

    /// Times one more run, if more are wanted.
    pub fn go_on(&mut self, engine: &mut dyn Engine, case: &Case) {
        if !self.open {
            return;
        }
        match Run::of(engine, case, self.counters.vertices) {
            Ok(run) => self.runs.push(run),
            Err(error) => self.fail(&error),
        }
    }

    /// It gave no sum after all.
    fn fail(&mut self, error: &EngineError) {
        let fate = match error {
            EngineError::Invalid(_) => Fate::Invalid,
            EngineError::Crashed(_) => Fate::Crashed,
        };
        *self = Self { look: Look::skipped(fate, error.to_string()), ..Self::default() };
    }
}
