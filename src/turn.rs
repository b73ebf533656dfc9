//! The signed turn at a vertex from one segment to the next (memo A7).
//!
//! Two segments that meet in a cusp, 180 degrees up to rounding, turn to the side that the angles cannot tell: a spike
//! of the region turns left (convex), a crack in it turns right. There, lines are compared by an exact orientation test
//! and arcs by their curvature.

use crate::angle::Ang;
use crate::exact::orientation;
use glam::DVec2;
use std::f64::consts::PI;

/// Turns within this of a half turn are decided by geometry, not by the sign of the angle: 16 eps, more than the errors
/// of two angles.
const CUSP: f64 = 8.0 * f64::EPSILON;

/// A segment at a turn: its ends and signed radius, 0 for a line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bend {
    pub(crate) tail: DVec2,
    pub(crate) head: DVec2,
    pub(crate) r: f64,
}

/// The turn in radians from angle b, where `before` ends, to angle a, where `after` starts: within pi, or beyond it by
/// no more than [`CUSP`] at a cusp. `None` if the two run back over each other.
pub(crate) fn turn(b: Ang, a: Ang, before: &Bend, after: &Bend) -> Option<f64> {
    let turn = b.turn_to(a);
    if turn.abs() < PI - CUSP {
        return Some(turn);
    }
    let side = if before.r == 0.0 && after.r == 0.0 {
        f64::from(orientation(before.tail, before.head, after.head) as i8)
    } else {
        // Next to the cusp, `after` runs left of `before`, with the region's inside between them, if it curves less.
        let curvature = |bend: &Bend| if bend.r == 0.0 { 0.0 } else { 1.0 / bend.r };
        -(curvature(before) + curvature(after))
    };
    (side != 0.0).then(|| libm::copysign(turn, side))
}
