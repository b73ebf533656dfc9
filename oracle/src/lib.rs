//! Exact and certified references for Minkowski sums of planar regions.
//!
//! Nothing here is shared with the engine: a case arrives as plain numbers ([`plain`]).

pub mod plain;
