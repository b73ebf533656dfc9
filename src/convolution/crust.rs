//! Crusts: the boundary of the sum of what lies below two upper chains, or above two lower ones (MS 5.1, 6; memo E2).
//!
//! Of the sum segments of the smoothed chains those are kept whose computed ends run the way a crust does, to the left on
//! upper chains. In exact arithmetic these are the convexly compatible ones; in doubles it is this rule that leaves no gap
//! in the envelope, however curvatures are rounded. Verticals close the envelope.

use super::envelope::{Span, envelope};
use super::part::part;
use super::sums::{Summand, Sums, straight};
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

/// Whether the computed ends of a sum of upper, or lower, chains run the way a crust does.
pub fn runs_forward(points: &[DVec2], piece: &Piece, upper: bool) -> bool {
    let [tail, head] = [piece.tail, piece.head].map(|v| points[v as usize].x);
    if upper { head < tail } else { tail < head }
}

/// The crust of a chain of A and a chain of B of the same kind, from their sum segments that run forward.
pub fn crust<M: CrossingModule>(
    sums: &mut Sums,
    [a, b]: [&Chain; 2],
    forward: &[&(Piece, [Summand; 2])],
    module: &M,
) -> Crust {
    let (upper, points) = (a.upper, sums.points());
    let pieces: Vec<&Piece> = forward.iter().map(|(piece, _)| piece).collect();
    let spans = envelope(points, &pieces, upper, module);
    let run = |left: u32, right: u32| if upper { (right, left) } else { (left, right) };
    let cut = |span: &Span| {
        let (tail, head) = run(span.left, span.right);
        (part(points, pieces[span.piece], tail, head), forward[span.piece].1)
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
