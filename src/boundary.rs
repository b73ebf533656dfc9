//! The boundary of a region in the unit box: lines and monotone circle segments (memo A3, A4).
//!
//! [`Boundary::new`] scales a region to its frame, computes all normal angles once, makes tangential joints agree
//! ([`crate::joint`]) and splits arcs at the axis normals. It asks nothing of how the loops run, so it takes results
//! whose loops cross by a rounding. What a convolution needs besides is added by [`crate::smooth`].

use crate::angle::Ang;
use crate::arc::{Arc, ArcError};
use crate::frame::Frame;
use crate::joint::{self, Edge};
use crate::piece::{Piece, Source};
use crate::region::{Node, Region};
use crate::robustness::{Robustness, Step};
use crate::smooth::{Counts, Kind, Seg, SmoothError};
use glam::DVec2;

/// The lines and monotone arcs of a region.
#[derive(Clone, Debug)]
pub struct Boundary {
    /// Vertices, in units of the frame: those of the input first, in input order, then the cuts at axis normals.
    pub points: Vec<DVec2>,
    /// The segments of each loop in the order of traversal, none of them a turn.
    pub loops: Vec<Vec<Seg>>,
    /// What was changed on the way.
    pub counts: Counts,
}

/// The most input edges a region may have: each yields at most five pieces.
const MAX_EDGES: usize = (u32::MAX / 8) as usize;

/// The largest exponent of a frame: coordinates of sums stay finite.
pub(crate) const MAX_EXPONENT: i32 = 1000;

impl Boundary {
    /// The boundary in units of the frame.
    ///
    /// # Errors
    /// [`SmoothError`] if an edge has no geometry, a loop has fewer than two, or the region is too large.
    pub fn new(region: &Region, frame: &Frame) -> Result<Self, SmoothError> {
        Self::by(region, frame, Robustness::ALL)
    }

    /// The same with these robustness steps only (MS 8.3), of which angles and joints matter here.
    ///
    /// # Errors
    /// As [`Boundary::new`].
    pub fn by(region: &Region, frame: &Frame, robustness: Robustness) -> Result<Self, SmoothError> {
        if region.segments() > MAX_EDGES {
            return Err(SmoothError::TooLarge);
        }
        if frame.exp > MAX_EXPONENT {
            return Err(SmoothError::TooFar);
        }
        let point = |n: &Node| frame.to_unit(DVec2::new(n.x, n.y));
        let points = region.loops.iter().flatten().map(point).collect();
        let mut builder = Builder { points, counts: Counts::default(), robustness };
        let (mut loops, mut first) = (Vec::new(), 0);
        for (index, nodes) in region.loops.iter().enumerate() {
            loops.push(builder.segs(nodes, frame, first).map_err(|fault| fault.in_loop(index))?);
            first += nodes.len() as u32;
        }
        Ok(Self { points: builder.points, loops, counts: builder.counts })
    }

    /// The segments as pieces of an arrangement; `source.first` is the edge. Their vertices are [`Boundary::points`].
    #[must_use]
    pub fn pieces(&self, operand: u8) -> Vec<Piece> {
        let piece = |s: &Seg| Piece {
            tail: s.tail,
            head: s.head,
            a: s.a,
            b: s.b,
            whole: [s.tail, s.head],
            delta: s.delta,
            r: s.r,
            source: Source { first: s.edge, second: 0 },
            operand,
            weight: 1,
        };
        self.loops.iter().flatten().map(piece).collect()
    }
}

/// What is wrong at an edge of a loop.
enum Fault {
    TooFewEdges,
    Edge(usize, ArcError),
}

impl Fault {
    fn in_loop(self, index: usize) -> SmoothError {
        match self {
            Self::TooFewEdges => SmoothError::TooFewEdges { index },
            Self::Edge(edge, reason) => SmoothError::Edge { index, edge, reason },
        }
    }
}

/// The vertices and counts so far.
struct Builder {
    points: Vec<DVec2>,
    counts: Counts,
    robustness: Robustness,
}

impl Builder {
    /// The segments of a loop whose first vertex has the index `first`.
    fn segs(&mut self, nodes: &[Node], frame: &Frame, first: u32) -> Result<Vec<Seg>, Fault> {
        if nodes.len() < 2 {
            return Err(Fault::TooFewEdges);
        }
        let mut edges = Vec::with_capacity(nodes.len());
        for (i, node) in nodes.iter().enumerate() {
            let next = &nodes[(i + 1) % nodes.len()];
            let (edge, secant) =
                joint::edge(node, next, frame, self.robustness).map_err(|reason| Fault::Edge(i, reason))?;
            self.counts.secants += u32::from(secant);
            self.counts.modification2 += u32::from(is_bent_to_axis(&edge));
            edges.push(edge);
        }
        let snapping = self.robustness.takes(Step::Joints);
        self.counts.snapped += if snapping { joint::join(&mut edges) } else { 0 };
        let mut segs = Vec::with_capacity(nodes.len());
        for (i, edge) in edges.iter().enumerate() {
            let next = (i + 1) % nodes.len();
            self.split(edge, [first + i as u32, first + next as u32], &mut segs);
        }
        Ok(segs)
    }

    /// Appends an edge, an arc in monotone pieces. Pieces between equal points are left out: a turn takes their place.
    fn split(&mut self, edge: &Edge, [tail, head]: [u32; 2], segs: &mut Vec<Seg>) {
        let (arc, r) = match *edge {
            Edge::Line { angle, .. } => {
                let (a, b, edge) = (angle, angle, tail);
                segs.push(Seg { kind: Kind::Line, tail, head, a, b, delta: 0.0, r: 0.0, edge });
                return;
            }
            Edge::Arc { arc, r } => (arc, r),
        };
        let tolerance = if self.robustness.takes(Step::Joints) { edge.tolerance() } else { 0.0 };
        let ends = self.stations(&arc, tolerance, [tail, head]);
        for pair in ends.windows(2) {
            let ((a, from), (b, to)) = (pair[0], pair[1]);
            if from != to {
                let piece = Arc::minor(self.points[from as usize], self.points[to as usize], a, b, r < 0.0);
                segs.push(Seg { kind: Kind::Arc, tail: from, head: to, a, b, delta: piece.delta(), r, edge: tail });
            }
        }
    }

    /// The angles and vertices at the ends and cuts of an arc. A first or last cut that falls on the end, or on an axis
    /// normal within the tolerance of the end's, shares the vertex of that end.
    fn stations(&mut self, arc: &Arc, tolerance: f64, [tail, head]: [u32; 2]) -> Vec<(Ang, u32)> {
        let cuts = arc.cuts();
        let at_tail = |(angle, p): &&(Ang, DVec2)| *p == arc.tail() || arc.a().turn_to(*angle).abs() <= tolerance;
        let at_head = |(angle, p): &&(Ang, DVec2)| *p == arc.head() || arc.b().turn_to(*angle).abs() <= tolerance;
        let first = cuts.iter().take_while(at_tail).count();
        let last = cuts.len() - cuts[first..].iter().rev().take_while(at_head).count();
        let mut stations = vec![(arc.a(), tail)];
        for (i, &(angle, p)) in cuts.iter().enumerate() {
            let vertex = match i {
                _ if i < first => tail,
                _ if i >= last => head,
                _ if i > first && cuts[i - 1].1 == p => self.points.len() as u32 - 1,
                _ => {
                    self.points.push(p);
                    self.points.len() as u32 - 1
                }
            };
            stations.push((angle, vertex));
        }
        stations.push((arc.b(), head));
        stations
    }
}

/// Input modification 2 of MS 4.1: a line that is not vertical (horizontal) but has a horizontal (vertical) normal.
fn is_bent_to_axis(edge: &Edge) -> bool {
    match *edge {
        Edge::Line { tail, head, angle } => {
            let along = if angle.axis().is_multiple_of(2) { head.x - tail.x } else { head.y - tail.y };
            angle.is_axis() && along != 0.0
        }
        Edge::Arc { .. } => false,
    }
}
