//! Shared inputs of the integration tests.

pub mod precise;
pub mod worst;

use proptest::test_runner::Config;

/// The settings of a property test. Failing seeds are not kept, as they go stale: keep the failing value in a test.
#[must_use]
pub fn cases(cases: u32) -> Config {
    Config { cases, failure_persistence: None, ..Config::default() }
}
