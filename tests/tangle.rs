//! Tangles: closed loops that cross themselves and each other at will, the raw input of an arrangement.

use glam::DVec2;
use proptest::prelude::*;

/// Loops of three to eight points on an integer grid of this size: full of coincidences.
pub fn on_grid(size: i32) -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    let point = (0..=size, 0..=size).prop_map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
    prop::collection::vec(prop::collection::vec(point, 3..8), 1..5)
}

/// Loops of three to eight points in the unit box.
pub fn in_box() -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    let point = (0.0..1.0, 0.0..1.0).prop_map(|(x, y)| DVec2::new(x, y));
    prop::collection::vec(prop::collection::vec(point, 3..8), 1..5)
}

/// Winding number of polygons around a point, by crossings of the ray to the right. Exact unless the point is on a loop.
#[must_use]
pub fn winding(loops: &[Vec<DVec2>], t: DVec2) -> i32 {
    let mut w = 0;
    for points in loops {
        for i in 0..points.len() {
            let (p, q) = (points[i] - t, points[(i + 1) % points.len()] - t);
            if (p.y < 0.0) != (q.y < 0.0) && (p.x * q.y - q.x * p.y > 0.0) == (q.y > p.y) {
                w += if q.y > p.y { 1 } else { -1 };
            }
        }
    }
    w
}
