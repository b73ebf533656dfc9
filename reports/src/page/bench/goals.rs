//! The goals: how many times faster ours is than its peers, and whether that is enough.

use crate::bench::goals::Reached;
use crate::page::number;
use crate::page::table::{Cell, Table};

/// A row a goal.
pub fn html(reached: &[Reached]) -> String {
    let columns = [
        ("against", ""),
        ("cases", "timed on both, neither found wrong"),
        ("nobody looked", "cases among them where a result could not be judged"),
        ("only ours", "cases put to both that only ours came through, right and in time"),
        ("only theirs", "the other way round"),
        ("mean", "geometric mean of theirs by ours"),
        ("wanted", ""),
        ("", ""),
        ("worst", "least ratio of a case"),
        ("wanted", ""),
        ("", ""),
        ("in case", ""),
        ("theirs there", ""),
    ];
    let ours = reached.first().map_or("", |row| row.ours.as_str());
    let mut table = Table::new(&format!("How many times faster {ours} is"), columns);
    for row in reached {
        let [mean, worst] = [row.geometric_mean, row.worst].map(times);
        let [wanted_mean, wanted_worst] = [row.wanted_mean, row.wanted_worst].map(|wanted| times(Some(wanted)));
        let [mean_met, worst_met] = [row.mean_met, row.worst_met].map(verdict);
        let start = [Cell::text(&row.goal), Cell::count(row.cases), Cell::count(row.unjudged)];
        let apart = [Cell::count(row.only_ours), Cell::count(row.only_theirs)];
        let middle = [mean, wanted_mean, mean_met, worst, wanted_worst, worst_met];
        let end = [Cell::text(&row.worst_case), Cell::text(&row.worst_engine)];
        table.row(None, &start.into_iter().chain(apart).chain(middle).chain(end).collect::<Vec<_>>());
    }
    table.html()
}

fn times(value: Option<f64>) -> Cell {
    value.map_or_else(Cell::empty, |value| Cell::number(value, number::plain(value)))
}

fn verdict(met: Option<bool>) -> Cell {
    let (class, word) = match met {
        Some(true) => ("ok", "met"),
        Some(false) => ("refuted", "missed"),
        None => ("not-tested", "not measured"),
    };
    Cell::html(format!("<span class=\"badge {class}\">{word}</span>"))
}
