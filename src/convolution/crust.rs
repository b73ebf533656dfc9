//! Crusts: the boundary of the sum of what lies below two upper chains, or above two lower ones (MS 5.1, 6; memo E2).
//!
//! Of the sum segments of the smoothed chains those are kept whose computed ends run the way a crust does, to the left on
//! upper chains. In exact arithmetic these are the convexly compatible ones; in doubles it is this rule that leaves no gap
//! in the envelope, however curvatures are rounded. Verticals close the envelope.

use super::envelope::{Span, envelope};
use super::sums::{Sums, Taken};
use crate::angle::Ang;
use crate::arrangement::cross::CrossingModule;
use crate::chain::Chain;
use crate::part::part;
use crate::piece::{Piece, Source};
use glam::DVec2;

/// The crust of two chains.
#[derive(Clone, Debug)]
pub struct Crust {
    /// Whether the region lies below it.
    upper: bool,
    /// The parts of sum segments that it consists of, from left to right. The verticals that close it are not among them.
    pub spans: Vec<Span>,
    /// The sums of the left and of the right ends of the chains.
    ends: [u32; 2],
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

/// The crust of a chain of A and a chain of B of the same kind, from left to right, from those of the sum segments taken that
/// are theirs and run forward.
pub fn crust<M: CrossingModule>(sums: &mut Sums, [a, b]: [&Chain; 2], taken: &Taken, own: &[u32], module: &M) -> Crust {
    let upper = a.upper;
    let spans = envelope(sums.points(), &taken.pieces, own, upper, module);
    let (tail, head) = (sums.corner(a.tail(), b.tail()), sums.corner(a.head(), b.head()));
    let ends = if upper { [head, tail] } else { [tail, head] };
    Crust { upper, spans, ends }
}

impl Crust {
    /// A piece of it, running the way of the chains.
    pub fn piece(&self, points: &[DVec2], taken: &Taken, span: &Span) -> Piece {
        let (tail, head) = self.run(span.left, span.right);
        part(points, &taken.pieces[span.piece], tail, head)
    }

    /// The verticals that close it.
    pub fn closers(&self, points: &[DVec2]) -> impl Iterator<Item = Piece> {
        let lefts = self.spans.iter().map(|span| span.left).chain([self.ends[1]]);
        let rights = [self.ends[0]].into_iter().chain(self.spans.iter().map(|span| span.right));
        rights.zip(lefts).filter(|(from, to)| from != to).map(|(from, to)| {
            let (tail, head) = self.run(from, to);
            Piece::between(points, tail, head, Source { first: u32::MAX, second: head })
        })
    }

    fn run(&self, left: u32, right: u32) -> (u32, u32) {
        if self.upper { (right, left) } else { (left, right) }
    }
}
