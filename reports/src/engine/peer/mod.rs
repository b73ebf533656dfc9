//! Engines of others in this process: each behind a cargo feature of its crate's name, at one version.
//!
//! Most compute on integers. A `NAME` or `NAME:union` unites the kinetic convolution of this project (MS 3), cut into closed
//! cycles, by the nonzero rule; a `NAME:minkowski` is a sum they ship themselves. Coordinates are those of the unit box times
//! a power of two, the finest grid that the engine takes, rounded to integers: what that loses is part of their error. The
//! time of the union, and of the shipped sum, is that of the arrangement.
//!
//! For arcs there are a union that takes them, unions of operands with chords for arcs, and an offset, the sum with a disc.
//! Nobody else sums two general regions with arcs.

#[cfg(test)]
mod arcs;
#[cfg(feature = "cavalier_contours")]
mod cavalier;
#[cfg(feature = "clipper2")]
mod clipper2;
mod curves;
#[cfg(all(test, any(feature = "i_overlay", feature = "clipper2", feature = "polyclip")))]
mod exact;
mod flat;
mod grid;
#[cfg(feature = "i_curve")]
mod i_curve;
#[cfg(feature = "i_overlay")]
mod i_overlay;
mod offset;
#[cfg(feature = "polyclip")]
mod polyclip;
#[cfg(test)]
mod tests;
mod walks;
mod way;

use super::{Abilities, Answer, Engine, EngineError};
use arcsum::region::Region;
pub use curves::Stretch;
pub use grid::Ring;
pub use offset::Offset;
use std::panic::{AssertUnwindSafe, catch_unwind};
pub use way::{Loops, Outcome, Way};

/// The features that bring engines of others.
pub const FEATURES: &[&str] = &["cavalier_contours", "clipper2", "i_curve", "i_overlay", "polyclip"];

/// An engine of somebody else.
#[derive(Clone, Copy, Debug)]
pub struct Peer {
    /// Its name on the command line.
    pub name: &'static str,
    /// Its version.
    pub version: &'static str,
    /// What it can do.
    pub abilities: Abilities,
    /// How it sums.
    pub way: Way,
}

/// Those that are built in.
const PEERS: &[Peer] = &[
    #[cfg(feature = "i_overlay")]
    i_overlay::NARROW,
    #[cfg(feature = "i_overlay")]
    i_overlay::WIDE,
    #[cfg(feature = "clipper2")]
    clipper2::UNION,
    #[cfg(feature = "clipper2")]
    clipper2::COARSE,
    #[cfg(feature = "clipper2")]
    clipper2::FINE,
    #[cfg(feature = "clipper2")]
    clipper2::MINKOWSKI,
    #[cfg(feature = "polyclip")]
    polyclip::UNION,
    #[cfg(feature = "polyclip")]
    polyclip::MINKOWSKI,
    #[cfg(feature = "i_curve")]
    i_curve::NARROW,
    #[cfg(feature = "i_curve")]
    i_curve::WIDE,
    #[cfg(feature = "cavalier_contours")]
    cavalier::OFFSET,
];

/// What the unions can do: all that the convolution of bounded polygons can.
pub const UNITES: Abilities = Abilities { arcs: false, ..UNITES_ARCS };

/// The same with arcs.
pub const UNITES_ARCS: Abilities = Abilities { unbounded: false, ..Abilities::ALL };

impl Peer {
    /// The engine of this name, if it is one of them and built in.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        PEERS.iter().find(|peer| peer.name == name).copied()
    }

    /// The names of all that are built in.
    #[must_use]
    pub fn names() -> Vec<&'static str> {
        PEERS.iter().map(|peer| peer.name).collect()
    }

    fn answered(&self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        let answer = self.way.sum(a, b)?;
        // The sum of two regions has points.
        if answer.region.loops.iter().all(Vec::is_empty) {
            return Err(EngineError::Invalid("its answer is empty".into()));
        }
        Ok(answer)
    }
}

impl Engine for Peer {
    fn name(&self) -> &str {
        self.name
    }

    fn version(&self) -> String {
        self.version.to_owned()
    }

    fn abilities(&self) -> Abilities {
        self.abilities
    }

    fn resolution(&self) -> Option<f64> {
        match self.way {
            Way::Flat { sagitta, .. } => Some(sagitta),
            _ => None,
        }
    }

    fn sum(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        if !self.abilities.cover(a, b) {
            return Err(EngineError::Invalid(format!("{} does not take such regions", self.name)));
        }
        catch_unwind(AssertUnwindSafe(|| self.answered(a, b)))
            .unwrap_or_else(|_| Err(EngineError::Crashed(format!("{} panicked", self.name))))
    }
}
