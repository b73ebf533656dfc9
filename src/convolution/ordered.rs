//! A crossing module that knows more about some curves than where they cross (MS 7.1).

use super::order::Order;
use crate::arrangement::cross::{CrossingModule, Crossings};
use crate::arrangement::curve::Curve;
use crate::arrangement::known::Known;
use glam::DVec2;

/// A crossing module with the convolution order of its pieces.
#[derive(Clone, Copy, Debug)]
pub struct Ordered<'o, M> {
    /// The module.
    pub module: M,
    /// The order.
    pub order: &'o Order,
    /// Where it is used.
    pub hooks: Hooks,
}

/// The places at which the sweep uses the order. Both are on; tests switch them off to show what they are good for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hooks {
    /// Swaps against the order are refused, and neighbours that are against it are swapped.
    pub swaps: bool,
    /// New curves are inserted between those that they are known to be between.
    pub insertion: bool,
}

impl Default for Hooks {
    fn default() -> Self {
        Self { swaps: true, insertion: true }
    }
}

impl<'o, M> Ordered<'o, M> {
    /// A module with an order, used everywhere.
    #[must_use]
    pub fn new(module: M, order: &'o Order) -> Self {
        Self { module, order, hooks: Hooks::default() }
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
        if self.hooks.swaps { self.order.known(f, g, x) } else { Known::NOTHING }
    }

    fn placed(&self, f: &Curve, g: &Curve, x: f64) -> Option<bool> {
        if self.hooks.insertion { self.order.known(f, g, x).below } else { None }
    }

    fn related(&self, piece: u32, x: f64) -> Vec<u32> {
        if self.hooks.insertion { self.order.related(piece, x).collect() } else { Vec::new() }
    }
}
