//! Machine instructions of a sum, counted by valgrind where it is installed: they do not depend on what else the machine
//! does. Of its tools cachegrind without its caches counts at the least cost, about that of running under valgrind at all.
//!
//! The hidden command `repeat` runs an engine k times on a case; those of two runs less those of one are the instructions of
//! the second. Engines in processes of their own are not counted.

use super::timing::Timing;
use crate::cases::Case;
use crate::command::repeat;
use std::io::{Error, Write};
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// The name of the tool.
const VALGRIND: &str = "valgrind";

/// Sums that take longer are not counted, in milliseconds: under valgrind they take some fifty times as long.
const LONGEST_MS: f64 = 2000.0;

/// What counts.
#[derive(Clone, Debug)]
pub struct Counter {
    program: PathBuf,
}

impl Counter {
    /// A counter that runs this program; none without valgrind.
    #[must_use]
    pub fn new(program: PathBuf) -> Option<Self> {
        let version = Command::new(VALGRIND).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        version.is_ok_and(|status| status.success()).then_some(Self { program })
    }

    /// The instructions of a sum by an engine of this process; none where the engine or valgrind fails.
    #[must_use]
    pub fn of(&self, case: &Case, engine: &str) -> Option<u64> {
        let [one, two] = [1, 2].map(|times| self.run(case, engine, times).ok());
        two?.checked_sub(one?)
    }

    /// Fills in the instructions of rows that have times.
    pub(super) fn count(&self, case: &Case, rows: &mut [Option<Timing>], here: &[bool]) {
        for (row, here) in rows.iter_mut().zip(here) {
            let quick = |row: &&mut Timing| row.median_ms.is_some_and(|ms| ms <= LONGEST_MS);
            if let Some(row) = row.as_mut().filter(quick).filter(|_| *here) {
                row.instructions = self.of(case, &row.engine);
            }
        }
        let first = rows.first().and_then(|row| row.as_ref()?.instructions);
        for row in rows.iter_mut().flatten() {
            row.instructions_to_first = row.instructions.zip(first).map(|(it, first)| it as f64 / first as f64);
        }
    }

    /// The instructions of the process that runs the engine so many times.
    fn run(&self, case: &Case, engine: &str, times: usize) -> Result<u64, Error> {
        let mut process = Command::new(VALGRIND)
            .args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"])
            .arg(&self.program)
            .args([repeat::COMMAND, engine, &times.to_string()])
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()?;
        let mut input = process.stdin.take().ok_or_else(|| Error::other("no pipe"))?;
        serde_json::to_writer(&mut input, case)?;
        input.flush()?;
        drop(input);
        let output = process.wait_with_output()?;
        let said = String::from_utf8_lossy(&output.stderr);
        counted(&said).filter(|_| output.status.success()).ok_or_else(|| Error::other("no count"))
    }
}

/// The number in the line `==1== I   refs:      107,530,799`.
fn counted(said: &str) -> Option<u64> {
    let (_, number) =
        said.lines().find_map(|line| line.split_once("refs:").filter(|(head, _)| head.contains(" I ")))?;
    number.trim().replace(',', "").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_is_read_and_nothing_else() {
        assert_eq!(counted("==1== Cachegrind\n==1== I   refs:      107,530,799\n"), Some(107_530_799));
        assert_eq!(counted("==1== I refs:        12\n"), Some(12));
        for odd in ["", "==1== D   refs:  12", "==1== I   refs:", "==1== I   refs: x"] {
            assert_eq!(counted(odd), None);
        }
    }
}
