//! Smoothed regions: lines, monotone circle segments and the turns between them (MS 2, MS 4.1; memo A3, A4, A7).
//!
//! [`Smooth::new`] takes the lines and monotone arcs of a region ([`crate::boundary`]), puts a turn wherever the angle jumps
//! and sorts the loops into connected parts. Every segment starts at the vertex and at the angle where the one before it
//! ended, whatever the rounding.

use crate::angle::Ang;
use crate::arc::{Arc, ArcError};
use crate::boundary::{Boundary, MAX_EXPONENT};
use crate::frame::Frame;
use crate::nesting;
use crate::region::Region;
use crate::robustness::Robustness;
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

/// How often [`Boundary::new`] changed the input within rounding.
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

impl Smooth {
    /// The region in units of the frame. A loop that turns counter-clockwise is an outer one, else a hole.
    ///
    /// # Errors
    /// [`SmoothError`] if the region is degenerate beyond what can be smoothed. That none is returned does not make the
    /// region valid: crossings between edges go unnoticed.
    pub fn new(region: &Region, frame: &Frame) -> Result<Self, SmoothError> {
        Self::by(region, frame, Robustness::ALL)
    }

    /// The same with these robustness steps only (MS 8.3), of which angles and joints matter here.
    ///
    /// # Errors
    /// As [`Smooth::new`].
    pub fn by(region: &Region, frame: &Frame, robustness: Robustness) -> Result<Self, SmoothError> {
        let Boundary { points, loops: boundary, counts } = Boundary::by(region, frame, robustness)?;
        let (mut loops, mut outer, mut first) = (Vec::new(), Vec::new(), 0);
        for (index, segs) in boundary.iter().enumerate() {
            let segs =
                with_turns(segs, &points).map_err(|edge| SmoothError::Fold { index, edge: edge as usize - first })?;
            match turning(&segs) {
                1 => outer.push(true),
                -1 => outer.push(false),
                turns => return Err(SmoothError::Turning { index, turns }),
            }
            loops.push(boxed(segs, &points));
            first += region.loops[index].len();
        }
        let components = nesting::components(&points, &loops, &outer, region.unbounded)
            .map_err(|index| SmoothError::Orphan { index })?;
        Ok(Self { points, loops, components, counts })
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

fn boxed(segs: Vec<Seg>, points: &[DVec2]) -> SmoothLoop {
    let corners = segs.iter().map(|s| points[s.tail as usize]);
    let (min, max) =
        corners.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(min, max): (DVec2, DVec2), p| (min.min(p), max.max(p)));
    SmoothLoop { segs, min, max }
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
