//! The chain of exact sums of polygons.

use super::{Reference, Step, Verdict};
use crate::bridge::plain;
use crate::cases::Case;
use crate::worker::parent::WorkerError;
use arcsum_oracle::convolve;
use arcsum_oracle::error::{Budget, OracleError};
use arcsum_oracle::measure::hausdorff;
use arcsum_oracle::region::ExactRegion;
use rug::Rational;
use std::time::{Duration, Instant};

/// The exact sum so far.
pub(super) struct Exact {
    /// The sum so far and what is added to it, or why they are not known.
    regions: Result<[ExactRegion<Rational>; 2], String>,
    limit: Duration,
}

impl Exact {
    /// Starts a chain. After a step that took longer than the limit, all is undecided.
    pub(super) fn new(case: &Case, limit: Duration) -> Self {
        let exact = |region| ExactRegion::from_plain(&plain(region));
        let regions = exact(&case.a).and_then(|a| Ok([a, exact(&case.b)?]));
        Self { regions: regions.map_err(|e| e.to_string()), limit }
    }
}

impl Reference for Exact {
    fn name(&self) -> &'static str {
        "chain"
    }

    fn judge(&mut self, step: &Step) -> Result<Verdict, WorkerError> {
        let start = Instant::now();
        let measured = match &mut self.regions {
            Err(note) => return Ok(Verdict { note: note.clone(), ..Verdict::default() }),
            Ok(regions) => measured(regions, step),
        };
        if start.elapsed() > self.limit {
            self.regions = Err(format!("the reference is too costly: over {} s", self.limit.as_secs_f64()));
        }
        Ok(measured.unwrap_or_else(|error| {
            self.regions = Err(error.to_string());
            Verdict { note: error.to_string(), ..Verdict::default() }
        }))
    }
}

/// Adds exactly and measures.
fn measured(regions: &mut [ExactRegion<Rational>; 2], step: &Step) -> Result<Verdict, OracleError> {
    let [so_far, added] = regions;
    *so_far = convolve::sum(so_far, added, Budget::default())?;
    let found = hausdorff(&plain(step.after), so_far, step.unit)?;
    Ok(Verdict { mu: Some([found.lo, found.hi]), exact_segments: Some(so_far.vertices()), note: String::new() })
}
