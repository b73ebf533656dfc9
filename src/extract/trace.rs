//! Loops of boundary half-edges, simple as far as the coordinates of their vertices go.

use super::places::Places;
use crate::arrangement::graph::{Edge, Graph, HalfEdge};

/// Simple loops of half-edges with the selection on their left, without those of length zero.
#[derive(Default)]
pub struct Loops {
    /// The half-edges, end to end, loop by loop.
    halves: Vec<HalfEdge>,
    /// Of each loop, the connected part of the selection that it bounds, and where its half-edges end.
    ends: Vec<(u32, usize)>,
}

impl Loops {
    /// The connected part of the selection that each loop bounds, and its half-edges.
    pub fn iter(&self) -> impl Iterator<Item = (u32, &[HalfEdge])> {
        let start = |i: usize| if i == 0 { 0 } else { self.ends[i - 1].1 };
        self.ends.iter().enumerate().map(move |(i, (component, end))| (*component, &self.halves[start(i)..*end]))
    }
}

/// The places that the boundary passes through more than once.
pub struct Pinches {
    passes: Vec<u8>,
}

impl Pinches {
    /// Those of all loops together.
    pub fn new(graph: &Graph, places: &Places, loops: &Loops) -> Self {
        let mut passes = vec![0_u8; places.count()];
        for &half in &loops.halves {
            let passes = &mut passes[places.of(graph.origin(half)) as usize];
            *passes = passes.saturating_add(1);
        }
        Self { passes }
    }

    /// Whether the place is one of them.
    pub fn contains(&self, place: u32) -> bool {
        self.passes[place as usize] > 1
    }
}

/// All boundary loops of the selected faces.
pub fn loops(graph: &Graph, places: &Places, selected: impl Fn([i32; 2]) -> bool) -> Loops {
    let is_in: Vec<bool> = graph.windings.iter().map(|w| selected(*w)).collect();
    let sides = |edge: &Edge| [edge.above, edge.below].map(|face| is_in[face as usize]);
    let is_boundary: Vec<bool> = graph
        .edges
        .iter()
        .flat_map(|edge| {
            let [above, below] = sides(edge);
            [above && !below, below && !above]
        })
        .collect();
    let on_boundary = |half: HalfEdge| is_boundary[half as usize];
    let mut components = Components::new(graph, &is_in);
    let mut seen = vec![false; 2 * graph.edges.len()];
    let mut splitter = Splitter::new(graph, places);
    for start in 0..2 * graph.edges.len() as u32 {
        if seen[start as usize] || !on_boundary(start) {
            continue;
        }
        let component = components.root(graph.face(start));
        let mut half = start;
        while !std::mem::replace(&mut seen[half as usize], true) {
            splitter.push(half, component);
            // Clockwise from where we came lies the inside; the next boundary edge ends this sector of it.
            let Some(next) = next_where(graph, half, on_boundary) else { break };
            half = next;
        }
        splitter.close(0, component);
    }
    splitter.loops
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

/// The depth of a place that a walk does not pass.
const NOWHERE: u32 = u32::MAX;

/// Cuts walks where they come back to a place.
struct Splitter<'a> {
    graph: &'a Graph,
    places: &'a Places,
    /// What is left of the walk under way, and the place where each half-edge leaves.
    walk: Vec<(HalfEdge, u32)>,
    /// Where the walk passes each place.
    depth_of: Vec<u32>,
    loops: Loops,
}

impl<'a> Splitter<'a> {
    fn new(graph: &'a Graph, places: &'a Places) -> Self {
        let depth_of = vec![NOWHERE; places.count()];
        Self { graph, places, walk: Vec::new(), depth_of, loops: Loops::default() }
    }

    /// Goes on along a half-edge, unless it has no length.
    fn push(&mut self, half: HalfEdge, component: u32) {
        let [from, to] = [half, half ^ 1].map(|half| self.places.of(self.graph.origin(half)));
        if from == to {
            return;
        }
        let depth = self.depth_of[from as usize];
        if depth != NOWHERE {
            self.close(depth as usize, component);
        }
        self.depth_of[from as usize] = self.walk.len() as u32;
        self.walk.push((half, from));
    }

    /// Makes a loop of the walk from this depth on.
    fn close(&mut self, depth: usize, component: u32) {
        if depth == self.walk.len() {
            return;
        }
        for (half, place) in self.walk.drain(depth..) {
            self.depth_of[place as usize] = NOWHERE;
            self.loops.halves.push(half);
        }
        self.loops.ends.push((component, self.loops.halves.len()));
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
