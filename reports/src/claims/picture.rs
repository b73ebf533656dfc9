//! The picture of a worst pair: the operands, their sum by this project's engine, and the point where it happens.

use super::finding::Worst;
use crate::cases::Case;
use crate::engine::own::Own;
use crate::engine::{Answer, Engine};
use crate::row::Record;
use crate::run::plan::Plan;
use crate::run::record::assemble;
use crate::worker::Outcome;
use arcsum::sum::Convolution;

/// Larger pairs are not drawn.
const MOST: usize = 600;

/// What a picture of the worst input needs; none if it is no pair, or too large.
#[must_use]
pub fn picture(worst: &Worst) -> Option<Record> {
    let case = worst.input.as_pair().filter(|case| case.segments() <= MOST)?;
    let mut engine = Own::new(Convolution::Monotonic);
    let answer = engine.sum(&case.a, &case.b).ok()?;
    let mut record = drawn(case, engine.name(), answer)?;
    let spot = worst.spot.filter(|spot| spot.iter().all(|c| c.is_finite()));
    (record.row.worst_x, record.row.worst_y) = spot.map_or((None, None), |[x, y]| (Some(x), Some(y)));
    Some(record)
}

fn drawn(case: &Case, engine: &str, answer: Answer) -> Option<Record> {
    let plan = Plan::new(vec![case.clone()], &[engine.to_owned()]).ok()?;
    (!plan.jobs.is_empty()).then_some(())?;
    Some(assemble(&plan, 0, Outcome { answer: Some(answer), judgement: None, failure: None }))
}
