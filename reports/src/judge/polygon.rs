//! Polygons: the exact sum, and the certified Hausdorff distance of the result to it (memo I1, I6).

use super::{Judgement, why};
use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::engine::Answer;
use crate::row::Status;
use crate::standin::oracle;
use arcsum_oracle::polygon;

/// Judges the answer to a case of two polygons.
pub(super) fn judge(case: &Case, answer: &Answer) -> Judgement {
    let exact = match polygon::sum(&plain(&case.a), &plain(&case.b)) {
        Ok(exact) => exact,
        Err(e) => return Judgement::undecided(e.to_string()),
    };
    let unit = unit(&case.a, &case.b);
    let bracket = oracle::hausdorff(&plain(&answer.region), &exact, unit);
    let loops = exact.loops().len();
    let differ = answer.region.loops.len() != loops;
    Judgement {
        status: if bracket.hi.is_finite() { Status::Ok } else { Status::Undecided },
        mu: [bracket.lo, bracket.hi].map(|v| v.is_finite().then_some(v)),
        direction: Some(bracket.direction.to_string()),
        witness: Some(bracket.witness),
        exact_loops: Some(loops as u64),
        failed_checks: if differ { vec!["loops".into()] } else { Vec::new() },
        note: why::short_bits(case, answer, loops, bracket.hi, unit),
    }
}
