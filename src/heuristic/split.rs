//! The map with connectors: edges are cut where necks end on them, and every neck becomes an edge of weight 0.

use super::neck::{End, Neck, Places};
use crate::angle::Ang;
use crate::arrangement::Arrangement;
use crate::arrangement::curve::Curve;
use crate::arrangement::graph::{Edge, Graph, HalfEdge};
use crate::piece::{Piece, Pieces, Source};
use glam::DVec2;

/// The edges that border each trapezoid from below and from above, in the new map.
pub(super) struct Refined {
    pub(super) borders: Vec<[u32; 2]>,
}

/// Where an edge is cut.
#[derive(Clone, Copy)]
struct Cut {
    x: f64,
    vertex: u32,
}

/// Puts the necks into the map. The faces of the new map are still those of the old one.
pub(super) fn split(arrangement: &mut Arrangement, places: &Places, necks: &[Neck], pieces: &mut Pieces) -> Refined {
    let mut splitter = Splitter::new(&arrangement.graph);
    let vertices: Vec<[u32; 2]> = necks.iter().map(|neck| neck.ends.map(|end| splitter.vertex(end, neck.x))).collect();
    let parts = splitter.cut_edges();
    let border = |t| {
        let edges = places.edges(&arrangement.graph, t);
        edges.map(|e| splitter.part_from(&parts[e as usize], e, t.from))
    };
    let borders = arrangement.trapezoids.iter().map(border).collect();
    for (vertices, neck) in vertices.into_iter().zip(necks) {
        splitter.turn_off(neck.ends, vertices, &parts);
        splitter.connect(vertices, neck.face, pieces);
    }
    let Splitter { points, edges, curves, around, .. } = splitter;
    let windings = arrangement.graph.windings.clone();
    let conflicts = arrangement.graph.winding_conflicts;
    arrangement.graph = Graph::assemble(points, edges, curves, &around, windings, conflicts);
    Refined { borders }
}

/// A map under change.
struct Splitter {
    points: Vec<DVec2>,
    edges: Vec<Edge>,
    curves: Vec<Curve>,
    /// Half-edges that leave each vertex, counter-clockwise from the upper left.
    around: Vec<Vec<HalfEdge>>,
    cuts: Vec<Vec<Cut>>,
    /// The first edge that is a connector.
    first_connector: u32,
}

impl Splitter {
    fn new(old: &Graph) -> Self {
        Self {
            points: old.points.clone(),
            edges: old.edges.clone(),
            curves: old.curves.clone(),
            around: (0..old.points.len() as u32).map(|v| old.around(v).to_vec()).collect(),
            cuts: vec![Vec::new(); old.edges.len()],
            first_connector: u32::MAX / 2,
        }
    }

    /// The vertex at the end of a neck, a new one inside an edge.
    fn vertex(&mut self, end: End, x: f64) -> u32 {
        match end {
            End::Corner(half) => {
                let edge = &self.edges[(half / 2) as usize];
                if half.is_multiple_of(2) { edge.from } else { edge.to }
            }
            End::Edge(edge) => {
                let vertex = self.points.len() as u32;
                let y = self.curves[self.edges[edge as usize].curve as usize].y_at(x);
                self.points.push(DVec2::new(x, y));
                self.around.push(Vec::new());
                self.cuts[edge as usize].push(Cut { x, vertex });
                vertex
            }
        }
    }

    /// Cuts the edges. Returns the parts of each from left to right; the first keeps the number of the whole.
    fn cut_edges(&mut self) -> Vec<Vec<u32>> {
        let mut parts: Vec<Vec<u32>> = (0..self.cuts.len() as u32).map(|e| vec![e]).collect();
        for (e, parts) in parts.iter_mut().enumerate() {
            let mut cuts = std::mem::take(&mut self.cuts[e]);
            cuts.sort_by(|c, d| c.x.total_cmp(&d.x));
            let (mut last, end) = (e, self.edges[e].to);
            for cut in cuts {
                let next = self.edges.len();
                self.edges.push(Edge { from: cut.vertex, ..self.edges[e] });
                self.edges[last].to = cut.vertex;
                self.around[cut.vertex as usize] = vec![2 * last as u32 + 1, 2 * next as u32];
                parts.push(next as u32);
                last = next;
            }
            self.edges[last].to = end;
            let arrival = self.around[end as usize].iter_mut().find(|half| **half == 2 * e as u32 + 1);
            if let Some(arrival) = arrival {
                *arrival = 2 * last as u32 + 1;
            }
        }
        self.first_connector = self.edges.len() as u32;
        parts
    }

    /// The part of an old edge that goes on to the right of an abscissa.
    fn part_from(&self, parts: &[u32], whole: u32, x: f64) -> u32 {
        let begins = |part: &u32| *part == whole || self.points[self.edges[*part as usize].from as usize].x <= x;
        parts[parts.partition_point(begins) - 1]
    }

    /// Enters the next edge into the rotations at its two ends. Where it leaves a vertex it follows the half-edge that has its
    /// cell on the left; of two in one corner, the one upwards comes first after a right edge, and last after a left one.
    fn turn_off(&mut self, ends: [End; 2], vertices: [u32; 2], parts: &[Vec<u32>]) {
        let edge = self.edges.len() as u32;
        for (side, half) in [(0, 2 * edge), (1, 2 * edge + 1)] {
            let around = &mut self.around[vertices[side] as usize];
            let corner = match ends[side] {
                End::Corner(half) if half % 2 == 1 => {
                    let parts = &parts[(half / 2) as usize];
                    2 * parts[parts.len() - 1] + 1
                }
                End::Corner(half) => half,
                End::Edge(_) => around[1 - side],
            };
            let place = around.iter().position(|known| *known == corner).map_or(around.len(), |place| place + 1);
            let is_other = |known: &HalfEdge| *known >= 2 * self.first_connector && known % 2 != half % 2;
            let last = (half % 2 == 0) == (corner % 2 == 1);
            let skipped = around[place..].iter().take_while(|known| last && is_other(known)).count();
            around.insert(place + skipped, half);
        }
    }

    /// Adds an edge between two vertices, the lower one first.
    fn connect(&mut self, [low, high]: [u32; 2], face: u32, pieces: &mut Pieces) {
        let curve = self.curves.len() as u32;
        let [p, q] = [low, high].map(|v| self.points[v as usize]);
        let first = pieces.points.len() as u32;
        pieces.points.extend([p, q]);
        let piece = Piece {
            tail: first,
            head: first + 1,
            a: Ang::RIGHT,
            b: Ang::RIGHT,
            whole: [first, first + 1],
            delta: 0.0,
            r: 0.0,
            source: Source { first: u32::MAX, second: pieces.pieces.len() as u32 },
            operand: 0,
            weight: 1,
        };
        let made = Curve::new(pieces.pieces.len() as u32, &piece, (low, p), (high, q), [p, q]);
        if let Some(mut made) = made {
            made.weight = [0; 2];
            self.curves.push(made);
        }
        pieces.pieces.push(piece);
        self.edges.push(Edge { curve, from: low, to: high, below: face, above: face });
    }
}
