//! Necks: verticals no higher than the threshold from a vertex through a free cell to the edge directly above or below it.
//! They are found at the ends of trapezoids, which is where vertices are.

use crate::arrangement::Arrangement;
use crate::arrangement::graph::{Graph, HalfEdge};
use crate::arrangement::trapezoid::Trapezoid;
use std::collections::HashSet;

/// The edges of each curve from left to right.
pub(super) struct Places {
    by_curve: Vec<Vec<u32>>,
}

impl Places {
    pub(super) fn new(arrangement: &Arrangement) -> Self {
        let graph = &arrangement.graph;
        let mut by_curve = vec![Vec::new(); graph.curves.len()];
        // Edges are opened from left to right.
        for (index, edge) in graph.edges.iter().enumerate() {
            by_curve[edge.curve as usize].push(index as u32);
        }
        Self { by_curve }
    }

    /// The edges below and above a trapezoid. Nothing happens on them between its ends.
    pub(super) fn edges(&self, graph: &Graph, trapezoid: &Trapezoid) -> [u32; 2] {
        [trapezoid.bottom, trapezoid.top].map(|curve| {
            let edges = &self.by_curve[curve as usize];
            let left = |e: &u32| graph.points[graph.edges[*e as usize].from as usize].x <= trapezoid.from;
            edges[edges.partition_point(left).saturating_sub(1)]
        })
    }
}

/// An end of a neck.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum End {
    /// In the corner of the cell at a vertex, on the left of this half-edge that leaves it.
    Corner(HalfEdge),
    /// Inside an edge.
    Edge(u32),
}

/// A vertical through a free cell, at least one end of which is at a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Neck {
    pub(super) x: f64,
    /// The ends from bottom to top.
    pub(super) ends: [End; 2],
    /// The face it runs through.
    pub(super) face: u32,
}

/// The necks of free cells, each once.
pub(super) fn necks(arrangement: &Arrangement, places: &Places, threshold: f64) -> Vec<Neck> {
    let graph = &arrangement.graph;
    let (mut necks, mut known) = (Vec::new(), HashSet::new());
    for trapezoid in arrangement.trapezoids.iter().filter(|t| graph.windings[t.face as usize][0] == 0) {
        let [below, above] = places.edges(graph, trapezoid);
        // Both sides of the cell as they run: to the right below, to the left above.
        let wall = |x| Wall { graph, x, sides: [2 * below, 2 * above + 1] };
        for ends in [wall(trapezoid.from).left(), wall(trapezoid.to).right()] {
            let Some((x, ends)) = ends else { continue };
            let [low, high] = ends.map(|end| height(graph, end, x));
            let corner = ends.iter().any(|end| matches!(end, End::Corner(_)));
            if corner && (0.0..=threshold).contains(&(high - low)) && known.insert(ends) {
                necks.push(Neck { x, ends, face: trapezoid.face });
            }
        }
    }
    necks
}

/// The vertical line at an end of a trapezoid. Edges without width along it are part of the boundary there.
struct Wall<'g> {
    graph: &'g Graph,
    x: f64,
    sides: [HalfEdge; 2],
}

impl Wall<'_> {
    /// What is open of the right end, from bottom to top.
    fn right(&self) -> Option<(f64, [End; 2])> {
        let [below, above] = self.sides;
        self.open([self.after(below, true), self.before(above, false)])
    }

    /// What is open of the left end.
    fn left(&self) -> Option<(f64, [End; 2])> {
        let [below, above] = self.sides;
        self.open([self.before(below, true), self.after(above, false)])
    }

    fn open(&self, ends: [End; 2]) -> Option<(f64, [End; 2])> {
        (ends[0] != ends[1]).then_some((self.x, ends))
    }

    /// The corner where a side ends at the wall, or further along edges on the wall.
    fn after(&self, side: HalfEdge, upwards: bool) -> End {
        if self.at(self.graph.target(side)).is_none() {
            return End::Edge(side / 2);
        }
        let mut out = self.graph.next(side);
        while self.goes_on(self.graph.origin(out), self.graph.target(out), upwards) {
            out = self.graph.next(out);
        }
        End::Corner(out)
    }

    /// The corner where a side begins at the wall, or further back along edges on the wall.
    fn before(&self, side: HalfEdge, upwards: bool) -> End {
        if self.at(self.graph.origin(side)).is_none() {
            return End::Edge(side / 2);
        }
        let mut out = side;
        while let previous = self.graph.previous(out)
            && self.goes_on(self.graph.target(previous), self.graph.origin(previous), upwards)
        {
            out = previous;
        }
        End::Corner(out)
    }

    /// The ordinate of a vertex on the wall.
    fn at(&self, vertex: u32) -> Option<f64> {
        let p = self.graph.points[vertex as usize];
        (p.x == self.x).then_some(p.y)
    }

    /// Whether an edge runs along the wall, into the gap.
    fn goes_on(&self, from: u32, to: u32, upwards: bool) -> bool {
        let ends = self.at(from).zip(self.at(to));
        ends.is_some_and(|(from, to)| if upwards { from < to } else { to < from })
    }
}

fn height(graph: &Graph, end: End, x: f64) -> f64 {
    match end {
        End::Corner(half) => graph.points[graph.origin(half) as usize].y,
        End::Edge(e) => graph.curves[graph.edges[e as usize].curve as usize].y_at(x),
    }
}
