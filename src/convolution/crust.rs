//! Crusts: the boundary of the sum of what lies below two upper chains, or above two lower ones (MS 5.1, 6; memo E2).
//!
//! Of the sum segments of the smoothed chains those are kept whose computed ends run the way a crust does, to the left on
//! upper chains. In exact arithmetic these are the convexly compatible ones; in doubles it is this rule that leaves no gap
//! in the envelope, however curvatures are rounded. Verticals close the envelope.

use super::envelope::{Span, envelope};
use super::part::part;
use super::sums::{Summand, Sums, Taken, straight};
use crate::angle::Ang;
use crate::arrangement::cross::CrossingModule;
use crate::chain::Chain;
use crate::piece::{Piece, Source};
use glam::DVec2;

/// The crust of two chains.
#[derive(Clone, Debug, Default)]
pub struct Crust {
    /// Its pieces from left to right with what they are sums of, each running the way of the chains. The verticals that
    /// close it are not among them.
    pub pieces: Vec<(Piece, [Summand; 2])>,
    /// The verticals.
    pub closers: Vec<Piece>,
}

/// Which sums of chains count as convexly compatible.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Those whose computed ends run the way of the chains (MS 6).
    Ends,
    /// Those of segments whose curvatures add up to no negative number (MS 5.1).
    Curvature,
}

impl Rule {
    /// Whether a sum of upper, or lower, chains counts.
    pub fn takes(self, piece: &Piece, points: &[DVec2], upper: bool) -> bool {
        let [tail, head] = [piece.tail, piece.head].map(|v| points[v as usize].x);
        match self {
            Self::Ends if upper => head < tail,
            Self::Ends => tail < head,
            // The curvatures show in the normals: where they add up to less than 0, the sum has been turned around (memo B1).
            Self::Curvature => [piece.a, piece.b].iter().any(|normal| faces(*normal, upper)),
        }
    }
}

/// Whether a normal points up, or else down.
fn faces(normal: Ang, up: bool) -> bool {
    if up { Ang::RIGHT < normal && normal < Ang::LEFT } else { normal > Ang::LEFT }
}

/// The crust of a chain of A and a chain of B of the same kind, from those of the sum segments taken that are theirs and run
/// forward.
pub fn crust<M: CrossingModule>(
    sums: &mut Sums,
    [a, b]: [&Chain; 2],
    taken: &Taken,
    own: impl Iterator<Item = usize> + Clone,
    module: &M,
) -> Crust {
    let (upper, points) = (a.upper, sums.points());
    let pieces: Vec<&Piece> = own.clone().map(|k| &taken.pieces[k]).collect();
    let summands: Vec<[Summand; 2]> = own.map(|k| taken.summands[k]).collect();
    let spans = envelope(points, &pieces, upper, module);
    let run = |left: u32, right: u32| if upper { (right, left) } else { (left, right) };
    let cut = |span: &Span| {
        let (tail, head) = run(span.left, span.right);
        (part(points, pieces[span.piece], tail, head), summands[span.piece])
    };
    let cut = spans.iter().map(cut).collect();
    let (tail, head) = (sums.corner(a.tail(), b.tail()), sums.corner(a.head(), b.head()));
    let (left, right) = run(tail, head);
    let mut stops = vec![left];
    stops.extend(spans.iter().flat_map(|span| [span.left, span.right]));
    stops.push(right);
    let points = sums.points();
    let closer = |pair: &[u32]| {
        let (tail, head) = run(pair[0], pair[1]);
        (tail != head).then(|| straight(points, tail, head, Source { first: u32::MAX, second: head }))
    };
    Crust { pieces: cut, closers: stops.chunks(2).filter_map(closer).collect() }
}
