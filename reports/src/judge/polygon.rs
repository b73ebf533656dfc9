//! Polygons: the exact sum, and the certified Hausdorff distance of the result to it (memo I1, I6).

use super::{Judgement, golden, why};
use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::engine::Answer;
use crate::row::Status;
use arcsum_oracle::error::OracleError;
use arcsum_oracle::measure::{Direction, hausdorff};
use arcsum_oracle::polygon;

/// Judges the answer to a case of two polygons.
pub(super) fn judge(case: &Case, engine: &str, answer: &Answer) -> Judgement {
    measured(case, engine, answer).unwrap_or_else(|e| Judgement::undecided(e.to_string()))
}

fn measured(case: &Case, engine: &str, answer: &Answer) -> Result<Judgement, OracleError> {
    let exact = polygon::sum(&plain(&case.a), &plain(&case.b))?;
    let unit = unit(&case.a, &case.b);
    let bracket = hausdorff(&plain(&answer.region), &exact, unit)?;
    let loops = exact.loops().len();
    let differ = answer.region.loops.len() != loops;
    let (x, y) = bracket.witness;
    let golden = case.golden.as_ref().map(|g| golden::compare(case, engine, g, answer, &exact)).transpose()?;
    let sentences = [
        why::short_bits(case, answer, bracket.hi, unit),
        why::other_loops(answer, loops),
        golden.as_ref().map_or_else(String::new, golden::Verdict::sentence),
    ];
    Ok(Judgement {
        status: Status::Ok,
        mu_lo: Some(bracket.lo),
        // Zero may come with a minus.
        mu_hi: Some(bracket.hi + 0.0),
        direction: Some(side(bracket.direction).to_owned()),
        witness: (x.is_finite() && y.is_finite()).then_some([x, y]),
        exact_loops: Some(loops as u64),
        failed_checks: if differ { vec!["loops".into()] } else { Vec::new() },
        note: sentences.into_iter().filter(|s| !s.is_empty()).collect::<Vec<_>>().join("; "),
        golden,
    })
}

fn side(direction: Direction) -> &'static str {
    match direction {
        Direction::FromResult => "result",
        Direction::FromSum => "sum",
    }
}
