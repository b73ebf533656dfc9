//! `verify --samples` and the offsets of CGAL from outside.

use super::{Place, code, column, errors, run, square};

#[test]
fn sampled_rows_say_so_and_have_no_mu() {
    let place = Place::new();
    let out = place.text("out");
    let output = run(&["verify", "star_6", "--samples", "40", "--sample-all", "--out", &out]);
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let columns = |name: &str| column(&place.path("out"), name);
    assert!(!columns("status").is_empty() && columns("status").iter().all(|s| s == "sampled"));
    assert!(columns("mu_lo").iter().chain(&columns("mu_hi")).all(String::is_empty));
    assert!(columns("samples_failed").iter().all(|failed| failed == "0"));
    assert!(columns("sampled_mu").iter().all(|mu| mu.parse::<f64>().is_ok_and(|mu| mu > 0.0 && mu < 1e-14)));
}

/// Within the limits of the reference nothing is sampled.
#[test]
fn small_cases_keep_their_reference() {
    let place = Place::new();
    let out = place.text("out");
    assert_eq!(code(&run(&["verify", "star_6", "--samples", "--out", &out])), 0);
    assert!(column(&place.path("out"), "status").iter().all(|s| s == "ok"));
    assert!(column(&place.path("out"), "samples").iter().all(String::is_empty));
}

#[test]
fn offsets_are_measured_where_an_operand_is_a_disc() {
    let place = Place::new();
    place.file("set/square.json", &square(3.0));
    place.file("set/disc.json", r#"{"loops": [[{"x":-1,"y":0,"bulge":1},{"x":1,"y":0,"bulge":1}]]}"#);
    let pairs = "set,one,set/square.json,set/disc.json\nset,other,set/disc.json,set/square.json\n";
    place.file("pairs.csv", &format!("family,case,A,B\n{pairs}set,none,set/square.json,set/square.json\n"));
    let (out, set) = (place.text("out"), place.text("set"));
    let engines = ["--engine", "cgal:offset:exact", "--engine", "cgal:offset:approximate"];
    let output = run(&[&["verify", &set, "--out", &out], &engines[..]].concat());
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let columns = |name: &str| column(&place.path("out"), name);
    let status = if arcsum_cgal::built_in() { "ok" } else { "invalid" };
    assert!(columns("status").len() >= 4 && columns("status").iter().all(|s| s == status), "{:?}", columns("note"));
    for (engine, mu) in columns("engine").iter().zip(columns("mu_hi")).filter(|_| arcsum_cgal::built_in()) {
        let most = if engine == "cgal:offset:exact" { 1e-15 } else { 1e-9 };
        assert!(mu.parse::<f64>().is_ok_and(|mu| mu <= most), "{engine} {mu}");
    }
}
