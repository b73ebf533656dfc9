//! Judging an answer: the reference's word about it, as the numbers of a row (section 3 of the design).

mod arcs;
pub mod free;
pub mod golden;
pub(crate) mod places;
pub mod polygon;
mod realized;
pub mod result;
pub mod samples;
pub mod separation;
pub mod why;

use crate::bridge::unit;
use crate::cases::Case;
use crate::engine::Answer;
use crate::engine::registry::BUILT_IN;
use crate::row::{Status, number};
use arcsum_oracle::certified::depth::{Depths, Summed};
use arcsum_oracle::error::OracleError;
use arcsum_oracle::measure::{Bracket, Direction};
use samples::Sampling;
use serde::{Deserialize, Serialize};

/// What the references found out about an answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Judgement {
    /// Ok, undecided, or sampled.
    pub status: Status,
    /// Lower bound of the Hausdorff distance, in unit-box lengths.
    #[serde(default, with = "number")]
    pub mu_lo: Option<f64>,
    /// Upper bound of it.
    #[serde(default, with = "number")]
    pub mu_hi: Option<f64>,
    /// Bounds of the distance to the sum of the realizations.
    #[serde(default)]
    pub mu_realized: Option<[f64; 2]>,
    /// `result` or `sum`: where the point that attains the lower bound lies.
    pub direction: Option<String>,
    /// That point, in input units.
    pub witness: Option<[f64; 2]>,
    /// Loops of the reference.
    pub exact_loops: Option<u64>,
    /// The most bits the reference needed; none for exact references.
    #[serde(default)]
    pub exact_bits: Option<u32>,
    /// Checks that failed, by name.
    pub failed_checks: Vec<String>,
    /// One sentence, or nothing.
    pub note: String,
    /// The verdict on somebody else's claim, where the case has one.
    pub golden: Option<golden::Verdict>,
    /// What was found at points that should be free or blocked.
    #[serde(default)]
    pub free: Option<free::Findings>,
    /// How far apart chains of the operands are that are not incident.
    #[serde(default)]
    pub separation: Option<separation::Separation>,
    /// What samples of the result say, where it was sampled.
    #[serde(default)]
    pub sampled: Option<samples::Sampled>,
}

impl Judgement {
    /// No decision, and why.
    #[must_use]
    pub fn undecided(note: impl Into<String>) -> Self {
        Self {
            status: Status::Undecided,
            mu_lo: None,
            mu_hi: None,
            mu_realized: None,
            direction: None,
            witness: None,
            exact_loops: None,
            exact_bits: None,
            failed_checks: Vec::new(),
            note: note.into(),
            golden: None,
            free: None,
            separation: None,
            sampled: None,
        }
    }

    /// What a certified bracket says: its numbers, whether the loops are as many as those of the reference if that is known,
    /// and a sentence made of what explains them and of a remark.
    #[must_use]
    fn measured(case: &Case, answer: &Answer, bracket: Bracket, loops: Option<usize>, remark: String) -> Self {
        let (x, y) = bracket.witness;
        let differ = loops.is_some_and(|loops| loops != answer.region.loops.len());
        let sentences = [
            why::short_bits(case, answer, bracket.hi, unit(&case.a, &case.b)),
            loops.map_or_else(String::new, |loops| why::other_loops(answer, loops)),
            remark,
        ];
        let direction = if bracket.direction == Direction::FromResult { "result" } else { "sum" };
        Self {
            status: Status::Ok,
            mu_lo: Some(bracket.lo),
            // Zero may come with a minus.
            mu_hi: Some(bracket.hi + 0.0),
            direction: Some(direction.to_owned()),
            witness: (x.is_finite() && y.is_finite()).then_some([x, y]),
            exact_loops: loops.map(|loops| loops as u64),
            failed_checks: if differ { vec!["loops".into()] } else { Vec::new() },
            ..Self::undecided(sentences.into_iter().filter(|s| !s.is_empty()).collect::<Vec<_>>().join("; "))
        }
    }
}

impl Judgement {
    /// Adds what falsely free points show, if the error is known at all.
    fn with_free(self, case: &Case, answer: &Answer, sum: &Summed) -> Result<Self, OracleError> {
        let Some(mu) = self.mu_hi.filter(|mu| mu.is_finite()) else { return Ok(self) };
        let findings = free::test(&Depths::new(sum)?, answer, mu, unit(&case.a, &case.b), case.segments())?;
        Ok(Self { free: Some(findings), ..self })
    }
}

/// Judges the answer of an engine to a case.
#[must_use]
pub fn judge(case: &Case, engine: &str, answer: &Answer) -> Judgement {
    judge_or_sample(case, engine, answer, None)
}

/// The same, and what the reference declines is sampled, or everything, if this is asked for.
#[must_use]
pub fn judge_or_sample(case: &Case, engine: &str, answer: &Answer, sampling: Option<Sampling>) -> Judgement {
    let mut judgement = by_reference(case, engine, answer, sampling);
    if BUILT_IN.contains(&engine) && judgement.status == Status::Ok {
        judgement.mu_realized = realized::measure(case, answer).map(|found| [found.lo, found.hi]);
    }
    if judgement.status != Status::Sampled {
        judgement.separation = separation::measure(case).ok();
    }
    judgement.failed_checks.extend(result::failed_checks(&answer.region));
    judgement
}

/// What the reference says, or samples in its place.
fn by_reference(case: &Case, engine: &str, answer: &Answer, sampling: Option<Sampling>) -> Judgement {
    if let Some(Sampling { count, all: true }) = sampling {
        return samples::judge(case, answer, count);
    }
    let judged = if case.is_polygonal() { polygon::judge(case, engine, answer) } else { arcs::judge(case, answer) };
    match (judged, sampling) {
        (Ok(judgement), _) => judgement,
        (Err(OracleError::TooCostly { .. }), Some(sampling)) => samples::judge(case, answer, sampling.count),
        (Err(error), _) => Judgement::undecided(error.to_string()),
    }
}

/// The error of an answer as [`judge_or_sample`] finds it, without most of what else there is to say.
#[must_use]
pub fn error(case: &Case, answer: &Answer, sampling: Option<Sampling>) -> Judgement {
    // The engine's name is of use only where a case has somebody else's answer.
    by_reference(case, "", answer, sampling)
}
