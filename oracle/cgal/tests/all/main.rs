//! What the shim promises, and how CGAL's answers compare with those of the references. Without CGAL there is nothing to
//! test but that it is missing.

mod agreement;
mod bad_input;
mod built_in;
mod common;
mod curved;
mod draw;
mod issues;
mod known;
mod offset;
mod silence;
mod verdict;
