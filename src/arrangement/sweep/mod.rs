//! The approximate arrangement sweep (MS reference 5; memo C2).
//!
//! Events come in lexicographic order; time never runs backwards. Neighbours in the status always agree with the crossing
//! module: a pair that does not is swapped on the spot (a late swap). A vertex is handled as one block: the curves that end
//! there are gathered, taken out, and replaced by those that start there, sorted by direction. At a fixed event a pair is
//! swapped at most once, because after the swap it agrees with the module, whose answer for a pair at an event is fixed;
//! hence the sweep ends for any module, honest or not.
//!
//! Lines that pass exactly through a vertex are cut there, and coinciding lines are merged with their net weight, so that
//! integer input gives the exact map.

mod apart;
mod bundle;
mod event;
mod gap;
mod guise;
mod strangers;
mod swap;
mod trust;
mod vertex;

use super::audit::Audit;
use super::cross::CrossingModule;
use super::curve::Curve;
use super::faces::Faces;
use super::graph::Graph;
use super::moment::Moment;
use super::status::{Place, Status};
use super::trapezoid::Trapezoid;
use super::vertices::Vertices;
use crate::piece::Pieces;
use crate::robustness::Robustness;
use event::Event;
use glam::DVec2;
use guise::Guises;
use rustc_hash::FxHashSet as HashSet;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use vertex::Block;

/// The running sweep.
pub(super) struct Sweep<'m, M> {
    module: &'m M,
    robustness: Robustness,
    curves: Vec<Curve>,
    vertices: Vertices,
    status: Status,
    queue: BinaryHeap<Reverse<Event>>,
    /// Where the sweep is.
    now: DVec2,
    /// What rounding took from the abscissa of `now`.
    low: f64,
    /// Lines found to cross exactly at a vertex still to come.
    joined: Vec<u32>,
    /// Open edge of each active curve.
    edge_of: Vec<u32>,
    /// The curve of each piece that is, or was last, on its way.
    curve_of: Vec<u32>,
    /// What merged curves stand for.
    guises: Guises,
    /// Face above each place.
    gap: Vec<u32>,
    /// Where the trapezoid above each place began.
    since: Vec<f64>,
    /// Curves ending at the vertex under way.
    is_ending: Vec<bool>,
    /// Places whose neighbours above may be in the wrong order.
    work: Vec<Place>,
    block: Block,
    /// Places of curves that something may be known about, while they are looked at.
    related: Vec<Place>,
    /// Neighbours, from bottom to top, whose swap is refused.
    refused: HashSet<[u32; 2]>,
    faces: Faces,
    graph: Graph,
    trapezoids: Vec<Trapezoid>,
    audit: Audit,
}

impl<'m, M: CrossingModule> Sweep<'m, M> {
    /// The sweep before its first event.
    pub(super) fn new(pieces: &Pieces, module: &'m M, robustness: Robustness) -> Self {
        let (vertices, curves) = Vertices::new(pieces);
        let audit = Audit { curves: curves.len(), ..Audit::default() };
        let mut curve_of = vec![u32::MAX; pieces.pieces.len()];
        for (index, curve) in curves.iter().enumerate() {
            curve_of[curve.piece as usize] = index as u32;
        }
        Self {
            module,
            robustness,
            edge_of: vec![u32::MAX; curves.len()],
            curve_of,
            guises: Guises::default(),
            is_ending: vec![false; curves.len()],
            work: Vec::new(),
            block: Block::default(),
            related: Vec::new(),
            refused: HashSet::default(),
            vertices,
            status: Status::new(),
            queue: BinaryHeap::new(),
            now: DVec2::NEG_INFINITY,
            low: 0.0,
            joined: Vec::new(),
            gap: Vec::new(),
            since: Vec::new(),
            faces: Faces::new(pieces.base),
            graph: Graph::with_room_for(curves.len()),
            trapezoids: Vec::with_capacity(2 * curves.len()),
            curves,
            audit,
        }
    }

    /// Sweeps over all vertices. Returns the planar map, its decomposition and the counters.
    pub(super) fn run(mut self) -> (Graph, Vec<Trapezoid>, Audit) {
        for vertex in 0..self.vertices.points.len() as u32 {
            let point = self.vertices.points[vertex as usize];
            while let Some(&Reverse(event)) = self.queue.peek()
                && event.moment.compare(&Moment::from(point)).is_le()
            {
                self.queue.pop();
                self.cross(event, point);
            }
            (self.now, self.low) = (point, 0.0);
            self.vertex(vertex);
        }
        self.audit.vertices = self.graph.points.len();
        let number = self.graph.finish(self.faces, self.curves);
        for trapezoid in &mut self.trapezoids {
            trapezoid.face = number[trapezoid.face as usize];
        }
        (self.graph, self.trapezoids, self.audit)
    }
}

fn add(v: [i32; 2], w: [i32; 2]) -> [i32; 2] {
    [v[0] + w[0], v[1] + w[1]]
}
