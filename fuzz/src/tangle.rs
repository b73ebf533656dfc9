//! Tangles: closed loops that cross themselves and each other at will, the raw input of an arrangement.

use arcsum::angle::Ang;
use arcsum::piece::{Piece, Pieces, Source};
use glam::DVec2;

/// Closed polygons through these points, as pieces of operand 0.
#[must_use]
pub fn tangle(loops: &[Vec<DVec2>]) -> Pieces {
    let mut pieces = Pieces::default();
    for points in loops {
        let first = pieces.points.len() as u32;
        let n = points.len();
        pieces.points.extend(points);
        for i in 0..n {
            let (p, q) = (points[i], points[(i + 1) % n]);
            let Some(normal) = Ang::of_line(p, q) else { continue };
            let source = Source { first: pieces.pieces.len() as u32, second: 0 };
            let (tail, head) = (first + i as u32, first + ((i + 1) % n) as u32);
            pieces.pieces.push(Piece::line(tail, head, normal, source));
        }
    }
    pieces
}
