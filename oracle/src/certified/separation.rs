//! The separation of a region: the least distance of two chains of it that are not incident (MS 7, Fig. 13; memo F). The
//! theorem on falsely free points (MS, Theorem 4) asks for 2 mu of it.
//!
//! A loop falls into chains that are weakly monotone in x: upper ones run to the left, lower ones to the right, and a
//! vertical belongs to its neighbours if these agree, else to an upper chain if it goes up (memo E1). Chains are incident if
//! one follows the other on their loop, so that they meet at a turning point. MS say no more, and neither does this:
//! - incident chains may come as near to each other as they like, also far away from their turning point (but where one
//!   of them ends inside of a slit, the chain that follows it is not incident with the other, and counts);
//! - a chain may come near to itself, as the two walls of a vertical notch do;
//! - a chain and the next but one are not incident: a short chain between them is enough to bring them near;
//! - loops that touch have chains at distance 0.

use std::cmp::Ordering;

use super::gap::gap;
use super::piece::Piece;
use super::precision::Precision;
use super::reference::scaled;
use super::shape::{Shape, Side};
use super::tree::Tree;
use super::vector::Vector;
use crate::error::OracleError;
use crate::interval::Interval;
use crate::plain::PlainRegion;

/// Distances that doubles give roughly are measured again with this precision.
const FINE: Precision = Precision::LADDER[2];

/// The chain of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Place {
    of_loop: usize,
    /// Counted along the loop from 0.
    chain: usize,
    /// The chains of the loop.
    chains: usize,
}

/// A bracket of the separation of a region in units of `unit`, a power of two; infinite if any two of its chains are
/// incident, as those of a convex region are.
///
/// # Errors
/// [`OracleError::BadNumber`] for numbers that are no region or not representable in the unit.
pub fn separation(region: &PlainRegion, unit: f64) -> Result<Interval, OracleError> {
    let shape = Shape::new(&scaled(region, unit)?)?;
    let sides: Vec<&Side> = shape.sides().collect();
    let places: Vec<Place> =
        shape.loops.iter().enumerate().flat_map(|(of_loop, sides)| chains(of_loop, sides)).collect();
    let near = near(&sides, &places);
    let fine = |&(i, j): &(usize, usize)| gap(sides[i].curve.at(FINE), sides[j].curve.at(FINE));
    let least = near.iter().map(fine).reduce(|least, distance| least.min(&distance));
    Ok(least.map_or(Interval::point(f64::INFINITY), |least| {
        let found = least.enclosure();
        Interval::new(found.lo().max(0.0), found.hi())
    }))
}

/// Pairs of pieces of chains that are not incident, among them a nearest one.
fn near(sides: &[&Side], places: &[Place]) -> Vec<(usize, usize)> {
    let rough = |i: usize| sides[i].curve.rough();
    let boxes: Vec<_> = (0..sides.len()).map(|i| rough(i).bounds()).collect();
    // The tree walk turns the second boxes by half a turn: they are turned before.
    let turned: Vec<_> = boxes.iter().map(|&[x0, y0, x1, y1]| [-x1, -y1, -x0, -y0]).collect();
    let origin = Vector::new(0.0, 0.0, Precision::DOUBLE);
    let (mut limit, mut found) = (f64::INFINITY, Vec::new());
    Tree::new(&boxes).visit_pairs(&Tree::new(&turned), &origin, limit, |i, j| {
        if i < j && !places[i].touches(places[j]) {
            let distance = gap(rough(i), rough(j));
            limit = limit.min(distance.hi());
            found.push((distance.lo(), (i, j)));
        }
        limit
    });
    found.into_iter().filter(|(lo, _)| *lo <= limit).map(|(_, pair)| pair).collect()
}

impl Place {
    /// Whether the chains are the same or incident.
    fn touches(self, other: Self) -> bool {
        let apart = self.chain.abs_diff(other.chain);
        self.of_loop == other.of_loop && (apart <= 1 || apart + 1 == self.chains)
    }
}

/// The chain of every piece of a loop.
fn chains(of_loop: usize, sides: &[Side]) -> Vec<Place> {
    let upper = uppers(sides);
    let n = upper.len();
    let Some(start) = (0..n).find(|&i| upper[i] != upper[(i + n - 1) % n]) else {
        return vec![Place { of_loop, chain: 0, chains: 1 }; n];
    };
    let mut places = vec![Place { of_loop, chain: 0, chains: 0 }; n];
    let mut chain = 0;
    for i in (start..start + n).map(|i| i % n) {
        let before = (i + n - 1) % n;
        chain += usize::from(i != start && upper[i] != upper[before]);
        places[i].chain = chain;
    }
    for place in &mut places {
        place.chains = chain + 1;
    }
    places
}

/// Whether each piece belongs to an upper chain.
fn uppers(sides: &[Side]) -> Vec<bool> {
    let own: Vec<Option<bool>> = sides.iter().map(|side| runs_left(|p| side.curve.at(p))).collect();
    let n = own.len();
    let near = |i: usize, step: usize| (1..n).find_map(|k| own[(i + k * step) % n]);
    let label = |i: usize| {
        let (before, after) = (near(i, n - 1), near(i, 1));
        own[i].or_else(|| before.filter(|_| before == after)).unwrap_or_else(|| {
            let chord = sides[i].curve.rough().chord();
            chord.y.mid() > 0.0
        })
    };
    (0..n).map(label).collect()
}

/// Whether a piece runs to the left; none for verticals.
fn runs_left<'p>(piece: impl Fn(Precision) -> &'p Piece) -> Option<bool> {
    let way = Precision::FINEST.decide(|p| piece(p).chord().x.sign())?;
    (way != Ordering::Equal).then_some(way == Ordering::Less)
}
