//! The pieces of a convolution as closed walks.

use arcsum::piece::Pieces;

/// The pieces, by index, as closed walks. Every vertex has as many pieces in as out, so a walk can only end where it began;
/// which piece follows which does not matter to winding numbers.
pub fn walks(pieces: &Pieces) -> Vec<Vec<usize>> {
    let mut leaving = vec![Vec::new(); pieces.points.len()];
    pieces.pieces.iter().enumerate().for_each(|(index, piece)| leaving[piece.tail as usize].push(index));
    let mut walks = Vec::new();
    for start in 0..leaving.len() {
        while let Some(first) = leaving[start].pop() {
            let mut walk = vec![first];
            let mut at = pieces.pieces[first].head as usize;
            while at != start {
                let next = leaving[at].pop().expect("a convolution is closed");
                walk.push(next);
                at = pieces.pieces[next].head as usize;
            }
            walks.push(walk);
        }
    }
    walks
}
