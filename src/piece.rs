//! Pieces: the directed, x- and y-monotone lines and circle segments that an arrangement is made of.
//!
//! Convolutions and set operations both end in pieces. The geometry of a piece is fixed by its two end points and its
//! half sweep alone (memo A1): unlike end points and radius, these stay consistent under rounding.

use crate::angle::Ang;
use glam::DVec2;

/// Where a piece comes from, so that parts of one source segment can be merged again. Two pieces with equal source
/// that meet end to end lie on the same line or circle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Source {
    /// The place on the first operand: an edge or a vertex, as the convolution numbers them.
    pub first: u32,
    /// The place on the second operand, likewise.
    pub second: u32,
}

/// A directed line or circle segment between two vertices of a [`Pieces`] set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Tail, an index of [`Pieces::points`]. Vertices are told apart by index, not by coordinates.
    pub tail: u32,
    /// Head, likewise.
    pub head: u32,
    /// Rightward normal angle at the tail.
    pub a: Ang,
    /// Rightward normal angle at the head.
    pub b: Ang,
    /// The ends of the piece that this is a part of, likewise; its own ends if it is whole. They fix the geometry: the ends
    /// of a part lie on the whole only up to rounding.
    pub whole: [u32; 2],
    /// Half the sweep of the whole in radians, in [-pi/4, pi/4]: positive when the centre is on the left, 0 for a line.
    pub delta: f64,
    /// Signed radius in units of the frame, 0 for a line. Kept to recognise equal circles; never used to evaluate.
    pub r: f64,
    /// What the piece is part of.
    pub source: Source,
    /// Which operand of a set operation the piece bounds: 0 or 1. A convolution is operand 0.
    pub operand: u8,
    /// By how much the winding number on the left exceeds that on the right: 1 but for the rims of what was culled.
    pub weight: i32,
}

impl Piece {
    /// A line with this normal.
    #[must_use]
    pub fn line(tail: u32, head: u32, normal: Ang, source: Source) -> Self {
        Self {
            tail,
            head,
            a: normal,
            b: normal,
            whole: [tail, head],
            delta: 0.0,
            r: 0.0,
            source,
            operand: 0,
            weight: 1,
        }
    }

    /// The line between two vertices. Where they have equal coordinates the arrangement merges them, and any normal will do.
    #[must_use]
    pub fn between(points: &[DVec2], tail: u32, head: u32, source: Source) -> Self {
        let normal = Ang::of_line(points[tail as usize], points[head as usize]).unwrap_or(Ang::RIGHT);
        Self::line(tail, head, normal, source)
    }
}

/// A set of pieces that together form closed loops: every vertex has as many pieces in as out, per operand. Those of a convex
/// convolution do not.
#[derive(Clone, Debug, Default)]
pub struct Pieces {
    /// The vertices, in units of the frame.
    pub points: Vec<DVec2>,
    /// The pieces.
    pub pieces: Vec<Piece>,
    /// The winding number far away, per operand.
    pub base: [i32; 2],
}
