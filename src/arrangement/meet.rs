//! Where two lines or circles meet (memo C1).

use super::cross::EPS;
use super::curve::Curve;
use glam::DVec2;

/// Intersections of two lines or circles (memo C1): at most two, not sorted. The residual distance to both is a few eps.
pub(super) fn meet(f: &Curve, g: &Curve) -> ([DVec2; 2], usize) {
    let ((n1, k1), (n2, k2)) = (f.implicit(), g.implicit());
    let ((t1, n1, k1), (t2, n2, k2)) =
        if k1.abs() >= k2.abs() { ((f.left, n1, k1), (g.left, n2, k2)) } else { ((g.left, n2, k2), (f.left, n1, k1)) };
    let w = t1 - t2;
    let ratio = if k1 == 0.0 { 0.0 } else { k2 / k1 };
    // The radical line: the multiple of the second equation's quadratic part is removed with the first.
    let normal = n2 - ratio * n1 + 2.0 * k2 * w;
    let constant = n2.dot(w) + k2 * w.length_squared();
    let length = normal.length();
    if length <= 8.0 * EPS {
        return ([DVec2::ZERO; 2], 0);
    }
    let foot = normal * (-constant / (length * length));
    let along = DVec2::new(-normal.y, normal.x) / length;
    let b = n1.dot(along) + 2.0 * k1 * foot.dot(along);
    let c = n1.dot(foot) + k1 * foot.length_squared();
    let (roots, count) = quadratic(k1, b, c);
    (roots.map(|s| t1 + foot + s * along), count)
}

/// Real roots of `a s^2 + b s + c`, by the stable formula.
fn quadratic(a: f64, b: f64, c: f64) -> ([f64; 2], usize) {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return ([0.0; 2], 0);
    }
    let w = -0.5 * (b + discriminant.sqrt().copysign(b));
    match (a == 0.0, w == 0.0) {
        (true, true) => ([0.0; 2], 0),
        (true, false) => ([c / w, 0.0], 1),
        (false, true) => ([0.0; 2], 2),
        (false, false) => ([c / w, w / a], 2),
    }
}
