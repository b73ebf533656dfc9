//! Convolutions: closed curves whose winding numbers tell the sum from the free space (MS 3; memo B).

pub mod fill;
mod kinetic;
mod sums;

use crate::angle::Ang;
use crate::piece::Pieces;
use crate::smooth::Smooth;
use crate::sum3::Rounding;
use fill::{PairSum, fill};
use sums::Sums;

/// A place inside an arc of an operand at which sum segments end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Stop {
    /// The loop, an index of [`Smooth::loops`].
    pub of_loop: usize,
    /// The arc, an index of its [`crate::smooth::SmoothLoop::segs`].
    pub seg: usize,
    /// The normal angle there.
    pub angle: Ang,
}

/// The kinetic convolution of two regions in frames of one scale, with the fill rule applied to every pair of
/// components. `None` when the sum is the whole plane.
#[must_use]
pub fn kinetic(a: &Smooth, b: &Smooth, rounding: Rounding) -> Option<Pieces> {
    collect(a, b, rounding).map(|(sums, base)| sums.finish(base))
}

/// The places inside the arcs of each operand at which the segments of their kinetic convolution end, in order: where
/// step 1 of MS 4.2 splits. Nothing when the sum is the whole plane.
#[must_use]
pub fn kinetic_stops(a: &Smooth, b: &Smooth) -> [Vec<Stop>; 2] {
    collect(a, b, Rounding::Correct).map(|(sums, _)| sums.stops()).unwrap_or_default()
}

/// The sum segments and the winding number far away.
fn collect<'a>(a: &'a Smooth, b: &'a Smooth, rounding: Rounding) -> Option<(Sums<'a>, i32)> {
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
    Some((sums, base))
}
