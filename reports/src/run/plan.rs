//! The plan of a run: which engine meets which case, in the order of the rows.

use crate::cases::Case;
use crate::cases::rng::fnv;
use crate::engine::registry::{Facts, NoSuchEngine, facts};
use crate::judge::samples::Sampling;

/// Everything that decides the results of a run, times and time limits aside.
#[derive(Debug)]
pub struct Plan {
    /// The cases.
    pub cases: Vec<Case>,
    /// The engines.
    pub engines: Vec<Facts>,
    /// The jobs: a case and an engine that can do it, by index.
    pub jobs: Vec<Job>,
    /// Whether and how often results are sampled.
    pub sampling: Option<Sampling>,
}

/// A row to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Job {
    /// Index of the case.
    pub case: usize,
    /// Index of the engine.
    pub engine: usize,
}

impl Plan {
    /// All engines on all cases they can do, case by case.
    ///
    /// # Errors
    /// When there is no engine of one of the names.
    pub fn new(cases: Vec<Case>, engines: &[String]) -> Result<Self, NoSuchEngine> {
        let engines = engines.iter().map(|name| facts(name)).collect::<Result<Vec<_>, _>>()?;
        let jobs = cases.iter().enumerate().flat_map(|(case, c)| {
            let able = engines.iter().enumerate().filter(|(_, e)| e.abilities.cover(&c.a, &c.b));
            able.map(move |(engine, _)| Job { case, engine }).collect::<Vec<_>>()
        });
        let jobs = jobs.collect();
        Ok(Self { cases, engines, jobs, sampling: None })
    }

    /// A text that differs between plans: the number of jobs and a hash over cases and engines.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let engines = self.engines.iter().map(|e| format!("{} {}\n", e.name, e.version));
        // Debug prints doubles so that they read back: plans with different coordinates differ.
        let cases = self.cases.iter().map(|c| format!("{c:?}\n"));
        let sampling = self.sampling.iter().map(|s| format!("{s:?}\n"));
        let hash = engines.chain(cases).chain(sampling).fold(0_u64, |h, text| h.rotate_left(7) ^ fnv(&text));
        format!("{} rows, {hash:016x}", self.jobs.len())
    }
}
