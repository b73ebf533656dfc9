//! Engines that misbehave are rows, never the end of a run.

use super::{Place, code, column, errors, rows, run, square};
use std::time::{Duration, Instant};

#[test]
fn misbehaving_engines_are_rows() {
    let place = Place::new();
    let engines = [
        ("abort.sh", "kill -ABRT $$", "crashed"),
        ("leave.sh", "exit 3", "crashed"),
        ("hang.sh", "sleep 600", "timeout"),
        ("nonsense.sh", "echo hello", "invalid"),
        ("other.sh", r#"echo '{"area": 3}'"#, "invalid"),
        ("point.sh", r#"echo '{"loops":[[{"x":0,"y":0}]]}'"#, "invalid"),
        ("flood.sh", "while :; do printf xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx; done", "timeout"),
    ];
    let names: Vec<String> = engines.iter().map(|(name, each, _)| place.engine(name, each)).collect();
    let out = place.text("out");
    let mut arguments = vec!["verify", "orthogonal_6", "--out", &out, "--time-limit", "1"];
    names.iter().for_each(|name| arguments.extend(["--engine", name]));
    let output = run(&arguments);
    assert_eq!(code(&output), 0, "{:?}", errors(&output));
    let wanted: Vec<&str> = (0..3).flat_map(|_| engines.iter().map(|(_, _, status)| *status)).collect();
    assert_eq!(column(&place.path("out"), "status"), wanted);
    assert!(column(&place.path("out"), "note").iter().all(|note| !note.is_empty()));
    // Each failure leaves a witness.
    assert_eq!(std::fs::read_dir(place.path("out/witnesses")).unwrap().count(), wanted.len());
}

#[test]
fn a_hanging_engine_does_not_outlive_the_run() {
    let place = Place::new();
    let pid = place.text("pid");
    let engine = place.engine("hang.sh", &format!("echo $$ > {pid}; sleep 600"));
    let started = Instant::now();
    run(&["verify", "passage_0", "--engine", &engine, "--out", &place.text("out"), "--time-limit", "0.5"]);
    assert!(started.elapsed() < Duration::from_secs(30));
    let pid = std::fs::read_to_string(place.path("pid")).unwrap();
    assert!(gone(pid.trim()), "process {pid} still runs");
}

/// Whether the process ends within a few seconds.
pub(crate) fn gone(pid: &str) -> bool {
    let alive = || {
        let stat = std::fs::read_to_string(format!("/proc/{pid}/stat")).unwrap_or_default();
        // A zombie has ended; whoever inherited it will collect it.
        !stat.is_empty() && !stat.contains(") Z ")
    };
    let deadline = Instant::now() + Duration::from_secs(5);
    while alive() && Instant::now() < deadline {
        std::thread::sleep(Duration::from_millis(20));
    }
    !alive()
}

#[test]
fn results_do_not_depend_on_the_number_of_threads() {
    let place = Place::new();
    // Answers with its first operand: wrong, different for each case, and measured all the same.
    let engine = place.engine("first.sh", r#"printf '%s\n' "$line" | sed 's/^{"a":\(.*\),"b":.*$/\1/'"#);
    let measured = |threads: &str| {
        let out = place.text(threads);
        let arguments = ["orthogonal_6", "twoopt_5", "far", "--seed", "5", "--threads", threads, "--out", &out];
        let output = run(&[&["verify", "--engine", "kinetic", "--engine", &engine], &arguments[..]].concat());
        assert_eq!(code(&output), 0, "{:?}", errors(&output));
        rows(&place.path(threads))
    };
    let one = measured("1");
    assert_eq!(one.len(), 2 * (3 + 3 + 5));
    assert_eq!(one, measured("4"));
}

#[test]
fn the_seed_changes_random_cases_only() {
    let place = Place::new();
    let engine = place.engine("same.sh", &format!("echo '{}'", square(2.0)));
    let regions = |seed: &str| {
        let out = place.text(seed);
        run(&["verify", "twoopt_5", "fork_2", "--seed", seed, "--engine", &engine, "--out", &out]);
        [1, 4].map(|n| {
            let text = std::fs::read_to_string(place.path(seed).join(format!("cases/000{n}.json"))).unwrap();
            let record: serde_json::Value = serde_json::from_str(&text).unwrap();
            record["a"].to_string()
        })
    };
    let (one, two) = (regions("1"), regions("2"));
    assert_ne!(one[0], two[0]);
    assert_eq!(one[1], two[1]);
}
