//! Extraction: the boundary of selected cells as loops of lines and circle segments again (memo D).
//!
//! A boundary edge has exactly one selected side. Loops are traced with the selection on the left, turning to stay in the
//! same sector at every vertex, then split where they touch themselves, so every loop is simple as far as identities
//! go: outer loops run counter-clockwise, holes clockwise. Pieces of one source are merged where no other part of the boundary
//! touches them, otherwise iterated sums would grow without end.

mod places;
mod run;
mod trace;

use crate::arrangement::Arrangement;
use crate::piece::Pieces;
use crate::region::{Curve, Node, Region};
use glam::DVec2;
use places::Places;
use run::Runs;
use trace::Pinches;

/// A vertex of a loop, in units of the frame, and half the sweep of the segment that leaves it: 0 for a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// The vertex.
    pub point: DVec2,
    /// Half the signed sweep in radians, within pi/2.
    pub delta: f64,
}

/// The boundary of the cells whose winding numbers are selected, each component's outer loop before its holes, in units
/// of the frame.
#[must_use]
pub fn outline(arrangement: &Arrangement, pieces: &Pieces, selected: impl Fn([i32; 2]) -> bool) -> Vec<Vec<Corner>> {
    let graph = &arrangement.graph;
    let places = Places::new(&graph.points);
    let traced = trace::loops(graph, &places, selected);
    let pinches = Pinches::new(graph, &places, &traced);
    let mut runs = Runs::new(graph, pieces, &places, &pinches);
    let mut loops: Vec<(u32, bool, Vec<Corner>)> = Vec::new();
    for (component, halves) in traced.iter() {
        let corners = runs.corners(halves);
        if !is_flat(&corners) {
            loops.push((component, signed_area(&corners) < 0.0, corners));
        }
    }
    loops.sort_by_key(|(component, hole, _)| (*component, *hole));
    loops.into_iter().map(|(_, _, corners)| corners).collect()
}

/// Makes a region of an outline, with its points carried to input units. What the rounding of `to_input` collapses is
/// dropped.
#[must_use]
pub fn region(outline: &[Vec<Corner>], unbounded: bool, to_input: impl Fn(DVec2) -> DVec2) -> Region {
    let mut mapped = Vec::new();
    let loops = outline.iter().filter_map(|corners| {
        mapped.clear();
        mapped.extend(corners.iter().map(|c| Corner { point: to_input(c.point), ..*c }));
        drop_repeats(&mut mapped);
        (!is_flat(&mapped)).then(|| mapped.iter().map(node).collect())
    });
    Region { name: None, loops: loops.collect(), unbounded }
}

fn node(corner: &Corner) -> Node {
    let bulge = if corner.delta == 0.0 { 0.0 } else { libm::tan(0.5 * corner.delta) };
    let curve = if bulge == 0.0 { Curve::Line } else { Curve::Bulge(bulge) };
    Node { x: corner.point.x, y: corner.point.y, curve }
}

/// Drops segments of length zero.
fn drop_repeats(corners: &mut Vec<Corner>) {
    // Of each run of equal points the last one has the segment that leaves.
    corners.dedup_by(|next, kept| {
        let same = next.point == kept.point;
        if same {
            *kept = *next;
        }
        same
    });
    if corners.len() > 1 && corners[0].point == corners[corners.len() - 1].point {
        corners.pop();
    }
}

/// Whether a loop bounds nothing: too few segments, or two that run back on each other.
fn is_flat(corners: &[Corner]) -> bool {
    match corners {
        [] | [_] => true,
        [c, d] => c.delta + d.delta == 0.0,
        _ => false,
    }
}

/// Signed area of a loop, positive counter-clockwise; good for the sign, not for the digits of slivers.
#[must_use]
pub fn signed_area(corners: &[Corner]) -> f64 {
    let n = corners.len();
    let origin = corners[0].point;
    let twice: f64 = (0..n)
        .map(|i| {
            let (p, q) = (corners[i].point - origin, corners[(i + 1) % n].point - origin);
            p.x * q.y - p.y * q.x + (q - p).length_squared() * segment_factor(corners[i].delta)
        })
        .sum();
    0.5 * twice
}

/// Twice the area between an arc and its chord of length 1: (2 delta - sin 2 delta) / (4 sin^2 delta).
fn segment_factor(delta: f64) -> f64 {
    if delta.abs() < 1e-4 {
        // Leading term; the next is of relative size delta^2.
        return delta / 3.0;
    }
    let s = libm::sin(delta);
    (2.0 * delta - libm::sin(2.0 * delta)) / (4.0 * s * s)
}
