//! Sum segments under construction: their vertices get identities, their arcs the orientation of memo B1.

use super::Stop;
use super::sites::{Place, Site, Sites};
use crate::angle::Ang;
use crate::piece::{Piece, Pieces, Source};
use crate::smooth::{Kind, Seg, Smooth};
use crate::sum3::Rounding;
use glam::DVec2;
use rustc_hash::{FxBuildHasher, FxHashMap as HashMap};

/// Sums of radii up to this, in the unit box, make lines: the circle is no larger than a few roundings.
const TINY_RADIUS: f64 = 8.0 * f64::EPSILON;

/// A segment of an operand and where it stands.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    /// The segment.
    pub seg: &'a Seg,
    /// Its loop.
    pub of_loop: u32,
    /// Its place in the loop.
    pub index: u32,
}

impl Placed<'_> {
    fn summand(&self) -> Summand {
        match self.seg.kind {
            Kind::Turn => Summand::Vertex(self.seg.tail),
            Kind::Line | Kind::Arc => Summand::Segment(self.of_loop, self.index),
        }
    }
}

/// A segment run backwards, between two vertices.
fn reversed(seg: &Seg, tail: u32, head: u32, source: Source) -> Piece {
    let (a, b) = (seg.b.opposite(), seg.a.opposite());
    let delta = if seg.kind == Kind::Line { 0.0 } else { -seg.delta };
    Piece { tail, head, a, b, whole: [tail, head], delta, r: -seg.r, source, operand: 0, weight: 1 }
}

/// Collects the sum segments of two regions.
pub struct Sums<'a> {
    a: &'a Smooth,
    b: &'a Smooth,
    rounding: Rounding,
    sites: [Sites<'a>; 2],
    vertices: HashMap<u64, u32>,
    edges: [u32; 2],
    pieces: Pieces,
    summands: Vec<[Summand; 2]>,
    /// Whether to leave out what cannot run forward on a crust: sums of lines, or of arcs and turns, with concave ones.
    pub forward_only: bool,
}

/// Pieces that are not yet part of a convolution, with what they are sums of.
pub struct Taken {
    /// The pieces.
    pub pieces: Vec<Piece>,
    /// Their summands.
    pub summands: Vec<[Summand; 2]>,
}

/// What a piece is the sum of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Summand {
    /// A vertex, or the turn there.
    Vertex(u32),
    /// A line or arc, by its loop and its place in the loop.
    Segment(u32, u32),
}

impl<'a> Sums<'a> {
    /// An empty collection for two regions, with the rounding of sum end points (memo A6).
    #[must_use]
    pub fn new(a: &'a Smooth, b: &'a Smooth, rounding: Rounding) -> Self {
        let edges = [a, b].map(|s| s.loops.iter().flat_map(|l| &l.segs).map(|s| s.edge + 1).max().unwrap_or(0));
        // There are as many sums at least, and seldom less than twice as many.
        let room = 2 * [a, b].map(|s| s.points.len()).into_iter().sum::<usize>();
        let pieces = Pieces { points: Vec::with_capacity(room), pieces: Vec::with_capacity(room), base: [0; 2] };
        Self {
            a,
            b,
            rounding,
            sites: [Sites::new(a), Sites::new(b)],
            vertices: HashMap::with_capacity_and_hasher(room, FxBuildHasher),
            edges,
            pieces,
            summands: Vec::with_capacity(room),
            forward_only: false,
        }
    }

    /// The two regions.
    #[must_use]
    pub fn regions(&self) -> (&'a Smooth, &'a Smooth) {
        (self.a, self.b)
    }

    /// How many pieces there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.pieces.pieces.len()
    }

    /// Takes back the pieces from this one on, with their summands.
    pub fn take_from(&mut self, first: usize) -> Taken {
        Taken { pieces: self.pieces.pieces.split_off(first), summands: self.summands.split_off(first) }
    }

    /// Adds a piece.
    pub fn push(&mut self, piece: Piece, summands: [Summand; 2]) {
        self.pieces.pieces.push(piece);
        self.summands.push(summands);
    }

    /// The vertices of the pieces.
    pub fn points(&mut self) -> &mut Vec<DVec2> {
        &mut self.pieces.points
    }

    /// One of the two regions.
    #[must_use]
    pub fn region(&self, operand: usize) -> &'a Smooth {
        [self.a, self.b][operand]
    }

    /// The abscissa of the sum of two vertices.
    #[must_use]
    pub fn corner_x(&self, p: u32, q: u32) -> f64 {
        self.rounding.sum(self.a.points[p as usize].x, 0.0, self.b.points[q as usize].x)
    }

    /// The vertex that is the sum of two vertices.
    pub fn corner(&mut self, p: u32, q: u32) -> u32 {
        self.vertex(p, q)
    }

    /// Adds a line or arc of B moved by a vertex of A, with its ends exchanged.
    pub fn reversed_by_vertex_of_a(&mut self, p: u32, y: Placed) {
        let [tail, head] = [y.seg.head, y.seg.tail].map(|v| self.corner(p, v));
        let source = Source { first: self.edges[0] + p, second: y.seg.edge };
        self.push(reversed(y.seg, tail, head, source), [Summand::Vertex(p), y.summand()]);
    }

    /// Adds a line or arc of A moved by a vertex of B, with its ends exchanged.
    pub fn reversed_by_vertex_of_b(&mut self, x: Placed, q: u32) {
        let [tail, head] = [x.seg.head, x.seg.tail].map(|v| self.corner(v, q));
        let source = Source { first: x.seg.edge, second: self.edges[1] + q };
        self.push(reversed(x.seg, tail, head, source), [x.summand(), Summand::Vertex(q)]);
    }

    /// The pieces collected, with the winding number far away.
    #[must_use]
    pub fn finish(mut self, base: i32) -> Pieces {
        self.pieces.base = [base, 0];
        self.pieces
    }

    /// The places inside arcs of each operand at which pieces end, in order.
    #[must_use]
    pub fn stops(&self) -> [Vec<Stop>; 2] {
        self.sites.each_ref().map(Sites::stops)
    }

    /// Adds a line of A and an arc or turn of B that has its angle.
    pub fn line_of_a(&mut self, line: Placed, other: Placed) {
        if self.forward_only && other.seg.delta < 0.0 {
            return;
        }
        let site = self.sites[1].site(other, line.seg.a);
        let ends = [line.seg.tail, line.seg.head].map(|v| self.vertex(v, site));
        self.line(ends, line, other.seg.delta, [line, other]);
    }

    /// Adds a line of B and an arc or turn of A that has its angle.
    pub fn line_of_b(&mut self, line: Placed, other: Placed) {
        if self.forward_only && other.seg.delta < 0.0 {
            return;
        }
        let site = self.sites[0].site(other, line.seg.a);
        let ends = [line.seg.tail, line.seg.head].map(|v| self.vertex(site, v));
        self.line(ends, line, other.seg.delta, [other, line]);
    }

    fn line(&mut self, [tail, head]: [u32; 2], line: Placed, delta: f64, summands: [Placed; 2]) {
        let forward = delta > 0.0;
        let (tail, head) = if forward { (tail, head) } else { (head, tail) };
        let normal = if forward { line.seg.a } else { line.seg.a.opposite() };
        let source = self.source(summands[0].seg, summands[1].seg);
        let piece = Piece::line(tail, head, normal, source);
        self.push(piece, summands.map(|placed| placed.summand()));
    }

    /// Adds a curved segment of A and one of B over their shared angles, counter-clockwise from `low` to `high`.
    /// At most one of them is a turn.
    pub fn curved(&mut self, x: Placed, y: Placed, low: Ang, high: Ang) {
        let is_concave_turn = |placed: &Placed| placed.seg.kind == Kind::Turn && placed.seg.delta < 0.0;
        if self.forward_only && (is_concave_turn(&x) || is_concave_turn(&y)) {
            return;
        }
        let [from, to] = [low, high].map(|angle| {
            let (p, q) = (self.sites[0].site(x, angle), self.sites[1].site(y, angle));
            self.vertex(p, q)
        });
        let radius = x.seg.r + y.seg.r;
        if radius.abs() <= TINY_RADIUS {
            self.tiny(from, to, x, y);
            return;
        }
        let source = self.source(x.seg, y.seg);
        let increasing = (x.seg.delta > 0.0) == (y.seg.delta > 0.0);
        let r = if increasing { radius.abs() } else { -radius.abs() };
        let half = 0.5 * low.turn_to(high);
        // The rightward normal is the shared angle where the sum runs as its larger summand does, else its opposite.
        let flip = |angle: Ang| if (r > 0.0) == (radius > 0.0) { angle } else { angle.opposite() };
        let (low, high) = (flip(low), flip(high));
        let piece = if increasing {
            Piece {
                tail: from,
                head: to,
                a: low,
                b: high,
                whole: [from, to],
                delta: half,
                r,
                source,
                operand: 0,
                weight: 1,
            }
        } else {
            Piece {
                tail: to,
                head: from,
                a: high,
                b: low,
                whole: [to, from],
                delta: -half,
                r,
                source,
                operand: 0,
                weight: 1,
            }
        };
        self.push(piece, [x.summand(), y.summand()]);
    }

    /// A circle of no size: its ends differ by rounding if at all. A line keeps the convolution closed.
    fn tiny(&mut self, from: u32, to: u32, x: Placed, y: Placed) {
        let (tail, head) = if x.seg.delta * y.seg.delta > 0.0 { (from, to) } else { (to, from) };
        if tail != head {
            let source = self.source(x.seg, y.seg);
            self.push(Piece::between(&self.pieces.points, tail, head, source), [x.summand(), y.summand()]);
        }
    }

    fn source(&self, x: &Seg, y: &Seg) -> Source {
        let place = |seg: &Seg, edges: u32| if seg.kind == Kind::Turn { edges + seg.tail } else { seg.edge };
        Source { first: place(x, self.edges[0]), second: place(y, self.edges[1]) }
    }

    fn vertex(&mut self, p: Site, q: Site) -> u32 {
        let next = self.pieces.points.len() as u32;
        let vertex = *self.vertices.entry(u64::from(p) << 32 | u64::from(q)).or_insert(next);
        if vertex == next {
            let point = match (self.sites[0].place(p), self.sites[1].place(q)) {
                (Place::Point(p), Place::Point(q)) => self.rounding.sum_points(p, DVec2::ZERO, q),
                (Place::Point(q), Place::On(arc, offset)) | (Place::On(arc, offset), Place::Point(q)) => {
                    arc.moved(offset, q, self.rounding)
                }
                // Does not occur: shared angles begin and end at an end of one of the summands.
                (Place::On(arc, offset), Place::On(_, (end, way))) => arc.moved(offset, end + way, self.rounding),
            };
            self.pieces.points.push(point);
        }
        vertex
    }
}
