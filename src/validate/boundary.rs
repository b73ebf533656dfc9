//! The boundary of a region on the grid of the exact predicates, its circle segments cut into monotone parts at the axis
//! normals (memo A4 step 3), each with the geometry that two end points and half the sweep give (memo A1, A5).

use super::Place;
use super::shape::{chord, farthest};
use crate::exact::{Grid, orientation};
use crate::region::{Curve, Node, Region};
use glam::DVec2;
use std::cmp::Ordering;
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

/// The tolerance of everything that involves a circle segment: as a share of the largest coordinate for lengths, in
/// radians for directions.
pub const TOLERANCE: f64 = 1.0 / (1u64 << 40) as f64;

/// Below this bulge a segment is a line: its height is under 2^-61 of its chord, far below rounding.
const FLAT: f64 = 1.0 / (1u64 << 60) as f64;

/// A line or a monotone circle segment of at most 90 degrees.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// Tail, on the grid.
    pub tail: DVec2,
    /// Head, on the grid.
    pub head: DVec2,
    /// Half the sweep in radians, positive when the centre is on the left, 0 for a line.
    pub half: f64,
    /// Length along the curve.
    pub length: f64,
    /// The vertex that the segment leaves which this is a part of.
    pub place: Place,
    sin: f64,
    cos: f64,
}

impl Part {
    fn new(tail: DVec2, head: DVec2, half: f64, place: Place) -> Self {
        let (sin, cos) = libm::sincos(half);
        let chord = libm::hypot(head.x - tail.x, head.y - tail.y);
        let length = if half == 0.0 { chord } else { chord * (half / sin) };
        Self { tail, head, half, length, place, sin, cos }
    }

    /// Whether it is a line.
    pub fn is_line(&self) -> bool {
        self.half == 0.0
    }

    /// The radius; infinite for a line.
    pub fn radius(&self) -> f64 {
        (self.length / (2.0 * self.half)).abs()
    }

    /// The point at a share of the length from the tail, in [0, 1].
    pub fn point(&self, share: f64) -> DVec2 {
        match share {
            0.0 => self.tail,
            1.0 => self.head,
            _ if self.is_line() => self.tail + (self.head - self.tail) * share,
            // Memo A5, from the tail.
            _ => {
                let (sin, cos) = libm::sincos(self.half * (share - 1.0));
                let ratio = libm::sin(self.half * share) / self.sin;
                self.tail + (self.head - self.tail).rotate(DVec2::new(cos, sin)) * ratio
            }
        }
    }

    /// The signed area between the chord and the curve, positive where the curve bulges to the right.
    pub fn cap(&self) -> f64 {
        let square = (self.head - self.tail).length_squared() / 4.0;
        // Below this angle the difference cancels; the next term of the series is 2e-13 of the first.
        if self.half.abs() < 1e-3 {
            return square * self.half * 2.0 / 3.0 * (1.0 + self.half * self.half * 2.0 / 15.0);
        }
        square * (self.half - self.sin * self.cos) / (self.sin * self.sin)
    }

    /// The direction of travel at a share of the length, with the length of the chord.
    pub fn direction(&self, share: f64) -> DVec2 {
        let (sin, cos) = libm::sincos(self.half * (2.0 * share - 1.0));
        (self.head - self.tail).rotate(DVec2::new(cos, sin))
    }

    /// The share of the length at which a point near the part lies; outside [0, 1] beyond its ends.
    pub fn share(&self, point: DVec2) -> f64 {
        let chord = self.head - self.tail;
        let along = (point - self.tail).dot(chord) / chord.length_squared();
        if self.is_line() {
            return along;
        }
        // The chord is the sine of the angle from the middle, and the sweep is at most 90 degrees.
        let sine = ((2.0 * along - 1.0) * self.sin).clamp(-1.0, 1.0);
        (libm::asin(sine) / self.half + 1.0) / 2.0
    }

    /// The height of a point over the line or circle, positive on the left: its distance close to the curve, of the right
    /// sign everywhere. By the inscribed angle, points p of the circle see the chord c under a fixed angle, and
    /// cos(half) c x (p - tail) - sin(half) (p - tail).(p - head) vanishes.
    pub fn height(&self, point: DVec2) -> f64 {
        let (chord, from_tail, from_head) = (self.head - self.tail, point - self.tail, point - self.head);
        (self.cos * chord.perp_dot(from_tail) - self.sin * from_tail.dot(from_head)) / chord.length()
    }

    /// The rate of [`Part::height`] in a direction, up to a positive factor.
    pub fn slope(&self, point: DVec2, direction: DVec2) -> f64 {
        let (from_tail, from_head) = (point - self.tail, point - self.head);
        self.cos * (self.head - self.tail).perp_dot(direction) - self.sin * (from_tail + from_head).dot(direction)
    }

    /// Whether a point is within the tolerance of the part.
    pub fn is_near(&self, point: DVec2, tolerance: f64) -> bool {
        let chord = self.head - self.tail;
        let length = chord.length();
        let (along, across) = (chord.dot(point - self.tail) / length, chord.perp_dot(point - self.tail) / length);
        // The part bulges by at most 0.21 chords; the far side of its circle is a whole chord away.
        (-tolerance..=length + tolerance).contains(&along)
            && across.abs() <= length / 2.0 + tolerance
            && self.height(point).abs() <= tolerance
    }

    /// On which side of the part a point at the height of the part lies, `Greater` on the left. Exact for lines.
    pub fn side(&self, point: DVec2) -> Ordering {
        let (min, max) = (self.tail.x.min(self.head.x), self.tail.x.max(self.head.x));
        if self.is_line() || !(min..=max).contains(&point.x) {
            // A monotone part lies within the box of its chord, so beyond the box the chord decides.
            return orientation(self.tail, self.head, point);
        }
        self.height(point).partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }
}

/// The boundary of a region.
#[derive(Debug)]
pub struct Boundary {
    /// The parts of all loops, in order.
    pub parts: Vec<Part>,
    /// The parts of each loop.
    pub loops: Vec<Range<usize>>,
    /// How coordinates came onto the grid.
    pub grid: Grid,
    /// The distance on the grid below which floating point does not tell curves apart.
    pub tolerance: f64,
}

impl Boundary {
    /// The boundary of a region of sound shape.
    pub fn new(region: &Region, grid: Grid) -> Self {
        let segments = |nodes: &[Node]| (0..nodes.len()).map(|i| (nodes[i], nodes[(i + 1) % nodes.len()])).collect();
        let loops: Vec<Vec<(Node, Node)>> = region.loops.iter().map(|nodes| segments(nodes)).collect();
        let reach = loops.iter().flatten().map(|(tail, head)| farthest(tail, head)).fold(0.0, f64::max);
        let mut boundary =
            Self { parts: Vec::new(), loops: Vec::new(), grid, tolerance: grid.scale(reach) * TOLERANCE };
        for (loop_index, segments) in loops.iter().enumerate() {
            let start = boundary.parts.len();
            for (vertex, (tail, head)) in segments.iter().enumerate() {
                boundary.push(tail, head, Place { loop_index, vertex });
            }
            boundary.loops.push(start..boundary.parts.len());
        }
        boundary
    }

    /// Appends the parts of a segment.
    fn push(&mut self, tail: &Node, head: &Node, place: Place) {
        let bulge = bulge(tail, head);
        let (tail, head) = (self.grid.scale_point(tail.x, tail.y), self.grid.scale_point(head.x, head.y));
        if bulge.abs() < FLAT {
            self.parts.push(Part::new(tail, head, 0.0, place));
            return;
        }
        let chord = head - tail;
        let half = 2.0 * libm::atan(bulge);
        let radius = chord.length() / 4.0 * (bulge + 1.0 / bulge);
        // The normal at the tail; the normal of the chord is its direction less 90 degrees.
        let first = libm::atan2(-chord.x, chord.y) - half;
        let (mut last_point, mut last_share) = (tail, 0.0);
        for share in cuts(first, half) {
            let (sin, cos) = libm::sincos(half * (share - 1.0));
            let (from_tail, to_head) = (libm::sin(half * share), libm::sin(half * (1.0 - share)));
            // No part shorter than the tolerance: its direction would be noise.
            if (2.0 * radius * from_tail).abs().min((2.0 * radius * to_head).abs()) <= self.tolerance {
                continue;
            }
            let point = tail + chord.normalize().rotate(DVec2::new(cos, sin)) * (2.0 * radius * from_tail);
            self.parts.push(Part::new(last_point, point, half * (share - last_share), place));
            (last_point, last_share) = (point, share);
        }
        self.parts.push(Part::new(last_point, head, half * (1.0 - last_share), place));
    }

    /// A bound on the coordinates, on the grid.
    pub fn size(&self) -> f64 {
        self.tolerance / TOLERANCE
    }

    /// The part after this one in its loop.
    pub fn next(&self, part: usize) -> usize {
        let parts = &self.loops[self.loop_of(part)];
        if part + 1 == parts.end { parts.start } else { part + 1 }
    }

    /// The part before this one in its loop.
    pub fn previous(&self, part: usize) -> usize {
        let parts = &self.loops[self.loop_of(part)];
        if part == parts.start { parts.end - 1 } else { part - 1 }
    }

    /// The loop of a part.
    pub fn loop_of(&self, part: usize) -> usize {
        self.parts[part].place.loop_index
    }
}

/// The bulge of a segment; 0 for a line.
fn bulge(tail: &Node, head: &Node) -> f64 {
    match tail.curve {
        Curve::Line => 0.0,
        Curve::Bulge(bulge) => bulge,
        Curve::Radius(radius) => {
            // tan(half/2) from sin(half), the ratio of chord and diameter.
            let sine = (chord(tail, head) / 2.0 / radius.abs()).min(1.0);
            (sine / (1.0 + ((1.0 - sine) * (1.0 + sine)).sqrt())).copysign(radius)
        }
    }
}

/// The shares of the sweep, strictly between 0 and 1 and increasing, at which the normal is along an axis, when it starts
/// at the angle `first` and turns by twice `half`.
fn cuts(first: f64, half: f64) -> impl Iterator<Item = f64> {
    let start = first / FRAC_PI_2;
    let axes =
        (1..=4).map(move |i| if half > 0.0 { start.floor() + f64::from(i) } else { start.ceil() - f64::from(i) });
    axes.map(move |axis| (axis - start) * FRAC_PI_2 / (2.0 * half)).filter(|share| (0.0..1.0).contains(share))
}
