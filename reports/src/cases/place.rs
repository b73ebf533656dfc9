//! Regions placed elsewhere: turned, moved and scaled vertex by vertex.
//!
//! Each vertex is rounded, so the placed region is a new region near the old one; curves keep their radius or bulge.

use arcsum::region::{Curve, Node, Region};
use libm::{cos, sin};

/// The region turned counter-clockwise by `angle` radians about the origin. Bulges do not change.
#[must_use]
pub fn turned(region: &Region, angle: f64) -> Region {
    let (s, c) = (sin(angle), cos(angle));
    each(region, |n| Node { x: c * n.x - s * n.y, y: s * n.x + c * n.y, ..n })
}

/// The region turned by 90 degrees counter-clockwise about the origin. Exact.
#[must_use]
pub fn quarter_turned(region: &Region) -> Region {
    each(region, |n| Node { x: -n.y, y: n.x, ..n })
}

/// The region moved by `by`.
#[must_use]
pub fn moved(region: &Region, by: [f64; 2]) -> Region {
    each(region, |n| Node { x: n.x + by[0], y: n.y + by[1], ..n })
}

/// The region scaled by `factor` > 0 about the origin. Exact for powers of two.
#[must_use]
pub fn scaled(region: &Region, factor: f64) -> Region {
    let curve = |c| match c {
        Curve::Radius(r) => Curve::Radius(r * factor),
        other => other,
    };
    each(region, |n| Node { x: n.x * factor, y: n.y * factor, curve: curve(n.curve) })
}

fn each(region: &Region, f: impl Fn(Node) -> Node) -> Region {
    let loops = region.loops.iter().map(|l| l.iter().map(|&n| f(n)).collect()).collect();
    Region { name: region.name.clone(), loops, unbounded: region.unbounded }
}
