//! Random simple polygons (memo J5): random points joined at random, then untangled by reversing stretches between
//! crossing edges (2-opt).
//!
//! Points lie on an integer grid of 2^20 by 2^20, so crossings are decided exactly. A reversal shortens the boundary,
//! therefore the loop ends. The result is simple, counter-clockwise, and has no repeated vertex.

use super::rng::Rng;
use super::shape::{Point, polygon};
use arcsum::region::Region;

type Grid = [i64; 2];

const SIDE: usize = 1 << 20;

/// A random simple polygon of n >= 3 vertices in the unit square, in multiples of 2^-20.
pub fn simple(n: u32, rng: &mut Rng) -> Region {
    loop {
        let mut points: Vec<Grid> = (0..n).map(|_| [rng.below(SIDE) as i64, rng.below(SIDE) as i64]).collect();
        untangle(&mut points);
        // Grazing contacts (three points on a line) are not crossings to the untangler; draw again.
        if is_simple(&points) {
            return polygon(&oriented(&points));
        }
    }
}

fn oriented(points: &[Grid]) -> Vec<Point> {
    let scale = 1.0 / SIDE as f64;
    let mut out: Vec<Point> = points.iter().map(|p| [p[0] as f64 * scale, p[1] as f64 * scale]).collect();
    if doubled_area(points) < 0 {
        out.reverse();
    }
    out
}

fn untangle(points: &mut [Grid]) {
    while let Some((i, j)) = crossing(points) {
        points[i + 1..=j].reverse();
    }
}

/// Two edges i < j (from vertex i, from vertex j) that cross properly.
fn crossing(points: &[Grid]) -> Option<(usize, usize)> {
    let n = points.len();
    let edge = |i: usize| (points[i], points[(i + 1) % n]);
    (0..n).flat_map(|i| (i + 2..n).map(move |j| (i, j))).find(|&(i, j)| {
        let ((a, b), (c, d)) = (edge(i), edge(j));
        turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0
    })
}

/// Whether no two edges have a point in common but the vertex between neighbours.
fn is_simple(points: &[Grid]) -> bool {
    let n = points.len();
    let edge = |i: usize| (points[i], points[(i + 1) % n]);
    let apart = |i: usize, j: usize| {
        let ((a, b), (c, d)) = (edge(i), edge(j));
        if j == i + 1 {
            return !folds(a, b, d);
        }
        if (j + 1) % n == i {
            return !folds(c, d, b);
        }
        !touch(a, b, c, d)
    };
    (0..n).all(|i| (i + 1..n).all(|j| apart(i, j)))
}

/// Whether the path a, b, c turns back on itself (or stands still).
fn folds(a: Grid, b: Grid, c: Grid) -> bool {
    let dot = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
    turn(a, b, c) == 0 && dot <= 0
}

fn touch(a: Grid, b: Grid, c: Grid, d: Grid) -> bool {
    let on = |p: Grid, q: Grid, r: Grid| {
        turn(p, q, r) == 0 && (0..2).all(|k| r[k] >= p[k].min(q[k]) && r[k] <= p[k].max(q[k]))
    };
    let proper = turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
    proper || on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)
}

/// Sign of the turn a, b, c. Coordinates below 2^20 cannot overflow.
fn turn(a: Grid, b: Grid, c: Grid) -> i64 {
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
}

fn doubled_area(points: &[Grid]) -> i64 {
    let n = points.len();
    (0..n).map(|i| (points[i], points[(i + 1) % n])).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bow_tie_is_untangled() {
        let mut tie = [[0, 0], [4, 4], [4, 0], [0, 4]];
        assert!(!is_simple(&tie));
        untangle(&mut tie);
        assert!(is_simple(&tie) && doubled_area(&tie).abs() == 32);
    }

    #[test]
    fn contacts_and_folds_are_not_simple() {
        assert!(!is_simple(&[[0, 0], [4, 0], [4, 4], [2, 0], [0, 4]]));
        assert!(!is_simple(&[[0, 0], [4, 0], [2, 0], [2, 4]]));
        assert!(is_simple(&[[0, 0], [4, 0], [8, 0], [4, 4]]));
    }
}
