//! Convolutions: closed curves whose winding numbers tell the sum from the free space (MS 3; memo B).

pub mod fill;
mod kinetic;
mod sums;

use crate::piece::Pieces;
use crate::smooth::Smooth;
use crate::sum3::Rounding;
use fill::{PairSum, fill};
use sums::Sums;

/// The kinetic convolution of two regions in frames of one scale, with the fill rule applied to every pair of components.
/// `None` when the sum is the whole plane.
#[must_use]
pub fn kinetic(a: &Smooth, b: &Smooth, rounding: Rounding) -> Option<Pieces> {
    let mut sums = Sums::new(a, b, rounding);
    let mut base = 0;
    for i in &a.components {
        for j in &b.components {
            match fill(a, i, b, j) {
                PairSum::Plane => return None,
                PairSum::Loops(filled) => {
                    base += filled.base;
                    kinetic::convolve(&mut sums, a, &filled.a, b, &filled.b);
                }
            }
        }
    }
    Some(sums.finish(base))
}
