//! One run of an engine on a case, with the sort next to it.

use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::engine::{Engine, EngineError, Times};
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

impl Run {
    /// Runs an engine once; `vertices` is what its arrangement has, if it tells.
    pub fn of(engine: &mut dyn Engine, case: &Case, vertices: Option<u64>) -> Result<Self, EngineError> {
        let start = Instant::now();
        let answer = black_box(engine.sum(&case.a, &case.b)?);
        let total = answer.times.total.unwrap_or(start.elapsed());
        let sort = vertices.map(|vertices| sort(vertices as usize));
        Ok(Self { total, times: answer.times, sort })
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
