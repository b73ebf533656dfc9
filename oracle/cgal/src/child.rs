//! Questions to CGAL in a process of its own: it may crash there, or never come back.
//!
//! [`serve`] is what such a process does: a question a line on standard input, an answer a line on standard output.

use crate::error::CgalError;
use crate::question::{Question, respond};
use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Child as Process, ChildStdin, Command, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::Duration;

/// A process that asks CGAL, started when needed and started anew after it died.
#[derive(Debug)]
pub struct Child {
    program: PathBuf,
    arguments: Vec<String>,
    limit: Duration,
    running: Option<Running>,
}

#[derive(Debug)]
struct Running {
    process: Process,
    input: ChildStdin,
    lines: Receiver<String>,
}

impl Child {
    /// A child that runs `program arguments...`, which must do no more than [`serve`]; each answer may take `limit`.
    #[must_use]
    pub fn new(program: impl Into<PathBuf>, arguments: &[&str], limit: Duration) -> Self {
        let arguments = arguments.iter().map(|a| (*a).to_owned()).collect();
        Self { program: program.into(), arguments, limit, running: None }
    }

    /// Asks CGAL in the child.
    ///
    /// # Errors
    /// As [`Question::ask`], and when the child dies or is late.
    pub fn ask<Q: Question>(&mut self, question: &Q) -> Result<Q::Answer, CgalError> {
        let limit = self.limit;
        let running = self.started()?;
        // A child that died is noticed by its silence.
        let _ = writeln!(running.input, "{}", question.line()).and_then(|()| running.input.flush());
        match running.lines.recv_timeout(limit) {
            Ok(line) if line == NOT_BUILT_IN => Err(CgalError::NotBuiltIn),
            Ok(line) => Q::read(&line),
            Err(RecvTimeoutError::Timeout) => {
                self.end();
                Err(CgalError::Late(limit.as_secs_f64()))
            }
            Err(RecvTimeoutError::Disconnected) => Err(CgalError::Died(self.end())),
        }
    }

    /// The id of the process that runs, if one does.
    #[must_use]
    pub fn process(&self) -> Option<u32> {
        self.running.as_ref().map(|running| running.process.id())
    }

    fn started(&mut self) -> Result<&mut Running, CgalError> {
        let running = match self.running.take() {
            Some(running) => running,
            None => start(&self.program, &self.arguments)
                .map_err(|e| CgalError::Died(format!("{} cannot be started: {e}", self.program.display())))?,
        };
        Ok(self.running.insert(running))
    }

    /// Ends the process, unless it has ended, and says how it did.
    fn end(&mut self) -> String {
        let Some(mut running) = self.running.take() else { return "it was not running".into() };
        drop(running.input);
        // Whoever has closed its output is dying by itself, and its own status is to be kept.
        if !matches!(running.lines.try_recv(), Err(mpsc::TryRecvError::Disconnected)) {
            let _ = running.process.kill();
        }
        running.process.wait().map_or_else(|e| e.to_string(), |status| status.to_string())
    }
}

impl Drop for Child {
    fn drop(&mut self) {
        self.end();
    }
}

fn start(program: &PathBuf, arguments: &[String]) -> std::io::Result<Running> {
    let mut command = Command::new(program);
    command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
    let mut process = command.spawn()?;
    let (Some(input), Some(output)) = (process.stdin.take(), process.stdout.take()) else {
        return Err(std::io::Error::other("no pipes"));
    };
    let (sender, lines) = mpsc::channel();
    std::thread::spawn(move || {
        for line in BufReader::new(output).lines().map_while(Result::ok) {
            if sender.send(line).is_err() {
                break;
            }
        }
    });
    Ok(Running { process, input, lines })
}

/// The answer where CGAL is not built in.
const NOT_BUILT_IN: &str = "not built in";

/// Answers the questions on standard input until it ends.
///
/// # Errors
/// When standard input or output fails.
pub fn serve() -> std::io::Result<()> {
    for line in std::io::stdin().lock().lines() {
        let answer = match respond(&line?) {
            Ok(text) => text,
            Err(CgalError::NotBuiltIn) => NOT_BUILT_IN.into(),
            Err(CgalError::Refused(reason)) => format!("refused {reason}"),
            Err(other) => format!("failed {other}"),
        };
        let mut out = std::io::stdout().lock();
        writeln!(out, "{answer}")?;
        out.flush()?;
    }
    Ok(())
}
