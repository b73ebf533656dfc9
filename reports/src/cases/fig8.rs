//! A convex part in a convex container (MS Fig. 8; memo M17): the complement of a regular polygon, and one of half its size
//! turned by a part of a corner.
//!
//! The sum leaves one convex cell free. The kinetic convolution runs back and forth along the boundary of that cell and
//! crosses itself at every corner, so it has more cells than corners, all but one of the bounded ones inside the sum. Neither
//! the convex convolution nor the monotonic one has any of these.

use super::shape::{polygon, regular};
use arcsum::region::Region;
use std::f64::consts::TAU;

/// The part's radius; the container's is 1.
const RADIUS: f64 = 0.5;

/// Where the container's first corner is, in turns: no edge is upright.
const TURNS: f64 = 0.0123;

/// How far the part is turned against it, in corners: no two edges are parallel.
const APART: f64 = 0.3;

/// The part and the plane without the container, both of so many corners.
#[must_use]
pub fn fig8(corners: u32) -> (Region, Region) {
    let regular = |radius: f64, turns: f64| polygon(&regular(corners, radius, TAU * turns));
    let part = regular(RADIUS, TURNS + APART / f64::from(corners));
    (part, regular(1.0, TURNS).complement())
}
