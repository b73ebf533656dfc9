//! Engines under test: the trait, its answers, and the engines by name (section 5 of the design).

pub mod cells;
pub mod cgal;
pub mod command;
pub mod corners;
pub mod offset;
pub mod own;
pub mod peer;
pub mod registry;

use crate::bridge::plain;
use arcsum::region::Region;
use arcsum_oracle::disc::Disc;
use serde::{Deserialize, Serialize};
use std::time::Duration;

/// What an engine can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Abilities {
    /// Circle segments.
    pub arcs: bool,
    /// Regions with holes.
    pub holes: bool,
    /// Unbounded regions.
    pub unbounded: bool,
    /// Regions of several pieces.
    pub pieces: bool,
    /// It takes only cases with one operand a disc; the words above then say what the other one may be.
    pub discs_only: bool,
}

impl Abilities {
    /// Everything a case can ask for.
    pub const ALL: Self = Self { arcs: true, holes: true, unbounded: true, pieces: true, discs_only: false };

    /// The sum of two polygons without holes.
    pub const NONE: Self = Self { arcs: false, holes: false, unbounded: false, pieces: false, discs_only: false };

    /// Whether this suffices for the sum of the two.
    #[must_use]
    pub fn cover(self, a: &Region, b: &Region) -> bool {
        if self.discs_only {
            let others = Self { discs_only: false, ..self };
            let fits = |disc: &Region, other: &Region| Disc::of(&plain(disc)).is_some() && others.cover(other, other);
            return fits(a, b) || fits(b, a);
        }
        let both = |able: fn(&Region) -> bool| able(a) && able(b);
        (self.arcs || both(Region::is_polygonal))
            && (self.unbounded || both(|r| !r.unbounded))
            && (self.holes || both(|r| holes(r) == 0))
            && (self.pieces || both(|r| r.loops.len() - holes(r) <= 1))
    }
}

/// How many loops run clockwise, judged by the area under their chords.
fn holes(region: &Region) -> usize {
    let doubled = |l: &Vec<arcsum::region::Node>| -> f64 {
        (0..l.len()).map(|i| (l[i], l[(i + 1) % l.len()])).map(|(p, q)| p.x * q.y - p.y * q.x).sum()
    };
    // A loop of two arcs has no area under its chords; it counts as an outer loop.
    region.loops.iter().filter(|l| l.len() > 2 && doubled(l) < 0.0).count()
}

/// An engine's answer to a case.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The sum, in input units.
    pub region: Region,
    /// What the engine counted on the way; empty for engines that tell nothing.
    #[serde(default)]
    pub counters: Counters,
    /// How long its stages took.
    #[serde(default)]
    pub times: Times,
    /// The convolution as `[x0, y0, x1, y1, bulge]` in input units; empty for engines that have none to show.
    #[serde(default)]
    pub convolution: Vec<[f64; 5]>,
    /// Checks of its own that failed, by name; none when the engine makes no checks.
    #[serde(default)]
    pub failed_checks: Option<Vec<String>>,
    /// By how much the memory grew during the sum, in bytes; where somebody watched.
    #[serde(default)]
    pub memory: Option<u64>,
    /// The cells it tells apart, with test points; none for engines that do not show them. They do not leave the process.
    #[serde(skip)]
    pub cells: Option<cells::Cells>,
}

/// Audit counters by the names of the columns (memo C4).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the columns of the same names are documented in the row")]
pub struct Counters {
    pub sums: Option<u64>,
    pub vertices: Option<u64>,
    pub crossings: Option<u64>,
    pub k: Option<u64>,
    pub late: Option<u64>,
    pub gather: Option<u64>,
    pub cancelled: Option<u64>,
    #[serde(default)]
    pub order_conflict: Option<u64>,
    pub cells: Option<u64>,
}

/// Time of each stage, where the engine tells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Times {
    /// The whole sum, without what is told about it afterwards.
    #[serde(default)]
    pub total: Option<Duration>,
    /// The convolution.
    pub convolution: Option<Duration>,
    /// The arrangement.
    pub arrangement: Option<Duration>,
    /// The extraction of the result.
    pub extraction: Option<Duration>,
}

/// Why an engine gave no region.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EngineError {
    /// It refused the case or answered something that is no region.
    #[error("{0}")]
    Invalid(String),
    /// It died.
    #[error("{0}")]
    Crashed(String),
}

/// An engine under test.
pub trait Engine {
    /// Its name on the command line and in the tables.
    fn name(&self) -> &str;

    /// Its version.
    fn version(&self) -> String;

    /// What it can do; cases beyond that are not put to it.
    fn abilities(&self) -> Abilities;

    /// The Minkowski sum of the regions, in their units.
    ///
    /// # Errors
    /// When the engine refuses, answers nonsense, or dies in a way that can be told.
    fn sum(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError>;

    /// The sum without counters and whatever else is told about it: what memory and instructions are counted on.
    ///
    /// # Errors
    /// As [`Engine::sum`].
    fn alone(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        self.sum(a, b)
    }

    /// The process that sums, once it has been asked; none where it is this one.
    fn process(&self) -> Option<u32> {
        None
    }

    /// How coarse its results are by its own word, in unit-box lengths, as those of flattened operands are; none where they
    /// are as fine as it can.
    fn resolution(&self) -> Option<f64> {
        None
    }
}
