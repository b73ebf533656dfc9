//! Points on the edges of an arrangement: the corners of its trapezoids, and places of edges (memo C3, F).
//!
//! The abscissa of a vertex is rounded. On an edge that rises by much within one rounding of x, the ordinate of the curve
//! at that abscissa may lie far beyond the vertex, outside of the edge and of the cells next to it. So every point is moved
//! into the box of the ends of its edge.

use arcsum::arrangement::Arrangement;
use arcsum::arrangement::graph::Edge;
use arcsum::arrangement::trapezoid::Trapezoid;
use glam::DVec2;

/// The edges of an arrangement by their curves.
pub struct Corners<'a> {
    arrangement: &'a Arrangement,
    edges: Vec<Vec<Edge>>,
}

impl<'a> Corners<'a> {
    /// Those of an arrangement.
    #[must_use]
    pub fn new(arrangement: &'a Arrangement) -> Self {
        let mut edges = vec![Vec::new(); arrangement.graph.curves.len()];
        for edge in &arrangement.graph.edges {
            edges[edge.curve as usize].push(*edge);
        }
        Self { arrangement, edges }
    }

    /// The corners of a trapezoid, in units of the arrangement: lower and upper left, lower and upper right.
    pub fn of(&self, trapezoid: &Trapezoid) -> impl Iterator<Item = DVec2> {
        let Trapezoid { face, from, to, bottom, top } = *trapezoid;
        let x = |vertex: u32| self.arrangement.graph.points[vertex as usize].x;
        let covers = move |edge: &&Edge| x(edge.from) <= from && to <= x(edge.to);
        let below = self.edges[bottom as usize].iter().filter(covers).find(|edge| edge.above == face);
        let above = self.edges[top as usize].iter().filter(covers).find(|edge| edge.below == face);
        let sides = [from, to].map(|x| [below, above].map(|edge| edge.map(|edge| self.at(edge, x))));
        sides.into_iter().flatten().flatten()
    }

    /// The point of an edge at an abscissa between its ends.
    #[must_use]
    pub fn at(&self, edge: &Edge, x: f64) -> DVec2 {
        let graph = &self.arrangement.graph;
        let [p, q] = [edge.from, edge.to].map(|vertex| graph.points[vertex as usize].y);
        DVec2::new(x, graph.curves[edge.curve as usize].y_at(x).clamp(p.min(q), p.max(q)))
    }
}
