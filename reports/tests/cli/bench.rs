//! `arcsum bench`: its tables and page, engines that are wrong or give no sum, and runs that are stopped.

use super::resume::signal;
use super::tables::{Row, rows};
use super::{Place, arcsum, code, errors, run, square};
use rustix::process::Signal;
use std::process::Stdio;
use std::time::{Duration, Instant};

/// Times engines on cases into the folder `out`; the rows of `timing.csv`.
fn timed(place: &Place, cases: &[&str], engines: &[&str], more: &[&str]) -> Vec<Row> {
    let out = place.text("out");
    let engines: Vec<&str> = engines.iter().flat_map(|engine| ["--engine", engine]).collect();
    let output = run(&[&["bench", "--runs", "3", "--out", &out], cases, &engines, more].concat());
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    rows(place, "out/timing.csv")
}

fn page(place: &Place) -> String {
    std::fs::read_to_string(place.path("out/bench.html")).unwrap()
}

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column} of {row:?}"))
}

#[test]
fn engines_are_timed_on_the_same_cases_and_found_right() {
    let place = Place::new();
    let file = place.file("square.json", &square(1.0));
    let engines = ["convex", "monotonic", "kinetic"];
    let found = timed(&place, &[&file, "fork_2"], &engines, &[]);
    assert_eq!(found.iter().map(|row| row["engine"].as_str()).collect::<Vec<_>>(), [engines, engines].concat());
    for row in &found {
        assert_eq!([&row["status"], &row["correct"], &row["runs"]], ["ok", "true", "3"], "{row:?}");
        assert!(!row["to_first"].is_empty() && !row["cells"].is_empty() && number(row, "mu_hi") < 1e-12);
        assert!(number(row, "min_ms") > 0.0 && number(row, "min_ms") <= number(row, "median_ms"));
        assert!(number(row, "to_first_min") <= number(row, "to_first"));
        assert!(number(row, "to_first") <= number(row, "to_first_max"));
        let stages: f64 = ["t_convolution", "t_arrangement", "t_extraction"].map(|t| number(row, t)).iter().sum();
        assert!(stages > 0.5 * number(row, "min_ms"), "{row:?}");
    }
    assert!(found.iter().filter(|row| row["engine"] == "convex").all(|row| row["to_first_max"] == "1.0"));
    let comparison = rows(&place, "out/comparison.csv");
    assert_eq!(comparison.iter().map(|row| row["engine"].as_str()).collect::<Vec<_>>(), engines[1..]);
    assert!(comparison.iter().all(|row| row["first"] == "convex" && row["cases"] == "2" && row["wrong"] == "0"));
    assert!(rows(&place, "out/goals.csv").iter().all(|row| row["ours"] == "convex" && row["cases"] == "0"));
    assert!(page(&place).contains("No result was found wrong"));
}

/// Planted: an engine that answers the unit square in no time.
#[test]
fn a_wrong_engine_is_marked_and_counts_in_no_mean() {
    let place = Place::new();
    let wrong = place.engine("wrong", &format!("echo '{}'", square(1.0)));
    let found = timed(&place, &["fork_2"], &["kinetic", &wrong], &[]);
    assert_eq!([&found[0]["correct"], &found[1]["correct"]], ["true", "false"]);
    assert_eq!(found[1]["status"], "ok");
    assert!(number(&found[1], "mu_hi") > 0.1 && !found[1]["to_first"].is_empty());
    assert_eq!(rows(&place, "out/comparison.csv").len(), 0, "nothing is left to compare");
    let page = page(&place);
    assert!(page.contains("1 wrong") && page.contains(">wrong</span>"));
}

/// Planted: engines that die, hang, and answer something else, and one that is right but never says the same twice.
#[test]
fn engines_without_a_sum_have_rows_that_say_why() {
    let place = Place::new();
    let dies = place.engine("dies", "exit 3");
    let hangs = place.engine("hangs", "sleep 60");
    let talks = place.engine("talks", "echo '{\"loops\": \"none\"}'");
    let engines = ["kinetic", &dies, &hangs, &talks];
    let found = timed(&place, &["fork_1", "fork_2"], &engines, &["--time-limit", "5"]);
    let fates: Vec<&str> = found.iter().map(|row| row["status"].as_str()).collect();
    let again = ["ok", "crashed", "too slow", "invalid"];
    assert_eq!(fates, [["ok", "crashed", "timeout", "invalid"], again].concat());
    for row in found.iter().filter(|row| row["status"] != "ok") {
        assert!(row["to_first"].is_empty() && row["median_ms"].is_empty() && row["correct"].is_empty(), "{row:?}");
        assert!(!row["note"].is_empty());
    }
    let page = page(&place);
    for words in ["2 crashed", "1 timeout", "1 too slow", "2 invalid"] {
        assert!(page.contains(words), "{words}");
    }
}

#[test]
fn answers_that_change_are_not_taken_for_right() {
    let place = Place::new();
    let side = format!("n=$(($(cat {0} 2>/dev/null || echo 0) + 1)); echo $n > {0}", place.text("count"));
    let turning =
        place.engine("turning", &format!("{side}; echo '{}'", square(1.0).replace("\"x\":0,", "\"x\":0.'$n',")));
    let found = timed(&place, &["fork_1"], &["kinetic", &turning], &[]);
    assert_eq!(found[1]["correct"], "");
    assert!(found[1]["note"].contains("not always"), "{:?}", found[1]);
}

#[test]
fn large_arrangements_are_left_out_on_larger_cases_of_the_family_too() {
    let place = Place::new();
    let found = timed(&place, &["fork_1", "fork_2", "fork_3", "combs_2"], &["monotonic"], &["--max-vertices", "100"]);
    let fates: Vec<&str> = found.iter().map(|row| row["status"].as_str()).collect();
    assert_eq!(fates, ["ok", "too large", "too large", "ok"]);
    assert!(found[2]["note"].contains("of the family"));
}

#[test]
fn slow_engines_run_once_and_are_not_asked_for_more() {
    let place = Place::new();
    let lazy = place.engine("lazy", &format!("echo x >> {}; sleep 0.4; echo '{}'", place.text("asked"), square(2.0)));
    let file = place.file("square.json", &square(1.0));
    let found = timed(&place, &[&file, "fork_1", "fork_2"], &["kinetic", &lazy], &["--slow", "0.2"]);
    let of_lazy: Vec<&Row> = found.iter().filter(|row| row["engine"] != "kinetic").collect();
    let fates: Vec<&str> = of_lazy.iter().map(|row| row["status"].as_str()).collect();
    assert_eq!(fates, ["ok", "ok", "too slow"]);
    assert!(of_lazy[..2].iter().all(|row| row["runs"] == "1" && number(row, "median_ms") > 300.0));
    // Each look asks twice: to wake the program up, then for the sum.
    assert_eq!(std::fs::read_to_string(place.path("asked")).unwrap().lines().count(), 2 * 2);
}

#[test]
fn a_stopped_run_keeps_what_it_has() {
    let place = Place::new();
    let out = place.text("out");
    let lazy = place.engine("lazy", &format!("sleep 0.3; echo '{}'", square(2.0)));
    let mut child = arcsum(&["bench", "combs", "fork", "--engine", "kinetic", "--engine", &lazy, "--out", &out])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let deadline = Instant::now() + Duration::from_secs(60);
    while !place.path("out/timing.csv").is_file() {
        assert!(Instant::now() < deadline && child.try_wait().unwrap().is_none());
        std::thread::sleep(Duration::from_millis(10));
    }
    signal(&child, Signal::INT);
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let kept = rows(&place, "out/timing.csv");
    assert!(!kept.is_empty() && kept.len().is_multiple_of(2) && kept.len() < 12, "{kept:?}");
    assert_eq!(rows(&place, "out/goals.csv").len(), 8);
    assert!(!place.path("out/bench.html").exists());
    assert_eq!(code(&run(&["bench", "--page", "--out", &out])), 0);
    assert!(page(&place).contains(&kept[0]["case"]));
}

#[test]
fn memory_grows_with_the_case() {
    let place = Place::new();
    let found = timed(&place, &["fork_2", "fork_13"], &["kinetic"], &["--time-limit", "20"]);
    if found[0]["peak_mb"].is_empty() {
        eprintln!("skipped: this system does not tell");
        return;
    }
    // An arrangement of over 100,000 vertices takes more than 5 MB, one of some hundreds far less.
    let [small, large] = [0, 1].map(|i| number(&found[i], "peak_mb"));
    assert!(small < 5.0 && large > 5.0 && large < 1000.0, "{small} {large}");
}

#[test]
fn without_valgrind_no_instructions_are_counted() {
    let place = Place::new();
    let out = place.text("out");
    let mut command = arcsum(&["bench", "fork_1", "--engine", "kinetic", "--instructions", "--out", &out]);
    let output = command.env("PATH", place.text("nowhere")).output().unwrap();
    assert_eq!(code(&output), 0);
    assert!(errors(&output).iter().any(|line| line.contains("valgrind is not installed")), "{:?}", errors(&output));
    assert_eq!(rows(&place, "out/timing.csv")[0]["instructions"], "");
}

#[test]
fn instructions_are_those_of_one_sum() {
    let place = Place::new();
    let wrong = place.engine("wrong", &format!("echo '{}'", square(1.0)));
    let engines = ["kinetic", "naive-kinetic", &wrong];
    let found = timed(&place, &["fork_1", "fork_3"], &engines, &["--instructions"]);
    if std::process::Command::new("valgrind").arg("--version").output().is_err() {
        eprintln!("skipped: valgrind is not installed");
        return;
    }
    let [small, large] = [0, 3].map(|i| number(&found[i], "instructions"));
    assert!(small > 1e4 && large > 4.0 * small && large < 1e9, "{small} {large}");
    assert_eq!([0, 3].map(|i| number(&found[i], "instructions_to_first")), [1.0, 1.0]);
    let naive = number(&found[4], "instructions_to_first");
    assert!(naive > 0.1 && naive < 1.0, "the robustness steps cost something: {naive}");
    assert!(found[2]["instructions"].is_empty(), "a program of its own is not counted");
}
