//! The charts read back: what their marks say must be what the rows say.

use crate::page::folder::Entry;
use crate::page::{cumulative, histogram, sample, scatter};
use proptest::prelude::*;

/// Rows with these bits; none, exact and negative bits are rows like others.
fn rows(bits: &[Option<f64>]) -> Vec<Entry> {
    sample::entries(&bits.iter().map(|b| b.map(|b| (-b).exp2())).collect::<Vec<_>>())
}

/// The part of `html` from the first `start` to the next `end`.
fn between<'a>(html: &'a str, start: &str, end: &str) -> &'a str {
    let from = html.find(start).unwrap() + start.len();
    &html[from..from + html[from..].find(end).unwrap()]
}

/// The `V` ordinates of a path of steps.
fn steps(data: &str) -> Vec<f64> {
    data.split('V').skip(1).map(|rest| rest.split(['H', 'M']).next().unwrap().parse().unwrap()).collect()
}

#[test]
fn curve_begins_with_the_rows_without_bits_and_counts_all_below() {
    let html = cumulative::html(&rows(&[None, Some(50.0), None, Some(52.0), Some(50.0)]), &["kinetic"]);
    let data = between(&html, "class=\"line s0\" stroke-dasharray=\"none\" d=\"", "\"");
    let height = |count: f64| 264.0 - (count.log10() + 0.15) / (5.0_f64.log10() + 0.15) * 242.0;
    let start: f64 = between(data, "M46 ", "H").parse().unwrap();
    let expected = [(start, 2.0), (steps(data)[0], 4.0), (steps(data)[1], 5.0)];
    assert_eq!(steps(data).len(), 2);
    for (y, count) in expected {
        assert!((y - height(count)).abs() < 0.01, "{y} for {count} rows: {data}");
    }
}

#[test]
fn curve_without_failures_begins_on_the_floor() {
    let html = cumulative::html(&rows(&[Some(50.0), Some(51.0)]), &["kinetic"]);
    let data = between(&html, "class=\"line s0\" stroke-dasharray=\"none\" d=\"", "\"");
    assert!(data.starts_with('M') && data.contains(" 264V"), "{data}");
}

#[test]
fn scatter_counts_what_it_does_not_show() {
    let mut entries = rows(&[None, Some(50.0), Some(f64::INFINITY), Some(30.0), Some(40.0)]);
    entries[1].row.sums = None;
    let html = scatter::html(&entries, &["kinetic"]);
    assert!(html.contains("2 rows without bits or without a convolution not shown"));
    let dots = between(&html, "<path class=\"dot s0\" d=\"", "\"");
    assert_eq!(dots.matches('M').count(), 3);
    assert!(html.contains("<a href=\"#r4\" aria-label=\"row 4\"><circle"));
    entries.iter_mut().for_each(|e| e.row.sums = None);
    assert!(scatter::html(&entries, &["kinetic"]).contains("no chart"));
}

proptest! {
    /// The bars of a histogram name every row once.
    #[test]
    fn bars_name_every_row(bits in prop::collection::vec(prop::option::of(-20.0..90.0_f64), 1..60), exact in 0..5_usize) {
        let mut entries = rows(&bits);
        entries.extend(rows(&vec![Some(f64::INFINITY); exact]));
        let html = histogram::html(&entries, &["kinetic"]);
        let named = html.split("<title>").skip(1).map(|rest| between(rest, ": ", " row").parse::<usize>().unwrap());
        prop_assert_eq!(named.sum::<usize>(), entries.len());
        let expected = format!("no bits: {} row", bits.iter().filter(|b| b.is_none()).count());
        prop_assert_eq!(html.contains(&expected), bits.iter().any(Option::is_none));
    }
}
