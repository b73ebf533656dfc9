//! The arithmetic of goals on rows made by hand.

use super::*;
use crate::bench::fate::Fate;
use proptest::prelude::*;

const EXACT: [&str; 2] = ["cgal:reduced:exact", "cgal:vertical:exact"];

fn row(case: &str, engine: &str, to_first: f64) -> Timing {
    Timing {
        case: case.into(),
        engine: engine.into(),
        polygonal: true,
        median_ms: Some(to_first),
        to_first: Some(to_first),
        correct: Some(true),
        ..Timing::default()
    }
}

fn of(rows: &[Timing], goal: usize) -> Reached {
    reached(rows, "ours").swap_remove(goal)
}

#[test]
fn the_best_exact_strategy_that_is_not_wrong_counts() {
    let wrong = Timing { correct: Some(false), ..row("p", "cgal:greene:exact", 0.1) };
    let rows = [
        row("p", "ours", 1.0),
        row("p", EXACT[0], 90.0),
        row("p", EXACT[1], 40.0),
        wrong,
        row("p", "cgal:reduced:inexact", 2.0),
        row("q", "ours", 1.0),
        row("q", EXACT[0], 10.0),
        Timing { status: Fate::Timeout, to_first: None, ..row("q", EXACT[1], 0.0) },
        row("theirs alone", EXACT[0], 1.0),
    ];
    let it = of(&rows, 0);
    assert_eq!((it.cases, it.unjudged), (2, 0));
    assert!((it.geometric_mean.unwrap() - 20.0).abs() < 1e-12);
    assert_eq!((it.mean_met, it.worst, it.worst_met), (Some(false), Some(10.0), Some(true)));
    assert_eq!((it.worst_case.as_str(), it.worst_engine.as_str()), ("q", EXACT[0]));
    let inexact = of(&rows, 1);
    assert_eq!((inexact.cases, inexact.geometric_mean, inexact.mean_met), (1, Some(2.0), Some(false)));
}

#[test]
fn cases_that_only_one_side_came_through_are_counted_apart() {
    let lost = |row: Timing| Timing { status: Fate::Crashed, to_first: None, ..row };
    let rows = [
        row("p", "ours", 1.0),
        lost(row("p", EXACT[0], 0.0)),
        row("p", EXACT[1], 2.0),
        row("q", "ours", 1.0),
        lost(row("q", EXACT[0], 0.0)),
        Timing { correct: Some(false), ..row("q", EXACT[1], 2.0) },
        lost(row("r", "ours", 0.0)),
        row("r", EXACT[0], 2.0),
        lost(row("s", "ours", 0.0)),
        lost(row("s", EXACT[0], 0.0)),
        row("never put to ours", EXACT[0], 2.0),
        row("never put to them", "ours", 1.0),
    ];
    let it = of(&rows, 0);
    assert_eq!((it.cases, it.only_ours, it.only_theirs), (1, 1, 1));
}

#[test]
fn a_goal_without_cases_is_neither_met_nor_missed() {
    let it = of(&[row("p", "ours", 1.0)], 2);
    assert_eq!((it.cases, it.geometric_mean, it.mean_met, it.worst_met), (0, None, None, None));
}

#[test]
fn cases_where_ours_is_wrong_do_not_count() {
    let ours = Timing { correct: Some(false), ..row("p", "ours", 1.0) };
    assert_eq!(of(&[ours, row("p", "i_overlay", 50.0)], 4).cases, 0);
    let nobody = Timing { correct: None, ..row("p", "ours", 1.0) };
    let it = of(&[nobody, row("p", "i_overlay", 50.0)], 4);
    assert_eq!((it.cases, it.unjudged, it.mean_met), (1, 1, Some(true)));
}

#[test]
fn cavalier_counts_where_it_is_right_to_nine_digits_and_flat_ones_on_arcs() {
    let cavalier = |mu| Timing { mu_hi: Some(mu), ..row("p", "cavalier", 0.4) };
    for (mu, cases) in [(1e-9, 1), (1.1e-9, 0)] {
        assert_eq!(of(&[row("p", "ours", 1.0), cavalier(mu)], 5).cases, cases);
    }
    let flat = |polygonal| Timing { polygonal, ..row("p", "clipper2:flat-1e-3", 6.0) };
    for (polygonal, cases) in [(false, 1), (true, 0)] {
        assert_eq!(of(&[row("p", "ours", 1.0), flat(polygonal)], 6).cases, cases);
    }
}

#[test]
fn sorting_is_compared_on_arrangements_of_its_sizes() {
    let ours =
        |case: &str, vertices, ratio| Timing { vertices: Some(vertices), ratio: Some(ratio), ..row(case, "ours", 1.0) };
    let rows =
        [ours("s", 9_999, 100.0), ours("p", 10_000, 10.0), ours("q", 1_000_000, 40.0), ours("t", 1_000_001, 1.0)];
    let it = of(&rows, GOALS.len());
    assert_eq!((it.cases, it.worst_case.as_str(), it.worst, it.mean_met), (2, "q", Some(1.0 / 40.0), Some(false)));
    assert!((it.geometric_mean.unwrap() - 0.05).abs() < 1e-12);
}

proptest! {
    /// The mean of a goal lies between its ratios, the worst is the least, and each is met as the numbers say.
    #[test]
    fn goals_are_what_the_ratios_say(ratios in proptest::collection::vec(1e-3_f64..1e3, 1..12)) {
        let mut rows = Vec::new();
        for (i, ratio) in ratios.iter().enumerate() {
            rows.extend([row(&i.to_string(), "ours", 1.0), row(&i.to_string(), "clipper2:union", *ratio)]);
        }
        let it = of(&rows, 3);
        let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
        let most = ratios.iter().copied().fold(0.0, f64::max);
        let mean = it.geometric_mean.unwrap();
        prop_assert!(least * (1.0 - 1e-12) <= mean && mean <= most * (1.0 + 1e-12));
        prop_assert_eq!((it.worst, it.worst_met), (Some(least), Some(least >= 0.8)));
        prop_assert_eq!(it.mean_met, Some(mean >= 2.0));
    }
}
