//! `claims` and `attack`: verdicts, files, witnesses that can be measured again, and runs that go on.

use super::{Place, code, errors, run};
use std::fs;

fn said(output: &std::process::Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn claims_end_in_a_table_a_page_and_witnesses() {
    let place = Place::new();
    let out = place.text("out");
    let output = run(&["claims", "m12", "M36", "--out", &out]);
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let text = said(&output);
    assert!(
        text.contains("3 claims: 1 confirmed, 1 refuted, 0 undecided, 1 not tested; 1 of 1 controls refuted"),
        "{text}"
    );
    let table = fs::read_to_string(place.path("out/claims.csv")).unwrap();
    assert!(table.starts_with("id,verdict,quantity,measured,"), "{table}");
    assert!(table.lines().any(|line| line.starts_with("M12 printed,refuted,")), "{table}");
    let page = fs::read_to_string(place.path("out/claims.html")).unwrap();
    assert!(page.contains("M12 printed"));
    fs::remove_file(place.path("out/claims.html")).unwrap();
    assert_eq!(code(&run(&["claims", "--page", "--out", &out])), 0);
    assert_eq!(fs::read_to_string(place.path("out/claims.html")).unwrap(), page);
    let again = run(&["replay", &place.text("out/witnesses/M12_printed.json")]);
    assert_eq!(code(&again), 0, "{:?}", errors(&again));
    assert!(said(&again).ends_with("holds\n"));
    let witness = place.path("out/witnesses/M12_printed.json");
    let better =
        fs::read_to_string(&witness).unwrap().replace("\"hi\":3.", "\"hi\":2.").replace("\"lo\":3.", "\"lo\":2.");
    assert_eq!(code(&run(&["replay", &place.file("better.json", &better)])), 1);
}

#[test]
fn the_same_seed_gives_the_same_table_for_any_number_of_threads() {
    let place = Place::new();
    let table = |name: &str, threads: &str| {
        let out = place.text(name);
        assert_eq!(code(&run(&["claims", "M11", "M12", "--threads", threads, "--seed", "7", "--out", &out])), 0);
        fs::read_to_string(place.path(name).join("claims.csv")).unwrap()
    };
    let one = table("one", "1");
    assert_eq!(one, table("two", "2"));
    // Resuming takes what is there: a record put there by hand survives, and with another seed it does not.
    let record = place.path("one/claims/M12_printed.json");
    fs::write(&record, fs::read_to_string(&record).unwrap().replace("\"cases\":", "\"cases\":1")).unwrap();
    let out = place.text("one");
    let table = || fs::read_to_string(place.path("one/claims.csv")).unwrap();
    assert_eq!(code(&run(&["claims", "M11", "M12", "--seed", "7", "--resume", "--out", &out])), 0);
    assert_ne!(table(), one);
    assert_eq!(code(&run(&["claims", "M11", "M12", "--seed", "7", "--out", &out])), 0);
    assert_eq!(table(), one);
}

#[test]
fn an_attack_leaves_its_worst_inputs() {
    let place = Place::new();
    let [out, keep] = ["out", "keep"].map(|name| place.text(name));
    let output = run(&["attack", "M12_printed", "--for", "1s", "--threads", "1", "--keep", &keep, "--out", &out]);
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let text = fs::read_to_string(place.path("out/worst/M12_printed.json")).unwrap();
    assert_eq!(text, fs::read_to_string(place.path("keep/M12_printed.json")).unwrap());
    let worst: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(worst[0]["lo"].as_f64().unwrap() > 3.9, "{text}");
}

#[test]
fn what_is_no_claim_is_told_in_a_sentence() {
    let place = Place::new();
    let nowhere = place.text("nowhere");
    for arguments in
        [&["claims", "M99"][..], &["attack", "M99"], &["attack", "M36"], &["claims", "--page", "--out", &nowhere]]
    {
        let output = run(arguments);
        assert_eq!((code(&output), errors(&output).len()), (2, 1), "{arguments:?}");
    }
}
