//! The tables of `iterate`.

use super::{Place, code, errors, run, square};
use std::collections::BTreeMap;

/// A row by its columns.
pub type Row = BTreeMap<String, String>;

/// The rows of a table.
pub fn rows(place: &Place, file: &str) -> Vec<Row> {
    csv::Reader::from_path(place.path(file)).unwrap().deserialize().collect::<Result<_, _>>().unwrap()
}

fn half_disc() -> &'static str {
    r#"{"loops": [[{"x": -1, "y": 0}, {"x": 1, "y": 0, "bulge": 1}]]}"#
}

#[test]
fn chains_of_polygons_and_of_arcs_are_measured() {
    let place = Place::new();
    let files = [place.file("square.json", &square(1.0)), place.file("half.json", half_disc())];
    let out = place.text("out");
    let output = run(&["iterate", &files[0], &files[1], "--engine", "monotonic", "--depth", "3", "--out", &out]);
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let rows = rows(&place, "out/iterated.csv");
    let [chains, steps] = ["chain", "steps"].map(|name| rows.iter().filter(|row| row["reference"] == name).count());
    assert!(chains >= 3 && steps >= 3 && chains + steps == rows.len(), "{rows:?}");
    for row in rows {
        assert_eq!(row["status"], "ok", "{row:?}");
        let [lo, hi] = ["mu_lo", "mu_hi"].map(|name| row[name].parse::<f64>().unwrap());
        assert!(lo <= hi && hi < 1e-14, "{row:?}");
    }
}

/// Planted: an engine that always answers the unit square.
#[test]
fn a_wrong_chain_is_seen() {
    let place = Place::new();
    let files = place.file("half.json", half_disc());
    let engine = place.engine("stuck", &format!("echo '{}'", square(1.0).replace('\n', " ")));
    let out = place.text("out");
    let output = run(&["iterate", &files, "--engine", &engine, "--depth", "2", "--out", &out]);
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let rows = rows(&place, "out/iterated.csv");
    assert!(rows[0]["mu_lo"].parse::<f64>().unwrap() > 0.1, "{rows:?}");
}

/// Steps that no reference can decide in the time given say so, and the chain ends.
#[test]
fn what_takes_too_long_is_undecided() {
    let place = Place::new();
    let out = place.text("out");
    let output =
        run(&["iterate", "parts_3", "--engine", "monotonic", "--depth", "2", "--time-limit", "0.001", "--out", &out]);
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let rows = rows(&place, "out/iterated.csv");
    assert!(
        !rows.is_empty() && rows.iter().all(|row| row["status"] == "undecided" && row["mu_hi"].is_empty()),
        "{rows:?}"
    );
}
