//! The worker's side: the hidden command `arcsum worker`.
//!
//! Standard input belongs to the parent: when it ends, the parent is gone or has had enough, and the worker ends at once
//! with everything it started. Memory is limited, so that a runaway allocation is a crash of the worker alone.

use super::{Ask, Message, Task};
use crate::cases::Case;
use crate::cases::shape::{polygon, rectangle};
use crate::engine::registry::engine;
use crate::engine::{Answer, Engine, EngineError};
use crate::judge::{Judgement, error, judge_or_sample, result};
use crate::memory::Watch;
use crate::row::Status;
use rustix::process::{Resource, Rlimit, Signal};
use std::any::Any;
use std::io::{BufRead, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc;
use std::time::Instant;

/// Memory for the data of a worker and of each program it starts.
const MEMORY_BYTES: u64 = 6 << 30;

/// Serves tasks until standard input ends.
///
/// # Errors
/// When the parent cannot be talked to.
pub fn serve() -> std::io::Result<()> {
    let limit = Rlimit { current: Some(MEMORY_BYTES), maximum: Some(MEMORY_BYTES) };
    // Where the system knows no such limit the worker runs without.
    let _ = rustix::process::setrlimit(Resource::Data, limit);
    let (sender, tasks) = mpsc::channel();
    std::thread::spawn(move || {
        for line in std::io::stdin().lock().lines().map_while(Result::ok) {
            if sender.send(line).is_err() {
                break;
            }
        }
        end_with_children();
    });
    let mut engines = Engines::default();
    for line in tasks {
        let task: Task = serde_json::from_str(&line)?;
        engines.measure(&task, &mut |message| say(&message))?;
    }
    Ok(())
}

/// Ends this process and the programs it started: all of its group, which the parent made for it.
fn end_with_children() {
    let own = rustix::process::getpid();
    if rustix::process::getpgrp() == own {
        let _ = rustix::process::kill_process_group(own, Signal::KILL);
    }
    std::process::exit(0);
}

fn say(message: &Message) -> std::io::Result<()> {
    let mut out = std::io::stdout().lock();
    serde_json::to_writer(&mut out, message)?;
    writeln!(out)?;
    out.flush()
}

/// The engine last asked, kept because programs are slow to start.
#[derive(Default)]
struct Engines {
    last: Option<(String, Box<dyn Engine>)>,
}

impl Engines {
    fn measure(&mut self, task: &Task, say: &mut dyn FnMut(Message) -> std::io::Result<()>) -> std::io::Result<()> {
        match self.answer(task) {
            Err((status, note)) => say(Message::Failed { status, note }),
            Ok(answer) => {
                say(Message::Answered(Box::new(answer.clone())))?;
                let judged = catch_unwind(AssertUnwindSafe(|| judged(task, &answer)));
                let judgement = judged.unwrap_or_else(|cause| {
                    Judgement::undecided(format!("the reference panicked: {}", reason(cause.as_ref())))
                });
                say(Message::Judged(Box::new(judgement)))
            }
        }
    }

    fn answer(&mut self, task: &Task) -> Result<Answer, (Status, String)> {
        if let Some(region) = &task.claim {
            return Ok(Answer { region: region.clone(), ..Answer::default() });
        }
        let engine = self.named(&task.engine).map_err(|note| (Status::Invalid, note))?;
        let asked = catch_unwind(AssertUnwindSafe(|| match task.ask {
            Ask::All => engine.sum(&task.case.a, &task.case.b),
            Ask::Alone { .. } => watched(engine.as_mut(), &task.case),
        }));
        let answer = match asked {
            Ok(Ok(answer)) => answer,
            Ok(Err(EngineError::Invalid(note))) => return Err((Status::Invalid, note)),
            Ok(Err(EngineError::Crashed(note))) => return Err((Status::Crashed, note)),
            Err(cause) => {
                self.last = None;
                return Err((Status::Crashed, format!("panicked: {}", reason(cause.as_ref()))));
            }
        };
        match result::nonsense(&answer.region) {
            Some(note) => Err((Status::Invalid, note)),
            None => Ok(answer),
        }
    }

    fn named(&mut self, name: &str) -> Result<&mut Box<dyn Engine>, String> {
        let kept = self.last.take().filter(|(last, _)| last == name);
        let engine = match kept {
            Some((_, engine)) => engine,
            None => engine(name).map_err(|e| e.to_string())?,
        };
        Ok(&mut self.last.insert((name.to_owned(), engine)).1)
    }
}

/// What the references say.
fn judged(task: &Task, answer: &Answer) -> Judgement {
    match task.ask {
        Ask::All => judge_or_sample(&task.case, &task.engine, answer, task.sampling),
        Ask::Alone { judged: true } => error(&task.case, answer, task.sampling),
        Ask::Alone { judged: false } => Judgement::undecided("nobody looked"),
    }
}

/// The sum alone, with its time and the growth of the memory of the process that computed it.
fn watched(engine: &mut dyn Engine, case: &Case) -> Result<Answer, EngineError> {
    // A process of the engine's own is there once it has been asked; what becomes of this is of no interest.
    let small = polygon(&rectangle([0.0, 0.0], [1.0, 1.0]));
    let _ = engine.alone(&small, &small);
    let watch = Watch::start(engine.process());
    let start = Instant::now();
    let mut answer = engine.alone(&case.a, &case.b)?;
    answer.times.total = answer.times.total.or(Some(start.elapsed()));
    answer.memory = watch.and_then(|watch| watch.growth());
    Ok(answer)
}

/// What a panic said.
fn reason(cause: &(dyn Any + Send)) -> String {
    let text = cause.downcast_ref::<&str>().map(|s| (*s).to_owned());
    let text = text.or_else(|| cause.downcast_ref::<String>().cloned());
    text.unwrap_or_else(|| "without a word".to_owned()).replace('\n', " ")
}
