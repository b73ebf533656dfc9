//! The monotonic convolution: the crusts of all pairs of chains, and the boundaries moved by concave turning points
//! (MS 5; memo E).
//!
//! Its winding number is O - F - T: the pairs of facing chains that overlap, less those that do face, less the concave
//! turning points inside the other region. It is positive where the regions overlap and 0 where they do not, if the fill
//! rule has made their overlap simply connected. The moved boundaries, T segments, run backwards (memo fact 8). Where a crust
//! runs along one, the two cancel. That is known from what the pieces are sums of, never from coordinates.

use super::crust::{Rule, crust};
use super::fill::Filled;
use super::part::part;
use super::sums::{Placed, Summand, Sums};
use crate::arrangement::cross::CrossingModule;
use crate::chain::{Chain, Chains, Turning};
use crate::piece::Piece;
use crate::smooth::{Kind, Smooth};
use std::collections::{HashMap, HashSet};

/// Adds the monotonic convolution of two components.
pub fn convolve<M: CrossingModule>(sums: &mut Sums, [a, b]: [&Smooth; 2], filled: &Filled, rule: Rule, module: &M) {
    let chains = [Chains::new(a, &filled.a), Chains::new(b, &filled.b)];
    let concave = chains
        .each_ref()
        .map(|chains| chains.turnings.iter().filter(|t| t.concave).map(|t| t.vertex).collect::<HashSet<u32>>());
    // The stretches of crusts that lie on a moved boundary, from left to right.
    let mut cancelled: HashMap<[Summand; 2], Vec<[u32; 2]>> = HashMap::new();
    for x in &chains[0].chains {
        for y in chains[1].chains.iter().filter(|y| y.upper == x.upper) {
            let crust = crust(sums, [x, y], rule, module);
            for (piece, summands) in crust.pieces {
                let on = |side: usize| matches!(summands[side], Summand::Vertex(v) if concave[side].contains(&v));
                if on(0) || on(1) {
                    let ends = if x.upper { [piece.head, piece.tail] } else { [piece.tail, piece.head] };
                    cancelled.entry(summands).or_default().push(ends);
                } else {
                    sums.push(piece, summands);
                }
            }
            for closer in crust.closers {
                sums.push(closer, [Summand::Vertex(x.tail()), Summand::Vertex(y.tail())]);
            }
        }
    }
    let first = sums.len();
    move_by(&chains[0].turnings, &chains[1].chains, |p, placed| sums.reversed_by_vertex_of_a(p, placed));
    move_by(&chains[1].turnings, &chains[0].chains, |p, placed| sums.reversed_by_vertex_of_b(placed, p));
    for (piece, summands) in sums.take_from(first) {
        let gone = cancelled.get(&summands).map_or(&[][..], Vec::as_slice);
        for rest in rest(sums, &piece, gone) {
            sums.push(rest, summands);
        }
    }
}

/// All segments of some chains with every concave turning point.
fn move_by(turnings: &[Turning], chains: &[Chain], mut add: impl FnMut(u32, Placed)) {
    for turning in turnings.iter().filter(|t| t.concave) {
        for chain in chains {
            for link in &chain.links {
                if let Some(index) = link.index.filter(|_| link.seg.kind != Kind::Turn) {
                    let placed = Placed { seg: &link.seg, of_loop: chain.of_loop as u32, index: index as u32 };
                    add(turning.vertex, placed);
                }
            }
        }
    }
}

/// What is left of a moved segment between the stretches that crusts run along.
fn rest(sums: &mut Sums, piece: &Piece, gone: &[[u32; 2]]) -> Vec<Piece> {
    if gone.is_empty() {
        return vec![*piece];
    }
    let points = sums.points();
    let x = |v: u32| points[v as usize].x;
    // A segment with stretches of a crust on it is not vertical.
    let rightward = x(piece.tail) < x(piece.head);
    let mut stops: Vec<u32> = gone.iter().flatten().copied().collect();
    if rightward {
        stops.insert(0, piece.tail)
    } else {
        stops.insert(0, piece.head)
    }
    stops.push(if rightward { piece.head } else { piece.tail });
    let kept = |pair: &[u32]| {
        let (tail, head) = if rightward { (pair[0], pair[1]) } else { (pair[1], pair[0]) };
        (tail != head).then(|| part(points, piece, tail, head))
    };
    stops.chunks(2).filter_map(kept).collect()
}
