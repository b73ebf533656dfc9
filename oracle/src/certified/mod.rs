//! Certified truth about regions bounded by lines and circle segments (memo I3–I7).
//!
//! Every number is an interval ([`real`]), of doubles first and of MPFR floats of 128 to 4096 bits where doubles cannot
//! tell; a question is answered yes, no or undecided at a precision, never guessed. Radius and bulge are taken literally:
//! the circle through both ends with exactly that radius, the arc with exactly that bulge.

pub mod boundary;
pub mod bounds;
pub mod carriers;
pub mod cell;
pub mod chain;
pub mod characteristic;
pub mod crossing;
pub mod curve;
pub mod depth;
pub mod direction;
pub mod distance;
pub mod fan;
pub mod gap;
pub mod hausdorff;
pub mod inside;
pub mod meet;
pub mod membership;
pub mod nearest;
pub mod piece;
pub mod precision;
pub mod reach;
pub mod real;
pub mod realize;
pub mod reference;
pub mod separation;
pub mod shape;
pub mod slabs;
pub mod spot;
pub mod stretch;
pub mod strips;
pub mod sums;
pub mod tree;
pub mod uprights;
pub mod vector;
pub mod walk;
