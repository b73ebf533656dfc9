//! The size of a case: what engines that tell nothing about themselves are compared by.

use crate::cases::Case;
use arcsum::convolution::kinetic;
use arcsum::frame::Frame;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;

/// The segments of the kinetic convolution of the case (MS 3); none where there is none, as when the sum is the plane.
#[must_use]
pub fn sum_segments(case: &Case) -> Option<u64> {
    let frames = Frame::pair(&case.a, &case.b);
    let a = Smooth::new(&case.a, &frames.0).ok()?;
    let b = Smooth::new(&case.b, &frames.1).ok()?;
    kinetic(&a, &b, Rounding::Correct).map(|pieces| pieces.pieces.len() as u64)
}
