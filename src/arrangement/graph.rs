//! The arrangement as a planar map: vertices, edges, half-edges in rotation, faces (memo C3).

use super::curve::Curve;
use super::faces::Faces;
use glam::DVec2;

/// A part of a curve between two vertices. Edges run from left to right; their length may be 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// The curve, an index of [`Graph::curves`].
    pub curve: u32,
    /// Left vertex.
    pub from: u32,
    /// Right vertex.
    pub to: u32,
    /// Face below.
    pub below: u32,
    /// Face above.
    pub above: u32,
}

/// A directed edge: twice the edge, plus one when it runs from right to left.
pub type HalfEdge = u32;

/// The planar map. Built by the sweep, which visits vertices from left to right.
#[derive(Clone, Debug)]
pub struct Graph {
    /// Vertices in the order of the sweep. Different vertices may have equal coordinates.
    pub points: Vec<DVec2>,
    /// Edges.
    pub edges: Vec<Edge>,
    /// The curves, of which several may be parts of one piece.
    pub curves: Vec<Curve>,
    /// Winding numbers of the faces; face 0 is the one far away.
    pub windings: Vec<[i32; 2]>,
    /// Assertions on winding numbers that failed; 0 whenever the pieces were closed.
    pub winding_conflicts: usize,
    /// Half-edges that leave a vertex, counter-clockwise from the upper left.
    around: Vec<HalfEdge>,
    first_around: Vec<u32>,
    /// Place of each half-edge in `around`.
    slot: Vec<u32>,
}

/// What Euler's formula is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Euler {
    /// Vertices.
    pub vertices: usize,
    /// Edges.
    pub edges: usize,
    /// Faces as the sweep counted them.
    pub faces: usize,
    /// Connected components of the edges.
    pub components: usize,
    /// Closed walks along half-edges.
    pub walks: usize,
    /// Whether all half-edges of each walk have the same face on their left.
    pub walks_agree: bool,
}

impl Euler {
    /// V - E + F = 1 + C, and every face has one boundary walk more than it has holes.
    #[must_use]
    pub fn holds(&self) -> bool {
        let planar = self.vertices + self.faces == self.edges + 1 + self.components;
        let walks = self.walks + 1 == self.faces + self.components || self.edges == 0;
        planar && walks && self.walks_agree
    }
}

impl Graph {
    /// An empty map.
    #[must_use]
    pub(super) fn new() -> Self {
        Self::with_room_for(0)
    }

    /// An empty map with room for so many curves that hardly cross.
    #[must_use]
    pub(super) fn with_room_for(curves: usize) -> Self {
        Self {
            points: Vec::with_capacity(2 * curves),
            edges: Vec::with_capacity(2 * curves),
            curves: Vec::new(),
            windings: Vec::new(),
            winding_conflicts: 0,
            around: Vec::with_capacity(4 * curves),
            first_around: Vec::with_capacity(2 * curves + 1),
            slot: Vec::with_capacity(4 * curves),
        }
    }

    /// Starts the next vertex: its left edges are closed next, from top to bottom, then its right ones opened upwards.
    pub(super) fn begin_vertex(&mut self, point: DVec2) {
        self.points.push(point);
        self.first_around.push(self.around.len() as u32);
    }

    /// Ends an edge at the current vertex.
    pub(super) fn close(&mut self, edge: u32) {
        self.edges[edge as usize].to = (self.points.len() - 1) as u32;
        self.leave(2 * edge + 1);
    }

    /// Begins an edge at the current vertex.
    pub(super) fn open(&mut self, curve: u32, below: u32, above: u32) -> u32 {
        let edge = self.edges.len() as u32;
        let from = (self.points.len() - 1) as u32;
        self.edges.push(Edge { curve, from, to: u32::MAX, below, above });
        self.slot.extend([0; 2]);
        self.leave(2 * edge);
        edge
    }

    fn leave(&mut self, half: HalfEdge) {
        self.slot[half as usize] = self.around.len() as u32;
        self.around.push(half);
    }

    /// Settles the faces. Returns the final number of each face.
    pub(super) fn finish(&mut self, faces: Faces, curves: Vec<Curve>) -> Vec<u32> {
        let (number, windings, conflicts) = faces.finish();
        for edge in &mut self.edges {
            edge.below = number[edge.below as usize];
            edge.above = number[edge.above as usize];
        }
        self.windings = windings;
        self.winding_conflicts = conflicts;
        self.curves = curves;
        self.first_around.push(self.around.len() as u32);
        number
    }

    /// A map from its parts: the half-edges that leave each vertex counter-clockwise from the upper left, as edges run, and
    /// the winding numbers of the faces that the edges name.
    pub(crate) fn assemble(
        points: Vec<DVec2>,
        edges: Vec<Edge>,
        curves: Vec<Curve>,
        rotations: &[Vec<HalfEdge>],
        windings: Vec<[i32; 2]>,
        winding_conflicts: usize,
    ) -> Self {
        let slot = vec![0; 2 * edges.len()];
        let mut graph = Self { points, edges, curves, windings, winding_conflicts, slot, ..Self::new() };
        for rotation in rotations {
            graph.first_around.push(graph.around.len() as u32);
            rotation.iter().for_each(|half| graph.leave(*half));
        }
        graph.first_around.push(graph.around.len() as u32);
        graph
    }

    /// The vertex a half-edge leaves.
    #[must_use]
    pub fn origin(&self, half: HalfEdge) -> u32 {
        let edge = &self.edges[(half / 2) as usize];
        if half.is_multiple_of(2) { edge.from } else { edge.to }
    }

    /// The vertex a half-edge reaches.
    #[must_use]
    pub fn target(&self, half: HalfEdge) -> u32 {
        self.origin(half ^ 1)
    }

    /// The face on the left of a half-edge.
    #[must_use]
    pub fn face(&self, half: HalfEdge) -> u32 {
        let edge = &self.edges[(half / 2) as usize];
        if half.is_multiple_of(2) { edge.above } else { edge.below }
    }

    /// Half-edges that leave a vertex, counter-clockwise.
    #[must_use]
    pub fn around(&self, vertex: u32) -> &[HalfEdge] {
        let v = vertex as usize;
        &self.around[self.first_around[v] as usize..self.first_around[v + 1] as usize]
    }

    /// The next half-edge that leaves the same vertex, clockwise.
    #[must_use]
    pub fn clockwise(&self, half: HalfEdge) -> HalfEdge {
        let v = self.origin(half) as usize;
        let (first, end) = (self.first_around[v], self.first_around[v + 1]);
        let slot = self.slot[half as usize];
        self.around[(if slot == first { end } else { slot } - 1) as usize]
    }

    /// The next half-edge along the boundary of the face on the left.
    #[must_use]
    pub fn next(&self, half: HalfEdge) -> HalfEdge {
        self.clockwise(half ^ 1)
    }

    /// The half-edge before it along that boundary.
    #[must_use]
    pub fn previous(&self, half: HalfEdge) -> HalfEdge {
        let around = self.around(self.origin(half));
        let place = self.slot[half as usize] - self.first_around[self.origin(half) as usize];
        around[(place as usize + 1) % around.len()] ^ 1
    }

    /// Counts what Euler's formula needs, independently of how the sweep assigned faces.
    #[must_use]
    pub fn euler(&self) -> Euler {
        let (walks, walks_agree) = self.walks();
        Euler {
            vertices: self.points.len(),
            edges: self.edges.len(),
            faces: self.windings.len(),
            components: self.components(),
            walks,
            walks_agree,
        }
    }

    fn walks(&self) -> (usize, bool) {
        let mut seen = vec![false; 2 * self.edges.len()];
        let (mut walks, mut agree) = (0, true);
        for start in 0..seen.len() {
            if seen[start] {
                continue;
            }
            walks += 1;
            let mut half = start as HalfEdge;
            while !seen[half as usize] {
                seen[half as usize] = true;
                agree &= self.face(half) == self.face(start as HalfEdge);
                half = self.next(half);
            }
            agree &= half == start as HalfEdge;
        }
        (walks, agree)
    }

    fn components(&self) -> usize {
        let mut seen = vec![false; self.points.len()];
        let mut components = 0;
        let mut stack = Vec::new();
        for start in 0..seen.len() {
            if std::mem::replace(&mut seen[start], true) {
                continue;
            }
            components += 1;
            stack.push(start as u32);
            while let Some(v) = stack.pop() {
                for &half in self.around(v) {
                    let to = self.target(half);
                    if !std::mem::replace(&mut seen[to as usize], true) {
                        stack.push(to);
                    }
                }
            }
        }
        components
    }
}
