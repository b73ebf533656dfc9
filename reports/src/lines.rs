//! Questions about convolutions of polygons: how far a point is from their pieces, its winding number in exact arithmetic, and
//! where it is in input units.

use arcsum::frame::Frame;
use arcsum::piece::{Piece, Pieces};
use arcsum_oracle::chains::{Point, winding};
use glam::DVec2;
use rug::Rational;

/// The distance of a point from the nearest of some lines, in doubles.
#[must_use]
pub fn distance(pieces: &Pieces, p: DVec2) -> f64 {
    let to = |piece: &Piece| {
        let [from, to] = [piece.tail, piece.head].map(|v| pieces.points[v as usize]);
        let (way, out) = (to - from, p - from);
        let along = if way == DVec2::ZERO { 0.0 } else { (out.dot(way) / way.length_squared()).clamp(0.0, 1.0) };
        (out - along * way).length()
    };
    pieces.pieces.iter().map(to).fold(f64::INFINITY, f64::min)
}

/// The winding number of a point in pieces that are lines, exactly.
///
/// # Panics
/// If one of them is an arc.
#[must_use]
pub fn around(pieces: &Pieces, p: DVec2) -> i32 {
    assert!(pieces.pieces.iter().all(|piece| piece.delta == 0.0), "polygons");
    let point = |p: DVec2| [exact(p.x), exact(p.y)];
    let ends = |piece: &Piece| [piece.tail, piece.head].map(|v| pieces.points[v as usize]);
    let level: Vec<[Point; 2]> =
        pieces.pieces.iter().map(ends).filter(|[p0, p1]| (p0.y > p.y) != (p1.y > p.y)).map(|e| e.map(point)).collect();
    winding(level.iter().map(|[from, to]| [from, to]), &point(p)) + pieces.base[0]
}

/// A point of a sum, given in units of the frames of its operands, in input units, exactly.
#[must_use]
pub fn in_input_units((a, b): &(Frame, Frame), p: DVec2) -> Point {
    let side = exact(libm::scalbn(1.0, a.exp));
    [exact(p.x) * &side + exact(a.shift.x) + exact(b.shift.x), exact(p.y) * &side + exact(a.shift.y) + exact(b.shift.y)]
}

/// A double as it is.
fn exact(x: f64) -> Rational {
    Rational::from_f64(x).unwrap_or_default()
}
