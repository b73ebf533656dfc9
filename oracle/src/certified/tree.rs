//! A binary tree of boxes, for the pairs of boxes of two sets that are near each other.
//!
//! The crates that index boxes answer for one box or point at a time; here two trees are walked at once, so that far
//! groups are left out together, and the one tree moves with the question.

use super::bounds::{Bounds, around, distance, meet, mirrored};
use super::vector::Vector;

/// Boxes by their position in a list.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The root is the last one; none for no boxes.
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Bounds,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    /// The box with this index.
    Leaf(usize),
    /// Two nodes.
    Fork([usize; 2]),
}

impl Tree {
    /// The tree of these boxes.
    #[must_use]
    pub fn new(boxes: &[Bounds]) -> Self {
        let mut tree = Self { nodes: Vec::with_capacity(2 * boxes.len()) };
        let mut items: Vec<usize> = (0..boxes.len()).collect();
        if !items.is_empty() {
            tree.grow(boxes, &mut items);
        }
        tree
    }

    /// Adds the node of some boxes, split in halves along the longer side, and answers its index.
    fn grow(&mut self, boxes: &[Bounds], items: &mut [usize]) -> usize {
        let bounds = items.iter().map(|&i| boxes[i]).reduce(around).expect("a node has boxes");
        let kind = if let [item] = *items {
            Kind::Leaf(item)
        } else {
            let axis = usize::from(bounds[3] - bounds[1] > bounds[2] - bounds[0]);
            let middle = |&i: &usize| boxes[i][axis] + boxes[i][axis + 2];
            let half = items.len() / 2;
            items.select_nth_unstable_by(half, |i, j| middle(i).total_cmp(&middle(j)));
            let (low, high) = items.split_at_mut(half);
            Kind::Fork([self.grow(boxes, low), self.grow(boxes, high)])
        };
        self.nodes.push(Node { bounds, kind });
        self.nodes.len() - 1
    }

    /// The box around all boxes; `None` for no boxes.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        self.nodes.last().map(|node| node.bounds)
    }

    /// Calls `visit` with every box that meets the query.
    pub fn visit(&self, query: &Bounds, mut visit: impl FnMut(usize)) {
        let mut open: Vec<usize> = self.nodes.len().checked_sub(1).into_iter().collect();
        while let Some(Node { bounds, kind }) = open.pop().map(|node| self.nodes[node]) {
            if !meet(&bounds, query) {
                continue;
            }
            match kind {
                Kind::Leaf(item) => visit(item),
                Kind::Fork(nodes) => open.extend(nodes),
            }
        }
    }

    /// Calls `visit` with pairs of a box of this tree and a box of the other one mirrored at t, near ones early. It answers up
    /// to which distance boxes matter from then on (less than 0 ends the walk); all pairs within the last answer are visited.
    pub fn visit_pairs(&self, other: &Self, t: &Vector, limit: f64, mut visit: impl FnMut(usize, usize) -> f64) {
        let mut limit = limit;
        let apart = |i: usize, j: usize| distance(&self.nodes[i].bounds, &mirrored(&other.nodes[j].bounds, t));
        let mut open: Vec<(usize, usize, f64)> = Vec::with_capacity(64);
        if let (Some(i), Some(j)) = (self.nodes.len().checked_sub(1), other.nodes.len().checked_sub(1)) {
            open.push((i, j, apart(i, j)));
        }
        while let Some((i, j, least)) = open.pop() {
            if least > limit {
                continue;
            }
            let pairs = match (self.nodes[i].kind, other.nodes[j].kind) {
                (Kind::Leaf(first), Kind::Leaf(second)) => {
                    limit = visit(first, second);
                    continue;
                }
                (Kind::Fork(forks), Kind::Leaf(_)) => forks.map(|i| (i, j)),
                (Kind::Leaf(_), Kind::Fork(forks)) => forks.map(|j| (i, j)),
                (Kind::Fork(forks), Kind::Fork(_)) if self.size(i) > other.size(j) => forks.map(|i| (i, j)),
                (Kind::Fork(_), Kind::Fork(forks)) => forks.map(|j| (i, j)),
            };
            let [near, far] = pairs.map(|(i, j)| (i, j, apart(i, j)));
            open.extend(if near.2 <= far.2 { [far, near] } else { [near, far] });
        }
    }

    /// The longer side of a node's box.
    fn size(&self, node: usize) -> f64 {
        let [x0, y0, x1, y1] = self.nodes[node].bounds;
        (x1 - x0).max(y1 - y0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certified::precision::Precision;
    use proptest::prelude::*;

    fn boxes() -> impl Strategy<Value = Vec<Bounds>> {
        let one = (-8..8i32, -8..8i32, 0..3i32, 0..3i32);
        let bounds = |(x, y, w, h)| [x, y, x + w, y + h].map(f64::from);
        prop::collection::vec(one.prop_map(bounds), 0..30)
    }

    proptest! {
        #[test]
        fn a_walk_misses_nothing_within_the_limit(a in boxes(), b in boxes(), x in -4..4i32, y in -4..4i32, limit in 0.0..6.0f64) {
            let (first, second) = (Tree::new(&a), Tree::new(&b));
            let t = Vector::new(f64::from(x), f64::from(y), Precision::DOUBLE);
            let near = |reach: f64| {
                let pair = |i: usize| (0..b.len()).map(move |j| (i, j));
                let apart = |&(i, j): &(usize, usize)| distance(&a[i], &mirrored(&b[j], &t));
                (0..a.len()).flat_map(pair).filter(|pair| apart(pair) <= reach).collect::<Vec<_>>()
            };
            let mut found = Vec::new();
            first.visit_pairs(&second, &t, limit, |i, j| {
                found.push((i, j));
                limit
            });
            found.sort_unstable();
            prop_assert_eq!(&found, &near(limit));
            let mut queried = Vec::new();
            if let Some(query) = second.bounds() {
                first.visit(&query, |i| queried.push(i));
                queried.sort_unstable();
                prop_assert_eq!(queried, (0..a.len()).filter(|&i| meet(&a[i], &query)).collect::<Vec<_>>());
            }
            // The limit may shrink: the nearest pair is still found.
            let mut best = f64::INFINITY;
            first.visit_pairs(&second, &t, best, |i, j| {
                best = best.min(distance(&a[i], &mirrored(&b[j], &t)));
                best
            });
            prop_assert!(near(best).len() >= usize::from(best < f64::INFINITY) && near(best.next_down()).is_empty());
        }
    }
}
