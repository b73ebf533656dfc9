//! Winding numbers of points in pieces, counted along a ray, and convolutions to count in.

use arcsum::convolution::{kinetic, monotonic};
use arcsum::frame::Frame;
use arcsum::piece::{Piece, Pieces};
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_reports::cases::Case;
use arcsum_reports::cases::rng::Rng;
use glam::DVec2;

/// Both convolutions of a bounded pair, the kinetic one first.
#[must_use]
pub fn convolutions(case: &Case) -> [Pieces; 2] {
    let frames = Frame::pair(&case.a, &case.b);
    let [a, b] = [(&case.a, &frames.0), (&case.b, &frames.1)].map(|(r, frame)| Smooth::new(r, frame).expect("valid"));
    let monotonic = monotonic(&a, &b, Rounding::Correct).expect("bounded").0;
    [kinetic(&a, &b, Rounding::Correct).expect("bounded"), monotonic]
}

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

/// Pairs of winding numbers of random points near some of the vertices, in a whole and in what is left of it.
#[must_use]
pub fn before_and_after(whole: &Pieces, left: &Pieces, seed: u64) -> Vec<[i32; 2]> {
    let mut random = Rng::new(seed, "tests");
    let mut pair = || {
        let p = *random.pick(&whole.points) + 0.05 * DVec2::new(random.unit() - 0.5, random.unit() - 0.5);
        Some([winding(whole, p)?, winding(left, p)?])
    };
    (0..400).filter_map(|_| pair()).collect()
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
