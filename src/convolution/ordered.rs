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
        self.order.known(f, g, x)
    }

    fn related(&self, piece: u32, x: f64) -> Vec<u32> {
        self.order.related(piece, x).collect()
    }
}
