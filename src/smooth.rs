//! Smoothed regions: lines, monotone circle segments and the turns between them (MS 2, MS 4.1; memo A3, A4, A7).

use crate::angle::Ang;
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
}
