//! Engines of others in this process, on polygons: each behind a cargo feature of its name, at one version.
//!
//! They compute on integers. A `NAME` unites the kinetic convolution of this project (MS 3), cut into closed cycles, by the
//! nonzero rule; a `NAME:minkowski` is a sum they ship themselves. Coordinates are those of the unit box times a power of
//! two, the finest grid that the engine takes, rounded to integers: what that loses is part of their error. The time of
//! the union, and of the shipped sum, is that of the arrangement.

#[cfg(feature = "clipper2")]
mod clipper2;
#[cfg(all(test, any(feature = "i_overlay", feature = "clipper2", feature = "polyclip")))]
mod exact;
mod grid;
#[cfg(feature = "i_overlay")]
mod i_overlay;
#[cfg(feature = "polyclip")]
mod polyclip;
#[cfg(test)]
mod tests;

use super::{Abilities, Answer, Engine, EngineError, Times};
use arcsum::region::Region;
use grid::Grid;
pub use grid::Ring;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// The features that bring engines of others.
pub const FEATURES: &[&str] = &["i_overlay", "clipper2", "polyclip"];

/// Rings around a result, the interior on the left; or why there are none.
pub type Outcome = Result<Vec<Ring>, EngineError>;

/// What an engine is given, and what makes a sum of it.
#[derive(Clone, Copy, Debug)]
pub enum Way {
    /// The union of closed cycles.
    Union(fn(&[Ring]) -> Outcome),
    /// The sum of two regions, each by its loops.
    Minkowski(fn(&[Ring], &[Ring]) -> Outcome),
}

/// An engine of somebody else.
#[derive(Clone, Copy, Debug)]
pub struct Peer {
    /// Its name on the command line.
    pub name: &'static str,
    /// Its version.
    pub version: &'static str,
    /// The unit box is so many bits wide; integers need two bits more, and a sign.
    pub bits: i32,
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
    clipper2::MINKOWSKI,
    #[cfg(feature = "polyclip")]
    polyclip::UNION,
    #[cfg(feature = "polyclip")]
    polyclip::MINKOWSKI,
];

/// What the unions can do: all that the convolution of bounded polygons can.
pub const UNITES: Abilities = Abilities { arcs: false, unbounded: false, ..Abilities::ALL };

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
        let start = Instant::now();
        let grid = Grid::new(a, b, self.bits);
        let (rings, convolved) = match self.way {
            Way::Union(unite) => {
                let cycles = grid.cycles(a, b)?;
                let convolved = Instant::now();
                (unite(&cycles)?, convolved)
            }
            Way::Minkowski(sum) => {
                let [a, b] = grid.operands(a, b);
                let ready = Instant::now();
                (sum(&a, &b)?, ready)
            }
        };
        let arranged = Instant::now();
        // The sum of two regions has points.
        if rings.is_empty() {
            return Err(EngineError::Invalid("its answer is empty".into()));
        }
        let region = grid.region(&rings);
        let times = Times {
            total: Some(start.elapsed()),
            convolution: matches!(self.way, Way::Union(_)).then(|| convolved - start),
            arrangement: Some(arranged - convolved),
            extraction: None,
        };
        Ok(Answer { region, times, ..Answer::default() })
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

    fn sum(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        if !self.abilities.cover(a, b) {
            return Err(EngineError::Invalid(format!("{} does not take such regions", self.name)));
        }
        catch_unwind(AssertUnwindSafe(|| self.answered(a, b)))
            .unwrap_or_else(|_| Err(EngineError::Crashed(format!("{} panicked", self.name))))
    }
}
