//! How long sums take, against the time the same machine needs, in the same run, to sort as many pairs of doubles as the
//! arrangement has vertices.
//!
//! Sorting is what any sweep must at least do; the ratio can be compared between machines, times cannot. Both are taken
//! by turns, so that a machine that slows down slows down both.

use crate::cases::Case;
use crate::cases::family::Family;
use crate::cases::rng::Rng;
use arcsum::sum::{Options, Sum, SumError, Times, sum};
use serde::Serialize;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The families and sizes timed: 10^3 to 10^6 vertices of the arrangement, dense and sparse.
const SIZES: &[(&str, &[u32])] = &[
    ("fork", &[4, 7, 13, 22]),
    ("combs", &[15, 50, 150, 450]),
    ("star", &[10, 20, 35, 60]),
    ("radial", &[20, 40, 70, 110]),
    ("twoopt", &[20, 50, 120, 200]),
    ("arcs", &[16, 40, 80, 140]),
];

/// No case takes longer than about this, however many runs were asked for.
const PATIENCE: Duration = Duration::from_secs(20);

/// A row of `timing.csv`. Times are in milliseconds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Timing {
    /// The case.
    pub case: String,
    /// Its family.
    pub family: String,
    /// The engine.
    pub engine: String,
    /// Median time of a sum.
    pub median_ms: f64,
    /// Least time of a sum.
    pub min_ms: f64,
    /// Runs timed.
    pub runs: usize,
    /// Whether the result was found right; empty where nobody looked.
    pub correct: Option<bool>,
    /// Median time of the convolution.
    pub t_convolution: f64,
    /// Median time of the arrangement.
    pub t_arrangement: f64,
    /// Median time of the extraction.
    pub t_extraction: f64,
    /// Segments of the convolution.
    pub sums: usize,
    /// Vertices of the arrangement.
    pub vertices: usize,
    /// Median time of a sum by vertex, in nanoseconds.
    pub ns_per_vertex: f64,
    /// Median time to sort as many pairs.
    pub sort_ms: f64,
    /// Median ratio of a sum to the sort next to it.
    pub ratio: f64,
    /// Least ratio.
    pub ratio_min: f64,
    /// Greatest ratio.
    pub ratio_max: f64,
}

/// The cases to be timed.
#[must_use]
pub fn cases(seed: u64) -> Vec<Case> {
    let first = |&(name, sizes): &(&str, &'static [u32])| {
        let family = Family::named(name)?;
        Some(sizes.iter().filter_map(|&size| family.cases_of_size(size, seed).into_iter().next()).collect::<Vec<_>>())
    };
    SIZES.iter().filter_map(first).flatten().collect()
}

/// Times the engine `kinetic` on a case, `runs` times after one run to warm up; `None` when the arrangement has more
/// than `most` vertices.
///
/// # Errors
/// When the engine refuses the case.
pub fn time(case: &Case, runs: usize, most: usize) -> Result<Option<Timing>, SumError> {
    let started = Instant::now();
    let warm = timed(case)?.1;
    let vertices = warm.arrangement.audit.vertices;
    if vertices > most {
        return Ok(None);
    }
    let mut samples = Vec::new();
    while samples.len() < runs.max(1) && (samples.len() < 3 || started.elapsed() < PATIENCE) {
        let (total, sum) = timed(case)?;
        samples.push(Sample { total, times: sum.times, sort: sort(vertices) });
    }
    Ok(Some(summary(case, &warm, vertices, &samples)))
}

/// One run: the sum, its stages, and the sort after it.
struct Sample {
    total: Duration,
    times: Times,
    sort: Duration,
}

fn timed(case: &Case) -> Result<(Duration, Sum), SumError> {
    let start = Instant::now();
    let sum = black_box(sum(&case.a, &case.b, &Options::default())?);
    Ok((start.elapsed(), sum))
}

fn sort(count: usize) -> Duration {
    let mut rng = Rng::new(0, "sort");
    let mut pairs: Vec<[f64; 2]> = (0..count).map(|_| [rng.unit(), rng.unit()]).collect();
    let start = Instant::now();
    pairs.sort_unstable_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
    black_box(&pairs);
    start.elapsed()
}

fn summary(case: &Case, sum: &Sum, vertices: usize, samples: &[Sample]) -> Timing {
    let milliseconds = |f: &dyn Fn(&Sample) -> Duration| sorted(samples, &|s| f(s).as_secs_f64() * 1e3);
    let total = milliseconds(&|s| s.total);
    let ratio = sorted(samples, &|s| s.total.as_secs_f64() / s.sort.as_secs_f64());
    Timing {
        case: case.name.clone(),
        family: case.family.clone(),
        engine: "kinetic".into(),
        median_ms: median(&total),
        min_ms: total[0],
        runs: samples.len(),
        correct: None,
        t_convolution: median(&milliseconds(&|s| s.times.convolution)),
        t_arrangement: median(&milliseconds(&|s| s.times.arrangement)),
        t_extraction: median(&milliseconds(&|s| s.times.extraction)),
        sums: sum.convolution.pieces.len(),
        vertices,
        ns_per_vertex: median(&total) * 1e6 / vertices.max(1) as f64,
        sort_ms: median(&milliseconds(&|s| s.sort)),
        ratio: median(&ratio),
        ratio_min: ratio[0],
        ratio_max: ratio[ratio.len() - 1],
    }
}

/// The values of all samples, least first; there is at least one.
fn sorted(samples: &[Sample], value: &dyn Fn(&Sample) -> f64) -> Vec<f64> {
    let mut values: Vec<f64> = samples.iter().map(value).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The middle of sorted values, the mean of the two in the middle of an even number.
fn median(sorted: &[f64]) -> f64 {
    let n = sorted.len();
    0.5 * (sorted[(n - 1) / 2] + sorted[n / 2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_are_in_the_middle() {
        assert_eq!(median(&[1.0, 2.0, 9.0]), 2.0);
        assert_eq!(median(&[1.0, 2.0, 4.0, 9.0]), 3.0);
    }

    #[test]
    fn a_timing_counts_its_runs_and_respects_the_limit() {
        let case = &cases(1)[0];
        let timing = time(case, 4, usize::MAX).unwrap().unwrap();
        assert_eq!(timing.runs, 4);
        assert!(timing.ratio_min <= timing.ratio && timing.ratio <= timing.ratio_max && timing.min_ms > 0.0);
        assert!(time(case, 4, timing.vertices - 1).unwrap().is_none());
    }
}
