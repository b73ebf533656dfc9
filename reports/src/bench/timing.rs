//! Rows of `timing.csv`.

use super::attempt::Attempt;
use super::fate::Fate;
use super::middle::Sorted;
use super::runs::Run;
use crate::cases::Case;
use crate::row::number;
use serde::{Deserialize, Serialize};
use std::time::Duration;

/// An engine on a case. Times are in milliseconds; what an engine does not tell, or nobody measured, is empty.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// The case.
    pub case: String,
    /// Its family.
    pub family: String,
    /// The engine.
    pub engine: String,
    /// What became of it; all but ok have no times.
    pub status: Fate,
    /// Median time of a sum.
    pub median_ms: Option<f64>,
    /// Least time of a sum.
    pub min_ms: Option<f64>,
    /// Runs timed.
    pub runs: usize,
    /// Whether the result was found right, by the rule of [`super::right`]; empty where nobody looked or could tell.
    pub correct: Option<bool>,
    /// The greatest error of the result, in unit-box lengths: a certified upper bound.
    #[serde(default, with = "number")]
    pub mu_hi: Option<f64>,
    /// By how much the resident set of a fresh process grew during one sum, in units of 10^6 bytes.
    pub peak_mb: Option<f64>,
    /// Machine instructions of one sum.
    pub instructions: Option<u64>,
    /// These by those of the run's first engine.
    pub instructions_to_first: Option<f64>,
    /// Median time of the convolution.
    pub t_convolution: Option<f64>,
    /// Median time of the arrangement.
    pub t_arrangement: Option<f64>,
    /// Median time of the extraction.
    pub t_extraction: Option<f64>,
    /// Whether both operands are polygons.
    pub polygonal: bool,
    /// Segments of the kinetic convolution of the case, whatever the engine: the size of the case.
    pub sum_segments: Option<u64>,
    /// Segments of the engine's own convolution.
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
    /// One sentence: why there are no times, or why the result is not right.
    pub note: String,
}

impl Timing {
    /// Whether the row may enter a mean: timed, and not found wrong.
    #[must_use]
    pub fn counts(&self) -> bool {
        self.status == Fate::Ok && self.correct != Some(false)
    }

    /// The row of an attempt at a case of so many sum segments; `first` is that of the run's first engine.
    pub(super) fn new(
        case: &Case,
        size: Option<u64>,
        engine: &str,
        attempt: &Attempt,
        first: Option<&Attempt>,
    ) -> Self {
        let look = &attempt.look;
        let blank = Self {
            case: case.name.clone(),
            family: case.family.clone(),
            engine: engine.to_owned(),
            status: look.fate,
            correct: look.right,
            mu_hi: look.mu_hi,
            peak_mb: look.memory.map(|bytes| bytes as f64 / 1e6),
            polygonal: case.is_polygonal(),
            sum_segments: size,
            note: look.note.clone(),
            ..Self::default()
        };
        if look.fate == Fate::Ok { blank.timed(attempt, first) } else { blank }
    }

    /// With what the runs say.
    fn timed(self, attempt: &Attempt, first: Option<&Attempt>) -> Self {
        let (runs, counters) = (&attempt.runs, &attempt.counters);
        let total = milliseconds(runs, |run| Some(run.total));
        let sort = Sorted::new(runs.iter().filter_map(|run| Some(quotient(run.total, run.sort?))));
        let firsts = first.map_or(&[][..], |first| &first.runs[..]);
        // An engine whose only run is the first look has no partner in each round.
        let beside = |i: usize| firsts.get(i).or(firsts.last()).map(|run| run.total);
        let to_first =
            Sorted::new(runs.iter().enumerate().filter_map(|(i, run)| Some(quotient(run.total, beside(i)?))));
        let median = |time: fn(&Run) -> Option<Duration>| milliseconds(runs, time).map(|t| t.median());
        let median_ms = total.as_ref().map(Sorted::median);
        Self {
            median_ms,
            min_ms: total.map(|total| total.least()),
            runs: runs.len(),
            t_convolution: median(|run| run.times.convolution),
            t_arrangement: median(|run| run.times.arrangement),
            t_extraction: median(|run| run.times.extraction),
            sums: counters.sums,
            vertices: counters.vertices,
            cells: counters.cells,
            ns_per_vertex: median_ms.and_then(|ms| Some(ms * 1e6 / counters.vertices?.max(1) as f64)),
            sort_ms: median(|run| run.sort),
            ratio: sort.as_ref().map(Sorted::median),
            ratio_min: sort.as_ref().map(Sorted::least),
            ratio_max: sort.as_ref().map(Sorted::greatest),
            to_first: to_first.as_ref().map(Sorted::median),
            to_first_min: to_first.as_ref().map(Sorted::least),
            to_first_max: to_first.as_ref().map(Sorted::greatest),
            ..self
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn fate() -> impl Strategy<Value = Fate> {
        proptest::sample::select(&Fate::ALL[..])
    }

    fn value() -> impl Strategy<Value = Option<f64>> {
        proptest::option::of(prop_oneof![1e-300_f64..1e300, Just(0.0)])
    }

    proptest! {
        /// A table that is written and read again is the same, so that the page can be made from it alone.
        #[test]
        fn rows_survive_csv(
            names in proptest::array::uniform3("[ -~é\n]{0,12}"),
            status in fate(),
            correct in proptest::option::of(any::<bool>()),
            times in proptest::array::uniform8(value()),
            infinite in any::<bool>(),
            counts in proptest::array::uniform4(proptest::option::of(any::<u64>())),
            runs in 0_usize..9,
        ) {
            let [case, engine, note] = names;
            let row = Timing {
                case, engine, note, status, correct, runs,
                mu_hi: if infinite { Some(f64::INFINITY) } else { times[0] },
                median_ms: times[1], min_ms: times[2], peak_mb: times[3], instructions_to_first: times[4],
                ratio: times[5], to_first: times[6], to_first_max: times[7],
                instructions: counts[0], sum_segments: counts[1], sums: counts[2], vertices: counts[3],
                ..Timing::default()
            };
            let mut writer = csv::Writer::from_writer(Vec::new());
            writer.serialize(&row).unwrap();
            let bytes = writer.into_inner().unwrap();
            let back: Timing = csv::Reader::from_reader(&bytes[..]).deserialize().next().unwrap().unwrap();
            prop_assert_eq!(back, row);
        }
    }

    #[test]
    fn wrong_rows_and_rows_without_times_count_in_no_mean() {
        let row = Timing::default();
        assert!(row.counts());
        for correct in [Some(true), Some(false), None] {
            assert_eq!(Timing { correct, ..row.clone() }.counts(), correct != Some(false));
            assert!(!Timing { correct, status: Fate::TooSlow, ..row.clone() }.counts());
        }
    }
}
