//! Step 3 of MS 4.2: chains are lifted until none runs into another.

use std::collections::BTreeMap;

use super::error::RealizeError;
use super::order::{self, Below, Double};
use super::path::Path;
use crate::certified::real::Real;

/// How far chains that would touch are kept apart, in the unit box. Far above what is uncertain at the working
/// precision (see [`order::relations`]), far below one eps, and a power of two that does not get lost next to an
/// excess of eps.
const MARGIN: f64 = 1.0 / (1u128 << 80) as f64;

/// The lift of every chain in the frame, doubles that are meant exactly.
///
/// # Errors
/// [`RealizeError::Tangled`] if the chains have no order, or if a chain runs between two that are joined.
pub fn lifts(chains: &[Double], scale: &Real) -> Result<Vec<f64>, RealizeError> {
    let relations = order::relations(chains, scale);
    check_joints(chains, &relations)?;
    let mut below: Vec<Vec<Below>> = vec![Vec::new(); chains.len()];
    for relation in &relations {
        below[relation.upper].push(*relation);
    }
    let mut lifts = vec![0.0_f64; chains.len()];
    for chain in order::sorted(chains.len(), &relations)? {
        let needed = below[chain].iter().map(|relation| lifts[relation.lower] + relation.excess + MARGIN);
        lifts[chain] = needed.fold(0.0, f64::max);
    }
    Ok(lifts)
}

/// Step 4 joins the end of one chain with the start of another at one abscissa. What runs over that abscissa must run
/// above both or below both. Where loops touch, a turn can lie within another on the same side: then both of its
/// chains must be between the two, and its connection comes to lie on that of the others, as the points did.
fn check_joints(chains: &[Double], relations: &[Below]) -> Result<(), RealizeError> {
    let upper: BTreeMap<(usize, usize), usize> =
        relations.iter().map(|r| ((r.lower.min(r.upper), r.lower.max(r.upper)), r.upper)).collect();
    let above = |chain: usize, other: usize| upper.get(&(chain.min(other), chain.max(other))).map(|&u| u == chain);
    let extents: Vec<(f64, f64)> = chains.iter().map(extent).collect();
    for starting in 0..chains.len() {
        let turn = Turn::before(chains, starting);
        let between = |other: usize| match (above(other, turn.ending), above(other, starting)) {
            (Some(one), Some(two)) => one != two,
            _ => false,
        };
        for (other, &(left, right)) in extents.iter().enumerate() {
            let apart = left > turn.x.hi() || right < turn.x.lo();
            if apart || other == turn.ending || other == starting || !between(other) {
                continue;
            }
            let at_start = Turn::before(chains, other);
            let at_end = Turn::before(chains, chains[other].next);
            let mates = [(at_start.ending, at_start), (at_end.starting, at_end)];
            if !mates.into_iter().any(|(mate, inner)| inner.is_beside(&turn) && between(mate)) {
                return Err(RealizeError::Tangled);
            }
        }
    }
    Ok(())
}

/// Where one chain ends and the next one starts.
struct Turn<'a> {
    ending: usize,
    starting: usize,
    x: &'a Real,
    /// Whether the chains lie to the left.
    at_right: bool,
}

impl<'a> Turn<'a> {
    /// The one at the start of a chain.
    fn before(chains: &'a [Double], starting: usize) -> Self {
        let Path { from, rightward, .. } = &chains[starting].placed[0].path;
        Self { ending: chains[starting].previous, starting, x: &from.x, at_right: !rightward }
    }

    /// Whether it may be at the same abscissa, on the same side.
    fn is_beside(&self, other: &Self) -> bool {
        self.at_right == other.at_right && !self.x.is_below(other.x) && !other.x.is_below(self.x)
    }
}

/// The abscissas of a chain, rounded outwards.
fn extent(chain: &Double) -> (f64, f64) {
    let (from, to) = (&chain.placed[0].path.from.x, &chain.placed[chain.placed.len() - 1].path.to.x);
    (from.lo().min(to.lo()), from.hi().max(to.hi()))
}
