//! Whether two pieces cross, as far as their precision tells (memo I4).
//!
//! The carriers (lines or circles) meet in at most two points unless they are the same. Pieces are apart if their boxes
//! are, if the carriers are, or if each of the points certainly misses one of the pieces; they cross if the carriers cross
//! properly in a point that is certainly strictly inside both. What touches, overlaps or ends on the other stays open.

use std::cmp::Ordering;

use super::bounds::meet;
use super::piece::{Circle, Piece};
use super::real::Real;
use super::vector::Vector;

/// `Some(true)` if relative interior points of both certainly cross transversally, `Some(false)` if the pieces certainly
/// have no point in common, `None` if the precision does not tell or they touch.
#[must_use]
pub fn crosses(a: &Piece, b: &Piece) -> Option<bool> {
    if !meet(&a.bounds(), &b.bounds()) {
        return Some(false);
    }
    match (&a.circle, &b.circle) {
        (None, None) => lines_cross(a, b),
        (None, Some(circle)) => line_crosses_arc(a, b, circle),
        (Some(circle), None) => line_crosses_arc(b, a, circle),
        (Some(first), Some(second)) => arcs_cross((a, first), (b, second)),
    }
}

/// Lines cross if each has its ends on different sides of the other.
fn lines_cross(a: &Piece, b: &Piece) -> Option<bool> {
    both(separates(a, b), || separates(b, a))
}

/// Whether the line through a has the ends of b strictly on different sides.
fn separates(a: &Piece, b: &Piece) -> Option<bool> {
    let chord = a.chord();
    let [from, to] = [&b.from, &b.to].map(|end| chord.cross(&(end - &a.from)).sign());
    match (from?, to?) {
        (Ordering::Equal, _) | (_, Ordering::Equal) => None,
        (from, to) => Some(from != to),
    }
}

/// With the chord d from p and the centre m + p, the points p + (s/d²) d of the line lie on the circle for
/// s = d·m ± √(r²d² - (d×m)²).
fn line_crosses_arc(line: &Piece, arc: &Piece, circle: &Circle) -> Option<bool> {
    let (chord, arm) = (line.chord(), &circle.centre - &line.from);
    let length = chord.square();
    let reach = circle.radius.square() * &length - chord.cross(&arm).square();
    if reach.is_negative() {
        return Some(false);
    }
    let (foot, root) = (chord.dot(&arm), reach.sqrt());
    let place = |along: Real| {
        let on_line = between(along.sign(), (&length - &along).sign());
        both(on_line, || on_arc(arc, circle, &(&(&chord * &(&along / &length)) - &arm)))
    };
    settle(reach.is_positive(), [place(&foot - &root), place(&foot + &root)])
}

/// With the step d from centre to centre, the circles meet at k d ± h d turned left, from the first centre, for
/// k = (d² + r² - R²) / 2d² and h = √((d² - (r-R)²) ((r+R)² - d²)) / 2d².
fn arcs_cross((a, first): (&Piece, &Circle), (b, second): (&Piece, &Circle)) -> Option<bool> {
    let step = &second.centre - &first.centre;
    let square = step.square();
    let sum = (&first.radius + &second.radius).square();
    let difference = (&first.radius - &second.radius).square();
    let (inner, outer) = (&square - &difference, &sum - &square);
    if inner.is_negative() || outer.is_negative() {
        return Some(false);
    }
    let double = &square * 2.0;
    let along = &(&square + &(first.radius.square() - second.radius.square())) / &double;
    let across = &step.left() * &(&(&inner * &outer).sqrt() / &double);
    let middle = &step * &along;
    let place = |arm: Vector| both(on_arc(a, first, &arm), || on_arc(b, second, &(&arm - &step)));
    settle(inner.is_positive() && outer.is_positive(), [place(&middle - &across), place(&middle + &across)])
}

/// Whether a point of the circle, given from the centre, lies strictly inside the arc; `Some(false)` if it certainly does
/// not belong to the arc, `None` at its ends. The arc is at most a quarter, so that two cross products tell.
fn on_arc(arc: &Piece, circle: &Circle, arm: &Vector) -> Option<bool> {
    let [start, end] = [&arc.from, &arc.to].map(|p| p - &circle.centre);
    let (low, high) = if circle.left { (start, end) } else { (end, start) };
    between(low.turn(arm), arm.turn(&high))
}

/// Whether something is strictly between two ends, given how far it is past the one and before the other.
fn between(after: Option<Ordering>, before: Option<Ordering>) -> Option<bool> {
    use Ordering::{Greater, Less};
    match (after, before) {
        (Some(Less), _) | (_, Some(Less)) => Some(false),
        (Some(Greater), Some(Greater)) => Some(true),
        _ => None,
    }
}

/// Whether both hold; the second is only asked if it matters.
fn both(first: Option<bool>, second: impl FnOnce() -> Option<bool>) -> Option<bool> {
    match first {
        Some(false) => Some(false),
        Some(true) => second(),
        None => second().filter(|&holds| !holds),
    }
}

/// What follows from whether each point where the carriers meet lies strictly inside both pieces.
fn settle(transversal: bool, places: [Option<bool>; 2]) -> Option<bool> {
    if places == [Some(false); 2] { Some(false) } else { (transversal && places.contains(&Some(true))).then_some(true) }
}
