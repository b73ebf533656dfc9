//! `cmd:PROGRAM`: any program that reads a case a line as JSON, `{"a": REGION, "b": REGION}`, on standard input and
//! answers each with a region a line on standard output.
//!
//! The program is started once and asked again and again; words after the program's name, separated by spaces, are its
//! arguments. What it writes to standard error is dropped.

use super::{Abilities, Answer, Engine, EngineError};
use arcsum::region::Region;
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// A program under test.
#[derive(Debug)]
pub struct Program {
    name: String,
    running: Option<Running>,
}

#[derive(Debug)]
struct Running {
    child: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
}

impl Program {
    /// The engine `cmd:PROGRAM` with this full name; the program is not started yet.
    #[must_use]
    pub fn new(name: &str) -> Self {
        Self { name: name.to_owned(), running: None }
    }

    fn started(&mut self) -> Result<&mut Running, EngineError> {
        let running = match self.running.take() {
            Some(running) => running,
            None => start(self.name.trim_start_matches("cmd:"))?,
        };
        Ok(self.running.insert(running))
    }

    fn ask(&mut self, question: &str) -> Result<String, EngineError> {
        let running = self.started()?;
        let asked = writeln!(running.input, "{question}").and_then(|()| running.input.flush());
        let mut line = String::new();
        // A program that dies while it is being asked is reported by how it died, not by the broken pipe.
        let read = asked.and_then(|()| running.output.read_line(&mut line)).unwrap_or(0);
        if read == 0 {
            let ending = self.running.take().map_or_else(|| "unknown".to_owned(), ending);
            return Err(EngineError::Crashed(format!("the program ended without an answer: {ending}")));
        }
        Ok(line)
    }
}

impl Engine for Program {
    fn name(&self) -> &str {
        &self.name
    }

    fn version(&self) -> String {
        "unknown".to_owned()
    }

    fn abilities(&self) -> Abilities {
        Abilities::ALL
    }

    fn sum(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        let question = serde_json::json!({"a": a, "b": b}).to_string();
        let line = self.ask(&question)?;
        let region = serde_json::from_str(&line).map_err(|e| {
            let start: String = line.trim_end().chars().take(60).collect();
            EngineError::Invalid(format!("the answer is no region ({e}): {start}"))
        })?;
        Ok(Answer { region, ..Answer::default() })
    }

    fn process(&self) -> Option<u32> {
        self.running.as_ref().map(|running| running.child.id())
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        if let Some(mut running) = self.running.take() {
            // It may have ended already, and nobody waits for its word any more.
            let _ = running.child.kill();
            let _ = running.child.wait();
        }
    }
}

fn start(command: &str) -> Result<Running, EngineError> {
    let failed = |why: String| EngineError::Crashed(format!("the program {command} cannot be started: {why}"));
    let mut words = command.split_whitespace();
    let program = words.next().ok_or_else(|| failed("no name".into()))?;
    let mut child = Command::new(program)
        .args(words)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .map_err(|e| failed(e.to_string()))?;
    match (child.stdin.take(), child.stdout.take()) {
        (Some(input), Some(output)) => Ok(Running { child, input, output: BufReader::new(output) }),
        _ => Err(failed("no pipes".into())),
    }
}

fn ending(mut running: Running) -> String {
    drop(running.input);
    running.child.wait().map_or_else(|e| e.to_string(), |status| status.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{polygon, rectangle};

    fn square() -> Region {
        polygon(&rectangle([0.0, 0.0], [1.0, 1.0]))
    }

    #[test]
    fn a_missing_program_is_a_crash() {
        let answer = Program::new("cmd:/nonexistent/engine").sum(&square(), &square());
        assert!(matches!(answer, Err(EngineError::Crashed(_))), "{answer:?}");
    }

    #[test]
    fn a_program_that_ends_is_a_crash_each_time() {
        let mut program = Program::new("cmd:false");
        for _ in 0..2 {
            assert!(matches!(program.sum(&square(), &square()), Err(EngineError::Crashed(_))));
        }
    }

    #[test]
    fn a_program_that_repeats_the_case_answers_no_region() {
        let answer = Program::new("cmd:cat").sum(&square(), &square());
        assert!(matches!(answer, Err(EngineError::Invalid(_))), "{answer:?}");
    }
}
