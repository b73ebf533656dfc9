//! Winding numbers of points in the engine's pieces, counted along a ray instead of by an arrangement, and wrong angles to
//! convolve with.

use arcsum::angle::Ang;
use arcsum::piece::{Piece, Pieces};
use arcsum::smooth::{Kind, Seg};
use glam::DVec2;

/// The winding number of a point; none if a piece is near it.
#[must_use]
pub fn winding(pieces: &Pieces, p: DVec2) -> Option<i32> {
    let mut winding = pieces.base[0];
    for piece in &pieces.pieces {
        let [from, to] = [piece.tail, piece.head].map(|v| pieces.points[v as usize]);
        if (from.x > p.x) == (to.x > p.x) {
            continue;
        }
        let y = ordinate(pieces, piece, p.x);
        if (y - p.y).abs() < 1e-9 {
            return None;
        }
        if y < p.y {
            winding += if from.x < to.x { piece.weight } else { -piece.weight };
        }
    }
    Some(winding)
}

/// The ordinate of a piece at an abscissa between its ends, by its chord and, of an arc, its centre.
fn ordinate(pieces: &Pieces, piece: &Piece, x: f64) -> f64 {
    let [from, to] = piece.whole.map(|v| pieces.points[v as usize]);
    let along = (x - from.x) / (to.x - from.x);
    let on_chord = from.y + (to.y - from.y) * along;
    if piece.delta == 0.0 {
        return on_chord;
    }
    let (chord, middle) = (to - from, 0.5 * (from + to));
    let radius = 0.5 * chord.length() / piece.delta.abs().sin();
    let centre = middle + 0.5 / piece.delta.tan() * chord.perp();
    let height = (radius * radius - (x - centre.x).powi(2)).max(0.0).sqrt();
    // A monotone arc is on the side of its centre where its chord is.
    if middle.y > centre.y { centre.y + height } else { centre.y - height }
}

/// Moves every angle by one of 97 numbers, in radians: equal angles alike, so that loops stay smooth.
pub fn disturb(segs: &mut [Seg], noise: &[f64]) {
    let moved = |angle: Ang| angle.plus(noise[(angle.offset().to_bits() % 97) as usize]);
    for seg in segs {
        (seg.a, seg.b) = (moved(seg.a), moved(seg.b));
        if seg.kind != Kind::Line {
            seg.delta = 0.5 * seg.a.turn_to(seg.b);
        }
    }
}
