//! Parts of pieces, between vertices that lie on them up to rounding.

use crate::angle::Ang;
use crate::piece::{Piece, Pieces};
use glam::DVec2;

/// Parts of the pieces of a convolution, and what was added to keep the curves closed.
#[derive(Clone, Debug)]
pub struct Parts {
    /// The parts, and what was added.
    pub pieces: Pieces,
    /// The piece that each is a part of; none for what was added.
    pub origins: Vec<Option<u32>>,
}

impl Parts {
    /// Parts of these parts, as parts of what these are parts of.
    #[must_use]
    pub(crate) fn refined(&self, parts: Self) -> Self {
        let origins = parts.origins.into_iter().map(|origin| origin.and_then(|part| self.origins[part as usize]));
        Self { pieces: parts.pieces, origins: origins.collect() }
    }
}

/// The part of a whole piece from one vertex to another, in its direction. A part too short to have a width is straight.
pub(crate) fn part(points: &[DVec2], piece: &Piece, tail: u32, head: u32) -> Piece {
    if [tail, head] == [piece.tail, piece.head] {
        return *piece;
    }
    let width = |[from, to]: [u32; 2]| points[to as usize].x - points[from as usize].x;
    if width([tail, head]) * width([piece.tail, piece.head]).signum() <= 0.0 {
        return Piece::between(points, tail, head, piece.source);
    }
    let [a, b] = [tail, head].map(|vertex| piece.a.plus(turned(points, piece, vertex)));
    Piece { tail, head, a, b, ..*piece }
}

/// How far the normal has turned at a vertex: twice the angle between the tangent at the nearer end and the chord to it.
fn turned(points: &[DVec2], piece: &Piece, vertex: u32) -> f64 {
    let whole = 2.0 * piece.delta;
    if vertex == piece.tail || whole == 0.0 {
        return 0.0;
    }
    if vertex == piece.head {
        return whole;
    }
    let [tail, p, head] = [piece.tail, vertex, piece.head].map(|v| points[v as usize]);
    let turned = if tail.distance_squared(p) <= p.distance_squared(head) {
        Ang::of_line(tail, p).map_or(0.0, |chord| 2.0 * piece.a.turn_to(chord))
    } else {
        Ang::of_line(p, head).map_or(whole, |chord| whole - 2.0 * chord.turn_to(piece.b))
    };
    turned.clamp(whole.min(0.0), whole.max(0.0))
}
