//! The status of the sweep: the active curves from bottom to top.
//!
//! A treap keeps the order for searching, a linked list for neighbours. No comparison is stored in it, so curves may be
//! exchanged between neighbouring places without touching the tree; a curve finds its place in constant time.

use std::cmp::Ordering;

/// A place in the status.
pub type Place = u32;

/// No place.
pub const NOWHERE: Place = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct Node {
    parent: Place,
    child: [Place; 2],
    near: [Place; 2],
    priority: u32,
    curve: u32,
}

/// The ordered set of active curves.
#[derive(Clone, Debug)]
pub struct Status {
    nodes: Vec<Node>,
    free: Vec<Place>,
    place_of: Vec<Place>,
    root: Place,
    ends: [Place; 2],
    seed: u32,
    size: usize,
}

/// Downwards, an index of children, neighbours and ends.
pub const DOWN: usize = 0;
/// Upwards.
pub const UP: usize = 1;

impl Status {
    /// An empty status.
    #[must_use]
    pub fn new() -> Self {
        Self {
            nodes: Vec::new(),
            free: Vec::new(),
            place_of: Vec::new(),
            root: NOWHERE,
            ends: [NOWHERE; 2],
            seed: 0x9e37_79b9,
            size: 0,
        }
    }

    /// The number of active curves.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// The curve at a place.
    #[must_use]
    pub fn curve(&self, place: Place) -> u32 {
        self.nodes[place as usize].curve
    }

    /// The place of a curve, `NOWHERE` if it is not active.
    #[must_use]
    pub fn place(&self, curve: u32) -> Place {
        self.place_of.get(curve as usize).copied().unwrap_or(NOWHERE)
    }

    /// The next place in a direction.
    #[must_use]
    pub fn near(&self, place: Place, side: usize) -> Place {
        self.nodes[place as usize].near[side]
    }

    /// The lowest or highest place.
    #[must_use]
    pub fn extreme(&self, side: usize) -> Place {
        self.ends[side]
    }

    /// Looks for a point, given where it lies relative to a curve. Returns the places next below and above it, and the
    /// place it hits, if any.
    pub fn search(&self, mut compare: impl FnMut(u32) -> Ordering) -> ([Place; 2], Option<Place>) {
        let mut around = [NOWHERE; 2];
        let mut at = self.root;
        while at != NOWHERE {
            let node = &self.nodes[at as usize];
            match compare(node.curve) {
                Ordering::Greater => {
                    around[DOWN] = at;
                    at = node.child[UP];
                }
                Ordering::Less => {
                    around[UP] = at;
                    at = node.child[DOWN];
                }
                Ordering::Equal => return (node.near, Some(at)),
            }
        }
        (around, None)
    }

    /// The order of two places from bottom to top: by the sides on which their ways to the root come together.
    #[must_use]
    pub fn compare(&self, p: Place, q: Place) -> Ordering {
        let (mut places, mut depths) = ([p, q], [self.depth(p), self.depth(q)]);
        let mut from = [None; 2];
        while places[0] != places[1] {
            let deeper = usize::from(depths[0] < depths[1]);
            from[deeper] = Some(places[deeper]);
            places[deeper] = self.nodes[places[deeper] as usize].parent;
            depths[deeper] -= 1;
        }
        let side = |child: Option<Place>| match child {
            None => 0,
            Some(child) if self.nodes[places[0] as usize].child[UP] == child => 1,
            Some(_) => -1,
        };
        side(from[0]).cmp(&side(from[1]))
    }

    /// How far a place is from the root.
    fn depth(&self, place: Place) -> usize {
        let (mut depth, mut at) = (0, place);
        while let parent = self.nodes[at as usize].parent
            && parent != NOWHERE
        {
            (depth, at) = (depth + 1, parent);
        }
        depth
    }

    /// Puts a curve directly above a place, or lowest of all above `NOWHERE`.
    pub fn insert_above(&mut self, below: Place, curve: u32) -> Place {
        let above = if below == NOWHERE { self.ends[DOWN] } else { self.near(below, UP) };
        let place = self.allocate(curve);
        self.nodes[place as usize].near = [below, above];
        self.link(below, UP, place);
        self.link(above, DOWN, place);
        self.attach(place, below, above);
        self.size += 1;
        place
    }

    /// Takes the curve at a place out.
    pub fn remove(&mut self, place: Place) {
        while let Some(side) = self.heavier_child(place) {
            let child = self.nodes[place as usize].child[side];
            self.rotate_up(child);
        }
        let [below, above] = self.nodes[place as usize].near;
        self.replace_child(self.nodes[place as usize].parent, place, NOWHERE);
        self.link(below, UP, above);
        self.link(above, DOWN, below);
        self.place_of[self.nodes[place as usize].curve as usize] = NOWHERE;
        self.free.push(place);
        self.size -= 1;
    }

    /// Puts another curve at a place; the one that was there is no longer active.
    pub fn replace(&mut self, place: Place, curve: u32) {
        let old = self.nodes[place as usize].curve;
        self.place_of[old as usize] = NOWHERE;
        self.settle(place, curve);
    }

    /// Exchanges the curves at two places.
    pub fn exchange(&mut self, p: Place, q: Place) {
        let (f, g) = (self.curve(p), self.curve(q));
        self.settle(p, g);
        self.settle(q, f);
    }

    fn settle(&mut self, place: Place, curve: u32) {
        let index = curve as usize;
        if self.place_of.len() <= index {
            self.place_of.resize(index + 1, NOWHERE);
        }
        self.place_of[index] = place;
        self.nodes[place as usize].curve = curve;
    }

    fn allocate(&mut self, curve: u32) -> Place {
        // xorshift: fixed, so that the same input always gives the same tree.
        self.seed ^= self.seed << 13;
        self.seed ^= self.seed >> 17;
        self.seed ^= self.seed << 5;
        let node =
            Node { parent: NOWHERE, child: [NOWHERE; 2], near: [NOWHERE; 2], priority: self.seed, curve: NOWHERE };
        let place = if let Some(place) = self.free.pop() {
            self.nodes[place as usize] = node;
            place
        } else {
            self.nodes.push(node);
            (self.nodes.len() - 1) as Place
        };
        self.settle(place, curve);
        place
    }

    fn link(&mut self, place: Place, side: usize, to: Place) {
        if place == NOWHERE {
            self.ends[1 - side] = to;
        } else {
            self.nodes[place as usize].near[side] = to;
        }
    }

    /// Hangs a new leaf between two neighbours: one of them has no child on that side.
    fn attach(&mut self, place: Place, below: Place, above: Place) {
        let (parent, side) = if below != NOWHERE && self.nodes[below as usize].child[UP] == NOWHERE {
            (below, UP)
        } else {
            (above, DOWN)
        };
        self.nodes[place as usize].parent = parent;
        if parent == NOWHERE {
            self.root = place;
            return;
        }
        self.nodes[parent as usize].child[side] = place;
        while let parent = self.nodes[place as usize].parent
            && parent != NOWHERE
            && self.nodes[parent as usize].priority < self.nodes[place as usize].priority
        {
            self.rotate_up(place);
        }
    }

    fn heavier_child(&self, place: Place) -> Option<usize> {
        let [down, up] = self.nodes[place as usize].child;
        match (down == NOWHERE, up == NOWHERE) {
            (true, true) => None,
            (true, false) => Some(UP),
            (false, true) => Some(DOWN),
            (false, false) => Some(usize::from(self.nodes[down as usize].priority < self.nodes[up as usize].priority)),
        }
    }

    fn rotate_up(&mut self, place: Place) {
        let parent = self.nodes[place as usize].parent;
        let side = usize::from(self.nodes[parent as usize].child[UP] == place);
        let inner = self.nodes[place as usize].child[1 - side];
        self.replace_child(self.nodes[parent as usize].parent, parent, place);
        self.nodes[parent as usize].child[side] = inner;
        if inner != NOWHERE {
            self.nodes[inner as usize].parent = parent;
        }
        self.nodes[place as usize].child[1 - side] = parent;
        self.nodes[parent as usize].parent = place;
    }

    fn replace_child(&mut self, parent: Place, old: Place, new: Place) {
        if parent == NOWHERE {
            self.root = new;
        } else {
            let side = usize::from(self.nodes[parent as usize].child[UP] == old);
            self.nodes[parent as usize].child[side] = new;
        }
        if new != NOWHERE {
            self.nodes[new as usize].parent = parent;
        }
    }
}

impl Default for Status {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(status: &Status) -> Vec<u32> {
        let mut out = Vec::new();
        let mut at = status.extreme(DOWN);
        while at != NOWHERE {
            out.push(status.curve(at));
            at = status.near(at, UP);
        }
        out
    }

    /// A vector with the same operations is the reference.
    #[test]
    fn behaves_like_a_vector() {
        let (mut status, mut model, mut seed) = (Status::new(), Vec::<u32>::new(), 1_u64);
        let mut random = |n: usize| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as usize % n
        };
        for curve in 0..4000 {
            let i = random(model.len() + 1);
            match random(3) {
                0 if i < model.len() => status.remove(status.place(model.remove(i))),
                1 if i + 1 < model.len() => {
                    status.exchange(status.place(model[i]), status.place(model[i + 1]));
                    model.swap(i, i + 1);
                }
                _ => {
                    let below = if i == 0 { NOWHERE } else { status.place(model[i - 1]) };
                    status.insert_above(below, curve);
                    model.insert(i, curve);
                }
            }
            assert_eq!(list(&status), model);
            if !model.is_empty() {
                let (i, j) = (random(model.len()), random(model.len()));
                assert_eq!(status.compare(status.place(model[i]), status.place(model[j])), i.cmp(&j));
            }
            assert_eq!(status.size(), model.len());
            let target = random(model.len() + 1);
            let (around, hit) = status.search(|c| {
                let j = model.iter().position(|m| *m == c).unwrap();
                (2 * target).cmp(&(2 * j + 1))
            });
            assert!(hit.is_none());
            let below = if target == 0 { NOWHERE } else { status.place(model[target - 1]) };
            let above = if target == model.len() { NOWHERE } else { status.place(model[target]) };
            assert_eq!(around, [below, above]);
        }
    }
}
