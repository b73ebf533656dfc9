//! Shared inputs and judges of the integration tests.

pub mod boundary;
pub mod fiber;
pub mod shapes;
pub mod tangle;
pub mod valid;
pub mod winding;
pub mod worst;

use proptest::prelude::ProptestConfig;

/// A configuration for this many cases, more on request by `PROPTEST_CASES` (256 stands for once as many). What fails is kept
/// as a value in a test, not as a seed in a file: seeds go stale.
#[must_use]
pub fn cases(n: u32) -> ProptestConfig {
    let asked = ProptestConfig::default().cases;
    let n = if std::env::var_os("PROPTEST_CASES").is_some() { n * asked.div_ceil(256) } else { n };
    ProptestConfig {
        failure_persistence: None,
        max_local_rejects: 100 * n,
        max_global_rejects: 100 * n,
        ..ProptestConfig::with_cases(n)
    }
}
