//! Nesting: which holes belong to which outer loop, so that a region falls into its connected parts (memo A8).
//!
//! Each hole goes to the smallest outer loop around it. Loops of a valid region may touch, so a probe point counts only
//! if it is clear of the outer loop by more than rounding, and the majority of several probes decides.

use crate::arc::Arc;
use crate::smooth::{Component, Kind, Seg, SmoothLoop};
use glam::DVec2;

/// Distances from a loop below this, in the unit box, count as touching: 16 eps.
const TOUCH: f64 = 8.0 * f64::EPSILON;

/// How many segments of a hole are probed, each at its tail and in its middle.
const PROBES: usize = 8;

/// The connected parts, the unbounded one first if there is one. `outer` tells for each loop whether it is an outer
/// one.
///
/// # Errors
/// The index of a hole that lies in no outer loop of a bounded region.
pub(crate) fn components(
    points: &[DVec2],
    loops: &[SmoothLoop],
    outer: &[bool],
    unbounded: bool,
) -> Result<Vec<Component>, usize> {
    let shell = |i| Component { outer: Some(i), holes: Vec::new() };
    let far = unbounded.then_some(Component { outer: None, holes: Vec::new() });
    let shells = (0..loops.len()).filter(|&i| outer[i]).map(shell);
    let mut parts: Vec<Component> = far.into_iter().chain(shells).collect();
    for hole in (0..loops.len()).filter(|&i| !outer[i]) {
        let area = |part: &Component| part.outer.map_or(f64::INFINITY, |i| box_area(&loops[i]));
        let around = |part: &&mut Component| part.outer.is_none_or(|i| contains(points, &loops[i], &loops[hole]));
        let owner = parts.iter_mut().filter(around).min_by(|x, y| area(x).total_cmp(&area(y)));
        owner.ok_or(hole)?.holes.push(hole);
    }
    Ok(parts)
}

fn box_area(of: &SmoothLoop) -> f64 {
    (of.max - of.min).element_product()
}

/// Whether the outer loop contains the inner one, given that the two do not cross.
fn contains(points: &[DVec2], outer: &SmoothLoop, inner: &SmoothLoop) -> bool {
    let slack = DVec2::splat(TOUCH);
    if (inner.min + slack).cmplt(outer.min).any() || (inner.max - slack).cmpgt(outer.max).any() {
        return false;
    }
    let probes = probes(points, inner);
    let inside = |p: &DVec2| winding(points, outer, *p).map(|w| if w == 0 { -1 } else { 1 });
    probes.iter().filter_map(inside).sum::<i32>() > 0
}

fn probes(points: &[DVec2], of: &SmoothLoop) -> Vec<DVec2> {
    let segs: Vec<&Seg> = of.segs.iter().filter(|s| s.kind != Kind::Turn).collect();
    let step = segs.len().div_ceil(PROBES).max(1);
    segs.iter().step_by(step).flat_map(|s| [points[s.tail as usize], middle(points, s)]).collect()
}

fn middle(points: &[DVec2], seg: &Seg) -> DVec2 {
    let (tail, head) = (points[seg.tail as usize], points[seg.head as usize]);
    if seg.kind == Kind::Line {
        return tail.midpoint(head);
    }
    let (end, way) = Arc::minor(tail, head, seg.a, seg.b, seg.delta < 0.0).offset(seg.a.plus(seg.delta));
    end + way
}

/// The winding number of the loop about p; `None` if p lies on the loop but for rounding.
fn winding(points: &[DVec2], of: &SmoothLoop, p: DVec2) -> Option<i32> {
    let mut winding = 0;
    for seg in of.segs.iter().filter(|s| s.kind != Kind::Turn) {
        let (tail, head) = (points[seg.tail as usize], points[seg.head as usize]);
        let (lo, hi) = (tail.min(head), tail.max(head));
        let near = p.cmpge(lo - TOUCH).all() && p.cmple(hi + TOUCH).all();
        let left = if near { left_by(tail, head, seg.delta, p) } else { 0.0 };
        if near && left.abs() <= TOUCH {
            return None;
        }
        let (rises, spans) = (tail.y < head.y, lo.y <= p.y && p.y < hi.y);
        let crosses_right_of_p = if near { (left > 0.0) == rises } else { p.x < lo.x };
        if spans && crosses_right_of_p {
            winding += if rises { 1 } else { -1 };
        }
    }
    Some(winding)
}

/// About how far p lies to the left of the line or arc, from (p-t).(h-p) sin delta = (p-t)x(h-p) cos delta on it
/// (memo C1). Good near the segment; elsewhere in its box the sign counts.
fn left_by(tail: DVec2, head: DVec2, delta: f64, p: DVec2) -> f64 {
    let (sin, cos) = libm::sincos(delta);
    let (to, from) = (p - tail, head - p);
    let length = (head - tail).length();
    if to == DVec2::ZERO || from == DVec2::ZERO || length == 0.0 {
        return 0.0;
    }
    (to.dot(from) * sin - to.perp_dot(from) * cos) / length
}
