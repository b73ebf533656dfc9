//! The first look at an engine on a case, in a process of its own: whether it answers at all, in its time, what memory it
//! takes, and whether what it answers is right. Only what comes through is timed in this process.
//!
//! Larger cases of a family are not put to an engine that was slow, or whose arrangement was too large, on a smaller one;
//! nor to a reference that did not come to an end.

use super::fate::Fate;
use super::right::right;
use crate::cases::Case;
use crate::engine::{Answer, Engine};
use crate::judge::Judgement;
use crate::row::Status;
use crate::worker::parent::{Worker, WorkerError};
use crate::worker::{Ask, Outcome, Task};
use arcsum::region::Region;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// What was seen.
#[derive(Clone, Debug, Default)]
pub struct Look {
    /// What became of the engine.
    pub fate: Fate,
    /// One sentence, unless all is well.
    pub note: String,
    /// Its answer.
    pub region: Option<Region>,
    /// How long that took, by the engine's own clock if it has one.
    pub time: Duration,
    /// By how much the memory grew, in bytes.
    pub memory: Option<u64>,
    /// The greatest error of the answer, in unit-box lengths, as far as known.
    pub mu_hi: Option<f64>,
    /// Whether it is right.
    pub right: Option<bool>,
}

impl Look {
    /// An engine that was not asked.
    pub(super) fn skipped(fate: Fate, note: impl Into<String>) -> Self {
        Self { fate, note: note.into(), ..Self::default() }
    }
}

/// How engines are looked at.
#[derive(Clone, Debug)]
pub struct Limits {
    /// This program, which has the hidden command `worker`.
    pub program: PathBuf,
    /// Time for an engine, and again for the reference, on a case.
    pub time: Duration,
    /// An engine that needs longer is not asked for larger cases of the family.
    pub slow: Duration,
}

/// Who gave up on which family, and from which size on.
#[derive(Debug)]
pub struct Looks {
    limits: Limits,
    /// By family and engine: the least size at which something happened, and what.
    given_up: BTreeMap<(String, String), (u64, Fate)>,
    /// By family: the least size at which the reference was silent.
    silent: BTreeMap<String, u64>,
}

impl Looks {
    /// Nobody has given up yet.
    #[must_use]
    pub fn new(limits: Limits) -> Self {
        Self { limits, given_up: BTreeMap::new(), silent: BTreeMap::new() }
    }

    /// An engine that takes longer than this is slow.
    pub(super) fn slow(&self) -> Duration {
        self.limits.slow
    }

    /// Looks at an engine on a case of this many sum segments.
    ///
    /// # Errors
    /// When stopped, or when no worker can be started.
    pub fn look(
        &mut self,
        case: &Case,
        size: u64,
        engine: &dyn Engine,
        stop: &AtomicBool,
    ) -> Result<Look, WorkerError> {
        if let Some((from, fate)) = self.given_up.get(&key(case, engine)).filter(|(from, _)| *from < size) {
            return Ok(Look::skipped(*fate, format!("it was so on a case of the family with {from} sum segments")));
        }
        let judged = self.silent.get(&case.family).is_none_or(|from| size < *from);
        let task = Task {
            case: case.clone(),
            engine: engine.name().to_owned(),
            claim: None,
            sampling: None,
            ask: Ask::Alone { judged },
        };
        // A fresh process: what one that has computed before takes from the system says little about a sum.
        let outcome = Worker::new(self.limits.program.clone(), self.limits.time).measure(&task, stop)?;
        if judged && outcome.answer.is_some() && outcome.judgement.is_none() {
            lower(&mut self.silent, case.family.clone(), size);
        }
        let look = seen(outcome, engine.resolution());
        if look.fate == Fate::Timeout || look.time > self.limits.slow {
            self.give_up(case, size, engine, Fate::TooSlow);
        }
        Ok(look)
    }

    /// Has an engine left out on larger cases of the family.
    pub(super) fn give_up(&mut self, case: &Case, size: u64, engine: &dyn Engine, fate: Fate) {
        let known = self.given_up.entry(key(case, engine)).or_insert((size, fate));
        if size < known.0 {
            *known = (size, fate);
        }
    }
}

fn key(case: &Case, engine: &dyn Engine) -> (String, String) {
    (case.family.clone(), engine.name().to_owned())
}

fn lower(sizes: &mut BTreeMap<String, u64>, family: String, size: u64) {
    let known = sizes.entry(family).or_insert(size);
    *known = size.min(*known);
}

fn seen(outcome: Outcome, resolution: Option<f64>) -> Look {
    let Some(Answer { region, times, memory, .. }) = outcome.answer else {
        let (status, note) = outcome.failure.unwrap_or((Status::Crashed, "no answer".into()));
        return Look::skipped(status.into(), note);
    };
    let note = outcome.failure.map_or_else(String::new, |(_, note)| note);
    let judgement = outcome.judgement.unwrap_or_else(|| Judgement::undecided(note));
    let right = right(&judgement, resolution);
    Look {
        fate: Fate::Ok,
        note: if right == Some(true) { String::new() } else { judgement.note },
        region: Some(region),
        time: times.total.unwrap_or_default(),
        memory,
        mu_hi: judgement.mu_hi,
        right,
    }
}
