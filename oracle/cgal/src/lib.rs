//! CGAL as a third opinion: its Minkowski sums, offsets and set operations behind one C ABI (memo I7), in exact numbers.
//!
//! Where CGAL is not found when this is built, or without the feature `cgal`, every question is answered by
//! [`error::CgalError::NotBuiltIn`]. Its answers are not the truth: versions in use lose holes (memo I7). Questions are put
//! in this process by [`question::Question::ask`], or by [`child::Child`] in another one, for CGAL can end a process.

mod binding;
pub mod bulge;
pub mod child;
pub mod curved;
pub mod error;
pub mod method;
pub mod offset;
pub mod question;
pub mod sum;
mod text;

pub use binding::{built_in, version};
pub use text::Loops;
