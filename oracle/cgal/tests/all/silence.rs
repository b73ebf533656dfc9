//! Processes that do not answer: that die, that hang, that cannot be started.

use crate::common::{loops, square};
use arcsum_cgal::child::Child;
use arcsum_cgal::error::CgalError;
use arcsum_cgal::sum::{Answer, Sum};
use std::time::{Duration, Instant};

fn ask(program: &str, arguments: &[&str]) -> Result<Answer, CgalError> {
    let method = "reduced:exact".parse().expect("a method");
    let question = Sum { method, a: loops(&[square(1)]), b: loops(&[square(1)]) };
    Child::new(program, arguments, Duration::from_millis(300)).ask(&question)
}

#[test]
fn a_process_that_dies_says_how() {
    for (arguments, how) in [("exit 3", "exit status: 3"), ("kill -SEGV $$", "signal: 11")] {
        let answer = ask("sh", &["-c", arguments]);
        assert!(matches!(&answer, Err(CgalError::Died(said)) if said.contains(how)), "{answer:?}");
    }
    assert!(matches!(ask("/nonexistent/cgal", &[]), Err(CgalError::Died(_))));
}

#[test]
fn a_process_that_hangs_is_late() {
    let start = Instant::now();
    assert_eq!(ask("sleep", &["600"]), Err(CgalError::Late(0.3)));
    assert!(start.elapsed() < Duration::from_secs(60));
}

#[test]
fn an_answer_that_is_none_is_nonsense() {
    assert!(matches!(ask("echo", &["hello"]), Err(CgalError::Nonsense(_))));
}
