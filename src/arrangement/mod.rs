//! The approximate arrangement of lines and circle segments: crossing module, sweep, planar map (memo C, D).
//!
//! [`arrange`] never fails: whatever finite pieces come in, a planar map comes out whose topology is consistent. How far it
//! is from the exact one depends on the crossing module alone.

pub mod audit;
pub mod cross;
pub mod curve;
mod faces;
pub mod graph;
pub mod known;
mod meet;
pub mod moment;
mod pair;
pub mod plain;
pub mod status;
mod sweep;
pub mod trapezoid;
mod vertices;

use crate::piece::Pieces;
use crate::robustness::{Robustness, Step};
use audit::Audit;
use cross::{CrossingModule, FloatModule};
use graph::Graph;
use plain::PlainModule;
use sweep::Sweep;
use trapezoid::Trapezoid;

/// A planar map with its vertical decomposition and the counters of the run.
#[derive(Clone, Debug)]
pub struct Arrangement {
    /// The planar map.
    pub graph: Graph,
    /// The vertical decomposition of its faces, the unbounded ends left out.
    pub trapezoids: Vec<Trapezoid>,
    /// What the sweep did.
    pub audit: Audit,
}

/// Arranges pieces with the honest crossing module. Coordinates should be of order 1; errors are a few eps times the larger
/// side of their bounding box.
#[must_use]
pub fn arrange(pieces: &Pieces) -> Arrangement {
    arrange_with(pieces, &module(pieces))
}

/// The honest crossing module for some pieces.
#[must_use]
pub fn module(pieces: &Pieces) -> FloatModule {
    FloatModule::new(extent(pieces))
}

/// Arranges pieces with any crossing module.
#[must_use]
pub fn arrange_with<M: CrossingModule>(pieces: &Pieces, module: &M) -> Arrangement {
    swept(pieces, module, Robustness::ALL)
}

/// Arranges pieces with these robustness steps only (MS 8.3). Without all of them the map may be inconsistent: Euler's
/// formula and the winding numbers show it.
#[must_use]
pub fn arrange_by(pieces: &Pieces, robustness: Robustness) -> Arrangement {
    if robustness.takes(Step::Crossings) {
        swept(pieces, &module(pieces), robustness)
    } else {
        swept(pieces, &PlainModule, robustness)
    }
}

/// Arranges pieces with any crossing module and these robustness steps.
#[must_use]
pub fn swept<M: CrossingModule>(pieces: &Pieces, module: &M, robustness: Robustness) -> Arrangement {
    let (graph, trapezoids, audit) = Sweep::new(pieces, module, robustness).run();
    Arrangement { graph, trapezoids, audit }
}

fn extent(pieces: &Pieces) -> f64 {
    let Some(&first) = pieces.points.first() else { return 0.0 };
    let (min, max) = pieces.points.iter().fold((first, first), |(min, max), p| (min.min(*p), max.max(*p)));
    (max - min).max_element()
}
