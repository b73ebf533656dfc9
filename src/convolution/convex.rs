//! The convex convolution: the sums of boundary points with equal normals at which A and t - B touch without overlapping, those
//! whose curvatures add up to no negative number (MS 3; memo B1, M17, M18).
//!
//! The boundary of the sum is part of it, in exact arithmetic. It is no closed curve: segments end inside the sum, and there
//! are no winding numbers, so every cell has to be decided by itself ([`crate::cellwise`]). A gap of one rounding between two
//! segments joins a free cell to a blocked one, so its error has no bound. It is here to be compared with.

use super::fill::Filled;
use super::kinetic::{Side, convolve};
use super::sums::{Summand, Sums};
use crate::smooth::{Kind, Smooth};

/// Adds the convex convolution of two components.
pub fn convex(sums: &mut Sums, filled: &Filled) {
    let (a, b) = sums.regions();
    let first = sums.len();
    sums.forward_only = true;
    convolve(sums, [Side::of_loops(a, &filled.a), Side::of_loops(b, &filled.b)]);
    sums.forward_only = false;
    let taken = sums.take_from(first);
    for (piece, summands) in taken.pieces.into_iter().zip(taken.summands) {
        if curvature(a, summands[0]) + curvature(b, summands[1]) >= 0.0 {
            sums.push(piece, summands);
        }
    }
}

/// The curvature of a summand: 0 for a line, infinite for a turn, of which only convex ones have been taken.
fn curvature(region: &Smooth, summand: Summand) -> f64 {
    match summand {
        Summand::Vertex(_) => f64::INFINITY,
        Summand::Segment(of_loop, index) => {
            let seg = &region.loops[of_loop as usize].segs[index as usize];
            if seg.kind == Kind::Line { 0.0 } else { seg.r.recip() }
        }
    }
}
