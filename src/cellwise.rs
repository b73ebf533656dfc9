//! Cells decided one by one, for convolutions that have no winding numbers (MS 3): a cell is blocked if A meets t - B for a
//! point t in it.

use crate::arrangement::Arrangement;
use crate::overlap::Overlap;
use crate::smooth::Smooth;
use glam::DVec2;

/// Where the point lies between the left and the right end of a trapezoid, and between its bottom and top. Any numbers do
/// that no sum of coordinates is likely to hit: in the middle, ends of segments of A and t - B may well coincide.
const SPOT: [f64; 2] = [0.464_101_615, 0.535_533_905];

/// Gives blocked cells the winding number 1 and free ones 0. Cells too thin to have a point are blocked.
pub fn decide(arrangement: &mut Arrangement, a: &Smooth, b: &Smooth) {
    let overlap = Overlap::new(a, b);
    let spots = spots(arrangement);
    let graph = &mut arrangement.graph;
    for (face, (winding, spot)) in graph.windings.iter_mut().zip(spots).enumerate() {
        let blocked = if face == 0 { overlap.is_unbounded() } else { spot.is_none_or(|t| overlap.at(t)) };
        *winding = [i32::from(blocked), 0];
    }
    // Open curves have no winding numbers to agree.
    graph.winding_conflicts = 0;
}

/// A point in the largest trapezoid of each face.
fn spots(arrangement: &Arrangement) -> Vec<Option<DVec2>> {
    let curves = &arrangement.graph.curves;
    let mut largest = vec![(0.0, None); arrangement.graph.windings.len()];
    for trapezoid in &arrangement.trapezoids {
        let size = trapezoid.size(curves);
        let face = &mut largest[trapezoid.face as usize];
        if size > face.0 {
            *face = (size, Some(trapezoid.spot(curves, SPOT)));
        }
    }
    largest.into_iter().map(|(_, spot)| spot).collect()
}
