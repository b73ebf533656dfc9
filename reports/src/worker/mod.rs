//! Workers: child processes that measure one case at a time, so that nothing an engine or a reference does can end a run.
//!
//! A worker reads tasks as JSON lines and answers each with the stages it goes through: first what the engine did, then
//! what the reference says. Whoever waits can therefore tell a hanging engine from a hanging reference.

pub mod child;
pub mod parent;

use crate::cases::Case;
use crate::engine::Answer;
use crate::judge::Judgement;
use crate::judge::samples::Sampling;
use crate::row::Status;
use arcsum::region::Region;
use serde::{Deserialize, Serialize};

/// What a worker is to find out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Ask {
    /// The sum with all that the engine tells about it, and all that the references say.
    #[default]
    All,
    /// The sum alone, its memory watched; then, if `judged`, its error and nothing else.
    Alone {
        /// Whether the reference is asked.
        judged: bool,
    },
}

/// A line to a worker.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Task {
    /// The case.
    pub case: Case,
    /// The name of the engine.
    pub engine: String,
    /// A region to be judged instead of the engine's answer, which is then not asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub claim: Option<Region>,
    /// Whether and how often the answer is sampled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sampling: Option<Sampling>,
    /// What is to be found out.
    #[serde(default)]
    pub ask: Ask,
}

/// A line from a worker.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Message {
    /// The engine gave no region; the task is done.
    Failed {
        /// Crashed or invalid.
        status: Status,
        /// One sentence.
        note: String,
    },
    /// The engine gave a region; the reference is asked next.
    Answered(Box<Answer>),
    /// The reference's word; the task is done.
    Judged(Box<Judgement>),
}

/// What became of a task.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// The engine's answer.
    pub answer: Option<Answer>,
    /// The reference's word on it.
    pub judgement: Option<Judgement>,
    /// Why one of the two is missing.
    pub failure: Option<(Status, String)>,
}
