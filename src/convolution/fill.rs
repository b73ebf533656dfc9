//! The fill rule: which holes may be ignored, and must be, before two regions are convolved (memo fact 6, A8).
//!
//! The winding number of the kinetic convolution is the Euler characteristic of A ∩ (t-B), which is 0 or negative where holes
//! lie inside, although the sets meet. A hole H of A into which B does not fit, by bounding boxes, cannot hold a free
//! placement; once it is filled, every component of A ∩ (t-B) is simply connected and the winding number is 0 exactly where
//! t is free. Equal boxes count as fitting.

use crate::smooth::{Component, Smooth};
use glam::DVec2;

/// The loops of one component of each region that take part in their sum.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Filled {
    /// Loops of A, indices of its [`Smooth::loops`].
    pub a: Vec<usize>,
    /// Loops of B.
    pub b: Vec<usize>,
    /// Winding number far away.
    pub base: i32,
}

/// What the sum of two components is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PairSum {
    /// Every point of the plane: nothing to compute.
    Plane,
    /// To be convolved.
    Loops(Filled),
}

/// Applies the rule to one component of A and one of B.
#[must_use]
pub fn fill(a: &Smooth, i: &Component, b: &Smooth, j: &Component) -> PairSum {
    let holes_a = kept(a, i, extent(b, j));
    let holes_b = kept(b, j, extent(a, i));
    let unbounded = (i.outer.is_none(), j.outer.is_none());
    let whole = match unbounded {
        (true, true) => true,
        (true, false) => holes_a.is_empty(),
        (false, true) => holes_b.is_empty(),
        (false, false) => false,
    };
    if whole {
        return PairSum::Plane;
    }
    PairSum::Loops(Filled {
        a: i.outer.into_iter().chain(holes_a).collect(),
        b: j.outer.into_iter().chain(holes_b).collect(),
        base: i32::from(unbounded.0 || unbounded.1),
    })
}

/// Width and height of a component; infinite if it is unbounded.
fn extent(region: &Smooth, component: &Component) -> DVec2 {
    component.outer.map_or(DVec2::INFINITY, |outer| size(region, outer))
}

fn size(region: &Smooth, index: usize) -> DVec2 {
    region.loops[index].max - region.loops[index].min
}

/// The holes that a partner of this extent fits into.
fn kept(region: &Smooth, component: &Component, partner: DVec2) -> Vec<usize> {
    component.holes.iter().copied().filter(|h| size(region, *h).cmpge(partner).all()).collect()
}
