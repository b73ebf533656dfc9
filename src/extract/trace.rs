//! Loops of boundary half-edges, simple as far as the coordinates of their vertices go.

use crate::arrangement::graph::{Graph, HalfEdge};
use glam::DVec2;
use rustc_hash::FxHashMap as HashMap;

/// A simple loop of half-edges with the selection on their left, without those of length zero.
pub struct Traced {
    /// The connected part of the selection that the loop bounds.
    pub component: u32,
    /// The half-edges, end to end.
    pub halves: Vec<HalfEdge>,
}

/// The points that the boundary passes through more than once.
pub struct Pinches {
    passes: HashMap<(u64, u64), u32>,
}

impl Pinches {
    /// Those of all loops together.
    pub fn new(graph: &Graph, loops: &[Traced]) -> Self {
        let mut passes = HashMap::default();
        for &half in loops.iter().flat_map(|traced| &traced.halves) {
            *passes.entry(key(graph.points[graph.origin(half) as usize])).or_insert(0) += 1;
        }
        Self { passes }
    }

    /// Whether the point is one of them.
    pub fn contains(&self, point: DVec2) -> bool {
        self.passes.get(&key(point)).is_some_and(|passes| *passes > 1)
    }
}

/// What tells points apart: no perturbation is smaller than their last bit.
fn key(p: DVec2) -> (u64, u64) {
    (p.x.to_bits(), p.y.to_bits())
}

/// All boundary loops of the selected faces.
pub fn loops(graph: &Graph, selected: impl Fn([i32; 2]) -> bool) -> Vec<Traced> {
    let is_in: Vec<bool> = graph.windings.iter().map(|w| selected(*w)).collect();
    let inside = |half: HalfEdge| is_in[graph.face(half) as usize];
    let on_boundary = |half: HalfEdge| inside(half) && !inside(half ^ 1);
    let mut components = Components::new(graph, &is_in);
    let mut seen = vec![false; 2 * graph.edges.len()];
    let mut out = Vec::new();
    for start in 0..2 * graph.edges.len() as u32 {
        if seen[start as usize] || !on_boundary(start) {
            continue;
        }
        let component = components.root(graph.face(start));
        let mut walk = Vec::new();
        let mut half = start;
        while !std::mem::replace(&mut seen[half as usize], true) {
            walk.push(half);
            // Clockwise from where we came lies the inside; the next boundary edge ends this sector of it.
            let Some(next) = next_where(graph, half, on_boundary) else { break };
            half = next;
        }
        split(graph, walk, |halves| out.push(Traced { component, halves }));
    }
    out
}

/// The next of some half-edges that leaves the vertex where another arrives, clockwise. A consistent map always has one.
fn next_where(graph: &Graph, half: HalfEdge, on_boundary: impl Fn(HalfEdge) -> bool) -> Option<HalfEdge> {
    let mut next = graph.next(half);
    while !on_boundary(next) {
        if next == half ^ 1 {
            return None;
        }
        next = graph.clockwise(next);
    }
    Some(next)
}

/// Cuts a walk where it comes back to a point, and hands out the simple loops.
fn split(graph: &Graph, walk: Vec<HalfEdge>, mut emit: impl FnMut(Vec<HalfEdge>)) {
    let origin = |half: HalfEdge| graph.points[graph.origin(half) as usize];
    let mut stack: Vec<HalfEdge> = Vec::new();
    let mut depth_of: HashMap<(u64, u64), usize> = HashMap::default();
    for half in walk {
        let from = origin(half);
        if from == origin(half ^ 1) {
            continue;
        }
        if let Some(&depth) = depth_of.get(&key(from)) {
            let closed = stack.split_off(depth);
            for &h in &closed {
                depth_of.remove(&key(origin(h)));
            }
            emit(closed);
        }
        depth_of.insert(key(from), stack.len());
        stack.push(half);
    }
    if !stack.is_empty() {
        emit(stack);
    }
}

/// Selected faces joined across edges that bound nothing.
struct Components {
    parent: Vec<u32>,
}

impl Components {
    fn new(graph: &Graph, is_in: &[bool]) -> Self {
        let mut components = Self { parent: (0..is_in.len() as u32).collect() };
        for edge in &graph.edges {
            if is_in[edge.below as usize] && is_in[edge.above as usize] {
                let (f, g) = (components.root(edge.below), components.root(edge.above));
                components.parent[f.max(g) as usize] = f.min(g);
            }
        }
        components
    }

    fn root(&mut self, mut face: u32) -> u32 {
        while self.parent[face as usize] != face {
            let up = self.parent[face as usize];
            self.parent[face as usize] = self.parent[up as usize];
            face = up;
        }
        face
    }
}
