//! Smoothed regions: lines, monotone circle segments and the turns between them (MS 2, MS 4.1; memo A3, A4, A7).
//!
//! [`Smooth::new`] scales a region to its frame, computes all normal angles once, makes tangential joints agree
//! ([`crate::joint`]), splits arcs at the axis normals and puts a turn wherever the angle jumps. Every segment starts
//! at the vertex and at the angle where the one before it ended, whatever the rounding.

use crate::angle::Ang;
use crate::arc::{Arc, ArcError};
use crate::frame::Frame;
use crate::joint::{self, Edge};
use crate::nesting;
use crate::piece::{Piece, Source};
use crate::region::{Node, Region};
use crate::turn::{Bend, turn};
use glam::DVec2;

/// What a segment is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A straight line.
    Line,
    /// A circle segment of at most 90 degrees with no axis normal strictly inside, so it is x- and y-monotone.
    Arc,
    /// The turn at a vertex from one segment to the next: radius 0, tail equals head.
    Turn,
}

/// One segment of a smoothed region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seg {
    /// Line, arc or turn.
    pub kind: Kind,
    /// Tail, an index of [`Smooth::points`]; vertices are told apart by index, never by coordinates.
    pub tail: u32,
    /// Head, likewise. Equal to the tail exactly for a turn.
    pub head: u32,
    /// Rightward normal angle at the tail.
    pub a: Ang,
    /// Rightward normal angle at the head; equal to `a` for a line.
    pub b: Ang,
    /// Half the sweep (b - a)/2 in radians, positive convex, negative concave: 0 for a line, within pi/4 for an arc,
    /// within pi/2 for a turn.
    pub delta: f64,
    /// Signed radius in units of the frame; 0 for lines and turns.
    pub r: f64,
    /// The edge of the input region this segment is part of, counted through all loops; for a turn, the edge it ends.
    pub edge: u32,
}

/// A loop of a smoothed region: each segment starts at the vertex and at the angle where the one before it ended.
#[derive(Clone, Debug)]
pub struct SmoothLoop {
    /// The segments in the order of traversal, turns included.
    pub segs: Vec<Seg>,
    /// Least corner of the bounding box, in units of the frame.
    pub min: DVec2,
    /// Greatest corner of the bounding box.
    pub max: DVec2,
}

/// A connected part of a region.
#[derive(Clone, Debug)]
pub struct Component {
    /// Its outer loop, an index of [`Smooth::loops`]; `None` for the part that reaches to infinity.
    pub outer: Option<usize>,
    /// Its holes, likewise.
    pub holes: Vec<usize>,
}

/// A region made ready for convolution.
#[derive(Clone, Debug)]
pub struct Smooth {
    /// Vertices, in units of the frame: those of the input first, in input order, then the cuts at axis normals.
    pub points: Vec<DVec2>,
    /// The loops, in input order.
    pub loops: Vec<SmoothLoop>,
    /// The connected parts; the unbounded one, if any, first.
    pub components: Vec<Component>,
    /// What was changed on the way.
    pub counts: Counts,
}

/// How often [`Smooth::new`] changed the input within rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Arcs replaced by their secants because both end angles are equal (MS 4.1, input modification 1).
    pub secants: u32,
    /// End angles of arcs moved to that of a neighbour or an axis.
    pub snapped: u32,
    /// Lines whose normal is an axis although they are not parallel to the other one: what the input modification 2 of
    /// MS 4.1 is for. With [`Ang`] it takes underflow, so this stays 0.
    pub modification2: u32,
}

/// Why a region cannot be smoothed. Loops and edges are counted from 0, edges within their loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SmoothError {
    /// An edge is degenerate.
    #[error("loop {index}, edge {edge}: {reason}")]
    Edge {
        /// The loop.
        index: usize,
        /// The edge.
        edge: usize,
        /// What is wrong with it.
        reason: ArcError,
    },
    /// A loop has fewer than two edges.
    #[error("loop {index} has fewer than two edges")]
    TooFewEdges {
        /// The loop.
        index: usize,
    },
    /// Two consecutive edges run back over each other, so their turn has no side.
    #[error("loop {index} folds back onto itself after edge {edge}")]
    Fold {
        /// The loop.
        index: usize,
        /// The first of the two edges.
        edge: usize,
    },
    /// A loop does not turn once, as a loop that does not cross itself does.
    #[error("loop {index} turns {turns} times, so it crosses itself")]
    Turning {
        /// The loop.
        index: usize,
        /// How often it turns, counter-clockwise.
        turns: i32,
    },
    /// A hole lies in no outer loop.
    #[error("loop {index} is a hole outside of all outer loops")]
    Orphan {
        /// The loop.
        index: usize,
    },
    /// The region has more segments than indices can tell apart.
    #[error("the region has too many segments")]
    TooLarge,
    /// The region, arcs included, is so large that sums of coordinates would overflow.
    #[error("the region is larger than 2^{MAX_EXPONENT}")]
    TooFar,
}

/// The most input edges a region may have: each yields at most five pieces.
const MAX_EDGES: usize = (u32::MAX / 8) as usize;

/// The largest exponent of a frame: coordinates of sums stay finite.
const MAX_EXPONENT: i32 = 1000;

impl Smooth {
    /// The region in units of the frame. A loop that turns counter-clockwise is an outer one, else a hole.
    ///
    /// # Errors
    /// [`SmoothError`] if the region is degenerate beyond what can be smoothed. That none is returned does not make the
    /// region valid: crossings between edges go unnoticed.
    pub fn new(region: &Region, frame: &Frame) -> Result<Self, SmoothError> {
        if region.segments() > MAX_EDGES {
            return Err(SmoothError::TooLarge);
        }
        if frame.exp > MAX_EXPONENT {
            return Err(SmoothError::TooFar);
        }
        let point = |n: &Node| frame.to_unit(DVec2::new(n.x, n.y));
        let points = region.loops.iter().flatten().map(point).collect();
        let mut builder = Builder { points, counts: Counts::default() };
        let (mut loops, mut outer, mut first) = (Vec::new(), Vec::new(), 0);
        for (index, nodes) in region.loops.iter().enumerate() {
            let segs = builder.segs(nodes, frame, first).map_err(|fault| fault.in_loop(index))?;
            match turning(&segs) {
                1 => outer.push(true),
                -1 => outer.push(false),
                turns => return Err(SmoothError::Turning { index, turns }),
            }
            loops.push(builder.boxed(segs));
            first += nodes.len() as u32;
        }
        let Builder { points, counts } = builder;
        let components = nesting::components(&points, &loops, &outer, region.unbounded)
            .map_err(|index| SmoothError::Orphan { index })?;
        Ok(Self { points, loops, components, counts })
    }

    /// The lines and arcs as pieces of an arrangement, without the turns; `source.first` is the edge. Their vertices
    /// are [`Smooth::points`].
    #[must_use]
    pub fn pieces(&self, operand: u8) -> Vec<Piece> {
        let segs = self.loops.iter().flat_map(|l| &l.segs).filter(|s| s.kind != Kind::Turn);
        let piece = |s: &Seg| Piece {
            tail: s.tail,
            head: s.head,
            a: s.a,
            b: s.b,
            delta: s.delta,
            r: s.r,
            source: Source { first: s.edge, second: 0 },
            operand,
        };
        segs.map(piece).collect()
    }

    /// The geometry of an arc of this region. For a line or a turn it has no meaning.
    #[must_use]
    pub fn arc(&self, seg: &Seg) -> Arc {
        let (tail, head) = (self.points[seg.tail as usize], self.points[seg.head as usize]);
        Arc::minor(tail, head, seg.a, seg.b, seg.delta < 0.0)
    }
}

/// How often a loop turns counter-clockwise: its net passages over the angle 0.
fn turning(segs: &[Seg]) -> i32 {
    let passage = |s: &Seg| match s.delta {
        d if d > 0.0 => i32::from(s.b < s.a),
        d if d < 0.0 => -i32::from(s.b > s.a),
        _ => 0,
    };
    segs.iter().map(passage).sum()
}

/// What is wrong at an edge of a loop.
enum Fault {
    TooFewEdges,
    Edge(usize, ArcError),
    Fold(usize),
}

impl Fault {
    fn in_loop(self, index: usize) -> SmoothError {
        match self {
            Self::TooFewEdges => SmoothError::TooFewEdges { index },
            Self::Edge(edge, reason) => SmoothError::Edge { index, edge, reason },
            Self::Fold(edge) => SmoothError::Fold { index, edge },
        }
    }
}

/// The vertices and counts so far.
struct Builder {
    points: Vec<DVec2>,
    counts: Counts,
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
            let (edge, secant) = joint::edge(node, next, frame).map_err(|reason| Fault::Edge(i, reason))?;
            self.counts.secants += u32::from(secant);
            self.counts.modification2 += u32::from(is_bent_to_axis(&edge));
            edges.push(edge);
        }
        self.counts.snapped += joint::join(&mut edges);
        let mut segs = Vec::with_capacity(2 * nodes.len());
        for (i, edge) in edges.iter().enumerate() {
            let next = (i + 1) % nodes.len();
            self.split(edge, [first + i as u32, first + next as u32], &mut segs);
        }
        with_turns(&segs, &self.points).map_err(|edge| Fault::Fold((edge - first) as usize))
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
        let ends = self.stations(&arc, edge.tolerance(), [tail, head]);
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

    fn boxed(&self, segs: Vec<Seg>) -> SmoothLoop {
        let corners = segs.iter().map(|s| self.points[s.tail as usize]);
        let (min, max) = corners
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(min, max): (DVec2, DVec2), p| (min.min(p), max.max(p)));
        SmoothLoop { segs, min, max }
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

/// The segments with a turn wherever the angle jumps from one to the next.
///
/// # Errors
/// The edge after which the loop folds back onto itself.
fn with_turns(segs: &[Seg], points: &[DVec2]) -> Result<Vec<Seg>, u32> {
    let mut all = Vec::with_capacity(2 * segs.len());
    for (i, seg) in segs.iter().enumerate() {
        let next = &segs[(i + 1) % segs.len()];
        all.push(*seg);
        if seg.b != next.a {
            let bend = |s: &Seg| Bend { tail: points[s.tail as usize], head: points[s.head as usize], r: s.r };
            let turn = turn(seg.b, next.a, &bend(seg), &bend(next)).ok_or(seg.edge)?;
            let (tail, head, a, b) = (seg.head, seg.head, seg.b, next.a);
            all.push(Seg { kind: Kind::Turn, tail, head, a, b, delta: turn / 2.0, r: 0.0, edge: seg.edge });
        }
    }
    Ok(all)
}
