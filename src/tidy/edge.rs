//! Edges between numbered vertices, the distance of a point from one, and the half sweep up to a point on it.

use glam::DVec2;

/// A directed line or circle segment of up to half a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    pub(super) tail: u32,
    pub(super) head: u32,
    /// Half the signed sweep in radians; 0 for a line.
    pub(super) delta: f64,
}

/// Loops of edges, end to end, and their vertices in the unit box.
#[derive(Clone, Debug, Default)]
pub(super) struct Net {
    pub(super) points: Vec<DVec2>,
    pub(super) loops: Vec<Vec<Edge>>,
}

impl Net {
    /// Adds a loop of vertices and half sweeps.
    pub(super) fn add(&mut self, stops: &[(DVec2, f64)]) {
        let (first, n) = (self.points.len() as u32, stops.len() as u32);
        let edges = (0..n).zip(stops);
        let edges = edges.map(|(i, stop)| Edge { tail: first + i, head: first + (i + 1) % n, delta: stop.1 });
        self.loops.push(edges.collect());
        self.points.extend(stops.iter().map(|stop| stop.0));
    }

    pub(super) fn span(&self, edge: &Edge) -> Span {
        Span { tail: self.points[edge.tail as usize], head: self.points[edge.head as usize], delta: edge.delta }
    }
}

/// An edge by its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) tail: DVec2,
    pub(super) head: DVec2,
    pub(super) delta: f64,
}

impl Span {
    /// The corners of a box that holds the edge.
    pub(super) fn bounds(&self) -> (DVec2, DVec2) {
        let sagitta = 0.5 * (self.head - self.tail).length() * libm::tan(0.5 * self.delta.abs());
        (self.tail.min(self.head) - sagitta, self.tail.max(self.head) + sagitta)
    }

    /// The point halfway.
    pub(super) fn middle(&self) -> DVec2 {
        let chord = self.head - self.tail;
        self.tail.midpoint(self.head) - chord.perp() * (0.5 * libm::tan(0.5 * self.delta))
    }

    /// How far p is from the edge if its nearest point is not an end, else `None`.
    pub(super) fn distance(&self, p: DVec2) -> Option<f64> {
        let (to, from, chord) = (p - self.tail, self.head - p, self.head - self.tail);
        let (sin, cos) = libm::sincos(self.delta);
        let (start, end) = (turned(chord, cos, -sin), turned(chord, cos, sin));
        if to.dot(start) <= 0.0 || from.dot(end) <= 0.0 {
            return None;
        }
        // On the edge (p-t).(h-p) sin delta = (p-t)x(h-p) cos delta (memo C1).
        Some(((to.dot(from) * sin - to.perp_dot(from) * cos) / chord.length()).abs())
    }

    /// Half the sweep from the tail to a point on the edge, measured from the nearer end: sines are proportional to
    /// chords. A point off the edge by d changes the sagitta of what is left by less than d.
    pub(super) fn half_sweep_to(&self, p: DVec2) -> f64 {
        let (to, from) = (p.distance(self.tail), p.distance(self.head));
        let sine = libm::sin(self.delta) / self.head.distance(self.tail);
        let upto = |chord: f64| libm::asin((sine * chord).clamp(-1.0, 1.0));
        let half = if to <= from { upto(to) } else { self.delta - upto(from) };
        half.clamp(self.delta.min(0.0), self.delta.max(0.0))
    }
}

fn turned(v: DVec2, cos: f64, sin: f64) -> DVec2 {
    DVec2::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y)
}
