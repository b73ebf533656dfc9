//! Progress on standard error: a bar on a terminal, plain lines elsewhere.

use crate::row::{Row, Status};
use indicatif::{ProgressBar, ProgressStyle};
use std::cell::Cell;
use std::io::IsTerminal;

/// How far a run is.
pub struct Progress {
    bar: Option<ProgressBar>,
    total: usize,
    done: Cell<usize>,
}

impl Progress {
    /// Progress of `total` rows, `done` of them known from before.
    #[must_use]
    pub fn new(total: usize, done: usize) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| bar(total, done));
        Self { bar, total, done: Cell::new(done) }
    }

    /// Another row is done.
    pub fn done(&self, row: &Row) {
        self.done.set(self.done.get() + 1);
        match &self.bar {
            Some(bar) => {
                bar.inc(1);
                bar.set_message(row.case.clone());
            }
            None => eprintln!("{}/{} {} {}: {}", self.done.get(), self.total, row.case, row.engine, verdict(row)),
        }
    }

    /// The run has ended: one line of counts.
    pub fn finish(&self, rows: &[Row]) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
        let count = |s: Status| rows.iter().filter(|r| r.status == s).count();
        let counts =
            [Status::Ok, Status::Crashed, Status::Timeout, Status::Invalid, Status::Undecided, Status::Sampled];
        // Few runs sample.
        let told = |s: &&Status| **s != Status::Sampled || count(**s) > 0;
        let parts: Vec<String> = counts.iter().filter(told).map(|&s| format!("{} {}", count(s), word(s))).collect();
        eprintln!("{} of {} rows: {}", rows.len(), self.total, parts.join(", "));
    }
}

fn bar(total: usize, done: usize) -> ProgressBar {
    let bar = ProgressBar::new(total as u64).with_position(done as u64);
    // The template is fixed: a mistake in it would show in every run.
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {eta} {msg}") {
        bar.set_style(style);
    }
    bar
}

fn verdict(row: &Row) -> String {
    match (row.status, row.bits) {
        (Status::Ok, Some(bits)) => format!("{bits:.1} bits"),
        (status, _) if row.note.is_empty() => word(status).to_owned(),
        (status, _) => format!("{}: {}", word(status), row.note),
    }
}

/// The status as the tables have it.
#[must_use]
pub fn word(status: Status) -> &'static str {
    match status {
        Status::Ok => "ok",
        Status::Crashed => "crashed",
        Status::Timeout => "timeout",
        Status::Invalid => "invalid",
        Status::Undecided => "undecided",
        Status::Sampled => "sampled",
    }
}
