//! Edges that run there and back cancel; what is left falls into loops that pass each vertex once. Winding numbers stay,
//! but between two edges that cancel.

use super::edge::{Edge, Net};
use std::collections::HashMap;

/// The net without pairs of opposite edges closer than the tolerance, in loops that pass each vertex once.
pub(super) fn cancel(net: Net, tolerance: f64) -> Net {
    let mut ring = Ring::new(&net);
    let mut waiting: HashMap<(u32, u32), Vec<usize>> = HashMap::new();
    for e in 0..ring.edges.len() {
        let edge = ring.edges[e];
        let opposite = waiting.entry((edge.head, edge.tail)).or_default();
        let length = net.points[edge.tail as usize].distance(net.points[edge.head as usize]);
        let sagitta = |delta: f64| 0.5 * length * libm::tan(0.5 * delta);
        let fits = |f: &usize| (sagitta(edge.delta) + sagitta(ring.edges[*f].delta)).abs() <= tolerance;
        match opposite.iter().position(fits) {
            Some(at) => {
                let f = opposite.swap_remove(at);
                ring.cancel(e, f);
            }
            None => waiting.entry((edge.tail, edge.head)).or_default().push(e),
        }
    }
    Net { loops: ring.walks().into_iter().flat_map(simple).collect(), points: net.points }
}

/// Edges linked to closed walks.
struct Ring {
    edges: Vec<Edge>,
    next: Vec<usize>,
    before: Vec<usize>,
    alive: Vec<bool>,
}

impl Ring {
    fn new(net: &Net) -> Self {
        let n = net.loops.iter().map(Vec::len).sum();
        let mut ring = Self { edges: Vec::new(), next: vec![0; n], before: vec![0; n], alive: vec![true; n] };
        for edges in &net.loops {
            let first = ring.edges.len();
            for i in 0..edges.len() {
                ring.link(first + i, first + (i + 1) % edges.len());
            }
            ring.edges.extend(edges);
        }
        ring
    }

    fn link(&mut self, e: usize, f: usize) {
        self.next[e] = f;
        self.before[f] = e;
    }

    /// Takes out two opposite edges: what led to either goes on after the other.
    fn cancel(&mut self, e: usize, f: usize) {
        let (to_e, to_f, after_e, after_f) = (self.before[e], self.before[f], self.next[e], self.next[f]);
        if after_f != e {
            self.link(to_e, after_f);
        }
        if after_e != f {
            self.link(to_f, after_e);
        }
        (self.alive[e], self.alive[f]) = (false, false);
    }

    /// The closed walks.
    fn walks(mut self) -> Vec<Vec<Edge>> {
        let mut walks = Vec::new();
        for start in 0..self.edges.len() {
            let (mut walk, mut e) = (Vec::new(), start);
            while std::mem::replace(&mut self.alive[e], false) {
                walk.push(self.edges[e]);
                e = self.next[e];
            }
            walks.push(walk);
        }
        walks
    }
}

/// The loops that a closed walk is made of.
fn simple(walk: Vec<Edge>) -> Vec<Vec<Edge>> {
    let (mut loops, mut open, mut passed) = (Vec::new(), Vec::<Edge>::new(), HashMap::new());
    for edge in walk {
        if let Some(&at) = passed.get(&edge.tail) {
            let closed = open.split_off(at);
            closed.iter().for_each(|e| _ = passed.remove(&e.tail));
            loops.push(closed);
        }
        passed.insert(edge.tail, open.len());
        open.push(edge);
    }
    loops.push(open);
    loops.retain(|edges| !edges.is_empty());
    loops
}
