//! Boundaries in plain doubles, by ways of their own: length, area, winding numbers, and whether two are the same.

use arcsum_oracle::certified::boundary::Boundary;
use arcsum_oracle::certified::curve::Curve;
use arcsum_oracle::certified::meet::{LIMIT, Meeting, meet};
use arcsum_oracle::certified::piece::Piece;
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::stretch::along;
use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::plain::PlainRegion;

/// The precision at which edges are compared.
pub const FINE: Precision = Precision::LADDER[2];

/// The boundary pieces of a region. In intervals of doubles nearly flat arcs would be unknown.
pub fn sides(region: &PlainRegion) -> Vec<Piece> {
    let shape = Shape::new(region).expect("valid numbers");
    shape.sides().map(|side| side.curve.at(FINE).clone()).collect()
}

/// The edges of a boundary.
pub fn edges(boundary: &Boundary) -> Vec<Piece> {
    boundary.edges.iter().map(|edge| edge.curve.at(FINE).clone()).collect()
}

/// The length of the chord, the radius (infinite for a line) and the angle of an arc, positive counter-clockwise.
fn sweep(piece: &Piece) -> (f64, f64, f64) {
    let chord = piece.chord().length().mid();
    let Some(circle) = &piece.circle else { return (chord, f64::INFINITY, 0.0) };
    let radius = circle.radius.mid();
    let angle = 2.0 * (0.5 * chord / radius).min(1.0).asin();
    (chord, radius, if circle.left { angle } else { -angle })
}

/// The total length.
pub fn length(pieces: &[Piece]) -> f64 {
    let one = |piece: &Piece| match sweep(piece) {
        (chord, _, 0.0) => chord,
        (_, radius, angle) => radius * angle.abs(),
    };
    pieces.iter().map(one).sum()
}

/// The enclosed area.
pub fn area(pieces: &[Piece]) -> f64 {
    let one = |piece: &Piece| {
        let triangle = 0.5 * piece.from.cross(&piece.to).mid();
        let cap = match sweep(piece) {
            (chord, radius, angle) if angle.abs() < 1e-4 => chord.powi(3) / (12.0 * radius) * angle.signum(),
            (_, radius, angle) => 0.5 * radius * radius * (angle - angle.sin()),
        };
        triangle + cap
    };
    pieces.iter().map(one).sum()
}

/// The winding number around a point by the pieces above it; none where an upward ray comes close to an end or a piece.
pub fn winds(pieces: &[Piece], x: f64, y: f64) -> Option<i32> {
    const CLOSE: f64 = 1e-9;
    let mut number = 0;
    for piece in pieces {
        let [from, to] = [piece.from.nearest(), piece.to.nearest()];
        if (from.0 - x).abs() < CLOSE || (to.0 - x).abs() < CLOSE {
            return None;
        }
        if (from.0 < x) == (to.0 < x) {
            continue;
        }
        let height = piece.ordinate(&Real::from(x)).mid() - y;
        if height.abs() < CLOSE {
            return None;
        }
        if height > 0.0 {
            number += if to.0 < from.0 { 1 } else { -1 };
        }
    }
    Some(number)
}

/// The distance of a point to the nearest piece.
pub fn distance(pieces: &[Piece], x: f64, y: f64) -> f64 {
    let point = Vector::new(x, y, Precision::DOUBLE);
    pieces.iter().map(|piece| piece.distance(&point).mid()).fold(f64::INFINITY, f64::min)
}

/// Whether every edge of one boundary, mapped, runs along edges of the other in the same direction, to 2^-80.
pub fn runs_along(one: &Boundary, other: &Boundary, map: impl Fn(&Vector) -> Vector) -> bool {
    let covers = |point: &Vector, next: &Vector, curve: &Curve| {
        let [x0, y0, x1, y1] = curve.rough().bounds();
        let (x, y) = point.nearest();
        let near = x0 - 1e-9 < x && x < x1 + 1e-9 && y0 - 1e-9 < y && y < y1 + 1e-9;
        near && {
            let piece = curve.at(FINE);
            piece.distance(point).is_within(-80) && piece.tangent(point).dot(&(next - point)).mid() > 0.0
        }
    };
    one.edges.iter().all(|edge| {
        let piece = edge.curve.at(FINE);
        [0.125, 0.5, 0.875].into_iter().all(|t| {
            let [point, next] = [t, t + 0.01].map(|t| map(&along(piece, &Real::new(t, FINE))));
            other.edges.iter().any(|edge| covers(&point, &next, &edge.curve))
        })
    })
}

/// Whether the loops of a region have no points in common but the vertices of neighbouring pieces.
pub fn is_simple(region: &PlainRegion) -> bool {
    let Ok(shape) = Shape::new(region) else { return false };
    let sides: Vec<_> = shape.sides().map(|side| &side.curve).collect();
    let is_joint = |place: &Vector, joint: &Vector| place.distance(joint).lo() < 1e-12;
    (0..sides.len()).all(|i| {
        (0..i).all(|j| {
            let joints: Vec<Vector> = [(i, j), (j, i)]
                .into_iter()
                .filter(|&(i, j)| (sides[i].rough().to.distance(&sides[j].rough().from)).lo() == 0.0)
                .map(|(i, _)| sides[i].rough().to.clone())
                .collect();
            let meeting = LIMIT.decide(|p| match meet(sides[i].at(p), sides[j].at(p), p) {
                Meeting::Unclear => None,
                meeting => Some(meeting),
            });
            match meeting {
                Some(Meeting::Apart) => true,
                Some(Meeting::Contacts { contacts, .. }) => {
                    contacts.iter().all(|contact| joints.iter().any(|joint| is_joint(&contact.place, joint)))
                }
                _ => false,
            }
        })
    })
}
