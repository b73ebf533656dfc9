//! What the rows of a run say about two engines: the ratio of their summed times, the mean of their ratios, and where which is
//! slower (MS 8; memo M38).
//!
//! Only cases count where neither was found wrong. The ratio of sums is that of the papers. It is about the largest cases; the geometric mean counts all cases alike.

use super::fate::Fate;
use super::middle::Sorted;
use super::timing::Timing;
use crate::cases::rng::Rng;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Resamplings of the cases for an interval.
const DRAWS: usize = 2000;

/// An engine beside the first one of a run, over the cases that both were timed on. Ratios are below 1 where it is faster. The
/// intervals hold 95% of what other samples of as many cases would give, the cases drawn again with repetition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// The engine.
    pub engine: String,
    /// The first engine of the run.
    pub first: String,
    /// The cases that both were timed on.
    pub cases: usize,
    /// The cases, timed or not, where it was found wrong; they are not among the others.
    pub wrong: usize,
    /// The cases where it crashed, came to no end or gave no region.
    pub failed: usize,
    /// The sum of its median times over these, in milliseconds.
    pub total_ms: f64,
    /// The same of the first engine.
    pub first_total_ms: f64,
    /// The quotient of the two.
    pub ratio_of_sums: f64,
    /// Lower end of its interval.
    pub ratio_of_sums_lo: f64,
    /// Upper end of it.
    pub ratio_of_sums_hi: f64,
    /// The geometric mean over cases of the median ratio of paired runs.
    pub geometric_mean: f64,
    /// Lower end of its interval.
    pub geometric_mean_lo: f64,
    /// Upper end of it.
    pub geometric_mean_hi: f64,
    /// The arithmetic mean of these ratios.
    pub mean: f64,
    /// The cases where it was slower in every round.
    pub always_slower: usize,
    /// The cases where it was slower in the middle of all rounds, by name.
    pub slower: String,
}

/// A case of a comparison.
#[derive(Clone, Copy)]
struct Pair {
    time: f64,
    first: f64,
    ratio: f64,
}

/// The comparison of every engine with the first one, in the order of their first rows.
#[must_use]
pub fn comparisons(rows: &[Timing], first: &str) -> Vec<Comparison> {
    let of_first: BTreeMap<&str, f64> = rows
        .iter()
        .filter(|row| row.engine == first && row.counts())
        .filter_map(|row| Some((row.case.as_str(), row.median_ms?)))
        .collect();
    let mut engines: Vec<&str> = Vec::new();
    for row in rows {
        if row.engine != first && !engines.contains(&row.engine.as_str()) {
            engines.push(&row.engine);
        }
    }
    engines.into_iter().filter_map(|engine| comparison(rows, engine, first, &of_first)).collect()
}

fn comparison(rows: &[Timing], engine: &str, first: &str, of_first: &BTreeMap<&str, f64>) -> Option<Comparison> {
    let shared: Vec<(&Timing, Pair)> = rows
        .iter()
        .filter(|row| row.engine == engine && row.counts())
        .filter_map(|row| {
            let pair = Pair { time: row.median_ms?, first: *of_first.get(row.case.as_str())?, ratio: row.to_first? };
            Some((row, pair))
        })
        .collect();
    let pairs: Vec<Pair> = shared.iter().map(|(_, pair)| *pair).collect();
    if pairs.is_empty() {
        return None;
    }
    let slower = |row: &&Timing| row.to_first > Some(1.0);
    let count = |of: &dyn Fn(&Timing) -> bool| rows.iter().filter(|row| row.engine == engine && of(row)).count();
    let [sums, means] = [ratio_of_sums, geometric_mean].map(|number| interval(&pairs, number));
    Some(Comparison {
        engine: engine.to_owned(),
        first: first.to_owned(),
        cases: pairs.len(),
        wrong: count(&|row| row.correct == Some(false)),
        failed: count(&|row| matches!(row.status, Fate::Crashed | Fate::Timeout | Fate::Invalid)),
        total_ms: pairs.iter().map(|pair| pair.time).sum(),
        first_total_ms: pairs.iter().map(|pair| pair.first).sum(),
        ratio_of_sums: ratio_of_sums(&pairs),
        ratio_of_sums_lo: sums[0],
        ratio_of_sums_hi: sums[1],
        geometric_mean: geometric_mean(&pairs),
        geometric_mean_lo: means[0],
        geometric_mean_hi: means[1],
        mean: pairs.iter().map(|pair| pair.ratio).sum::<f64>() / pairs.len() as f64,
        always_slower: shared.iter().filter(|(row, _)| row.to_first_min > Some(1.0)).count(),
        slower: shared
            .iter()
            .map(|(row, _)| *row)
            .filter(slower)
            .map(|r| r.case.as_str())
            .collect::<Vec<_>>()
            .join(" "),
    })
}

fn ratio_of_sums(pairs: &[Pair]) -> f64 {
    pairs.iter().map(|pair| pair.time).sum::<f64>() / pairs.iter().map(|pair| pair.first).sum::<f64>()
}

fn geometric_mean(pairs: &[Pair]) -> f64 {
    Sorted::new(pairs.iter().map(|pair| pair.ratio)).map_or(f64::NAN, |ratios| ratios.geometric_mean())
}

/// The 2.5th and the 97.5th of a hundred parts of what resampled cases give.
fn interval(pairs: &[Pair], number: fn(&[Pair]) -> f64) -> [f64; 2] {
    let mut rng = Rng::new(0, "comparison");
    let mut draw = || number(&pairs.iter().map(|_| pairs[rng.below(pairs.len())]).collect::<Vec<_>>());
    let mut found: Vec<f64> = (0..DRAWS).map(|_| draw()).collect();
    found.sort_by(f64::total_cmp);
    [DRAWS / 40, DRAWS - 1 - DRAWS / 40].map(|i| found[i])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(case: &str, engine: &str, median_ms: f64, to_first: f64) -> Timing {
        Timing {
            case: case.into(),
            engine: engine.into(),
            median_ms: Some(median_ms),
            to_first: Some(to_first),
            to_first_min: Some(0.9 * to_first),
            ..Timing::default()
        }
    }

    #[test]
    fn a_comparison_is_over_the_shared_cases() {
        let rows = [
            row("p", "a", 2.0, 1.0),
            row("p", "b", 1.0, 0.5),
            row("q", "a", 8.0, 1.0),
            row("q", "b", 16.0, 2.0),
            row("only b", "b", 1000.0, 7.0),
            row("only a", "a", 1000.0, 1.0),
        ];
        let all = comparisons(&rows, "a");
        assert_eq!(all.len(), 1);
        let it = &all[0];
        assert_eq!((it.engine.as_str(), it.first.as_str(), it.cases), ("b", "a", 2));
        assert_eq!((it.total_ms, it.first_total_ms, it.ratio_of_sums), (17.0, 10.0, 1.7));
        assert!((it.geometric_mean - 1.0).abs() < 1e-12 && it.mean == 1.25);
        assert_eq!((it.slower.as_str(), it.always_slower), ("q", 1));
        // With two cases the interval reaches from one to the other.
        assert_eq!([it.ratio_of_sums_lo, it.ratio_of_sums_hi], [0.5, 2.0]);
        assert!((it.geometric_mean_lo - 0.5).abs() < 1e-12 && (it.geometric_mean_hi - 2.0).abs() < 1e-12);
    }

    /// Planted: a wrong answer in no time, and a wrong one of the first engine.
    #[test]
    fn wrong_rows_are_counted_and_enter_no_mean() {
        let wrong = |row: Timing| Timing { correct: Some(false), ..row };
        let crashed = Timing { status: Fate::Crashed, median_ms: None, to_first: None, ..row("s", "b", 0.0, 0.0) };
        let rows = [
            row("p", "a", 2.0, 1.0),
            row("p", "b", 6.0, 3.0),
            row("q", "a", 2.0, 1.0),
            wrong(row("q", "b", 0.002, 0.001)),
            wrong(row("r", "a", 2.0, 1.0)),
            row("r", "b", 2000.0, 1000.0),
            row("s", "a", 2.0, 1.0),
            crashed,
        ];
        let it = &comparisons(&rows, "a")[0];
        assert_eq!((it.cases, it.wrong, it.failed, it.ratio_of_sums), (1, 1, 1, 3.0));
        assert!((it.geometric_mean - 3.0).abs() < 1e-12);
    }

    #[test]
    fn nothing_in_common_is_no_comparison() {
        assert_eq!(comparisons(&[row("p", "a", 1.0, 1.0), row("q", "b", 1.0, 1.0)], "a"), []);
    }
}
