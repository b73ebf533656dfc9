//! A realization as a recipe: what is decided once, and the numbers that follow from it at any precision.

use super::chain::{Chain, chains};
use super::error::RealizeError;
use super::lift::lifts;
use super::order::Double;
use super::path::Path;
use super::place::{Placed, place};
use super::stored::StoredRegion;
use super::track::Track;
use super::up::Up;
use crate::certified::precision::Precision;

/// The precision at which chains are ordered and lifted and distances are measured.
pub const WORK: Precision = Precision::LADDER[3];

/// The decisions: direction, chains and lifts.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The stored boundary.
    pub region: StoredRegion,
    /// What is vertical.
    pub up: Up,
    /// The chains, loop by loop in the order of the boundary.
    pub chains: Vec<Chain>,
    /// By how much each chain is lifted, in the frame.
    pub lifts: Vec<f64>,
}

impl Plan {
    /// Decides.
    ///
    /// # Errors
    /// [`RealizeError`], as its variants say.
    pub fn new(region: StoredRegion, up: Up) -> Result<Self, RealizeError> {
        let mut all = Vec::new();
        for (ring, pieces) in region.loops.iter().enumerate() {
            all.extend(chains(ring, pieces, up, WORK)?);
        }
        let mut plan = Self { region, up, lifts: vec![0.0; all.len()], chains: all };
        plan.check()?;
        plan.lifts = lifts(&plan.doubles(), &up.square(WORK).sqrt())?;
        Ok(plan)
    }

    /// The chain that follows a chain in its loop.
    #[must_use]
    pub fn next(&self, chain: usize) -> usize {
        let ring = self.chains[chain].ring;
        match self.chains.get(chain + 1) {
            Some(next) if next.ring == ring => chain + 1,
            _ => self.chains.partition_point(|other| other.ring < ring),
        }
    }

    /// The loop of a chain at a precision.
    #[must_use]
    pub fn track(&self, chain: usize, precision: Precision) -> Track<'_> {
        Track { pieces: &self.region.loops[self.chains[chain].ring], up: self.up, precision }
    }

    /// The spans of all chains in their places, lifted, in the frame.
    #[must_use]
    pub fn placed(&self, precision: Precision) -> Vec<Vec<Placed>> {
        let one = |(i, chain)| {
            let spans = place(&self.track(i, precision), chain);
            spans.into_iter().map(|span| span.lifted(self.lifts[i])).collect()
        };
        self.chains.iter().enumerate().map(one).collect()
    }

    /// The chains after step 2, not lifted, next to the stored ones.
    #[must_use]
    pub fn doubles(&self) -> Vec<Double> {
        let mut doubles: Vec<Double> = Vec::with_capacity(self.chains.len());
        for (i, chain) in self.chains.iter().enumerate() {
            let track = self.track(i, WORK);
            let stored = chain.spans.iter().map(|span| Path::stored(&track, span)).collect();
            doubles.push(Double { placed: place(&track, chain), stored, previous: 0, next: self.next(i) });
        }
        for i in 0..doubles.len() {
            let next = doubles[i].next;
            doubles[next].previous = i;
        }
        doubles
    }

    /// Whether all spans run their way.
    fn check(&self) -> Result<(), RealizeError> {
        for (chain, spans) in self.chains.iter().zip(self.placed(WORK)) {
            for (span, placed) in chain.spans.iter().zip(spans) {
                let piece = span.pieces.start;
                if !placed.is_sound(self.region.loops[chain.ring][piece].radius > 0.0) {
                    return Err(RealizeError::Backward { ring: chain.ring, piece });
                }
            }
        }
        Ok(())
    }
}
