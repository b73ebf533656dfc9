//! Rows of `timing.csv`.

use super::middle::Sorted;
use super::runs::{Run, Runs};
use crate::cases::Case;
use serde::Serialize;
use std::time::Duration;

/// An engine on a case. Times are in milliseconds; what an engine does not tell is empty.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
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
    pub t_convolution: Option<f64>,
    /// Median time of the arrangement.
    pub t_arrangement: Option<f64>,
    /// Median time of the extraction.
    pub t_extraction: Option<f64>,
    /// Segments of the convolution.
    pub sums: Option<u64>,
    /// Vertices of the arrangement.
    pub vertices: Option<u64>,
    /// Cells of the arrangement, the one far away included.
    pub cells: Option<u64>,
    /// Median time of a sum by vertex, in nanoseconds.
    pub ns_per_vertex: Option<f64>,
    /// Median time to sort as many pairs.
    pub sort_ms: Option<f64>,
    /// Median ratio of a sum to the sort next to it.
    pub ratio: Option<f64>,
    /// Least ratio.
    pub ratio_min: Option<f64>,
    /// Greatest ratio.
    pub ratio_max: Option<f64>,
    /// Median ratio of a sum to that of the run's first engine in the same round; empty without the latter.
    pub to_first: Option<f64>,
    /// Least of these ratios.
    pub to_first_min: Option<f64>,
    /// Greatest of these ratios.
    pub to_first_max: Option<f64>,
}

impl Timing {
    /// The row of an engine with at least one run; `first` are the times of the run's first engine, round by round.
    pub(super) fn new(case: &Case, engine: &str, runs: &Runs, first: &[Duration]) -> Self {
        let Runs { counters, runs } = runs;
        let total = milliseconds(runs, |run| Some(run.total));
        let median_ms = total.as_ref().map_or(f64::NAN, Sorted::median);
        let sort = Sorted::new(runs.iter().filter_map(|run| Some(quotient(run.total, run.sort?))));
        let to_first = Sorted::new(runs.iter().zip(first).map(|(run, first)| quotient(run.total, *first)));
        let median = |time: fn(&Run) -> Option<Duration>| milliseconds(runs, time).map(|t| t.median());
        Self {
            case: case.name.clone(),
            family: case.family.clone(),
            engine: engine.to_owned(),
            median_ms,
            min_ms: total.map_or(f64::NAN, |total| total.least()),
            runs: runs.len(),
            correct: None,
            t_convolution: median(|run| run.times.convolution),
            t_arrangement: median(|run| run.times.arrangement),
            t_extraction: median(|run| run.times.extraction),
            sums: counters.sums,
            vertices: counters.vertices,
            cells: counters.cells,
            ns_per_vertex: counters.vertices.map(|vertices| median_ms * 1e6 / vertices.max(1) as f64),
            sort_ms: median(|run| run.sort),
            ratio: sort.as_ref().map(Sorted::median),
            ratio_min: sort.as_ref().map(Sorted::least),
            ratio_max: sort.as_ref().map(Sorted::greatest),
            to_first: to_first.as_ref().map(Sorted::median),
            to_first_min: to_first.as_ref().map(Sorted::least),
            to_first_max: to_first.as_ref().map(Sorted::greatest),
        }
    }
}

fn quotient(time: Duration, by: Duration) -> f64 {
    time.as_secs_f64() / by.as_secs_f64()
}

/// A time of all runs that have it.
fn milliseconds(runs: &[Run], time: impl Fn(&Run) -> Option<Duration>) -> Option<Sorted> {
    Sorted::new(runs.iter().filter_map(time).map(|t| t.as_secs_f64() * 1e3))
}
