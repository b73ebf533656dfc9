//! A robust float engine for Minkowski sums of planar regions bounded by line and circle segments, after Milenkovic and
//! Sacks, *Two approximate Minkowski sum algorithms* (MS in the docs).
//!
//! Data flows one way: a [`region::Region`] is normalised to a [`smooth::Smooth`] region in the unit box, two of these are
//! convolved to [`piece::Pieces`], the pieces are arranged, and the cells of nonzero winding number are extracted as a
//! region again.

pub mod angle;
pub mod arc;
pub mod arrangement;
pub mod boolean;
pub mod boundary;
mod cellwise;
pub mod chain;
pub mod coincide;
pub mod convolution;
pub mod cull;
pub mod errata;
pub mod exact;
pub mod extract;
pub mod format;
pub mod frame;
pub mod heuristic;
pub mod iterate;
mod joint;
mod nesting;
pub mod overlap;
pub mod part;
pub mod piece;
pub mod region;
pub mod robustness;
mod size;
pub mod smooth;
pub mod sum;
pub mod sum3;
pub mod tidy;
mod turn;
pub mod twofold;
pub mod validate;
