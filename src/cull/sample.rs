//! A guess of how often the pieces cross each other, from a sample of pairs: the grid is not for sparse arrangements.

use crate::piece::Pieces;
use glam::DVec2;

/// Pairs in the sample.
const PAIRS: u32 = 4096;

/// With fewer crossings a piece the arrangement takes no longer than the grid, whatever is culled.
const FEW: f64 = 5.0;

/// Whether there seem to be so many crossings that culling may pay. The same pieces always give the same answer.
#[must_use]
pub fn is_dense(pieces: &Pieces) -> bool {
    let count = pieces.pieces.len() as u64;
    // The generator of Knuth's MMIX; its upper half picks a piece.
    let mut state = 1_u64;
    let mut pick = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (((state >> 32) * count) >> 32) as usize
    };
    let found = (0..PAIRS).filter(|_| cross(ends(pieces, pick()), ends(pieces, pick()))).count();
    let pairs_a_piece = count as f64 / 2.0;
    found as f64 / f64::from(PAIRS) * pairs_a_piece > FEW
}

fn ends(pieces: &Pieces, piece: usize) -> [DVec2; 2] {
    let piece = &pieces.pieces[piece];
    [piece.tail, piece.head].map(|v| pieces.points[v as usize])
}

/// Whether two chords cross.
fn cross([p, q]: [DVec2; 2], [u, v]: [DVec2; 2]) -> bool {
    let parts = |p: DVec2, q: DVec2, u: DVec2, v: DVec2| (q - p).perp_dot(u - p) * (q - p).perp_dot(v - p) < 0.0;
    p.min(q).cmple(u.max(v)).all() && u.min(v).cmple(p.max(q)).all() && parts(p, q, u, v) && parts(u, v, p, q)
}
