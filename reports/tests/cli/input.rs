//! Bad input ends in one sentence and exit code 2, with nothing written.

use super::{Place, arcsum, code, column, errors, run, square};

/// Files that hold no region, with a word their sentence must have.
fn bad_files(place: &Place) -> Vec<(String, &'static str)> {
    let missing = place.text("missing.json");
    let broken = place.file("broken.json", "{\"loops\": [[{\"x\": 0,");
    let empty = place.file("empty.json", r#"{"loops": []}"#);
    let tie = r#"{"loops":[[{"x":0,"y":0},{"x":4,"y":4},{"x":4,"y":0},{"x":0,"y":4}]]}"#;
    let chord = r#"{"loops":[[{"x":0,"y":0,"radius":1},{"x":4,"y":0},{"x":4,"y":4}]]}"#;
    vec![
        (missing, "missing.json"),
        (broken, "broken.json"),
        (empty, "empty.json"),
        (place.file("tie.json", tie), "tie.json"),
        (place.file("chord.json", chord), "chord.json"),
    ]
}

#[test]
fn sum_refuses_bad_regions() {
    let place = Place::new();
    let good = place.file("good.json", &square(1.0));
    let out = place.text("out.json");
    for (bad, name) in bad_files(&place) {
        for pair in [[&bad, &good], [&good, &bad]] {
            let output = run(&["sum", pair[0], pair[1], "-o", &out]);
            let lines = errors(&output);
            assert_eq!(code(&output), 2, "{lines:?}");
            assert!(lines.len() == 1 && lines[0].contains(name), "{lines:?}");
            assert!(output.stdout.is_empty() && !place.path("out.json").exists());
        }
    }
}

#[test]
fn verify_lists_bad_files_and_measures_the_others() {
    let place = Place::new();
    place.file("set/good.json", &square(1.0));
    place.file("set/bad.json", r#"{"loops": []}"#);
    place.file("set/worse.json", "loops");
    let engine = place.engine("same.sh", &format!("echo '{}'", square(2.0)));
    let output = run(&["verify", &place.text("set"), "--engine", &engine, "--out", &place.text("out")]);
    let named = |word: &str| errors(&output).iter().filter(|l| l.starts_with("arcsum: ") && l.contains(word)).count();
    assert_eq!((code(&output), named("bad.json"), named("worse.json")), (2, 1, 1), "{:?}", errors(&output));
    assert_eq!(column(&place.path("out"), "case"), ["set/good_negative"]);
}

#[test]
fn verify_writes_nothing_when_no_case_is_left() {
    let place = Place::new();
    place.file("set/bad.json", r#"{"loops": []}"#);
    let set = place.text("set");
    let out = place.text("out");
    for arguments in [
        vec!["verify", &set, "--out", &out],
        vec!["verify", "no_such_family", "--out", &out],
        vec!["verify", "fork", "--max-segments", "3", "--out", &out],
        vec!["verify", "fork", "--engine", "nobody", "--out", &out],
    ] {
        let output = run(&arguments);
        assert_eq!(code(&output), 2, "{arguments:?}: {:?}", errors(&output));
        assert!(!errors(&output).is_empty() && !place.path("out").exists());
    }
}

#[test]
fn pairs_are_read_from_the_parent_and_names_stay_unique() {
    let place = Place::new();
    for (name, side) in [("a", 1.0), ("b", 2.0), ("c", 3.0)] {
        place.file(&format!("data/set/{name}.json"), &square(side));
    }
    place.file("data/pairs.csv", "family,case,A,B,golden\nset,one,set/a.json,set/b.json,\nset,two,set/a.json,set/c.json,set/b.json\nother,x,other/a.json,other/b.json,\n");
    let engine = place.engine("same.sh", &format!("echo '{}'", square(2.0)));
    let output = run(&["verify", &place.text("data/set"), "--engine", &engine, "--out", &place.text("out")]);
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let wanted = ["set/one", "set/two", "set/a_negative", "set/b_negative", "set/c_negative"];
    assert_eq!(column(&place.path("out"), "case"), wanted);
}

#[test]
fn files_meet_their_negative_and_the_next() {
    let place = Place::new();
    let files = ["a", "b"].map(|n| place.file(&format!("{n}.json"), &square(1.0)));
    let engine = place.engine("same.sh", &format!("echo '{}'", square(2.0)));
    let output = run(&["verify", &files[0], &files[1], "--engine", &engine, "--out", &place.text("out")]);
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    assert_eq!(column(&place.path("out"), "case"), ["files/a_negative", "files/b_negative", "files/a+b"]);
}

#[test]
fn a_wrong_command_line_is_exit_code_2() {
    for arguments in [vec!["verify", "--threads", "0"], vec!["sum"], vec!["verify", "--time-limit", "-1"]] {
        assert_eq!(code(&arcsum(&arguments).output().unwrap()), 2, "{arguments:?}");
    }
}
