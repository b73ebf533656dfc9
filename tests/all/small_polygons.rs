//! Validation against an independent judge on random polygons of a small grid, where touches, overlaps and cusps abound.
//!
//! The judge works in integers on coordinates that are multiplied by 2, so that the middle of two grid points is one as
//! well; every touch of two lines that do not cross is at a vertex, so it is a grid point too.

use arcsum::region::{Node, Region};
use arcsum::validate::validate;
use arcsum_reports::cases::rng::Rng;
use std::collections::{BTreeMap, BTreeSet};

type Point = (i64, i64);

fn orient(a: Point, b: Point, c: Point) -> i64 {
    ((b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)).signum()
}

fn on_segment(p: Point, (a, b): (Point, Point)) -> bool {
    orient(a, b, p) == 0 && (p.0 - a.0) * (p.0 - b.0) <= 0 && (p.1 - a.1) * (p.1 - b.1) <= 0
}

fn edges(polygon: &[Point]) -> Vec<(Point, Point)> {
    (0..polygon.len()).map(|i| (polygon[i], polygon[(i + 1) % polygon.len()])).collect()
}

fn cross((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    orient(a, b, c) * orient(a, b, d) < 0 && orient(c, d, a) * orient(c, d, b) < 0
}

/// The ends of either segment that lie on the other.
fn shared_ends(one: (Point, Point), other: (Point, Point)) -> BTreeSet<Point> {
    let mine = [one.0, one.1].into_iter().filter(|&p| on_segment(p, other));
    let theirs = [other.0, other.1].into_iter().filter(|&p| on_segment(p, one));
    mine.chain(theirs).collect()
}

fn doubled_area(polygon: &[Point]) -> i64 {
    edges(polygon).iter().map(|((ax, ay), (bx, by))| ax * by - ay * bx).sum()
}

/// Whether the polygon is simple: edges share nothing but the vertex between neighbours.
fn is_simple(polygon: &[Point]) -> bool {
    let (edges, n) = (edges(polygon), polygon.len());
    (0..n).all(|i| {
        (i + 1..n).all(|j| {
            let shared = shared_ends(edges[i], edges[j]);
            let neighbours = j == i + 1 || (i == 0 && j == n - 1);
            !cross(edges[i], edges[j]) && shared.len() == usize::from(neighbours)
        })
    })
}

/// Whether a point off the boundary lies inside, by the crossings of a ray to the right.
fn contains(polygon: &[Point], p: Point) -> bool {
    let crossed = |&&(a, b): &&(Point, Point)| (a.1 <= p.1) != (b.1 <= p.1) && (orient(a, b, p) > 0) == (b.1 > a.1);
    edges(polygon).iter().filter(crossed).count() % 2 == 1
}

/// How simple polygons lie: `Err` if they cross or overlap, else for each pair the common points and, if one holds the
/// other, which.
fn relation(a: &[Point], b: &[Point]) -> Result<(BTreeSet<Point>, Option<bool>), ()> {
    let mut touches = BTreeSet::new();
    for &e in &edges(a) {
        for &f in &edges(b) {
            let shared = shared_ends(e, f);
            if cross(e, f) || shared.len() > 1 {
                return Err(());
            }
            touches.extend(shared);
        }
    }
    let (a_in_b, b_in_a) = (side(a, b, &touches)?, side(b, a, &touches)?);
    Ok((touches, if a_in_b { Some(true) } else { b_in_a.then_some(false) }))
}

/// Whether `a` lies inside `b`; `Err` if only some of the stretches between touches do.
fn side(a: &[Point], b: &[Point], touches: &BTreeSet<Point>) -> Result<bool, ()> {
    let mut sides = BTreeSet::new();
    for edge in edges(a) {
        let distance = |p: &Point| (p.0 - edge.0.0).abs() + (p.1 - edge.0.1).abs();
        let mut stops: Vec<Point> = touches.iter().copied().filter(|&p| on_segment(p, edge)).collect();
        stops.extend([edge.0, edge.1]);
        stops.sort_by_key(distance);
        stops.dedup();
        sides.extend(stops.windows(2).map(|w| contains(b, ((w[0].0 + w[1].0) / 2, (w[0].1 + w[1].1) / 2))));
    }
    if sides.len() == 1 { Ok(sides.contains(&true)) } else { Err(()) }
}

/// Whether loops with the interior on the left make a valid bounded region.
fn judge(loops: &[Vec<Point>]) -> bool {
    if loops.is_empty() || !loops.iter().all(|l| is_simple(l)) {
        return false;
    }
    let mut around = vec![BTreeSet::new(); loops.len()];
    let mut touches = BTreeMap::new();
    for i in 0..loops.len() {
        for j in i + 1..loops.len() {
            let Ok((points, inside)) = relation(&loops[i], &loops[j]) else { return false };
            match inside {
                Some(true) => drop(around[i].insert(j)),
                Some(false) => drop(around[j].insert(i)),
                None => {}
            }
            touches.insert((i, j), points);
        }
    }
    let oriented = |i: usize| (doubled_area(&loops[i]) > 0) == (around[i].len() % 2 == 0);
    (0..loops.len()).all(oriented) && interior_is_connected(&around, &touches)
}

/// Whether in no part of the region its loops and their touching points form a ring. Without a ring the graph of loops
/// and points of each part has as many groups as nodes less edges.
fn interior_is_connected(around: &[BTreeSet<usize>], touches: &BTreeMap<(usize, usize), BTreeSet<Point>>) -> bool {
    let part = |i: usize| match around[i].len() % 2 {
        0 => i,
        _ => *around[i].iter().max_by_key(|&&j| around[j].len()).expect("a hole lies in a loop"),
    };
    let mut incidences = BTreeSet::new();
    for (&(i, j), points) in touches.iter().filter(|&(&(i, j), _)| part(i) == part(j)) {
        incidences.extend(points.iter().flat_map(|&p| [(i, (part(i), p)), (j, (part(j), p))]));
    }
    // Repeatedly drop what hangs on by one edge; only rings remain.
    loop {
        let before = incidences.len();
        let loops = incidences.iter().map(|&(i, _)| i).collect::<Vec<_>>();
        incidences.retain(|&(i, _)| loops.iter().filter(|&&l| l == i).count() > 1);
        let points = incidences.iter().map(|&(_, p)| p).collect::<Vec<_>>();
        incidences.retain(|&(_, p)| points.iter().filter(|&&q| q == p).count() > 1);
        if incidences.len() == before {
            return incidences.is_empty();
        }
    }
}

fn region(loops: &[Vec<Point>]) -> Region {
    // Halves, so that the region is on the grid of the polygons before they were doubled.
    let node = |&(x, y): &Point| Node::line(x as f64 / 2.0, y as f64 / 2.0);
    Region { loops: loops.iter().map(|l| l.iter().map(node).collect()).collect(), ..Region::default() }
}

fn random_loop(random: &mut Rng, grid: usize) -> Vec<Point> {
    let count = 3 + random.below(4);
    (0..count).map(|_| (2 * random.below(grid) as i64, 2 * random.below(grid) as i64)).collect()
}

#[test]
fn single_polygons_are_judged_as_by_integers() {
    let mut random = Rng::new(2, "tests");
    let mut valid = 0;
    for _ in 0..300_000 {
        let loops = [random_loop(&mut random, 5)];
        let verdict = validate(&region(&loops));
        assert_eq!(verdict.is_ok(), judge(&loops), "{loops:?}: {verdict:?}");
        valid += usize::from(verdict.is_ok());
    }
    println!("{valid} of 300000 polygons are valid");
    assert!(valid > 10_000);
}

#[test]
fn sets_of_polygons_are_judged_as_by_integers() {
    let mut random = Rng::new(3, "tests");
    let (mut valid, mut cut, mut touching) = (0, 0, 0);
    for _ in 0..200_000 {
        let mut simple = || {
            let polygon = std::iter::repeat_with(|| random_loop(&mut random, 6)).find(|p| is_simple(p));
            polygon.expect("the generator never ends")
        };
        let mut loops = vec![simple(), simple(), vec![(-2, -2), (12, -2), (12, 12), (-2, 12)]];
        loops[2].rotate_left(random.below(4));
        loops.truncate(2 + random.below(2));
        orient_by_depth(&mut loops);
        let verdict = validate(&region(&loops));
        assert_eq!(verdict.is_ok(), judge(&loops), "{loops:?}: {verdict:?}");
        let touches = relation(&loops[0], &loops[1]).is_ok_and(|(points, _)| !points.is_empty());
        valid += usize::from(verdict.is_ok());
        touching += usize::from(verdict.is_ok() && touches);
        cut += usize::from(verdict.is_err_and(|e| matches!(e, arcsum::validate::Invalid::CutInterior { .. })));
    }
    println!("{valid} of 200000 sets are valid, {touching} of them touch, {cut} are cut");
    assert!(valid > 5_000 && touching > 1_000 && cut > 100);
}

/// Turns the loops that lie the wrong way for their depth, so that most sets fail for a better reason.
fn orient_by_depth(loops: &mut [Vec<Point>]) {
    let middle = |l: &[Point]| ((l[0].0 + l[1].0) / 2, (l[0].1 + l[1].1) / 2);
    for i in 0..loops.len() {
        let depth = (0..loops.len()).filter(|&j| j != i && contains(&loops[j], middle(&loops[i]))).count();
        if (doubled_area(&loops[i]) > 0) != (depth % 2 == 0) {
            loops[i].reverse();
        }
    }
}
