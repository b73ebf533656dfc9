//! CGAL's engines from outside: rows like any other, a sentence where CGAL is missing, and no end of a run.

use super::{Place, code, column, errors, run, square};

const ENGINES: [&str; 2] = ["--engine", "cgal:reduced:exact"];

/// A square plate with square holes, `[x, y, side]` each.
fn plate(side: f64, holes: &[[f64; 3]]) -> String {
    let hole = |[x, y, s]: &[f64; 3]| {
        let (x1, y1) = (x + s, y + s);
        format!(r#",[{{"x":{x},"y":{y}}},{{"x":{x},"y":{y1}}},{{"x":{x1},"y":{y1}}},{{"x":{x1},"y":{y}}}]"#)
    };
    let holes: String = holes.iter().map(hole).collect();
    square(side).replace("]]", &format!("]{holes}]"))
}

#[test]
fn cgal_is_measured_or_said_to_be_missing() {
    let place = Place::new();
    place.file("set/plate.json", &plate(9.0, &[[2.0, 2.0, 5.0]]));
    place.file("set/part.json", &square(1.0));
    place.file("pairs.csv", "family,case,A,B\nset,two,set/plate.json,set/part.json\n");
    let out = place.text("out");
    let output = run(&[&["verify", &place.text("set"), "--out", &out], &ENGINES[..]].concat());
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let first = |name: &str| column(&place.path("out"), name)[0].clone();
    if arcsum_cgal::built_in() {
        assert_eq!([first("status"), first("bits"), first("exact_loops")], ["ok", "inf", "2"]);
        assert_eq!(first("failed_checks"), "none");
    } else {
        assert_eq!([first("status"), first("note")], ["invalid", "CGAL is not built in"]);
    }
}

/// CGAL 5.5.1 breaks a list of its own when several holes are too small for the part (CGAL issue 5839): whatever becomes of
/// the first case, the second one is measured.
#[test]
fn what_harms_cgal_is_a_row() {
    let place = Place::new();
    place.file("set/bad.json", &plate(50.0, &[[10.0, 10.0, 30.0], [2.0, 2.0, 1.0], [6.0, 2.0, 1.0]]));
    place.file("set/good.json", &plate(50.0, &[[10.0, 10.0, 30.0]]));
    place.file("set/part.json", &square(2.0));
    let pairs = "set,bad,set/bad.json,set/part.json\nset,good,set/good.json,set/part.json\n";
    place.file("pairs.csv", &format!("family,case,A,B\n{pairs}"));
    let out = place.text("out");
    let output = run(&[&["verify", &place.text("set"), "--out", &out, "--time-limit", "20"], &ENGINES[..]].concat());
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let (cases, statuses) = (column(&place.path("out"), "case"), column(&place.path("out"), "status"));
    let good = cases.iter().position(|case| case.ends_with("good")).unwrap();
    assert_eq!(statuses[good], if arcsum_cgal::built_in() { "ok" } else { "invalid" });
}

#[test]
fn a_sum_by_cgal_is_printed() {
    let place = Place::new();
    let part = place.file("part.json", &square(2.0));
    let output = run(&["sum", &part, &part, "--engine", "cgal:reduced:exact"]);
    assert_eq!(code(&output) == 0, arcsum_cgal::built_in(), "{:?}", errors(&output));
    let sentence = errors(&output).concat();
    assert!(arcsum_cgal::built_in() || sentence.contains("CGAL is not built in"), "{sentence}");
}
