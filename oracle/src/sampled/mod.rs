//! Certified samples of a sum that is too large to be computed: at single places, how near the boundaries of the result and
//! of the exact sum are, or how far off the result certainly is. From the operands and the result alone (memo I6).
//!
//! A sample certifies `near`: the boundary of the sum has a point within so much of the sampled place, which lies on the
//! boundary of the result, or the other way around. It proves `far`: a point of the result is that far from the sum, or a
//! point of the sum that far from the result, which is a lower bound of the region Hausdorff distance. Samples say nothing
//! about the places between them.

mod boundary;
mod regions;
mod sides;
mod walk;

pub use boundary::{COARSEST, FINEST};
pub use regions::Regions;
pub use sides::Sampler;

/// What is known at one place, in unit-box lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The place, in input units.
    pub place: [f64; 2],
    /// The two boundaries come that near to each other here; none without a certificate.
    pub near: Option<f64>,
    /// The result is certainly that far off here; 0 where nothing is proved.
    pub far: f64,
    /// Whether something here could not be decided.
    pub undecided: bool,
}
