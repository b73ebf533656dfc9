//! The exact offset of a polygon by a disc: CGAL's conic arcs, on CORE's algebraic numbers.
//!
//! The boundary lies on lines parallel to the edges and on circles around the vertices. All of these are known in rationals:
//! circles by centre and squared radius, lines as a x + b y = c + sqrt(d). A vertex is where two of them meet; it is told as
//! a rational point with a bound of how far each coordinate is off. [`Offset::carriers`] finds the edges and vertices that
//! the pieces belong to, and proves of each vertex that it is near both carriers.

use crate::bulge::bulge;
use crate::curved::Circle;
use crate::error::CgalError;
use crate::question::{Question, result};
use crate::text::{self, Loops, nonsense, number};
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::point::Point;
use arcsum_oracle::region::ring_edges;
use rug::float::Round;
use rug::{Float, Rational};
use std::time::Duration;

/// The exact offset of a region by a disc.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Offset {
    /// An outer loop and its holes, the interior on the left.
    pub region: Loops,
    /// The radius of the disc.
    pub radius: Rational,
}

/// A number that is known up to a bound.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Near {
    /// A number nearby.
    pub value: Rational,
    /// The distance of the two is at most this.
    pub off: Rational,
}

/// A boundary segment, at most half a turn long: where it begins, and its circle unless it is a line. It ends where the next
/// begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Abscissa and ordinate of its tail.
    pub tail: [Near; 2],
    /// Its circle.
    pub circle: Option<Circle>,
}

/// An offset, in input units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// The loops, the interior on their left.
    pub loops: Vec<Vec<Piece>>,
    /// How long CGAL took, until all vertices were computed.
    pub time: Duration,
}

/// The curve that a piece lies on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// The line a x + b y = c + sqrt(d), as [a, b, c, d]; the normal (a, b) points out of the region.
    Line([Rational; 4]),
    /// A circle.
    Circle(Circle),
}

impl Question for Offset {
    type Answer = Answer;

    fn line(&self) -> String {
        format!("offset-exact|{}|{}", self.radius, text::write(&self.region))
    }

    fn read(text: &str) -> Result<Answer, CgalError> {
        let (time, loops) = result(text)?;
        let loops = loops.split_terminator(';').map(ring).collect::<Result<_, _>>()?;
        Ok(Answer { loops, time: Duration::from_nanos(time) })
    }
}

fn ring(text: &str) -> Result<Vec<Piece>, CgalError> {
    let mut words = text.split_whitespace().peekable();
    let mut pieces = Vec::new();
    while words.peek().is_some() {
        let mut next = || number(words.next().unwrap_or_default());
        let tail = [Near { value: next()?, off: next()? }, Near { value: next()?, off: next()? }];
        let way = words.next().unwrap_or_default();
        let mut next = || number(words.next().unwrap_or_default());
        let circle = match way {
            "l" => None,
            "+" | "-" => {
                let centre = Point { x: next()?, y: next()? };
                Some(Circle { centre, squared_radius: next()?, left: way == "+" })
            }
            other => return Err(nonsense(other)),
        };
        pieces.push(Piece { tail, circle });
    }
    Ok(pieces)
}

impl Answer {
    /// The region with vertices and bulges rounded to the nearest doubles.
    #[must_use]
    pub fn to_plain(&self) -> PlainRegion {
        let float = |near: &Near| Float::with_val(256, &near.value);
        let corner = |(piece, next): (&Piece, &Piece)| {
            let [[x, y], [u, v]] = [piece, next].map(|p| p.tail.each_ref().map(float));
            let bend = piece.circle.as_ref().map_or(Bend::Line, |circle| {
                let [cx, cy] = [&circle.centre.x, &circle.centre.y].map(|c| Float::with_val(256, c));
                Bend::Bulge(bulge([&cx, &cy], [&x, &y], [&u, &v], circle.left))
            });
            Corner { x: x.to_f64(), y: y.to_f64(), bend }
        };
        PlainRegion {
            loops: self.loops.iter().map(|l| ring_edges(l).map(corner).collect()).collect(),
            unbounded: false,
        }
    }
}

impl Offset {
    /// The carrier of every piece of the answer to this question, loop by loop.
    ///
    /// # Errors
    /// [`CgalError::Nonsense`] for a circle that is none of the disc around a vertex, for a line that is no edge moved by the
    /// radius, and for a vertex that is certainly not on both of its carriers.
    pub fn carriers(&self, answer: &Answer) -> Result<Vec<Vec<Carrier>>, CgalError> {
        let lines: Vec<[Rational; 4]> =
            self.region.iter().flat_map(|ring| ring_edges(ring).map(|e| self.moved(e))).collect();
        let carrier = |(piece, next): (&Piece, &Piece)| match &piece.circle {
            Some(circle) => self.checked(circle, [piece, next]),
            None => {
                let through = |line: &&[Rational; 4]| {
                    is_forward(line, piece, next) && [piece, next].iter().all(|p| may_pass(line, &p.tail))
                };
                let line =
                    lines.iter().find(through).ok_or_else(|| nonsense("a line that is no edge moved by the radius"))?;
                Ok(Carrier::Line(line.clone()))
            }
        };
        answer.loops.iter().map(|ring| ring_edges(ring).map(carrier).collect()).collect()
    }

    /// The line of an edge moved out by the radius.
    fn moved(&self, (from, to): (&Point<Rational>, &Point<Rational>)) -> [Rational; 4] {
        let step = to.minus(from);
        let normal = Point { x: step.y, y: -step.x };
        let level = normal.dot(from);
        let square = normal.dot(&normal) * Rational::from(self.radius.square_ref());
        [normal.x, normal.y, level, square]
    }

    fn checked(&self, circle: &Circle, ends: [&Piece; 2]) -> Result<Carrier, CgalError> {
        let is_vertex = self.region.iter().flatten().any(|p| *p == circle.centre);
        let is_disc = circle.left && circle.squared_radius == Rational::from(self.radius.square_ref());
        let passes = |piece: &&Piece| may_be_on(circle, &piece.tail);
        if is_vertex && is_disc && ends.iter().all(passes) {
            return Ok(Carrier::Circle(circle.clone()));
        }
        Err(nonsense("a circle that is not the disc around a vertex"))
    }
}

/// Whether the piece runs along the line with the normal on its right.
fn is_forward(line: &[Rational; 4], piece: &Piece, next: &Piece) -> bool {
    let [a, b, ..] = line;
    let [dx, dy] = [0, 1].map(|i| Rational::from(&next.tail[i].value - &piece.tail[i].value));
    Rational::from(b * &dx) < Rational::from(a * &dy)
}

/// Whether a point within the bounds may be on the line: a x + b y - c and sqrt(d) as intervals.
fn may_pass([a, b, c, d]: &[Rational; 4], [x, y]: &[Near; 2]) -> bool {
    let height = Rational::from(a * &x.value) + Rational::from(b * &y.value) - c;
    let off = Rational::from(a.abs_ref()) * &x.off + Rational::from(b.abs_ref()) * &y.off;
    let root = |way| {
        let below = Float::with_val_round(512, d, way).0;
        Float::with_val_round(512, below.sqrt_ref(), way).0
    };
    Rational::from(&height - &off) <= root(Round::Up) && root(Round::Down) <= height + off
}

/// Whether a point within the bounds may be on the circle.
fn may_be_on(circle: &Circle, [x, y]: &[Near; 2]) -> bool {
    let [least, most] = [(x, &circle.centre.x), (y, &circle.centre.y)]
        .map(|(near, centre)| {
            let arm = Rational::from(&near.value - centre).abs();
            let inner = Rational::from(&arm - &near.off).max(Rational::new());
            [inner.square(), (arm + &near.off).square()]
        })
        .into_iter()
        .fold([Rational::new(), Rational::new()], |[lo, hi], [l, h]| [lo + l, hi + h]);
    least <= circle.squared_radius && circle.squared_radius <= most
}
