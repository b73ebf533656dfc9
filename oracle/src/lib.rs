//! Exact and certified references for Minkowski sums of planar regions.
//!
//! Nothing here is shared with the engine: a case arrives as plain numbers ([`plain`]).

pub mod arc;
pub mod arrange;
pub mod backward;
pub mod boolean;
pub mod boxes;
pub mod cells;
pub mod certified;
pub mod chains;
pub mod clip;
pub mod convex;
pub mod convolve;
pub mod cover;
pub mod curves;
pub mod decompose;
pub mod disc;
pub mod enclose;
pub mod error;
pub mod farthest;
pub mod graph;
pub mod interval;
pub mod kinetic;
pub mod lattice;
pub mod locate;
pub mod measure;
pub mod monotone;
pub mod number;
pub mod overlap;
pub mod parts;
pub mod perturbation;
pub mod plain;
pub mod point;
pub mod polygon;
pub mod precise;
pub mod probe;
pub mod region;
pub mod rivals;
pub mod sampled;
pub mod strand;
pub mod trace;
pub mod trapezoid;
pub mod turnings;
pub mod union;
mod walk;
