//! Why the oracle declines to answer.

use thiserror::Error;

/// A question the oracle cannot or will not answer.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum OracleError {
    /// A bend is not a line where only polygons are understood.
    #[error("loop {ring}, vertex {vertex}: a circle segment where a polygon was asked for")]
    NotPolygonal {
        /// Index of the loop.
        ring: usize,
        /// Index of the vertex the bend leaves.
        vertex: usize,
    },
    /// A coordinate or bend is not a usable number.
    #[error("loop {ring}, vertex {vertex}: {reason}")]
    BadNumber {
        /// Index of the loop.
        ring: usize,
        /// Index of the vertex.
        vertex: usize,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// The work would pass the budget.
    #[error("the reference is too costly: more than {limit} {what}")]
    TooCostly {
        /// What there are too many of.
        what: &'static str,
        /// The budget's limit.
        limit: u64,
    },
    /// A fact that holds for exact sums was violated: a defect of the oracle itself.
    #[error("the oracle contradicts itself: {0}")]
    Inconsistent(&'static str),
}

/// Limits on the work of one question. Counts, not times, so that the same question always gets the same answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Segments in one arrangement (sum segments, equal ones counted once, or edges of pairwise sums).
    pub segments: u64,
    /// Pairs of segments or pieces whose boxes meet, and segments that may meet a ray.
    pub meetings: u64,
}

impl Default for Budget {
    /// Enough for two polygons of about 2,000 vertices, less where their sum has many holes: up to about a minute.
    fn default() -> Self {
        Self { segments: 3_000_000, meetings: 400_000_000 }
    }
}

impl Budget {
    /// No limits.
    pub const NONE: Self = Self { segments: u64::MAX, meetings: u64::MAX };

    pub(crate) fn check_segments(self, count: usize) -> Result<(), OracleError> {
        if count as u64 > self.segments {
            return Err(OracleError::TooCostly { what: "segments", limit: self.segments });
        }
        Ok(())
    }

    pub(crate) fn check_meetings(self, count: u64) -> Result<(), OracleError> {
        if count > self.meetings {
            return Err(OracleError::TooCostly { what: "meetings", limit: self.meetings });
        }
        Ok(())
    }
}
