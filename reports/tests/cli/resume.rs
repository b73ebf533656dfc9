//! Interrupted runs: killed or told to stop, the files stay sound, nobody is left behind, and `--resume` ends where an
//! uninterrupted run does.

use super::engines::gone;
use super::{Place, arcsum, code, errors, rows, run, square};
use rustix::process::{Pid, Signal, kill_process};
use std::path::Path;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

const CASES: [&str; 4] = ["twoopt_5", "orthogonal", "passage", "far"];

/// An engine that writes down its process and takes its time.
fn slow(place: &Place) -> String {
    place.engine("slow.sh", &format!("echo $$ >> {}; sleep 0.1; echo '{}'", place.text("pids"), square(2.0)))
}

fn started(engine: &str, out: &str) -> Child {
    let mut command = arcsum(&["verify", "--threads", "2", "--engine", engine, "--out", out]);
    command.args(CASES).stderr(Stdio::null()).spawn().unwrap()
}

/// Waits until the journal has this many rows.
fn wait_for_rows(journal: &Path, count: usize) {
    let deadline = Instant::now() + Duration::from_secs(30);
    let lines = || std::fs::read_to_string(journal).map_or(0, |t| t.lines().count());
    while lines() < count + 1 {
        assert!(Instant::now() < deadline, "no {count} rows in time");
        std::thread::sleep(Duration::from_millis(10));
    }
}

pub fn signal(child: &Child, signal: Signal) {
    let pid = i32::try_from(child.id()).ok().and_then(Pid::from_raw).unwrap();
    kill_process(pid, signal).unwrap();
}

fn all_gone(place: &Place) {
    for pid in std::fs::read_to_string(place.path("pids")).unwrap().lines() {
        assert!(gone(pid), "process {pid} still runs");
    }
}

/// Resumes the run in `out` and compares it with one that nobody disturbed.
fn same_as_undisturbed(place: &Place, engine: &str) {
    let done: Vec<String> =
        std::fs::read_to_string(place.path("out/journal.jsonl")).unwrap().lines().map(str::to_owned).collect();
    let common = ["--threads", "2", "--engine", engine, "--out"];
    let resumed = run(&[&["verify"], &CASES[..], &common, &[&place.text("out"), "--resume"]].concat());
    assert_eq!(code(&resumed), 0, "{:?}", errors(&resumed));
    // What was measured before is not measured again.
    let journal = std::fs::read_to_string(place.path("out/journal.jsonl")).unwrap();
    assert!(done[..done.len() - 1].iter().zip(journal.lines()).all(|(old, new)| old == new));
    run(&[&["verify"], &CASES[..], &common, &[&place.text("whole")]].concat());
    assert_eq!(rows(&place.path("out")), rows(&place.path("whole")));
    let names = |folder: &str| {
        let mut names: Vec<_> =
            std::fs::read_dir(place.path(folder)).unwrap().map(|e| e.unwrap().file_name()).collect();
        names.sort();
        names
    };
    assert_eq!(names("out/witnesses"), names("whole/witnesses"));
    assert_eq!(names("out/cases"), names("whole/cases"));
}

#[test]
fn a_killed_run_goes_on_to_the_same_result() {
    let place = Place::new();
    let engine = slow(&place);
    let mut child = started(&engine, &place.text("out"));
    wait_for_rows(&place.path("out/journal.jsonl"), 3);
    signal(&child, Signal::KILL);
    child.wait().unwrap();
    all_gone(&place);
    same_as_undisturbed(&place, &engine);
}

#[test]
fn an_interrupted_run_ends_with_130_and_goes_on() {
    let place = Place::new();
    let engine = slow(&place);
    let mut child = started(&engine, &place.text("out"));
    wait_for_rows(&place.path("out/journal.jsonl"), 3);
    signal(&child, Signal::INT);
    assert_eq!(child.wait().unwrap().code(), Some(130));
    all_gone(&place);
    assert!(rows(&place.path("out")).len() >= 3);
    same_as_undisturbed(&place, &engine);
}

#[test]
fn another_run_is_not_resumed() {
    let place = Place::new();
    let engine = place.engine("same.sh", &format!("echo '{}'", square(2.0)));
    let out = place.text("out");
    run(&["verify", "passage_0", "--engine", &engine, "--out", &out]);
    let before = rows(&place.path("out"));
    let output = run(&["verify", "fork_2", "--engine", &engine, "--out", &out, "--resume"]);
    assert_eq!(code(&output), 2, "{:?}", errors(&output));
    assert_eq!(rows(&place.path("out")), before);
}
