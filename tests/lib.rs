//! Shared inputs and judges of the integration tests.

pub mod liar;
pub mod tangle;
