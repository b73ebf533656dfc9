//! Regions of unit cells on a small integer grid (memo J5, degenerate): random orthogonal polygons with or without holes,
//! with chamfered or rounded corners, with or without the collinear vertices between cells.
//!
//! Cells are added one by one next to earlier ones and never so that two cells meet in a corner alone; the boundary is
//! therefore made of disjoint simple loops. Nearly all coincidences a sum can have occur here.

use super::rng::Rng;
use super::shape::region;
use arcsum::region::{Curve, Node, Region};
use std::collections::{BTreeMap, BTreeSet};

type Cell = [i32; 2];

/// What happens to the corners of a cell region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corners {
    /// Left as they are.
    Sharp,
    /// Cut at 45 degrees, half a cell wide.
    Chamfered,
    /// Replaced by a tangent quarter circle, half a cell in radius.
    Rounded,
}

/// What a cell region looks like.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// The side of the grid.
    pub side: i32,
    /// The number of cells.
    pub cells: usize,
    /// Whether holes are wanted; without, a cell that would close one is not added.
    pub holes: bool,
    /// Whether vertices between collinear cell edges are kept.
    pub collinear: bool,
    /// The corners.
    pub corners: Corners,
}

/// A random cell region. Vertices are integers or halves.
pub fn cells(style: Style, rng: &mut Rng) -> Region {
    let set = grow(style, rng);
    let loops = outline(&set).into_iter().map(|l| if style.collinear { l } else { straightened(&l) });
    region(loops.map(|l| dressed(&l, style.corners)).collect())
}

fn grow(style: Style, rng: &mut Rng) -> BTreeSet<Cell> {
    let mut set = BTreeSet::from([[style.side / 2, style.side / 2]]);
    // A grid can fill up before the wanted number is reached; the tries bound the walk.
    for _ in 0..40 * style.cells {
        if set.len() >= style.cells {
            break;
        }
        let cell = [rng.below(style.side as usize) as i32, rng.below(style.side as usize) as i32];
        let beside = sides(cell).iter().filter(|c| set.contains(*c)).count();
        if beside > 0 && !set.contains(&cell) && !pinches(&set, cell) {
            set.insert(cell);
            if !style.holes && has_hole(&set, style.side) {
                set.remove(&cell);
            }
        }
    }
    set
}

fn sides([x, y]: Cell) -> [Cell; 4] {
    [[x + 1, y], [x, y + 1], [x - 1, y], [x, y - 1]]
}

/// Whether the cell would touch another in a corner alone.
fn pinches(set: &BTreeSet<Cell>, [x, y]: Cell) -> bool {
    let has = |dx: i32, dy: i32| set.contains(&[x + dx, y + dy]);
    [(1, 1), (1, -1), (-1, 1), (-1, -1)].iter().any(|&(dx, dy)| has(dx, dy) && !has(dx, 0) && !has(0, dy))
}

/// Whether some empty cell cannot reach the border.
fn has_hole(set: &BTreeSet<Cell>, side: i32) -> bool {
    let inside = |[x, y]: Cell| (-1..=side).contains(&x) && (-1..=side).contains(&y);
    let mut reached = BTreeSet::from([[-1, -1]]);
    let mut open = vec![[-1, -1]];
    while let Some(cell) = open.pop() {
        for next in sides(cell) {
            if inside(next) && !set.contains(&next) && reached.insert(next) {
                open.push(next);
            }
        }
    }
    let empty = ((side + 2) * (side + 2)) as usize - set.len();
    reached.len() < empty
}

/// The boundary loops in unit steps, the cells on the left.
fn outline(set: &BTreeSet<Cell>) -> Vec<Vec<Cell>> {
    let mut next: BTreeMap<Cell, Cell> = BTreeMap::new();
    for &[x, y] in set {
        let ring = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
        let outward = [[x, y - 1], [x + 1, y], [x, y + 1], [x - 1, y]];
        for k in 0..4 {
            if !set.contains(&outward[k]) {
                // No pinches: every boundary vertex has exactly one edge out.
                next.insert(ring[k], ring[(k + 1) % 4]);
            }
        }
    }
    let mut loops = Vec::new();
    while let Some((start, mut at)) = next.pop_first() {
        let mut walk = vec![start];
        while at != start {
            walk.push(at);
            at = next.remove(&at).unwrap_or(start);
        }
        loops.push(walk);
    }
    loops
}

fn straightened(walk: &[Cell]) -> Vec<Cell> {
    let n = walk.len();
    let keeps = |i: usize| {
        let (p, q, r) = (walk[(i + n - 1) % n], walk[i], walk[(i + 1) % n]);
        q[0] - p[0] != r[0] - q[0] || q[1] - p[1] != r[1] - q[1]
    };
    (0..n).filter(|&i| keeps(i)).map(|i| walk[i]).collect()
}

fn dressed(walk: &[Cell], corners: Corners) -> Vec<Node> {
    let n = walk.len();
    let at = |i: usize| walk[i % n].map(f64::from);
    let mut nodes: Vec<Node> = Vec::new();
    for i in 0..n {
        let (p, q, r) = (at(i + n - 1), at(i), at(i + 1));
        let (u, v) = (unit(p, q), unit(q, r));
        let turn = u[0] * v[1] - u[1] * v[0];
        // Only convex corners are cut: a cut into a concave corner could meet the cut of another cell.
        if corners == Corners::Sharp || turn <= 0.0 {
            nodes.push(Node::line(q[0], q[1]));
            continue;
        }
        let (before, after) = ([q[0] - u[0] / 2.0, q[1] - u[1] / 2.0], [q[0] + v[0] / 2.0, q[1] + v[1] / 2.0]);
        let curve = if corners == Corners::Rounded { Curve::Radius(0.5) } else { Curve::Line };
        nodes.push(Node { x: before[0], y: before[1], curve });
        nodes.push(Node::line(after[0], after[1]));
    }
    without_repeats(nodes)
}

/// Two cuts on an edge of length one meet in its middle: the line between them is dropped.
fn without_repeats(nodes: Vec<Node>) -> Vec<Node> {
    let n = nodes.len();
    let same = |a: &Node, b: &Node| a.x == b.x && a.y == b.y;
    (0..n).filter(|&i| !same(&nodes[i], &nodes[(i + 1) % n])).map(|i| nodes[i]).collect()
}

fn unit(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    [(to[0] - from[0]).signum() * f64::from(to[0] != from[0]), (to[1] - from[1]).signum() * f64::from(to[1] != from[1])]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_has_one_loop_and_a_ring_two() {
        let block: BTreeSet<Cell> = (0..3).flat_map(|x| (0..3).map(move |y| [x, y])).collect();
        let mut ring = block.clone();
        ring.remove(&[1, 1]);
        let sizes = |set: &BTreeSet<Cell>| outline(set).iter().map(|l| straightened(l).len()).collect::<Vec<_>>();
        assert_eq!(sizes(&block), [4]);
        assert_eq!(sizes(&ring), [4, 4]);
        assert!(has_hole(&ring, 3) && !has_hole(&block, 3));
    }

    #[test]
    fn a_rounded_cell_is_four_quarter_circles() {
        let nodes = dressed(&[[0, 0], [1, 0], [1, 1], [0, 1]], Corners::Rounded);
        assert_eq!(nodes.len(), 4);
        assert!(nodes.iter().all(|n| n.curve == Curve::Radius(0.5)));
    }
}
