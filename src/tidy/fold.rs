//! Folds: corners where a loop runs back along itself within the tolerance. A loop that makes a curl, a turn too many, of the
//! size of a rounding has one there: at the tip of the curl, or at an edge no longer than the tolerance.

use super::edge::Net;
use glam::DVec2;

/// Whether at some corner the shorter edge ends within the tolerance of the longer one.
pub(super) fn folds(net: &Net, tolerance: f64) -> bool {
    net.loops.iter().any(|edges| {
        (0..edges.len()).any(|i| {
            let (before, after) = (net.span(&edges[i]), net.span(&edges[(i + 1) % edges.len()]));
            let (end, other) = if before.tail.distance(before.head) <= after.tail.distance(after.head) {
                (before.tail, after)
            } else {
                (after.head, before)
            };
            let near = |p: DVec2| end.distance(p) <= tolerance;
            near(other.tail) || near(other.head) || other.distance(end).is_some_and(|d| d <= tolerance)
        })
    })
}
