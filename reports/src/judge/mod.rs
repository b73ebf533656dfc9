//! Judging an answer: the reference's word about it, as the numbers of a row (section 3 of the design).

pub mod golden;
pub mod polygon;
pub mod result;
pub mod why;

use crate::cases::Case;
use crate::engine::Answer;
use crate::row::{Status, number};
use serde::{Deserialize, Serialize};

/// What the references found out about an answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Judgement {
    /// Ok, or undecided.
    pub status: Status,
    /// Lower bound of the Hausdorff distance, in unit-box lengths.
    #[serde(default, with = "number")]
    pub mu_lo: Option<f64>,
    /// Upper bound of it.
    #[serde(default, with = "number")]
    pub mu_hi: Option<f64>,
    /// `result` or `sum`: where the point that attains the lower bound lies.
    pub direction: Option<String>,
    /// That point, in input units.
    pub witness: Option<[f64; 2]>,
    /// Loops of the reference.
    pub exact_loops: Option<u64>,
    /// Checks that failed, by name.
    pub failed_checks: Vec<String>,
    /// One sentence, or nothing.
    pub note: String,
    /// The verdict on somebody else's claim, where the case has one.
    pub golden: Option<golden::Verdict>,
}

impl Judgement {
    /// No decision, and why.
    #[must_use]
    pub fn undecided(note: impl Into<String>) -> Self {
        Self {
            status: Status::Undecided,
            mu_lo: None,
            mu_hi: None,
            direction: None,
            witness: None,
            exact_loops: None,
            failed_checks: Vec::new(),
            note: note.into(),
            golden: None,
        }
    }
}

/// Judges the answer of an engine to a case.
#[must_use]
pub fn judge(case: &Case, engine: &str, answer: &Answer) -> Judgement {
    let mut judgement = if case.is_polygonal() {
        polygon::judge(case, engine, answer)
    } else {
        Judgement::undecided("the bounds for arcs are not in the workspace yet")
    };
    judgement.failed_checks.extend(result::failed_checks(&answer.region));
    judgement
}
