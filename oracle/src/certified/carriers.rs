//! Where the lines and circles that carry two pieces come within the zone of each other (memo I4).
//!
//! The zone is carried through the formulas as an interval: a radius r is used as r + [-Z, Z], the distance of two lines
//! as 0 + [-Z, Z]. What comes out contains every point of the first carrier that is within Z of the second. So the size
//! of a place needs no estimate of its own; it is about Z / sin(angle) where the carriers cross, and sqrt(Z r) for the
//! harmonic mean r of the radii where they touch.

use super::piece::{Circle, Piece};
use super::precision::Precision;
use super::real::Real;
use super::vector::Vector;

/// Carriers that come closer than two to this power are treated as touching there.
pub const ZONE: i32 = -300;
/// Carriers that agree to two to this power are treated as the same.
pub const SAME: i32 = -450;

/// The places where two carriers come within the zone of each other, each with a box around all of it.
pub(super) enum Places {
    /// Nowhere that matters to the pieces.
    Nowhere,
    /// The carriers cross once in each place.
    Crossings(Vec<Vector>),
    /// One place that contains every point within the zone; the carriers cross there, touch, or just do not.
    Tangency(Vector),
    /// They are the same to within two to the power of [`SAME`].
    Same,
    /// This precision cannot tell.
    Unclear,
}

impl Places {
    /// The places for the carriers of two pieces.
    pub(super) fn of(first: &Piece, second: &Piece, precision: Precision) -> Self {
        match (&first.circle, &second.circle) {
            (None, None) => lines(first, second, precision),
            (None, Some(circle)) => line_and_circle(first, circle, precision),
            (Some(circle), None) => line_and_circle(second, circle, precision),
            (Some(a), Some(b)) => circles(a, b, precision),
        }
    }
}

/// A box grown by the zone on all sides: from the points of one carrier near another to those of both.
pub(super) fn grown(place: &Vector, precision: Precision) -> Vector {
    let zone = zone(precision);
    Vector { x: &place.x + &zone, y: &place.y + &zone }
}

/// The numbers of size up to the zone.
pub(super) fn zone(precision: Precision) -> Real {
    symmetric(&Real::new(f64::from(ZONE).exp2(), precision))
}

/// The numbers no larger than this one.
fn symmetric(size: &Real) -> Real {
    size.hull(&-size)
}

fn lines(first: &Piece, second: &Piece, precision: Precision) -> Places {
    if is_beside(first, second, precision) || is_beside(second, first, precision) {
        return Places::Nowhere;
    }
    // Only on a line of its own precision is it worth a look.
    if precision > Precision::DOUBLE && same_lines(first, second) {
        return Places::Same;
    }
    let (along, across) = (first.chord(), second.chord());
    let turn = across.cross(&along);
    if turn.sign().is_none_or(|sign| sign.is_eq()) {
        return Places::Unclear;
    }
    let height = across.cross(&(&second.from - &first.from)) + across.length() * zone(precision);
    Places::Crossings(vec![grown(&(&first.from + &(&along * &(height / turn))), precision)])
}

/// Whether both ends of a line are beyond the zone on the same side of another.
fn is_beside(line: &Piece, other: &Piece, precision: Precision) -> bool {
    let chord = other.chord();
    let limit = chord.length() * Real::new(f64::from(ZONE).exp2(), precision);
    let [a, b] = [&line.from, &line.to].map(|end| chord.cross(&(end - &other.from)));
    (limit.is_below(&a) && limit.is_below(&b)) || (a.is_below(&-&limit) && b.is_below(&-&limit))
}

fn same_lines(first: &Piece, second: &Piece) -> bool {
    let carries =
        |line: &Piece, other: &Piece| [&other.from, &other.to].into_iter().all(|end| line.offset(end).is_within(SAME));
    carries(first, second) && carries(second, first)
}

fn line_and_circle(line: &Piece, circle: &Circle, precision: Precision) -> Places {
    let direction = line.chord().unit();
    let arm = &circle.centre - &line.from;
    let foot = &line.from + &(&direction * &arm.dot(&direction));
    let reach = (&circle.radius + zone(precision)).square() - direction.cross(&arm).square();
    pair(&foot, &direction, &reach, precision)
}

fn circles(a: &Circle, b: &Circle, precision: Precision) -> Places {
    let limit = Real::new(f64::from(ZONE).exp2(), precision);
    let distance = a.centre.distance(&b.centre);
    let difference = (&a.radius - &b.radius).abs();
    if precision > Precision::DOUBLE && distance.is_within(SAME) && difference.is_within(SAME) {
        return Places::Same;
    }
    let outside = &distance - &(&a.radius + &b.radius);
    if limit.is_below(&outside) || limit.is_below(&(&difference - &distance)) {
        return Places::Nowhere;
    }
    if !distance.is_positive() {
        return Places::Unclear;
    }
    // From the smaller circle the place is known best.
    let (small, large) = if a.radius.mid() <= b.radius.mid() { (a, b) } else { (b, a) };
    let axis = &(&large.centre - &small.centre) * &(Real::from(1.0) / &distance);
    let radius = &large.radius + zone(precision);
    let along = ((&distance - &radius) * (&distance + &radius) + small.radius.square()) / (&distance * 2.0);
    let foot = &small.centre + &(&axis * &along);
    pair(&foot, &axis.left(), &(small.radius.square() - along.square()), precision)
}

/// The two places at this squared distance from a foot, in a direction of length 1 and against it.
fn pair(foot: &Vector, direction: &Vector, square: &Real, precision: Precision) -> Places {
    let reach = square.sqrt();
    if square.is_negative() {
        Places::Nowhere
    } else if square.is_positive() {
        let ends = [-&reach, reach].map(|step| grown(&(foot + &(direction * &step)), precision));
        Places::Crossings(ends.to_vec())
    } else {
        Places::Tangency(grown(&(foot + &(direction * &symmetric(&reach))), precision))
    }
}
