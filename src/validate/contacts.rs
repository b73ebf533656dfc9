//! Where the boundary meets itself: crossings, shared stretches and self-touches are defects; the touches of different
//! loops that remain are returned.

use super::arc::{is_short, overlap, stretch, touches};
use super::boundary::{Boundary, Part, TOLERANCE};
use super::boxes::{Box2, Tree};
use super::line;
use super::sweep::sweep;
use super::touch::{Spot, Touch};
use super::{Contact, Invalid, Meeting};
use glam::DVec2;

/// The tree of the boxes of all parts.
pub fn tree(boundary: &Boundary) -> Tree {
    Tree::new(boundary.parts.iter().map(|part| bounds(boundary, part)).collect())
}

/// The box of a part, widened by the tolerance if it is curved.
fn bounds(boundary: &Boundary, part: &Part) -> Box2 {
    Box2::of(part.tail, part.head, if part.is_line() { 0.0 } else { boundary.tolerance })
}

/// Checks all pairs of parts that can meet: lines by a sweep, a curve with each part whose box meets its own. Returns the
/// touches of different loops.
pub fn check(boundary: &Boundary, tree: &Tree) -> Result<Vec<Touch>, Invalid> {
    let mut touches = Vec::new();
    sweep(&boundary.parts, |i, j| check_lines(boundary, i.min(j), i.max(j), &mut touches))?;
    let curves = (0..boundary.parts.len()).filter(|&i| !boundary.parts[i].is_line());
    let mut others = Vec::new();
    for i in curves {
        others.clear();
        tree.on_box(&bounds(boundary, &boundary.parts[i]), &mut |j| others.push(j));
        others.retain(|&j| j > i || (j < i && boundary.parts[j].is_line()));
        others.iter().try_for_each(|&j| check_curves(boundary, i.min(j), i.max(j), &mut touches))?;
    }
    Ok(touches)
}

fn check_lines(boundary: &Boundary, i: usize, j: usize, touches: &mut Vec<Touch>) -> Result<(), Invalid> {
    let (p, q) = (&boundary.parts[i], &boundary.parts[j]);
    let Some((contact, at)) = line::meet((p.tail, p.head), (q.tail, q.head)) else { return Ok(()) };
    if contact != Contact::Touch {
        return Err(defect(boundary, i, j, contact, at));
    }
    if boundary.loop_of(i) == boundary.loop_of(j) {
        let joint = boundary.next(i) == j && at == q.tail || boundary.next(j) == i && at == p.tail;
        return if joint { Ok(()) } else { Err(defect(boundary, i, j, contact, at)) };
    }
    if at == p.head || at == q.head {
        // The next part, which starts here, sees the same touch.
        return Ok(());
    }
    // Inside a line only the order along it matters, not rounding; but it must not be taken for an end.
    let inside = |part: &Part| part.share(at).clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON);
    let spot =
        |index: usize, part: &Part| Spot { part: index, share: if at == part.tail { 0.0 } else { inside(part) } };
    keep(boundary, Touch { at, spots: [spot(i, p), spot(j, q)], exact: true }, touches)
}

fn check_curves(boundary: &Boundary, i: usize, j: usize, found: &mut Vec<Touch>) -> Result<(), Invalid> {
    if let Some(at) = overlap(boundary, i, j) {
        return Err(defect(boundary, i, j, Contact::Overlap, at));
    }
    if folds(boundary, i, j) || folds(boundary, j, i) {
        let joint = boundary.parts[if boundary.next(i) == j { j } else { i }].tail;
        return Err(defect(boundary, i, j, Contact::Fold, joint));
    }
    for touch in touches(boundary, i, j) {
        if boundary.loop_of(i) != boundary.loop_of(j) {
            keep(boundary, touch, found)?;
            continue;
        }
        let [p, q] = touch.spots;
        let limit = stretch(boundary, i, j);
        if touch.crosses(boundary) {
            return Err(defect(boundary, i, j, Contact::Cross, touch.at));
        }
        // Curves that leave a common vertex side by side keep within the tolerance for a while.
        if touch.exact || !(is_short(boundary, p, q, limit) || is_short(boundary, q, p, limit)) {
            return Err(defect(boundary, i, j, Contact::Touch, touch.at));
        }
    }
    Ok(())
}

/// Whether the second part follows the first and turns back by 180 degrees, which leaves the sign of the turn undefined
/// (memo A7).
fn folds(boundary: &Boundary, i: usize, j: usize) -> bool {
    let (arriving, leaving) = (boundary.parts[i].direction(1.0), boundary.parts[j].direction(0.0));
    boundary.next(i) == j
        && arriving.dot(leaving) < 0.0
        && arriving.perp_dot(leaving).abs() <= TOLERANCE * arriving.length() * leaving.length()
}

/// Keeps a touch of different loops, unless it is a crossing.
fn keep(boundary: &Boundary, touch: Touch, touches: &mut Vec<Touch>) -> Result<(), Invalid> {
    if touch.crosses(boundary) {
        let [p, q] = touch.spots;
        return Err(defect(boundary, p.part, q.part, Contact::Cross, touch.at));
    }
    touches.push(touch);
    Ok(())
}

fn defect(boundary: &Boundary, i: usize, j: usize, contact: Contact, at: DVec2) -> Invalid {
    let point = boundary.grid.unscale_point(at);
    let (first, second) = (boundary.parts[i].place, boundary.parts[j].place);
    let meeting = Meeting { first, second, contact, x: point.x, y: point.y };
    if first.loop_index == second.loop_index {
        Invalid::SelfIntersection(meeting)
    } else {
        Invalid::OverlappingLoops(meeting)
    }
}
