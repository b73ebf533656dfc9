//! Necks: verticals no higher than the threshold from a vertex through a free cell to the edge directly above or below it.
//! They are found at the ends of trapezoids, which is where vertices are.

use crate::arrangement::Arrangement;
use crate::arrangement::graph::Graph;
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
    /// At a vertex.
    Vertex(u32),
    /// Inside an edge.
    Edge(u32),
}

/// A vertical through a free cell, at least one end of which is a vertex.
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
        let edges = places.edges(graph, trapezoid);
        for x in [trapezoid.from, trapezoid.to] {
            let ends = ends(graph, edges, x);
            let [low, high] = [0, 1].map(|side| height(graph, ends[side], x));
            let open = ends[0] != ends[1] && ends.iter().any(|end| matches!(end, End::Vertex(_)));
            if open && (0.0..=threshold).contains(&(high - low)) && known.insert(ends) {
                necks.push(Neck { x, ends, face: trapezoid.face });
            }
        }
    }
    necks
}

/// Where the vertical at the end of a trapezoid between two edges begins and ends.
fn ends(graph: &Graph, edges: [u32; 2], x: f64) -> [End; 2] {
    let end = |side: usize| {
        let edge = &graph.edges[edges[side] as usize];
        let here = [edge.from, edge.to].into_iter().find(|v| graph.points[*v as usize].x == x);
        here.map_or(End::Edge(edges[side]), |v| End::Vertex(passed(graph, v, side == 0)))
    };
    [end(0), end(1)]
}

/// The far end of the vertical edges that go on from a vertex, upwards or downwards: they are the wall there.
fn passed(graph: &Graph, mut vertex: u32, upwards: bool) -> u32 {
    loop {
        let around = graph.around(vertex);
        let lefts = around.iter().take_while(|half| **half % 2 == 1).count();
        let next = if upwards { around[lefts..].last() } else { around[..lefts].last() };
        match next.filter(|half| graph.curves[graph.edges[(**half / 2) as usize].curve as usize].is_vertical()) {
            Some(half) => vertex = graph.target(*half),
            None => return vertex,
        }
    }
}

fn height(graph: &Graph, end: End, x: f64) -> f64 {
    match end {
        End::Vertex(v) => graph.points[v as usize].y,
        End::Edge(e) => graph.curves[graph.edges[e as usize].curve as usize].y_at(x),
    }
}
