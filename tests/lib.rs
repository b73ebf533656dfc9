//! Shared inputs of the integration tests.

pub mod random;
pub mod shapes;
