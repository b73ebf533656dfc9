//! A tree of bounding boxes over the parts of a boundary: reports the pairs whose boxes meet and the boxes that a
//! horizontal ray meets. Built by halving at the median of the boxes' centres, so it is of logarithmic depth.

use glam::DVec2;
use std::ops::Range;

/// The number of boxes up to which a node is not split.
const LEAF: usize = 8;

/// A closed axis-parallel box.
#[derive(Clone, Copy, Debug)]
pub struct Box2 {
    /// Least corner.
    pub min: DVec2,
    /// Greatest corner.
    pub max: DVec2,
}

impl Box2 {
    /// The box of two points, widened on all sides.
    pub fn of(p: DVec2, q: DVec2, margin: f64) -> Self {
        Self { min: p.min(q) - DVec2::splat(margin), max: p.max(q) + DVec2::splat(margin) }
    }

    fn centre(&self) -> DVec2 {
        (self.min + self.max) / 2.0
    }

    fn join(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    fn meets(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// Whether it meets the ray from a point to the left.
    fn meets_ray(&self, from: DVec2) -> bool {
        self.min.y <= from.y && from.y <= self.max.y && self.min.x <= from.x
    }
}

#[derive(Debug)]
struct Node {
    bounds: Box2,
    items: Range<usize>,
    /// The two halves; none in a leaf.
    children: Option<[usize; 2]>,
}

/// The tree.
#[derive(Debug)]
pub struct Tree {
    boxes: Vec<Box2>,
    order: Vec<usize>,
    nodes: Vec<Node>,
}

impl Tree {
    /// The tree of these boxes, known by their index.
    pub fn new(boxes: Vec<Box2>) -> Self {
        let mut tree = Self { order: (0..boxes.len()).collect(), boxes, nodes: Vec::new() };
        if !tree.boxes.is_empty() {
            tree.grow(0..tree.boxes.len());
        }
        tree
    }

    /// Adds the node of a nonempty range of the order, returns its index.
    fn grow(&mut self, items: Range<usize>) -> usize {
        let boxes = &self.boxes;
        let range = &mut self.order[items.clone()];
        let bounds = range.iter().map(|&i| boxes[i]).reduce(Box2::join).expect("the range is not empty");
        let index = self.nodes.len();
        self.nodes.push(Node { bounds, items: items.clone(), children: None });
        if items.len() > LEAF {
            // Along the side on which the centres spread most: long boxes side by side must not be split along themselves.
            let centres = range.iter().map(|&i| Box2::of(boxes[i].centre(), boxes[i].centre(), 0.0));
            let spread = centres.reduce(Box2::join).map_or(DVec2::ZERO, |b| b.max - b.min);
            let key = |i: usize| if spread.x > spread.y { boxes[i].centre().x } else { boxes[i].centre().y };
            range.select_nth_unstable_by(items.len() / 2, |&i, &j| key(i).total_cmp(&key(j)));
            let middle = items.start + items.len() / 2;
            self.nodes[index].children = Some([self.grow(items.start..middle), self.grow(middle..items.end)]);
        }
        index
    }

    /// Visits every pair of different boxes that meet, each once, until a visit fails.
    pub fn pairs<E>(&self, visit: &mut impl FnMut(usize, usize) -> Result<(), E>) -> Result<(), E> {
        for node in &self.nodes {
            if let Some([left, right]) = node.children {
                self.pairs_between(left, right, visit)?;
                continue;
            }
            let items = &self.order[node.items.clone()];
            for (k, &i) in items.iter().enumerate() {
                for &j in items[k + 1..].iter().filter(|&&j| self.boxes[i].meets(&self.boxes[j])) {
                    visit(i, j)?;
                }
            }
        }
        Ok(())
    }

    fn pairs_between<E>(
        &self,
        left: usize,
        right: usize,
        visit: &mut impl FnMut(usize, usize) -> Result<(), E>,
    ) -> Result<(), E> {
        let (a, b) = (&self.nodes[left], &self.nodes[right]);
        if !a.bounds.meets(&b.bounds) {
            return Ok(());
        }
        match (a.children, b.children) {
            (Some(halves), _) if a.items.len() >= b.items.len() || b.children.is_none() => {
                halves.iter().try_for_each(|&half| self.pairs_between(half, right, visit))
            }
            (_, Some(halves)) => halves.iter().try_for_each(|&half| self.pairs_between(left, half, visit)),
            _ => {
                for &i in &self.order[a.items.clone()] {
                    for &j in self.order[b.items.clone()].iter().filter(|&&j| self.boxes[i].meets(&self.boxes[j])) {
                        visit(i, j)?;
                    }
                }
                Ok(())
            }
        }
    }

    /// Visits every box that meets the ray from a point to the left.
    pub fn on_ray(&self, from: DVec2, visit: &mut impl FnMut(usize)) {
        let mut open = Vec::from_iter((!self.nodes.is_empty()).then_some(0));
        while let Some(index) = open.pop() {
            let node = &self.nodes[index];
            if !node.bounds.meets_ray(from) {
                continue;
            }
            match node.children {
                Some(halves) => open.extend(halves),
                None => {
                    let items = &self.order[node.items.clone()];
                    items.iter().filter(|&&i| self.boxes[i].meets_ray(from)).for_each(|&i| visit(i));
                }
            }
        }
    }
}
