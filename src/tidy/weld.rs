//! Vertices joined: each goes to the first one within the tolerance, and edges between equal vertices are dropped.

use super::edge::{Edge, Net};
use glam::DVec2;
use std::collections::HashMap;

/// The net with no two vertices closer than the tolerance.
pub(super) fn weld(net: &Net, tolerance: f64) -> Net {
    let mut cells = Cells { tolerance, points: Vec::new(), by_cell: HashMap::new() };
    let joined: Vec<u32> = net.points.iter().map(|p| cells.vertex(*p)).collect();
    let edge = |e: &Edge| Edge { tail: joined[e.tail as usize], head: joined[e.head as usize], ..*e };
    let edges = |edges: &Vec<Edge>| edges.iter().map(edge).filter(|e| e.tail != e.head).collect();
    Net { loops: net.loops.iter().map(edges).collect(), points: cells.points }
}

/// The vertices that stay, in square cells as wide as the tolerance.
struct Cells {
    tolerance: f64,
    points: Vec<DVec2>,
    by_cell: HashMap<(i64, i64), Vec<u32>>,
}

impl Cells {
    /// The vertex within the tolerance of p, else p itself as a new one.
    fn vertex(&mut self, p: DVec2) -> u32 {
        let cell = ((p.x / self.tolerance).floor() as i64, (p.y / self.tolerance).floor() as i64);
        let around = (-1..=1).flat_map(|i| (-1..=1).map(move |j| (cell.0.saturating_add(i), cell.1.saturating_add(j))));
        let mut known = around.filter_map(|c| self.by_cell.get(&c)).flatten();
        if let Some(&vertex) = known.find(|v| self.points[**v as usize].distance(p) <= self.tolerance) {
            return vertex;
        }
        let vertex = self.points.len() as u32;
        self.points.push(p);
        self.by_cell.entry(cell).or_default().push(vertex);
        vertex
    }
}
