//! Shared inputs and judges of the integration tests.

pub mod boundary;
mod draw;
pub mod fiber;
pub mod precise;
pub mod random;
pub mod shapes;
pub mod tangle;
pub mod valid;
pub mod worst;

use proptest::prelude::ProptestConfig;

/// A configuration for this many cases. What fails is kept as a value in a test, not as a seed in a file: seeds go stale.
#[must_use]
pub fn cases(n: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, max_global_rejects: 100 * n, ..ProptestConfig::with_cases(n) }
}
