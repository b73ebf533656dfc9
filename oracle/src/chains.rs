//! Chains and turning points of polygons by definition (MS 2; memo E1), in exact arithmetic: ordinates of chains, of crusts
//! and of moved chains at one abscissa.

use crate::plain::{Bend, PlainRegion};
use rug::Rational;
use std::cmp::Ordering;

/// A point.
pub type Point = [Rational; 2];

/// A maximal run of edges that face up, or down.
#[derive(Clone, Debug)]
pub struct Chain {
    /// Whether the region lies below it.
    pub upper: bool,
    /// Its vertices in the order of traversal.
    pub path: Vec<Point>,
}

/// The rings of a polygon with doubles for coordinates.
///
/// # Panics
/// If a segment is bent or a coordinate is not finite.
#[must_use]
pub fn rings(region: &PlainRegion) -> Vec<Vec<Point>> {
    let exact = |x: f64| Rational::from_f64(x).expect("finite");
    let ring = |corners: &Vec<crate::plain::Corner>| {
        assert!(corners.iter().all(|corner| corner.bend == Bend::Line), "a polygon");
        corners.iter().map(|corner| [exact(corner.x), exact(corner.y)]).collect()
    };
    region.loops.iter().map(ring).collect()
}

/// The chains of a ring, in the order of traversal.
#[must_use]
pub fn chains(ring: &[Point]) -> Vec<Chain> {
    let (n, labels) = (ring.len(), labels(ring));
    let starts: Vec<usize> = (0..n).filter(|&i| labels[i] != labels[(i + n - 1) % n]).collect();
    let chain = |(k, &start): (usize, &usize)| {
        let end = starts[(k + 1) % starts.len()];
        let length = (end + n - start - 1) % n + 1;
        Chain { upper: labels[start], path: (0..=length).map(|i| ring[(start + i) % n].clone()).collect() }
    };
    starts.iter().enumerate().map(chain).collect()
}

/// Whether each edge faces up. A vertical goes with its neighbours if they agree, else it faces up when it goes up.
fn labels(ring: &[Point]) -> Vec<bool> {
    let n = ring.len();
    let way = |i: usize| ring[(i + 1) % n][0].cmp(&ring[i][0]);
    let near = |i: usize, step: usize| {
        (1..n).map(|k| way((i + k * step) % n)).find(|way| *way != Ordering::Equal) == Some(Ordering::Less)
    };
    let label = |i: usize| match way(i) {
        Ordering::Less => true,
        Ordering::Greater => false,
        Ordering::Equal if near(i, 1) == near(i, n - 1) => near(i, 1),
        Ordering::Equal => ring[(i + 1) % n][1] > ring[i][1],
    };
    (0..n).map(label).collect()
}

/// The turning points of a ring with the lower chain on top, from its chains.
#[must_use]
pub fn concave(chains: &[Chain]) -> Vec<Point> {
    let is_concave = |k: usize| {
        let (before, after) = (&chains[k], &chains[(k + 1) % chains.len()]);
        let p = &after.path[0];
        let out = |q: &Point| [Rational::from(&q[0] - &p[0]), Rational::from(&q[1] - &p[1])];
        let (u, v) = (out(&before.path[before.path.len() - 2]), out(&after.path[1]));
        // The region lies to the left: the interior angle at p opens from v counter-clockwise to u.
        let cross = Rational::from(&v[0] * &u[1]) - Rational::from(&v[1] * &u[0]);
        (cross < 0).then(|| p.clone())
    };
    (0..chains.len()).filter_map(is_concave).collect()
}

/// The highest, or lowest, ordinate of a path at an abscissa.
#[must_use]
pub fn extreme(path: &[Point], x: &Rational, highest: bool) -> Option<Rational> {
    let mut found: Option<Rational> = None;
    for pair in path.windows(2) {
        let [l, r] = if pair[0][0] <= pair[1][0] { [&pair[0], &pair[1]] } else { [&pair[1], &pair[0]] };
        if l[0] > *x || *x > r[0] {
            continue;
        }
        let width = Rational::from(&r[0] - &l[0]);
        let ordinates = if width == 0 {
            vec![l[1].clone(), r[1].clone()]
        } else {
            vec![Rational::from(x - &l[0]) / width * Rational::from(&r[1] - &l[1]) + &l[1]]
        };
        found = ordinates.into_iter().chain(found).reduce(|y, z| outer(y, z, highest));
    }
    found
}

/// The sup-convolution of two upper paths at an abscissa, or the inf-convolution of two lower ones: the outermost sum of
/// ordinates over all pairs of abscissas with this sum. It is attained at a vertex of one path.
#[must_use]
pub fn convolved(p: &[Point], q: &[Point], x: &Rational, upper: bool) -> Option<Rational> {
    let own = p.iter().map(|v| v[0].clone());
    let other = q.iter().map(|v| Rational::from(x - &v[0]));
    let sum = |u: Rational| Some(extreme(p, &u, upper)? + extreme(q, &Rational::from(x - &u), upper)?);
    own.chain(other).filter_map(sum).reduce(|y, z| outer(y, z, upper))
}

fn outer(y: Rational, z: Rational, highest: bool) -> Rational {
    if (y > z) == highest { y } else { z }
}

/// The winding number of a point, on none of the edges, in directed edges that close.
pub fn winding<'a>(edges: impl Iterator<Item = [&'a Point; 2]>, t: &Point) -> i32 {
    let crossing = |[p, q]: [&Point; 2]| {
        let up = q[1] > t[1];
        if (p[1] > t[1]) == up {
            return 0;
        }
        let along = Rational::from(&t[1] - &p[1]) / Rational::from(&q[1] - &p[1]);
        let x = along * Rational::from(&q[0] - &p[0]) + &p[0];
        i32::from(x > t[0]) * if up { 1 } else { -1 }
    };
    edges.map(crossing).sum()
}

/// The edges of a ring.
pub fn edges(ring: &[Point]) -> impl Iterator<Item = [&Point; 2]> {
    (0..ring.len()).map(|i| [&ring[i], &ring[(i + 1) % ring.len()]])
}
