//! Certified truth about regions bounded by lines and circle segments (memo I3–I7).
//!
//! Every number is an interval ([`real`]), of doubles first and of MPFR floats of 128 to 4096 bits where doubles cannot
//! tell; a question is answered yes, no or undecided at a precision, never guessed. Radius and bulge are taken literally:
//! the circle through both ends with exactly that radius, the arc with exactly that bulge.

pub mod curve;
pub mod piece;
pub mod precision;
pub mod real;
pub mod realize;
pub mod shape;
pub mod vector;
