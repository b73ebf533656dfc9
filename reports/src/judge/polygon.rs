//! Polygons: the exact sum, and the certified Hausdorff distance of the result to it (memo I1, I6).

use super::{Judgement, why};
use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::engine::Answer;
use crate::row::Status;
use arcsum_oracle::error::OracleError;
use arcsum_oracle::measure::{Direction, hausdorff};
use arcsum_oracle::polygon;

/// Judges the answer to a case of two polygons.
pub(super) fn judge(case: &Case, answer: &Answer) -> Judgement {
    measured(case, answer).unwrap_or_else(|e| Judgement::undecided(e.to_string()))
}

fn measured(case: &Case, answer: &Answer) -> Result<Judgement, OracleError> {
    let exact = polygon::sum(&plain(&case.a), &plain(&case.b))?;
    let unit = unit(&case.a, &case.b);
    let bracket = hausdorff(&plain(&answer.region), &exact, unit)?;
    let loops = exact.loops().len();
    let differ = answer.region.loops.len() != loops;
    let (x, y) = bracket.witness;
    Ok(Judgement {
        status: Status::Ok,
        mu_lo: Some(bracket.lo),
        mu_hi: Some(bracket.hi),
        direction: Some(side(bracket.direction).to_owned()),
        witness: (x.is_finite() && y.is_finite()).then_some([x, y]),
        exact_loops: Some(loops as u64),
        failed_checks: if differ { vec!["loops".into()] } else { Vec::new() },
        note: why::short_bits(case, answer, loops, bracket.hi, unit),
    })
}

fn side(direction: Direction) -> &'static str {
    match direction {
        Direction::FromResult => "result",
        Direction::FromSum => "sum",
    }
}
