//! A piece seen from left to right: the x-monotone curve the sweep works with (memo C1).
//!
//! Evaluation never uses a centre or a radius. With `t`, `h` the left and right end and `s`, `c` sine and cosine of the
//! half sweep, the curve is the zero set of
//! `F(p) = c (p-t) x (h-p) - s (p-t) . (h-p)`, and `-F / |h-t|` is the signed distance above it to first order.

use crate::angle::Ang;
use crate::piece::Piece;
use crate::twofold::two_sum;
use glam::DVec2;
use std::cmp::Ordering;

/// An x-monotone line or circle segment, or a vertical line taken from bottom to top.
#[derive(Clone, Copy, Debug)]
pub struct Curve {
    /// First point of the part the sweep still has before it, and its vertex.
    pub start: DVec2,
    /// Vertex of `start`.
    pub first: u32,
    /// Right (upper) end of the part, and its vertex.
    pub end: DVec2,
    /// Vertex of `end`.
    pub last: u32,
    /// Left (of a vertical: lower) end of the whole piece.
    pub left: DVec2,
    /// Right (upper) end.
    pub right: DVec2,
    /// Half sweep of the whole piece from left to right: positive when it bends to the left (upwards).
    pub delta: f64,
    /// Normal angle at `start` of the traversal from left to right, and at the right end.
    pub normals: [Ang; 2],
    /// What crossing the curve upwards adds to the winding numbers of the two operands.
    pub weight: [i32; 2],
    /// The piece this is, or is part of.
    pub piece: u32,
    low: f64,
    high: f64,
    sin: f64,
    cos: f64,
    inverse_length: f64,
}

/// Lexicographic order of points, the order of events.
#[must_use]
pub fn compare(p: DVec2, q: DVec2) -> Ordering {
    by_size(p.x, q.x).then_with(|| by_size(p.y, q.y))
}

/// The total order of numbers, quick where they differ.
#[must_use]
pub fn by_size(x: f64, y: f64) -> Ordering {
    if x < y {
        Ordering::Less
    } else if x > y {
        Ordering::Greater
    } else {
        x.total_cmp(&y)
    }
}

impl Curve {
    /// The curve of a piece with these two end points, part of a whole with those; `None` if they coincide. An arc on a
    /// vertical chord becomes a line: its x extent has been rounded away, so its sagitta is below one rounding as well.
    #[must_use]
    pub fn new(
        index: u32,
        piece: &Piece,
        tail: (u32, DVec2),
        head: (u32, DVec2),
        [whole_tail, whole_head]: [DVec2; 2],
    ) -> Option<Self> {
        if tail.0 == head.0 {
            return None;
        }
        let forward = compare(tail.1, head.1).is_lt();
        let (from, to) = if forward { (tail, head) } else { (head, tail) };
        let (left, right) = if forward { (whole_tail, whole_head) } else { (whole_head, whole_tail) };
        let chord = right - left;
        let signed = if forward { piece.delta } else { -piece.delta };
        let delta = if chord.x == 0.0 { 0.0 } else { signed };
        let normals = match (chord.x == 0.0, forward) {
            (true, _) => [Ang::RIGHT; 2],
            (false, true) => [piece.a, piece.b],
            (false, false) => [piece.b.opposite(), piece.a.opposite()],
        };
        let mut weight = [0; 2];
        weight[usize::from(piece.operand)] = if forward { piece.weight } else { -piece.weight };
        Some(Self {
            start: from.1,
            first: from.0,
            end: to.1,
            last: to.0,
            left,
            right,
            delta,
            normals,
            weight,
            piece: index,
            low: from.1.y.min(to.1.y),
            high: from.1.y.max(to.1.y),
            sin: libm::sin(delta),
            cos: libm::cos(delta),
            inverse_length: libm::hypot(chord.x, chord.y).recip(),
        })
    }

    /// The part of this line that begins at vertex `first`, a point on it.
    #[must_use]
    pub fn from_vertex(&self, first: u32, start: DVec2) -> Self {
        Self { first, start, ..*self }
    }

    /// The same curve as another piece.
    #[must_use]
    pub fn named(mut self, piece: u32) -> Self {
        self.piece = piece;
        self
    }

    /// The curve moved. Its ends are rounded; its sweep and length are taken to stay the same.
    #[must_use]
    pub fn moved(&self, by: DVec2) -> Self {
        Self {
            start: self.start + by,
            end: self.end + by,
            left: self.left + by,
            right: self.right + by,
            low: self.low + by.y,
            high: self.high + by.y,
            ..*self
        }
    }

    /// Whether this is a straight line.
    #[must_use]
    pub fn is_line(&self) -> bool {
        self.delta == 0.0
    }

    /// Whether this is a vertical line.
    #[must_use]
    pub fn is_vertical(&self) -> bool {
        self.left.x == self.right.x
    }

    /// Whether this is a line so steep that the rounding of x shows in y; true of verticals.
    #[must_use]
    pub fn is_steep_line(&self) -> bool {
        self.is_line() && is_steep(self.chord())
    }

    /// Least and greatest ordinate of the whole piece.
    #[must_use]
    pub fn y_range(&self) -> (f64, f64) {
        (self.low, self.high)
    }

    /// Chord from left to right.
    #[must_use]
    pub fn chord(&self) -> DVec2 {
        self.right - self.left
    }

    /// Unit normal at the left end, pointing down, and half the curvature: the curve is
    /// `n.(p-left) + k |p-left|^2 = 0` (memo C1, implicit form).
    #[must_use]
    pub fn implicit(&self) -> (DVec2, f64) {
        let c = self.chord();
        let m = DVec2::new(self.cos * c.y - self.sin * c.x, -self.cos * c.x - self.sin * c.y);
        (m * self.inverse_length, self.sin * self.inverse_length)
    }

    /// Ordinate at `x`, which should lie in the x range; of a vertical, its lower end. Error at most about 2 eps times the
    /// length, divided by the sine of the normal where the curve is steep.
    #[must_use]
    pub fn y_at(&self, x: f64) -> f64 {
        let c = self.chord();
        let (base, offset) = if x - self.left.x <= self.right.x - x {
            (self.left.y, solve(c.x, c.y, self.sin, self.cos, x - self.left.x))
        } else {
            (self.right.y, solve(-c.x, -c.y, -self.sin, self.cos, x - self.right.x))
        };
        (base + offset).clamp(self.low, self.high)
    }

    /// Abscissa at ordinate `y`, by the same formula with the axes exchanged.
    #[must_use]
    pub fn x_at(&self, y: f64) -> f64 {
        self.twofold_x_at(y).0.clamp(self.left.x, self.right.x)
    }

    /// Abscissa at ordinate `y` and its error: the distance from the nearer end is right to a few eps of itself.
    #[must_use]
    pub fn twofold_x_at(&self, y: f64) -> (f64, f64) {
        let c = self.chord();
        if (y - self.left.y).abs() <= (self.right.y - y).abs() {
            two_sum(self.left.x, solve(c.y, c.x, -self.sin, self.cos, y - self.left.y))
        } else {
            two_sum(self.right.x, solve(-c.y, -c.x, self.sin, self.cos, y - self.right.y))
        }
    }

    /// A vector normal to the curve at a point of it.
    #[must_use]
    pub fn gradient(&self, p: DVec2) -> DVec2 {
        let (normal, half_curvature) = self.implicit();
        normal + 2.0 * half_curvature * (p - self.left)
    }

    /// How far `p` lies above the curve, vertically, for `p` within the x range; 0 on the line of a vertical. As a
    /// difference of ordinates it orders curves at one abscissa consistently, however steep they are.
    #[must_use]
    pub fn above(&self, p: DVec2) -> f64 {
        if self.is_vertical() { 0.0 } else { p.y - self.y_at(p.x) }
    }

    /// Signed distance of `p` from the curve, positive above, for `p` within the x range: right in sign up to a few eps of
    /// distance, and never larger in size than the distance by more than a few eps. 0 on the line of a vertical.
    #[must_use]
    pub fn side(&self, p: DVec2) -> f64 {
        if self.is_vertical() {
            return 0.0;
        }
        // Outside the box the rest of the circle would confuse the sign, and a steep line, extended, would seem close.
        let q = DVec2::new(p.x, p.y.clamp(self.low, self.high));
        let inside = self.offset(q);
        match p.y - q.y {
            d if d > 0.0 => d.max(inside),
            d if d < 0.0 => d.min(inside),
            _ => inside,
        }
    }

    fn offset(&self, p: DVec2) -> f64 {
        let (u, v) = (p - self.left, self.right - p);
        let cross = u.x * v.y - u.y * v.x;
        if self.sin == 0.0 {
            return -cross * self.inverse_length;
        }
        (self.sin * (u.x * v.x + u.y * v.y) - self.cos * cross) * self.inverse_length
    }
}

/// Where the ordinate along a direction changes this many times faster than the abscissa, the rounding of x shows in y. Any
/// small number serves: below it an error of a few eps in x is one of a few tens of eps in y.
const STEEP: f64 = 8.0;

/// Whether a direction is steep.
#[must_use]
pub fn is_steep(direction: DVec2) -> bool {
    direction.y.abs() > STEEP * direction.x.abs()
}

/// Solves `s Y^2 - B Y + C0 = 0` for the ordinate Y over the abscissa `x`, both measured from one end of a curve with chord
/// (cx, cy) (memo C1). Chooses the root that vanishes with `x`.
fn solve(cx: f64, cy: f64, s: f64, c: f64, x: f64) -> f64 {
    if s == 0.0 {
        return if cx == 0.0 { 0.0 } else { x * cy / cx };
    }
    let b = s * cy + c * cx;
    let c0 = c * x * cy - s * x * (cx - x);
    let root = (b * b - 4.0 * s * c0).max(0.0).sqrt();
    let denominator = b + root.copysign(cx);
    if denominator == 0.0 { 0.0 } else { 2.0 * c0 / denominator }
}

/// Order of two curves that start at the same vertex, just to the right of it: by direction, then curvature. `Equal` means
/// that they cannot be told apart there.
#[must_use]
pub fn order_at_start(f: &Curve, g: &Curve) -> Ordering {
    if f.is_line() && g.is_line() { by_chord(f, g) } else { by_normal_at_start(f, g) }
}

/// The same by the normals of the pieces. Among lines and arcs at one vertex it is the order that is transitive: where a
/// line goes on as an arc their normals are equal and the curvature decides, while the chord's would differ by rounding.
#[must_use]
pub fn by_normal_at_start(f: &Curve, g: &Curve) -> Ordering {
    direction(f.normals[0]).cmp(&direction(g.normals[0])).then(by_curvature(f, g))
}

/// Order of two curves that end at the same vertex, just to the left of it.
#[must_use]
pub fn order_at_end(f: &Curve, g: &Curve) -> Ordering {
    if f.is_line() && g.is_line() {
        return by_chord(g, f);
    }
    direction(g.normals[1]).cmp(&direction(f.normals[1])).then(by_curvature(f, g))
}

/// Order of two lines to the right of a common point. The normal of a steep piece is as good in angle as that of its chord,
/// but the rounding of the ends moves the line by far more in y than across, so the chord's counts.
fn by_chord(f: &Curve, g: &Curve) -> Ordering {
    let [f, g] = [f, g].map(|line| {
        let chord =
            if line.is_steep_line() && !line.is_vertical() { Ang::of_line(line.left, line.right) } else { None };
        direction(chord.unwrap_or(line.normals[0]))
    });
    f.cmp(&g)
}

fn by_curvature(f: &Curve, g: &Curve) -> Ordering {
    (f.sin * f.inverse_length).total_cmp(&(g.sin * g.inverse_length))
}

/// Sort key of the normal of a traversal to the right, which lies between 180 degrees (straight down) and 360 (straight
/// up, stored as 0). A piece a few roundings long may claim a normal outside; it counts as the nearer end.
fn direction(normal: Ang) -> (bool, Ang) {
    if normal <= Ang::UP { (true, Ang::RIGHT) } else { (false, normal.max(Ang::LEFT)) }
}
