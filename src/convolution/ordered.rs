//! Arrangements in convolution order: a crossing module that knows more about some curves than where they cross (MS 7.1).

use super::order::Order;
use crate::arrangement::cross::{CrossingModule, Crossings};
use crate::arrangement::curve::Curve;
use crate::arrangement::known::Known;
use crate::arrangement::plain::PlainModule;
use crate::arrangement::{Arrangement, module, swept};
use crate::piece::Pieces;
use crate::robustness::{Robustness, Step};
use glam::DVec2;

/// A crossing module with the convolution order of its pieces.
#[derive(Clone, Copy, Debug)]
pub struct Ordered<'o, M> {
    /// The module.
    pub module: M,
    /// The order.
    pub order: &'o Order,
    /// Whether it is used for swaps, and for insertion.
    pub robustness: Robustness,
}

/// Arranges the pieces of a convolution in their order.
#[must_use]
pub fn arrange(pieces: &Pieces, order: &Order, robustness: Robustness) -> Arrangement {
    if robustness.takes(Step::Crossings) {
        swept(pieces, &Ordered { module: module(pieces), order, robustness }, robustness)
    } else {
        swept(pieces, &Ordered { module: PlainModule, order, robustness }, robustness)
    }
}

impl<M: CrossingModule> CrossingModule for Ordered<'_, M> {
    fn cross(&self, f: &Curve, g: &Curve) -> Crossings {
        self.module.cross(f, g)
    }

    fn above(&self, p: DVec2, curve: &Curve) -> f64 {
        self.module.above(p, curve)
    }

    fn tolerance(&self) -> f64 {
        self.module.tolerance()
    }

    fn known(&self, f: &Curve, g: &Curve, x: f64) -> Known {
        if self.robustness.takes(Step::OrderedSwaps) { self.order.known(f, g, x) } else { Known::NOTHING }
    }

    fn agrees(&self, below: bool, f: &Curve, g: &Curve) -> bool {
        self.order.agrees(below, f.piece, g.piece)
    }

    fn placed(&self, f: &Curve, g: &Curve, x: f64) -> Option<bool> {
        if self.robustness.takes(Step::OrderedInsertion) { self.order.known(f, g, x).below } else { None }
    }

    fn related(&self, piece: u32, x: f64, found: &mut Vec<u32>) {
        if self.robustness.takes(Step::OrderedInsertion) {
            self.order.related(piece, x, found);
        }
    }
}
