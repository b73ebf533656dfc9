//! Polygons: the exact sum, and the certified Hausdorff distance of the result to it (memo I1, I6).

use super::{Judgement, golden};
use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::engine::Answer;
use arcsum_oracle::certified::depth::Summed;
use arcsum_oracle::error::OracleError;
use arcsum_oracle::measure::hausdorff;
use arcsum_oracle::polygon;

/// Judges the answer to a case of two polygons.
pub(super) fn judge(case: &Case, engine: &str, answer: &Answer) -> Result<Judgement, OracleError> {
    let exact = polygon::sum(&plain(&case.a), &plain(&case.b))?;
    let unit = unit(&case.a, &case.b);
    let bracket = hausdorff(&plain(&answer.region), &exact, unit)?;
    let golden = case.golden.as_ref().map(|g| golden::compare(case, engine, g, answer, &exact)).transpose()?;
    let verdict = golden.as_ref().map_or_else(String::new, golden::Verdict::sentence);
    let summed = Summed::of_polygons([&plain(&case.a), &plain(&case.b)], &exact, unit)?;
    Judgement { golden, ..Judgement::measured(case, answer, bracket, Some(exact.loops().len()), verdict) }
        .with_free(case, answer, &summed)
}
