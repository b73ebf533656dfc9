//! Vertices of the input in the order of the sweep, and the curves that start and end there.
//!
//! Vertices whose coordinates are equal bit by bit become one: no perturbation is smaller. A zero-length piece disappears
//! with it.

use super::curve::{Curve, compare};
use crate::piece::Pieces;
use glam::DVec2;

const NONE: u32 = u32::MAX;

/// Vertices and incidences. The lists grow when the sweep cuts a curve at a vertex.
#[derive(Clone, Debug)]
pub struct Vertices {
    /// Distinct points in lexicographic order.
    pub points: Vec<DVec2>,
    lists: [Lists; 2],
}

/// Linked lists of curves, one a vertex.
#[derive(Clone, Debug, Default)]
struct Lists {
    head: Vec<u32>,
    next: Vec<u32>,
}

impl Lists {
    fn push(&mut self, vertex: u32, curve: u32) {
        let index = curve as usize;
        if self.next.len() <= index {
            self.next.resize(index + 1, NONE);
        }
        self.next[index] = self.head[vertex as usize];
        self.head[vertex as usize] = curve;
    }

    fn collect(&self, vertex: u32, out: &mut Vec<u32>) {
        let mut at = self.head[vertex as usize];
        while at != NONE {
            out.push(at);
            at = self.next[at as usize];
        }
    }
}

/// Coordinates so small that their squares would underflow become 0; -0, which the total order would tell apart, becomes 0.
fn flushed(x: f64) -> f64 {
    if x.abs() < 1e-150 { 0.0 } else { x }
}

impl Vertices {
    /// Sorts and merges the points of a set of pieces and makes their curves.
    #[must_use]
    pub fn new(pieces: &Pieces) -> (Self, Vec<Curve>) {
        let clean: Vec<DVec2> = pieces.points.iter().map(|p| DVec2::new(flushed(p.x), flushed(p.y))).collect();
        let mut is_end = vec![false; clean.len()];
        pieces.pieces.iter().flat_map(|piece| [piece.tail, piece.head]).for_each(|v| is_end[v as usize] = true);
        let ends = (0..clean.len() as u32).filter(|v| is_end[*v as usize]);
        let mut order: Vec<(DVec2, u32)> = ends.map(|v| (clean[v as usize], v)).collect();
        order.sort_unstable_by(|(p, _), (q, _)| compare(*p, *q));
        let mut points: Vec<DVec2> = Vec::with_capacity(order.len());
        let mut vertex_of = vec![NONE; clean.len()];
        for (p, i) in order {
            if points.last() != Some(&p) {
                points.push(p);
            }
            vertex_of[i as usize] = (points.len() - 1) as u32;
        }
        let lists = Lists { head: vec![NONE; points.len()], next: Vec::with_capacity(pieces.pieces.len()) };
        let mut vertices = Self { points, lists: [lists.clone(), lists] };
        let mut curves = Vec::with_capacity(pieces.pieces.len());
        for (index, piece) in pieces.pieces.iter().enumerate() {
            let end = |i: u32| (vertex_of[i as usize], clean[i as usize]);
            let whole = piece.whole.map(|i| clean[i as usize]);
            if let Some(curve) = Curve::new(index as u32, piece, end(piece.tail), end(piece.head), whole) {
                vertices.register(curves.len() as u32, &curve);
                curves.push(curve);
            }
        }
        (vertices, curves)
    }

    /// Notes where a curve starts and ends.
    pub fn register(&mut self, index: u32, curve: &Curve) {
        self.register_start(index, curve);
        self.register_end(index, curve);
    }

    /// Notes where a curve starts.
    pub fn register_start(&mut self, index: u32, curve: &Curve) {
        self.lists[0].push(curve.first, index);
    }

    /// Notes where a curve ends.
    pub fn register_end(&mut self, index: u32, curve: &Curve) {
        self.lists[1].push(curve.last, index);
    }

    /// The curves that start at a vertex.
    pub fn starting(&self, vertex: u32, out: &mut Vec<u32>) {
        out.clear();
        self.lists[0].collect(vertex, out);
    }

    /// The curves that end at a vertex, those that have been cut before it included.
    pub fn ending(&self, vertex: u32, out: &mut Vec<u32>) {
        out.clear();
        self.lists[1].collect(vertex, out);
    }
}
