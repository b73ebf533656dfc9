//! The heuristic against falsely free points of the kinetic convolution (MS 8.2; memo F): cells too small to be believed.
//!
//! Falsely free points lie in bubbles, which are tiny cells, and in cracks, thin parts of other cells. [`reject`] closes every
//! neck of a free cell, where a vertex is within a threshold of the edge directly above or below it, by a vertical connector
//! of weight 0, which makes cells of cracks; then it counts every free cell as blocked whose largest trapezoid is smaller
//! than the threshold. It returns what it did, and leaves a map as consistent as it found.
//!
//! A point that truly is free is lost if its cell is that small: a slit narrower than the threshold closes. The monotonic
//! convolution leaves few such cells, and keeps slits.

mod cell;
mod neck;
mod split;

use crate::arrangement::Arrangement;
use crate::piece::Pieces;
use neck::Places;

/// The threshold of MS 8.2, in unit-box lengths.
pub const THRESHOLD: f64 = 1e-13;

/// What the heuristic did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rejected {
    /// Necks closed by connectors.
    pub connectors: usize,
    /// Free cells counted as blocked, by a winding number of 1.
    pub cells: usize,
}

/// Closes the necks of free cells and counts small ones as blocked. `threshold` is in units of the frame, like the pieces. The
/// map and its decomposition are changed in place, and the connectors are added to the pieces.
pub fn reject(arrangement: &mut Arrangement, pieces: &mut Pieces, threshold: f64) -> Rejected {
    let places = Places::new(arrangement);
    let necks = neck::necks(arrangement, &places, threshold);
    let refined = split::split(arrangement, &places, &necks, pieces);
    cell::settle(arrangement, &refined);
    let sizes = sizes(arrangement);
    let small = |face: &usize| arrangement.graph.windings[*face][0] == 0 && sizes[*face] < threshold;
    let removed: Vec<usize> = (0..sizes.len()).filter(small).collect();
    removed.iter().for_each(|face| arrangement.graph.windings[*face][0] = 1);
    Rejected { connectors: necks.len(), cells: removed.len() }
}

/// The size of the largest trapezoid of each face. That of the face far away is infinite.
fn sizes(arrangement: &Arrangement) -> Vec<f64> {
    let mut sizes = vec![0.0_f64; arrangement.graph.windings.len()];
    for trapezoid in &arrangement.trapezoids {
        let face = &mut sizes[trapezoid.face as usize];
        *face = face.max(trapezoid.size(&arrangement.graph.curves));
    }
    sizes[0] = f64::INFINITY;
    sizes
}
