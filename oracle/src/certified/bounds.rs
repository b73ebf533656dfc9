//! Boxes of doubles around pieces.

use super::vector::Vector;

/// A closed box `[x0, y0, x1, y1]`.
pub type Bounds = [f64; 4];

/// The box around two boxes.
#[must_use]
pub fn around(a: Bounds, b: Bounds) -> Bounds {
    [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])]
}

/// Whether closed boxes have a point in common.
#[must_use]
pub fn meet(a: &Bounds, b: &Bounds) -> bool {
    a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3]
}

/// A box around the points t - p for p in the box.
#[must_use]
pub fn mirrored(bounds: &Bounds, t: &Vector) -> Bounds {
    let [x0, y0, x1, y1] = bounds;
    [(t.x.lo() - x1).next_down(), (t.y.lo() - y1).next_down(), (t.x.hi() - x0).next_up(), (t.y.hi() - y0).next_up()]
}

/// A lower bound of the distance of two boxes.
#[must_use]
pub fn distance(a: &Bounds, b: &Bounds) -> f64 {
    // Three roundings of 2^-53 each and the root: 2^-50 covers them.
    const SHRINK: f64 = 1.0 - 8.9e-16;
    const UNDERFLOW: f64 = 1e-150;
    let [x, y] = [0, 1].map(|i| (b[i] - a[i + 2]).max(a[i] - b[i + 2]).max(0.0));
    ((x * x + y * y).sqrt() * SHRINK - UNDERFLOW).max(0.0)
}
