//! The distance between two pieces in closed form (memo I4).
//!
//! If two pieces have no point in common, a pair of nearest points is one of these: an end of one and the point of the
//! other nearest to it, or two inner points on a common normal. On the common normal of a line and a circle, or of two
//! circles, the distance has a minimum only where the carriers do not meet, and then in one place: between a line and a
//! circle beside it, between circles beside each other, or in the narrow part between nested circles. Everywhere else
//! moving one of the points brings it nearer to the other piece. Parallel lines and concentric arcs keep their distance, so
//! that an end also attains it. Every pair considered is a pair of points of the pieces; if it is open whether it is one,
//! it counts for the lower bound only.

use super::bounds;
use super::crossing::crosses;
use super::piece::{Circle, Piece};
use super::real::Real;
use super::vector::Vector;

/// An interval around the distance of the pieces: 0 where they certainly cross, from 0 up where they may have a point in
/// common. It is as tight as the precision allows, in absolute terms.
#[must_use]
pub fn gap(a: &Piece, b: &Piece) -> Real {
    let crossing = crosses(a, b);
    if crossing == Some(true) {
        return Real::from(0.0);
    }
    let mut nearest = between_ends(a, b);
    let feet = [(a, &b.from), (a, &b.to), (b, &a.from), (b, &a.to)].map(|(piece, end)| foot(piece, end));
    for (distance, exists) in feet.into_iter().flatten().chain(stationary(a, b)) {
        let smaller = nearest.min(&distance);
        nearest = if exists { smaller } else { nearest.hull(&smaller) };
    }
    match crossing {
        None => nearest.hull(&Real::from(0.0)),
        Some(_) => nearest.max(&Real::from(bounds::distance(&a.bounds(), &b.bounds()))),
    }
}

/// The least distance between an end of one and an end of the other.
fn between_ends(a: &Piece, b: &Piece) -> Real {
    let [first, second] = [&a.from, &a.to].map(|end| (end - &b.from).square().min(&(end - &b.to).square()));
    first.min(&second).sqrt()
}

/// The distance of a point to the nearest inner point of a piece, and whether there certainly is one; `None` if there
/// certainly is none.
fn foot(piece: &Piece, point: &Vector) -> Option<(Real, bool)> {
    let exists = spanned(piece.spans(point), || Some(true))?;
    Some((piece.offset(point), exists))
}

/// The distance on a common normal that may be less than at the ends, and whether its points certainly belong to the
/// pieces; `None` if there is certainly no such place.
fn stationary(a: &Piece, b: &Piece) -> Option<(Real, bool)> {
    match (&a.circle, &b.circle) {
        (None, None) => None,
        (None, Some(circle)) => beside_line(a, b, circle),
        (Some(circle), None) => beside_line(b, a, circle),
        (Some(first), Some(second)) => on_line_of_centres((a, first), (b, second)),
    }
}

/// Between a line and a circle on one side of it.
fn beside_line(line: &Piece, arc: &Piece, circle: &Circle) -> Option<(Real, bool)> {
    let chord = line.chord();
    let height = chord.cross(&(&circle.centre - &line.from));
    let distance = height.abs() / chord.length() - &circle.radius;
    if distance.is_negative() {
        return None;
    }
    let towards_line = &chord.left() * &-&height;
    let exists = spanned(line.spans(&circle.centre), || arc.spans(&(&circle.centre + &towards_line)))?;
    Some((distance.abs(), exists))
}

/// Between two circles beside each other, or one inside the other.
fn on_line_of_centres((a, first): (&Piece, &Circle), (b, second): (&Piece, &Circle)) -> Option<(Real, bool)> {
    let (c, d) = (&first.centre, &second.centre);
    let apart = c.distance(d);
    let difference = &first.radius - &second.radius;
    let [beyond_c, beyond_d] = [&(c + c) - d, &(d + d) - c];
    let places = [
        (&apart - &(&first.radius + &second.radius), d, c),
        (&difference - &apart, d, &beyond_d),
        (-&difference - &apart, &beyond_c, c),
    ];
    let mut found: Option<(Real, bool)> = None;
    for (distance, towards_on_a, towards_on_b) in places {
        if distance.is_negative() {
            continue;
        }
        if let Some(exists) = spanned(a.spans(towards_on_a), || b.spans(towards_on_b)) {
            let distance = distance.abs();
            // Two places can only both be open, not both exist, unless a radius is 0.
            found = Some(match found {
                None => (distance, exists),
                Some((other, also)) => (distance.min(&other), exists && also),
            });
        }
    }
    found
}

/// Whether both directions certainly meet their pieces; `None` if one certainly does not.
fn spanned(first: Option<bool>, second: impl FnOnce() -> Option<bool>) -> Option<bool> {
    if first == Some(false) {
        return None;
    }
    match second() {
        Some(false) => None,
        second => Some(first == Some(true) && second == Some(true)),
    }
}
