//! Shared inputs of the integration tests.
