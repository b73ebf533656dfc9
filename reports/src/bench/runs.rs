//! The runs of one engine on one case, each with the sort next to it.

use super::Missing;
use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::engine::{Answer, Counters, Engine, EngineError, Times};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// One run.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// Time of the sum.
    pub total: Duration,
    /// Times of its stages.
    pub times: Times,
    /// Time of the sort after it; none for engines that do not tell how many vertices there are.
    pub sort: Option<Duration>,
}

/// What an engine counted and how long each run took.
#[derive(Clone, Debug)]
pub struct Runs {
    /// The counters.
    pub counters: Counters,
    /// The runs, without the one to warm up.
    pub runs: Vec<Run>,
}

impl Runs {
    /// Warms an engine up, unless the case is beyond it or its arrangement has more than `most` vertices.
    pub fn warm(engine: &mut dyn Engine, case: &Case, most: u64) -> Result<Self, Missing> {
        if !engine.abilities().cover(&case.a, &case.b) {
            return Err(Missing::Unable);
        }
        let Answer { counters, .. } = engine.sum(&case.a, &case.b)?;
        match counters.vertices {
            Some(vertices) if vertices > most => Err(Missing::TooLarge(vertices)),
            _ => Ok(Self { counters, runs: Vec::new() }),
        }
    }

    /// Runs the engine once more.
    pub fn add(&mut self, engine: &mut dyn Engine, case: &Case) -> Result<(), EngineError> {
        let start = Instant::now();
        let answer = black_box(engine.sum(&case.a, &case.b)?);
        let total = answer.times.total.unwrap_or(start.elapsed());
        let sort = self.counters.vertices.map(|vertices| sort(vertices as usize));
        self.runs.push(Run { total, times: answer.times, sort });
        Ok(())
    }

    /// The times of the sums.
    pub fn totals(&self) -> Vec<Duration> {
        self.runs.iter().map(|run| run.total).collect()
    }
}

/// The time to sort so many pairs of doubles.
fn sort(count: usize) -> Duration {
    let mut rng = Rng::new(0, "sort");
    let mut pairs: Vec<[f64; 2]> = (0..count).map(|_| [rng.unit(), rng.unit()]).collect();
    let start = Instant::now();
    pairs.sort_unstable_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
    black_box(&pairs);
    start.elapsed()
}
