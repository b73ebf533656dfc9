//! Witnesses measured again.

use super::{Place, code, errors, run, square};

/// The witness of an engine that answers every case with a square.
fn witness(place: &Place) -> String {
    let engine = place.engine("same.sh", &format!("echo '{}'", square(2.0)));
    run(&["verify", "passage_0", "--engine", &engine, "--out", &place.text("out")]);
    place.text("out/witnesses/0001.json")
}

#[test]
fn a_witness_holds_until_the_engine_changes() {
    let place = Place::new();
    let file = witness(&place);
    let output = run(&["replay", &file]);
    assert_eq!(code(&output), 0, "{output:?}");
    place.engine("same.sh", "exit 1");
    let output = run(&["replay", &file]);
    assert_eq!(code(&output), 1, "{output:?}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("no longer holds"));
}

#[test]
fn a_witness_whose_number_was_touched_no_longer_holds() {
    let place = Place::new();
    let file = witness(&place);
    let mut value: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
    let hi = value["measured"]["mu_hi"].as_f64().unwrap();
    value["measured"]["mu_lo"] = (hi / 4.0).into();
    value["measured"]["mu_hi"] = (hi / 2.0).into();
    std::fs::write(&file, value.to_string()).unwrap();
    assert_eq!(code(&run(&["replay", &file])), 1);
}

#[test]
fn a_file_that_is_no_witness_is_bad_input() {
    let place = Place::new();
    for file in [place.text("missing.json"), place.file("square.json", &square(1.0))] {
        let output = run(&["replay", &file]);
        assert_eq!((code(&output), errors(&output).len()), (2, 1), "{output:?}");
    }
}
