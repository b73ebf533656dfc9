//! Goals of the engine against its peers: how many times faster than theirs it is, in the geometric mean over cases and in
//! the worst case (`goals.csv`). Theirs is one engine, or the best of several in each case.
//!
//! A case counts where both are timed and neither was found wrong; a goal can ask that theirs is right to more than that.
//! Cases where only one of the two has such a time are counted apart: a mean over those where both came through says nothing
//! about the ones where one did not.

use super::middle::Sorted;
use super::timing::Timing;
use crate::row::number;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// Vertices of the arrangements that are compared with sorting.
const SORTED_VERTICES: std::ops::RangeInclusive<u64> = 10_000..=1_000_000;

/// The name of the goal against sorting.
const SORTING: &str = "sorting as many pairs, 10^4 to 10^6 vertices";

/// A sum is to take at most six times as long as the sort.
const A_SIXTH: f64 = 1.0 / 6.0;

/// A goal.
struct Goal {
    name: &'static str,
    theirs: fn(&Timing) -> bool,
    /// Theirs by ours at least, in the mean and in the worst case.
    wanted: [f64; 2],
}

const GOALS: [Goal; 7] = [
    Goal { name: "CGAL, best exact strategy a case", theirs: exact_cgal, wanted: [30.0, 5.0] },
    Goal {
        name: "cgal:reduced:inexact where it survives",
        theirs: |row| row.engine == "cgal:reduced:inexact",
        wanted: [5.0, 1.0],
    },
    Goal { name: "clipper2:minkowski", theirs: |row| row.engine == "clipper2:minkowski", wanted: [20.0, 2.0] },
    Goal { name: "clipper2:union", theirs: |row| row.engine == "clipper2:union", wanted: [2.0, 0.8] },
    Goal { name: "i_overlay", theirs: |row| row.engine == "i_overlay", wanted: [3.0, 0.8] },
    Goal { name: "cavalier, where right to 1e-9", theirs: cavalier, wanted: [0.5, 0.2] },
    Goal {
        name: "clipper2:flat-1e-3 on arcs",
        theirs: |row| row.engine == "clipper2:flat-1e-3" && !row.polygonal,
        wanted: [5.0, 1.0],
    },
];

fn exact_cgal(row: &Timing) -> bool {
    row.engine.strip_prefix("cgal:").is_some_and(|method| method.ends_with(":exact"))
}

fn cavalier(row: &Timing) -> bool {
    row.engine.starts_with("cavalier") && row.mu_hi.is_some_and(|mu| mu <= 1e-9)
}

/// A row of `goals.csv`. Ratios are theirs by ours: above 1 where ours is faster.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reached {
    /// The goal.
    pub goal: String,
    /// Ours: the first engine of the run.
    pub ours: String,
    /// The cases that count.
    pub cases: usize,
    /// Those among them where nobody could tell whether one of the two results is right.
    pub unjudged: usize,
    /// Cases put to both where ours has a time that counts and theirs has none, of any engine of the goal.
    pub only_ours: usize,
    /// The other way round.
    pub only_theirs: usize,
    /// The geometric mean of the ratios; empty without cases.
    #[serde(default, with = "number")]
    pub geometric_mean: Option<f64>,
    /// What it should be at least.
    pub wanted_mean: f64,
    /// Whether it is.
    pub mean_met: Option<bool>,
    /// The least ratio.
    #[serde(default, with = "number")]
    pub worst: Option<f64>,
    /// The case it is of.
    pub worst_case: String,
    /// Theirs in that case.
    pub worst_engine: String,
    /// What it should be at least.
    pub wanted_worst: f64,
    /// Whether it is.
    pub worst_met: Option<bool>,
}

/// A case of a goal.
struct Pair<'a> {
    case: &'a str,
    engine: &'a str,
    ratio: f64,
    judged: bool,
}

/// How far the goals are reached by `ours`, the first engine of the run.
#[must_use]
pub fn reached(rows: &[Timing], ours: &str) -> Vec<Reached> {
    let of_ours: BTreeMap<&str, &Timing> =
        rows.iter().filter(|row| row.engine == ours && row.counts()).map(|row| (row.case.as_str(), row)).collect();
    let of_goal = |goal: &Goal| {
        let [only_ours, only_theirs] = alone(rows, goal, ours, &of_ours);
        let pairs = against(rows, goal, &of_ours);
        Reached { only_ours, only_theirs, ..measured(goal.name, ours, &pairs, goal.wanted) }
    };
    let mut all: Vec<Reached> = GOALS.iter().map(of_goal).collect();
    let sorted: Vec<Pair<'_>> = of_ours.values().filter_map(|row| sorting(row)).collect();
    all.push(measured(SORTING, ours, &sorted, [A_SIXTH; 2]));
    all
}

/// The cases of a goal, theirs the fastest of those that count.
fn against<'a>(rows: &'a [Timing], goal: &Goal, ours: &BTreeMap<&str, &Timing>) -> Vec<Pair<'a>> {
    let mut best: BTreeMap<&str, Pair<'a>> = BTreeMap::new();
    for row in rows.iter().filter(|row| row.counts() && (goal.theirs)(row)) {
        let Some((ours, ratio)) = ours.get(row.case.as_str()).zip(row.to_first) else { continue };
        let judged = row.correct.is_some() && ours.correct.is_some();
        let pair = Pair { case: &row.case, engine: &row.engine, ratio, judged };
        if best.get(row.case.as_str()).is_none_or(|known| ratio < known.ratio) {
            best.insert(&row.case, pair);
        }
    }
    best.into_values().collect()
}

/// The cases put to both sides where only ours, and where only theirs, has a time that counts.
fn alone(rows: &[Timing], goal: &Goal, ours: &str, of_ours: &BTreeMap<&str, &Timing>) -> [usize; 2] {
    let asked: BTreeSet<&str> = rows.iter().filter(|row| row.engine == ours).map(|row| row.case.as_str()).collect();
    let mut theirs: BTreeMap<&str, bool> = BTreeMap::new();
    for row in rows.iter().filter(|row| (goal.theirs)(row) && asked.contains(row.case.as_str())) {
        *theirs.entry(&row.case).or_default() |= row.counts();
    }
    let count = |ours: bool| {
        theirs.iter().filter(|(case, theirs)| of_ours.contains_key(*case) == ours && **theirs != ours).count()
    };
    [count(true), count(false)]
}

/// Ours against sorting.
fn sorting(row: &Timing) -> Option<Pair<'_>> {
    let ratio = 1.0 / row.ratio?;
    let large = row.vertices.is_some_and(|vertices| SORTED_VERTICES.contains(&vertices));
    large.then_some(Pair { case: &row.case, engine: "sort", ratio, judged: row.correct.is_some() })
}

fn measured(goal: &str, ours: &str, pairs: &[Pair<'_>], wanted: [f64; 2]) -> Reached {
    let ratios = Sorted::new(pairs.iter().map(|pair| pair.ratio));
    let geometric_mean = ratios.as_ref().map(Sorted::geometric_mean);
    let least = pairs.iter().min_by(|p, q| p.ratio.total_cmp(&q.ratio));
    let worst = least.map(|pair| pair.ratio);
    let met = |value: Option<f64>, wanted: f64| value.map(|value| value >= wanted);
    Reached {
        goal: goal.to_owned(),
        ours: ours.to_owned(),
        cases: pairs.len(),
        unjudged: pairs.iter().filter(|pair| !pair.judged).count(),
        only_ours: 0,
        only_theirs: 0,
        geometric_mean,
        wanted_mean: wanted[0],
        mean_met: met(geometric_mean, wanted[0]),
        worst,
        worst_case: least.map_or_else(String::new, |pair| pair.case.to_owned()),
        worst_engine: least.map_or_else(String::new, |pair| pair.engine.to_owned()),
        wanted_worst: wanted[1],
        worst_met: met(worst, wanted[1]),
    }
}

#[cfg(test)]
#[path = "goals_tests.rs"]
mod tests;
