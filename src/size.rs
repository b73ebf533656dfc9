//! Area and perimeter of regions, in doubles: for plausibility, not for proofs.

use crate::extract::{Corner, signed_area};
use crate::region::{Curve, Node, Region};
use glam::DVec2;

impl Region {
    /// The area in squared input units: of an unbounded region, minus the area of its complement.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.loops.iter().filter(|l| !l.is_empty()).map(|l| signed_area(&corners(l))).sum()
    }

    /// The length of the boundary in input units.
    #[must_use]
    pub fn perimeter(&self) -> f64 {
        self.loops.iter().map(|l| length(&corners(l))).sum()
    }
}

/// Half the sweep of the curve from one vertex to the next; of a radius too small for its chord, a half circle.
fn half_sweep(from: &Node, to: &Node) -> f64 {
    match from.curve {
        Curve::Line => 0.0,
        Curve::Bulge(b) => 2.0 * libm::atan(b),
        Curve::Radius(r) => libm::asin((libm::hypot(to.x - from.x, to.y - from.y) / (2.0 * r)).clamp(-1.0, 1.0)),
    }
}

fn corners(nodes: &[Node]) -> Vec<Corner> {
    let n = nodes.len();
    let corner = |i: usize| Corner {
        point: DVec2::new(nodes[i].x, nodes[i].y),
        delta: half_sweep(&nodes[i], &nodes[(i + 1) % n]),
    };
    (0..n).map(corner).collect()
}

fn length(corners: &[Corner]) -> f64 {
    let n = corners.len();
    let arc = |i: usize| {
        let (delta, chord) = (corners[i].delta, (corners[(i + 1) % n].point - corners[i].point).length());
        if delta.abs() < 1e-8 { chord } else { chord * delta / libm::sin(delta) }
    };
    (0..n).map(arc).sum()
}
