//! Faces of a map that connectors have cut: boundary walks are joined by the trapezoids between them, as the sweep joins gaps.

use super::split::Refined;
use crate::arrangement::Arrangement;
use crate::arrangement::graph::{Graph, HalfEdge};

/// Numbers the faces anew, with the winding numbers of the old ones. The face far away stays number 0.
pub(super) fn settle(arrangement: &mut Arrangement, refined: &Refined) {
    if arrangement.graph.edges.is_empty() {
        return;
    }
    let mut cells = Cells::new(&arrangement.graph);
    for (trapezoid, [below, above]) in arrangement.trapezoids.iter().zip(&refined.borders) {
        let sides = [2 * below, 2 * above + 1];
        if sides.iter().all(|half| arrangement.graph.face(*half) == trapezoid.face) {
            cells.join_faces(sides[0], sides[1]);
        }
    }
    cells.join_far(arrangement, refined);
    cells.join_stray(&arrangement.graph, refined);
    cells.number(arrangement, refined);
}

/// A disjoint-set forest of half-edges by the face on their left; the last is for the face far away.
struct Cells {
    parent: Vec<u32>,
    /// Whether a root stands for a whole cell with its outer boundary, or for the face far away. No two of these are one,
    /// whatever trapezoids that are inverted by a rounding may say.
    whole: Vec<bool>,
}

impl Cells {
    /// The boundary walks.
    fn new(graph: &Graph) -> Self {
        let halves = 2 * graph.edges.len() as u32;
        let mut cells = Self { parent: (0..=halves).collect(), whole: vec![true; halves as usize + 1] };
        (0..halves).for_each(|half| cells.join(half, graph.next(half)));
        for half in outer(graph) {
            let root = cells.root(half);
            cells.whole[root as usize] = false;
        }
        cells
    }

    fn root(&mut self, mut half: HalfEdge) -> HalfEdge {
        while self.parent[half as usize] != half {
            let up = self.parent[half as usize];
            self.parent[half as usize] = self.parent[up as usize];
            half = self.parent[half as usize];
        }
        half
    }

    fn join(&mut self, f: HalfEdge, g: HalfEdge) {
        let (f, g) = (self.root(f), self.root(g));
        // The greatest leads: the face far away, if it is one of them.
        self.parent[f.min(g) as usize] = f.max(g);
    }

    /// Joins what cannot be two cells.
    fn join_faces(&mut self, f: HalfEdge, g: HalfEdge) {
        let (f, g) = (self.root(f), self.root(g));
        let [one, other] = [f, g].map(|root| self.whole[root as usize]);
        if f != g && !(one && other) {
            self.join(f, g);
            self.whole[f.max(g) as usize] = one || other;
        }
    }

    fn far(&self) -> HalfEdge {
        (self.parent.len() - 1) as HalfEdge
    }

    /// Joins to the face far away what no trapezoids cover: it is unbounded upwards or downwards there.
    fn join_far(&mut self, arrangement: &Arrangement, refined: &Refined) {
        let graph = &arrangement.graph;
        let mut spans = vec![Vec::new(); 2 * graph.edges.len()];
        for (trapezoid, [below, above]) in arrangement.trapezoids.iter().zip(&refined.borders) {
            for half in [2 * below, 2 * above + 1] {
                spans[half as usize].push((trapezoid.from, trapezoid.to));
            }
        }
        for (half, mut spans) in (0..).zip(spans) {
            if graph.face(half) != 0 {
                continue;
            }
            spans.sort_by(|s, t| s.0.total_cmp(&t.0));
            let edge = &graph.edges[(half / 2) as usize];
            let [from, to] = [edge.from, edge.to].map(|v| graph.points[v as usize].x);
            let covered = spans.iter().fold(from, |x, span| if span.0 == x { span.1 } else { x });
            if covered < to {
                self.join_faces(half, self.far());
            }
        }
    }

    /// Joins the walk around a connected part of the edges that no trapezoid joins to a cell, as that around a vertical alone,
    /// to the greatest part of its old face.
    fn join_stray(&mut self, graph: &Graph, refined: &Refined) {
        let mut met = vec![0_u32; self.parent.len()];
        for [below, above] in &refined.borders {
            for half in [2 * below, 2 * above + 1] {
                met[self.root(half) as usize] += 1;
            }
        }
        let far = self.far();
        met[self.root(far) as usize] = u32::MAX;
        let mut greatest: Vec<Option<HalfEdge>> = vec![None; graph.windings.len()];
        greatest[0] = Some(far);
        for half in 0..far {
            let root = self.root(half);
            let best = &mut greatest[graph.face(half) as usize];
            if self.whole[root as usize] && best.is_none_or(|best| met[best as usize] < met[root as usize]) {
                *best = Some(root);
            }
        }
        for half in outer(graph) {
            let root = self.root(half);
            if let Some(best) = greatest[graph.face(half) as usize] {
                self.join_faces(root, best);
            }
        }
    }

    fn number(&mut self, arrangement: &mut Arrangement, refined: &Refined) {
        let graph = &mut arrangement.graph;
        let mut number = vec![u32::MAX; self.parent.len()];
        let mut windings = vec![graph.windings[0]];
        let far = self.far();
        number[self.root(far) as usize] = 0;
        for half in 0..far {
            let root = self.root(half) as usize;
            if number[root] == u32::MAX {
                number[root] = windings.len() as u32;
                windings.push(graph.windings[graph.face(half) as usize]);
            }
        }
        // Where an inverted trapezoid is next to no edge of its face, any part of that face will do.
        let mut part = vec![0; graph.windings.len()];
        (0..far).for_each(|half| part[graph.face(half) as usize] = number[self.root(half) as usize]);
        for (trapezoid, [below, above]) in arrangement.trapezoids.iter_mut().zip(&refined.borders) {
            let side = [2 * below, 2 * above + 1].into_iter().find(|half| graph.face(*half) == trapezoid.face);
            trapezoid.face = side.map_or(part[trapezoid.face as usize], |half| number[self.root(half) as usize]);
        }
        for (e, edge) in (0..).zip(&mut graph.edges) {
            edge.above = number[self.root(2 * e) as usize];
            edge.below = number[self.root(2 * e + 1) as usize];
        }
        graph.windings = windings;
    }
}

/// A half-edge of the walk around each connected part of the edges: the last one at its first vertex, which has its left side
/// to the left of all edges.
fn outer(graph: &Graph) -> Vec<HalfEdge> {
    let mut parent: Vec<u32> = (0..graph.points.len() as u32).collect();
    let root = |parent: &mut Vec<u32>, mut v: u32| {
        while parent[v as usize] != v {
            parent[v as usize] = parent[parent[v as usize] as usize];
            v = parent[v as usize];
        }
        v
    };
    for edge in &graph.edges {
        let (u, v) = (root(&mut parent, edge.from), root(&mut parent, edge.to));
        parent[u.max(v) as usize] = u.min(v);
    }
    let first = (0..parent.len() as u32).filter(|v| parent[*v as usize] == *v);
    first.filter_map(|v| graph.around(v).last().copied()).collect()
}
