//! Why CGAL gave no answer.

use thiserror::Error;

/// No answer, and why.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CgalError {
    /// This was built without CGAL.
    #[error("CGAL is not built in")]
    NotBuiltIn,
    /// The input is none that CGAL promises an answer for, so it was not asked.
    #[error("CGAL is not asked: {0}")]
    Refused(String),
    /// An exception in CGAL.
    #[error("CGAL gave up: {0}")]
    Failed(String),
    /// The process that asked CGAL died.
    #[error("CGAL ended its process: {0}")]
    Died(String),
    /// No answer within the limit.
    #[error("CGAL gave no answer in {0} s")]
    Late(f64),
    /// An answer that is no region.
    #[error("CGAL's answer is no region: {0}")]
    Nonsense(String),
}
