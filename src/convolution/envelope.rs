//! Envelopes: the highest, or lowest, of many x-monotone pieces at each abscissa (MS 6; memo E2).
//!
//! Divide and conquer. Two envelopes are merged by a sweep that has at most one piece of each at a time, so the crossing
//! module is asked about two pieces only and cannot be inconsistent. Where a piece comes out from behind another, it is cut
//! at its own ordinate; where two cross, both are cut at the same vertex.

use crate::arrangement::cross::CrossingModule;
use crate::arrangement::curve::Curve;
use crate::piece::Piece;
use glam::DVec2;

/// A part of a piece that is on the envelope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// The piece.
    pub piece: usize,
    /// Its left end, a vertex.
    pub left: u32,
    /// Its right end.
    pub right: u32,
}

/// The upper or lower envelope of some of these pieces, given by their places in the list, from left to right. None of them
/// is vertical. Of pieces that are equal the first is taken. Vertices are added where pieces are cut. Where there is no piece
/// there is no span.
pub fn envelope<M: CrossingModule>(
    points: &mut Vec<DVec2>,
    pieces: &[Piece],
    own: &[u32],
    upper: bool,
    module: &M,
) -> Vec<Span> {
    let mut spans = sorted(points, pieces, own);
    if !follow_each_other(points, &spans) {
        let mut curves = Curves { pieces, own, made: vec![None; own.len()] };
        let mut rows = rows(points, &spans);
        while rows.len() > 1 {
            let merged = rows.chunks(2).map(|pair| match pair {
                [first, second] => {
                    let parts = Vec::with_capacity(2 * (first.len() + second.len()));
                    Merge { points, curves: &mut curves, upper, module, parts }.run(first, second)
                }
                rest => rest.concat(),
            });
            rows = merged.collect();
        }
        spans = rows.pop().unwrap_or_default();
    }
    spans.iter_mut().for_each(|span| span.piece = own[span.piece] as usize);
    spans
}

/// The spans of whole pieces by their left ends, each with its place among these.
fn sorted(points: &[DVec2], pieces: &[Piece], own: &[u32]) -> Vec<Span> {
    let x = |vertex: u32| points[vertex as usize].x;
    let span = |(piece, k): (usize, &u32)| {
        let Piece { tail, head, .. } = pieces[*k as usize];
        let (left, right) = if x(tail) < x(head) { (tail, head) } else { (head, tail) };
        Span { piece, left, right }
    };
    let mut spans: Vec<Span> = own.iter().enumerate().map(span).collect();
    spans.sort_by(|s, t| x(s.left).total_cmp(&x(t.left)));
    spans
}

fn follow_each_other(points: &[DVec2], spans: &[Span]) -> bool {
    spans.windows(2).all(|pair| points[pair[0].right as usize].x <= points[pair[1].left as usize].x)
}

/// The curves of some pieces, made when asked for: most pieces are so far below the envelope that their boxes tell.
struct Curves<'a> {
    pieces: &'a [Piece],
    own: &'a [u32],
    made: Vec<Option<Curve>>,
}

impl Curves<'_> {
    /// Makes the curve of the piece with this place among the own ones, if it is not there.
    fn make(&mut self, points: &[DVec2], index: usize) {
        if self.made[index].is_none() {
            let piece = &self.pieces[self.own[index] as usize];
            let end = |v: u32| (v, points[v as usize]);
            let whole = piece.whole.map(|v| points[v as usize]);
            self.made[index] = Curve::new(0, piece, end(piece.tail), end(piece.head), whole);
        }
    }

    /// The least and the greatest ordinate of a piece.
    fn y_range(&self, points: &[DVec2], index: usize) -> [f64; 2] {
        let piece = &self.pieces[self.own[index] as usize];
        let [p, q] = [piece.tail, piece.head].map(|v| points[v as usize].y);
        [p.min(q), p.max(q)]
    }

    /// Whether one piece is below another, if their boxes tell.
    fn apart(&self, points: &[DVec2], f: usize, g: usize) -> Option<bool> {
        let [f, g] = [f, g].map(|index| self.y_range(points, index));
        (f[1] < g[0] || g[1] < f[0]).then_some(f[1] < g[0])
    }
}

/// Spans in as few rows as can be, each from left to right without overlap, from spans by their left ends.
fn rows(points: &[DVec2], spans: &[Span]) -> Vec<Vec<Span>> {
    let x = |vertex: u32| points[vertex as usize].x;
    let mut rows: Vec<Vec<Span>> = Vec::new();
    for &span in spans {
        match rows.iter_mut().find(|row| row.last().is_none_or(|last| x(last.right) <= x(span.left))) {
            Some(row) => row.push(span),
            None => {
                let mut row = Vec::with_capacity(spans.len());
                row.push(span);
                rows.push(row);
            }
        }
    }
    rows
}

/// Where a part ends.
#[derive(Clone, Copy, Debug, PartialEq)]
enum End {
    Vertex(u32),
    /// At an abscissa inside the piece.
    At(f64),
}

/// A part of a span.
#[derive(Clone, Copy, Debug)]
struct Part {
    piece: usize,
    ends: [End; 2],
    /// The abscissa of the right end.
    to: f64,
}

/// A merge of two envelopes.
struct Merge<'a, 'c, M> {
    points: &'a mut Vec<DVec2>,
    curves: &'a mut Curves<'c>,
    upper: bool,
    module: &'a M,
    parts: Vec<Part>,
}

impl<M: CrossingModule> Merge<'_, '_, M> {
    fn run(mut self, first: &[Span], second: &[Span]) -> Vec<Span> {
        let (mut i, mut j) = (0, 0);
        let mut x = f64::NEG_INFINITY;
        while let (Some(p), Some(q)) = (first.get(i), second.get(j)) {
            let [(p_from, p_to), (q_from, q_to)] = [p, q].map(|s| (self.x(s.left).max(x), self.x(s.right)));
            x = if p_to <= q_from || q_to <= p_from {
                let (span, from, to) = if p_to <= q_from { (p, p_from, p_to) } else { (q, q_from, q_to) };
                self.keep(span, from, to);
                to.min(p_from.max(q_from))
            } else if p_from == q_from {
                self.overlap(p, q, p_from, p_to.min(q_to));
                p_to.min(q_to)
            } else {
                let (span, from, to) = if p_from < q_from { (p, p_from, q_from) } else { (q, q_from, p_from) };
                self.keep(span, from, to);
                to
            };
            i += usize::from(p_to <= x);
            j += usize::from(q_to <= x);
        }
        for span in first[i..].iter().chain(&second[j..]) {
            self.keep(span, self.x(span.left).max(x), self.x(span.right));
        }
        self.finish()
    }

    fn x(&self, vertex: u32) -> f64 {
        self.points[vertex as usize].x
    }

    /// Adds the part of a span between two abscissas.
    fn keep(&mut self, span: &Span, from: f64, to: f64) {
        let end = |vertex: u32, x: f64| if self.x(vertex) == x { End::Vertex(vertex) } else { End::At(x) };
        let ends = [end(span.left, from), end(span.right, to)];
        self.push(Part { piece: span.piece, ends, to });
    }

    /// Adds a part, or lengthens the last one if this goes on where it ended.
    fn push(&mut self, part: Part) {
        match self.parts.last_mut() {
            Some(last) if last.piece == part.piece && last.ends[1] == part.ends[0] => {
                last.ends[1] = part.ends[1];
                last.to = part.to;
            }
            _ => self.parts.push(part),
        }
    }

    /// Adds the outer of two spans between two abscissas.
    fn overlap(&mut self, p: &Span, q: &Span, from: f64, to: f64) {
        if let Some(below) = self.curves.apart(self.points, p.piece, q.piece) {
            return self.outer(below, [p, q], (None, from), (None, to));
        }
        for span in [p, q] {
            self.curves.make(self.points, span.piece);
        }
        let [Some(f), Some(g)] = [p, q].map(|span| self.curves.made[span.piece].as_ref()) else { return };
        let exchanged = q.piece < p.piece;
        let answer = if exchanged { self.module.cross(g, f).exchanged() } else { self.module.cross(f, g) };
        let (mut below, mut start, mut end) = (answer.below, None, None);
        for crossing in answer.points() {
            let place = crossing.at;
            let [outer, next] = if below == self.upper { [q, p] } else { [p, q] };
            if place.x >= to {
                end = self.cut(place, to, outer.right);
                break;
            }
            if place.x > from {
                let vertex = self.add(place);
                self.outer(below, [p, q], (start, from), (Some(vertex), place.x));
                start = Some(vertex);
            } else {
                start = self.cut(place, from, next.left);
            }
            below = !below;
        }
        self.outer(below, [p, q], (start, from), (end, to));
    }

    /// The vertex that takes the place of the end of a piece where another one crosses it so near by that the abscissa is the
    /// same but for rounding. What is left beyond would be behind the other one, and on a steep piece it may be long.
    fn cut(&mut self, place: DVec2, x: f64, end: u32) -> Option<u32> {
        let own = self.points[end as usize];
        (place.x == x && own.x == x && own.y != place.y).then(|| self.add(place))
    }

    fn add(&mut self, place: DVec2) -> u32 {
        self.points.push(place);
        (self.points.len() - 1) as u32
    }

    /// Adds the outer of two spans, given whether the first is below, between two ends: vertices, or abscissas.
    fn outer(&mut self, below: bool, [p, q]: [&Span; 2], from: (Option<u32>, f64), to: (Option<u32>, f64)) {
        let span = if below == self.upper { q } else { p };
        let end = |own: u32, (vertex, x): (Option<u32>, f64)| match vertex {
            Some(vertex) => End::Vertex(vertex),
            None if self.x(own) == x => End::Vertex(own),
            None => End::At(x),
        };
        let from = match from {
            (Some(vertex), _) => End::Vertex(vertex),
            from => end(span.left, from),
        };
        let part = Part { piece: span.piece, ends: [from, end(span.right, to)], to: to.1 };
        self.push(part);
    }

    /// The parts with vertices where they are cut.
    fn finish(self) -> Vec<Span> {
        let (points, curves) = (self.points, self.curves);
        let mut vertex = |piece: usize, end: End| match end {
            End::Vertex(vertex) => vertex,
            End::At(x) => {
                curves.make(points, piece);
                points.push(DVec2::new(x, curves.made[piece].as_ref().map_or(0.0, |c| c.y_at(x))));
                (points.len() - 1) as u32
            }
        };
        let span = |part: &Part| {
            let [left, right] = part.ends.map(|end| vertex(part.piece, end));
            Span { piece: part.piece, left, right }
        };
        self.parts.iter().map(span).collect()
    }
}
