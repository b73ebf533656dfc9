//! The nine parts 1a to 5 of the packing experiments (memo G, in place of MS Fig. 16), as regions of lines and circle
//! segments with signed radii.

use super::shape::{Point, polar, region};
use arcsum::region::{Curve, Node, Region};
use libm::{atan2, cos, hypot, sin, tan};
use std::f64::consts::TAU;

/// The names of the parts, in the order of the papers' table.
pub const NAMES: [&str; 9] = ["1a", "1b", "1c", "2a", "2b", "2c", "3", "4", "5"];

/// The part of this name; none for other names.
#[must_use]
pub fn part(name: &str) -> Option<Region> {
    let nodes = match name {
        "1a" => gear(8),
        "1b" => gear(16),
        "1c" => gear(32),
        "2a" => cam(10),
        "2b" => cam(20),
        "2c" => cam(40),
        "3" => channel(),
        "4" => hook(),
        "5" => sprocket(12),
        _ => return None,
    };
    Some(Region { name: Some(name.to_owned()), ..region(vec![nodes]) })
}

/// A gear: tip arc, flank, root arc, flank for each tooth.
#[must_use]
pub fn gear(teeth: u32) -> Vec<Node> {
    let (outer, inner, tip, root) = (1.0, 0.78, 0.22, 0.28);
    let flank = (1.0 - tip - root) / 2.0;
    let pitch = TAU / f64::from(teeth);
    let at = |r: f64, i: u32, part: f64, curve| {
        let [x, y] = polar(r, pitch * (f64::from(i) + part));
        Node { x, y, curve }
    };
    let tooth = |i: u32| {
        [
            at(outer, i, 0.0, Curve::Radius(outer)),
            at(outer, i, tip, Curve::Line),
            at(inner, i, tip + flank, Curve::Radius(inner)),
            at(inner, i, tip + flank + root, Curve::Line),
        ]
    };
    (0..teeth).flat_map(tooth).collect()
}

/// A cam: a closed tangent-continuous convex spline of arcs with radii r0 + a2 cos 2t + a3 cos 3t, changed least so that
/// it closes.
fn cam(arcs: u32) -> Vec<Node> {
    let n = f64::from(arcs);
    let edge = |i: u32| {
        let (s, t) = (TAU * f64::from(i) / n, TAU * f64::from(i + 1) / n);
        [cos(t) - cos(s), sin(t) - sin(s)]
    };
    let wanted = |i: u32| {
        let t = TAU * (f64::from(i) + 0.5) / n;
        1.0 + 0.45 * cos(2.0 * t) + 0.25 * cos(3.0 * t)
    };
    let sum = |f: &dyn Fn(u32) -> f64| (0..arcs).map(f).sum::<f64>();
    let xx = sum(&|i| edge(i)[0] * edge(i)[0]);
    let xy = sum(&|i| edge(i)[0] * edge(i)[1]);
    let yy = sum(&|i| edge(i)[1] * edge(i)[1]);
    let gap = [sum(&|i| wanted(i) * edge(i)[0]), sum(&|i| wanted(i) * edge(i)[1])];
    let det = xx * yy - xy * xy;
    let change = [(gap[0] * yy - gap[1] * xy) / det, (gap[1] * xx - gap[0] * xy) / det];
    let mut at = [0.0, 0.0];
    let mut nodes = Vec::new();
    for i in 0..arcs {
        let radius = wanted(i) - change[0] * edge(i)[0] - change[1] * edge(i)[1];
        nodes.push(Node { x: at[0], y: at[1], curve: Curve::Radius(radius) });
        at = [at[0] + radius * edge(i)[0], at[1] + radius * edge(i)[1]];
    }
    nodes
}

/// A C-channel with lips and twelve rounded corners.
fn channel() -> Vec<Node> {
    let corners = [
        ([0.0, 0.0], 0.25),
        ([4.0, 0.0], 0.25),
        ([4.0, 1.6], 0.2),
        ([3.2, 1.6], 0.2),
        ([3.2, 0.8], 0.25),
        ([0.8, 0.8], 0.3),
        ([0.8, 3.2], 0.3),
        ([3.2, 3.2], 0.25),
        ([3.2, 2.4], 0.2),
        ([4.0, 2.4], 0.2),
        ([4.0, 4.0], 0.25),
        ([0.0, 4.0], 0.25),
    ];
    rounded(&corners)
}

/// A snap hook with eleven rounded corners.
fn hook() -> Vec<Node> {
    let corners = [
        ([0.0, 0.0], 0.2),
        ([3.0, 0.0], 0.25),
        ([3.0, 0.9], 0.25),
        ([1.1, 0.9], 0.3),
        ([1.1, 2.2], 0.3),
        ([2.6, 2.2], 0.12),
        ([2.9, 2.7], 0.15),
        ([2.4, 3.2], 0.15),
        ([1.1, 3.1], 0.2),
        ([0.9, 3.8], 0.15),
        ([0.0, 3.8], 0.2),
    ];
    rounded(&corners)
}

/// A sprocket: tip, two roundings, two flanks, two fillets and root for each tooth.
fn sprocket(teeth: u32) -> Vec<Node> {
    let pitch = TAU / f64::from(teeth);
    let tooth = |i: u32| {
        let at = |r: f64, part: f64| polar(r, pitch * (f64::from(i) + part));
        [(at(1.0, 0.0), 0.03), (at(1.0, 0.24), 0.03), (at(0.74, 0.47), 0.05), (at(0.74, 0.77), 0.05)]
    };
    let corners: Vec<(Point, f64)> = (0..teeth).flat_map(tooth).collect();
    rounded(&corners)
}

/// The polygon with every corner replaced by a tangent arc of the given radius: two nodes a corner.
#[must_use]
pub fn rounded(corners: &[(Point, f64)]) -> Vec<Node> {
    let n = corners.len();
    let corner = |i: usize| {
        let (before, (at, radius), after) = (corners[(i + n - 1) % n].0, corners[i], corners[(i + 1) % n].0);
        let (u, v) = (direction(before, at), direction(at, after));
        let turn = atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
        let cut = radius * tan(turn.abs() / 2.0);
        let curve = Curve::Radius(radius.copysign(turn));
        [
            Node { x: at[0] - u[0] * cut, y: at[1] - u[1] * cut, curve },
            Node::line(at[0] + v[0] * cut, at[1] + v[1] * cut),
        ]
    };
    (0..n).flat_map(corner).collect()
}

fn direction(from: Point, to: Point) -> Point {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = hypot(dx, dy);
    [dx / length, dy / length]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_the_papers_segments() {
        let counts: Vec<usize> = NAMES.iter().filter_map(|n| part(n)).map(|r| r.segments()).collect();
        assert_eq!(counts, [32, 64, 128, 10, 20, 40, 24, 22, 96]);
    }

    #[test]
    fn the_cam_closes_tangentially() {
        let nodes = cam(10);
        // The chord of arc i points along the middle normal turned by 90 degrees, also for the closing one.
        let (last, first) = (nodes[9], nodes[0]);
        let chord = atan2(first.y - last.y, first.x - last.x);
        let wanted = TAU * 9.5 / 10.0 + TAU / 4.0 - TAU;
        assert!((chord - wanted).abs() < 1e-14, "{chord} {wanted}");
    }
}
