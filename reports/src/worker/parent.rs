//! The parent's side of a worker: start it, give it a task, wait no longer than the limit, start it anew when it died.

use super::{Message, Outcome, Task};
use crate::row::Status;
use rustix::process::{Pid, Signal};
use std::io::{BufRead, BufReader, Write};
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

/// How often a waiting parent looks whether it shall stop.
const GLANCE: Duration = Duration::from_millis(50);

/// Why no outcome came of a task.
#[derive(Debug, thiserror::Error)]
pub enum WorkerError {
    /// The run was stopped.
    #[error("stopped")]
    Stopped,
    /// The worker cannot be started at all.
    #[error("a worker cannot be started: {0}")]
    Start(#[from] std::io::Error),
    /// A task cannot be written down.
    #[error("a task cannot be put into words: {0}")]
    Task(#[from] serde_json::Error),
}

/// A worker that is restarted whenever needed.
#[derive(Debug)]
pub struct Worker {
    program: PathBuf,
    limit: Duration,
    running: Option<Running>,
}

#[derive(Debug)]
struct Running {
    child: Child,
    input: ChildStdin,
    lines: Receiver<String>,
}

/// Why waiting for a message ended without one.
enum Silence {
    Died,
    Late,
    Stopped,
}

impl Worker {
    /// A worker run by `program worker`; engine and reference have `limit` each for a task.
    #[must_use]
    pub fn new(program: PathBuf, limit: Duration) -> Self {
        Self { program, limit, running: None }
    }

    /// Has the task measured.
    ///
    /// # Errors
    /// When stopped, or when no worker can be started. All else is an outcome.
    pub fn measure(&mut self, task: &Task, stop: &AtomicBool) -> Result<Outcome, WorkerError> {
        let line = serde_json::to_string(task)?;
        let running = self.started()?;
        // A worker that died between two tasks is noticed by its silence.
        let _ = writeln!(running.input, "{line}").and_then(|()| running.input.flush());
        let mut outcome = Outcome::default();
        loop {
            match self.message(stop) {
                Ok(Message::Failed { status, note }) => {
                    outcome.failure = Some((status, note));
                    return Ok(outcome);
                }
                Ok(Message::Answered(answer)) => outcome.answer = Some(*answer),
                Ok(Message::Judged(judgement)) => {
                    outcome.judgement = Some(*judgement);
                    return Ok(outcome);
                }
                Err(Silence::Stopped) => {
                    self.end();
                    return Err(WorkerError::Stopped);
                }
                Err(silence) => {
                    let how = self.end();
                    outcome.failure = Some(blame(&silence, outcome.answer.is_some(), self.limit, &how));
                    return Ok(outcome);
                }
            }
        }
    }

    fn started(&mut self) -> Result<&mut Running, WorkerError> {
        let running = match self.running.take() {
            Some(running) => running,
            None => start(&self.program)?,
        };
        Ok(self.running.insert(running))
    }

    fn message(&mut self, stop: &AtomicBool) -> Result<Message, Silence> {
        let Some(running) = &self.running else { return Err(Silence::Died) };
        let deadline = Instant::now() + self.limit;
        loop {
            if stop.load(Ordering::Relaxed) {
                return Err(Silence::Stopped);
            }
            match running.lines.recv_timeout(GLANCE) {
                Ok(line) => return serde_json::from_str(&line).map_err(|_| Silence::Died),
                Err(RecvTimeoutError::Disconnected) => return Err(Silence::Died),
                Err(RecvTimeoutError::Timeout) if Instant::now() >= deadline => return Err(Silence::Late),
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    }

    /// Kills the worker with all it started and says how it ended.
    fn end(&mut self) -> String {
        let Some(mut running) = self.running.take() else { return "it was not running".into() };
        // Whoever died by itself leaves its status; the kill then finds nobody.
        let ended = match running.child.try_wait() {
            Ok(Some(status)) => Some(status),
            _ if matches!(running.lines.try_recv(), Err(mpsc::TryRecvError::Disconnected)) => running.child.wait().ok(),
            _ => None,
        };
        if let Some(group) = i32::try_from(running.child.id()).ok().and_then(Pid::from_raw) {
            let _ = rustix::process::kill_process_group(group, Signal::KILL);
        }
        let killed = running.child.wait();
        ended.map_or_else(|| killed.map_or_else(|e| e.to_string(), |s| s.to_string()), |s| s.to_string())
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.end();
    }
}

/// What a worker's silence says: before the answer it is the engine's fault, after it the reference's.
fn blame(silence: &Silence, answered: bool, limit: Duration, how: &str) -> (Status, String) {
    let seconds = limit.as_secs_f64();
    match (silence, answered) {
        (Silence::Late, false) => (Status::Timeout, format!("no answer in {seconds} s")),
        (Silence::Late, true) => (Status::Undecided, format!("the reference is too costly: over {seconds} s")),
        (_, false) => (Status::Crashed, format!("the process died: {how}")),
        (_, true) => (Status::Undecided, format!("the reference died: {how}")),
    }
}

fn start(program: &PathBuf) -> std::io::Result<Running> {
    let mut child = Command::new(program)
        .arg("worker")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        // A group of its own: it can be killed with all it started, and an interrupt from the keyboard leaves it alone.
        .process_group(0)
        .spawn()?;
    let (Some(input), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
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
    Ok(Running { child, input, lines })
}
