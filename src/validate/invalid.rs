//! Why a region is invalid: one sentence with the place.

use super::MAX_VERTICES;
use crate::exact::MAX_SPREAD;
use std::fmt;
use thiserror::Error;

/// A vertex of a region, or the curve that leaves it. Loops and vertices are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Index of the loop.
    pub loop_index: usize,
    /// Index of the vertex in its loop.
    pub vertex: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "loop {}, vertex {}", self.loop_index, self.vertex)
    }
}

/// Where and in which way two curves meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// The vertex that the first curve leaves.
    pub first: Place,
    /// The vertex that the second curve leaves.
    pub second: Place,
    /// What they do.
    pub contact: Contact,
    /// Abscissa of a common point, in input units, rounded.
    pub x: f64,
    /// Its ordinate.
    pub y: f64,
}

/// In which way two curves meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// They pass through each other.
    Cross,
    /// They share a point without crossing.
    Touch,
    /// They share a stretch.
    Overlap,
    /// One follows the other and turns back by 180 degrees.
    Fold,
}

impl fmt::Display for Meeting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let verb = match self.contact {
            Contact::Cross => "cross",
            Contact::Touch => "touch",
            Contact::Overlap => "overlap",
            Contact::Fold => "form a cusp of 180 degrees",
        };
        write!(f, "the curves from {} and from {} {verb} at ({}, {})", self.first, self.second, self.x, self.y)
    }
}

/// Why a region is invalid.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum Invalid {
    /// A coordinate, bulge or radius is infinite or not a number.
    #[error("not finite: {0} has a coordinate, bulge or radius that is no finite number")]
    NotFinite(Place),
    /// A loop has too few vertices to enclose anything: one, or two joined by lines alone.
    #[error("open loop: loop {loop_index} has {vertices} vertices and does not close around anything")]
    OpenLoop {
        /// Index of the loop.
        loop_index: usize,
        /// The number of its vertices.
        vertices: usize,
    },
    /// A segment ends where it starts.
    #[error("zero-length segment: {0} equals the next vertex")]
    ZeroLength(Place),
    /// The ends of a circle segment are further apart than its diameter.
    #[error("chord longer than the diameter: {place} has chord {chord} and diameter {diameter}")]
    LongChord {
        /// The vertex that the segment leaves.
        place: Place,
        /// Distance of its ends, in input units.
        chord: f64,
        /// Twice its radius.
        diameter: f64,
    },
    /// Two curves of one loop meet elsewhere than at their common vertex, or turn back there.
    #[error("self-intersection: {0}")]
    SelfIntersection(Meeting),
    /// Curves of different loops cross or share a stretch.
    #[error("overlapping loops: {0}")]
    OverlappingLoops(Meeting),
    /// Loops that bound the same part of the region touch in a ring, which cuts its interior in two.
    #[error(
        "overlapping loops: loop {loop_index} closes a ring of loops that touch, last at ({x}, {y}), and cuts the interior"
    )]
    CutInterior {
        /// Index of the loop whose touch closes the ring.
        loop_index: usize,
        /// Abscissa of the touch, in input units.
        x: f64,
        /// Its ordinate.
        y: f64,
    },
    /// A loop runs the wrong way for its depth.
    #[error(
        "wrong orientation: loop {loop_index} lies inside {depth} loops and must run {}",
        if *clockwise { "counter-clockwise, as an outer loop" } else { "clockwise, as a hole" }
    )]
    WrongOrientation {
        /// Index of the loop.
        loop_index: usize,
        /// The number of loops around it.
        depth: usize,
        /// Whether it runs clockwise.
        clockwise: bool,
    },
    /// The region is bounded and has no loops.
    #[error("empty: the region has no loops")]
    NoLoops,
    /// A loop encloses no area.
    #[error("empty: loop {0} encloses no area")]
    NoArea(usize),
    /// There are too many vertices.
    #[error("too large: {0} vertices, at most {MAX_VERTICES} are allowed")]
    TooManyVertices(usize),
    /// A coordinate exceeds 2^1000, or a circle segment reaches beyond.
    #[error("too large: {0} or the circle segment that leaves it reaches beyond 2^1000")]
    TooFar(Place),
    /// The bits of the coordinates spread too far for exact predicates.
    #[error("too large: the coordinates spread over {0} binary digits, at most {MAX_SPREAD} are allowed")]
    TooWide(i32),
}

impl Invalid {
    /// The reason in the words of the format's design, without the place.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::NotFinite(_) => "not finite",
            Self::OpenLoop { .. } => "open loop",
            Self::ZeroLength(_) => "zero-length segment",
            Self::LongChord { .. } => "chord longer than the diameter",
            Self::SelfIntersection(_) => "self-intersection",
            Self::OverlappingLoops(_) | Self::CutInterior { .. } => "overlapping loops",
            Self::WrongOrientation { .. } => "wrong orientation",
            Self::NoLoops | Self::NoArea(_) => "empty",
            Self::TooManyVertices(_) | Self::TooFar(_) | Self::TooWide(_) => "too large",
        }
    }
}
