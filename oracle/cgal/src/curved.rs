//! Regions of line and circle segments: offsets of polygons by a disc, and set operations. CGAL computes both exactly with
//! coordinates p + q sqrt(r), centres and squared radii that are rational; of an offset, the lines are approximated.

use crate::bulge::bulge;
use crate::error::CgalError;
use crate::question::{Question, points, result};
use crate::text::{self, Loops, nonsense, number};
use arcsum_oracle::boolean::Operation;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::point::Point;
use arcsum_oracle::region::ring_edges;
use rug::{Float, Rational};
use std::fmt::Write;
use std::time::Duration;

/// The offset of a region by a disc.
#[derive(Clone, Debug, PartialEq)]
pub struct Offset {
    /// An outer loop and its holes, the interior on the left.
    pub region: Loops,
    /// The radius of the disc.
    pub radius: Rational,
    /// How far CGAL's lines may be from the exact ones, in input units.
    pub error: f64,
}

/// A set operation on two regions of lines and arcs, each an outer loop and its holes.
#[derive(Clone, Debug, PartialEq)]
pub struct Combine {
    operation: Operation,
    a: String,
    b: String,
}

impl Combine {
    /// The question, for regions whose doubles and bulges are taken literally.
    ///
    /// # Errors
    /// [`CgalError::Refused`] for unbounded regions, numbers that are not finite, and arcs given by a radius, whose centres
    /// are not rational.
    pub fn new(operation: Operation, a: &PlainRegion, b: &PlainRegion) -> Result<Self, CgalError> {
        Ok(Self { operation, a: curved_text(a)?, b: curved_text(b)? })
    }
}

/// A coordinate p + q sqrt(r).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coordinate([Rational; 3]);

impl Coordinate {
    /// The value, p and q sqrt(r) computed to 256 bits.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.to_float().to_f64()
    }

    fn to_float(&self) -> Float {
        let [p, q, r] = self.0.each_ref().map(|part| Float::with_val(256, part));
        p + q * r.sqrt()
    }
}

/// A circle segment's circle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Circle {
    /// The centre.
    pub centre: Point<Rational>,
    /// The radius, squared.
    pub squared_radius: Rational,
    /// Whether the segment runs counter-clockwise.
    pub left: bool,
}

/// A boundary segment, monotone in x: where it begins, and its circle unless it is a line. It ends where the next begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Abscissa and ordinate of its tail.
    pub tail: [Coordinate; 2],
    /// Its circle.
    pub circle: Option<Circle>,
}

/// A region of line and circle segments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Curved {
    /// The loops, the interior on their left.
    pub loops: Vec<Vec<Edge>>,
    /// How long CGAL took, until the result was exact.
    pub time: Duration,
}

impl Curved {
    /// The area, in doubles.
    #[must_use]
    pub fn area(&self) -> f64 {
        let edges =
            |ring: &[Edge]| -> f64 { (0..ring.len()).map(|i| under(&ring[i], &ring[(i + 1) % ring.len()])).sum() };
        self.loops.iter().map(|ring| edges(ring)).sum()
    }

    /// The region with vertices and bulges rounded to the nearest doubles.
    #[must_use]
    pub fn to_plain(&self) -> PlainRegion {
        let loops = self.loops.iter().map(|ring| ring_edges(ring).map(|(edge, next)| edge.corner(next)).collect());
        PlainRegion { loops: loops.collect(), unbounded: false }
    }
}

impl Edge {
    /// Its tail with the way to the next edge, in doubles.
    fn corner(&self, next: &Self) -> Corner {
        let [[x, y], [u, v]] = [self, next].map(|edge| edge.tail.each_ref().map(Coordinate::to_float));
        let bend = self.circle.as_ref().map_or(Bend::Line, |circle| {
            let [cx, cy] = [&circle.centre.x, &circle.centre.y].map(|c| Float::with_val(256, c));
            Bend::Bulge(bulge([&cx, &cy], [&x, &y], [&u, &v], circle.left))
        });
        Corner { x: x.to_f64(), y: y.to_f64(), bend }
    }
}

/// The signed area between an edge and the origin: the triangle of its chord and the cap beyond it. An edge monotone in x
/// turns by half a turn at most.
fn under(edge: &Edge, next: &Edge) -> f64 {
    let [[x0, y0], [x1, y1]] = [edge, next].map(|e| e.tail.each_ref().map(Coordinate::to_f64));
    let triangle = 0.5 * (x0 * y1 - x1 * y0);
    let Some(circle) = &edge.circle else { return triangle };
    let squared = circle.squared_radius.to_f64();
    let angle = 2.0 * (0.5 * (x1 - x0).hypot(y1 - y0) / squared.sqrt()).min(1.0).asin();
    let cap = 0.5 * squared * (angle - angle.sin());
    if circle.left { triangle + cap } else { triangle - cap }
}

impl Question for Offset {
    type Answer = Curved;

    fn line(&self) -> String {
        format!("offset|{:e}|{}|{}", self.error, self.radius, text::write(&self.region))
    }

    fn read(text: &str) -> Result<Curved, CgalError> {
        read(text)
    }
}

impl Question for Combine {
    type Answer = Curved;

    fn line(&self) -> String {
        format!("combine|{:?}|{}|{}", self.operation, self.a, self.b)
    }

    fn read(text: &str) -> Result<Curved, CgalError> {
        read(text)
    }
}

/// A region in the text of the C ABI.
fn curved_text(region: &PlainRegion) -> Result<String, CgalError> {
    let mut text = String::new();
    for (ring, corners) in points(region)?.iter().zip(&region.loops) {
        for (i, corner) in corners.iter().enumerate() {
            let (from, to) = (&ring[i], &ring[(i + 1) % ring.len()]);
            let _ = write!(text, "{} {} {} ", from.x, from.y, way(corner.bend, from, to)?);
        }
        text.push(';');
    }
    Ok(text)
}

/// The way along a bend. The centre of a bulge b = tan(sweep/4) is off the chord's middle by (1 - b²) / 4b chords, to the
/// left if positive.
fn way(bend: Bend, from: &Point<Rational>, to: &Point<Rational>) -> Result<String, CgalError> {
    let bulge = match bend {
        Bend::Line => return Ok("l".into()),
        Bend::Radius(_) => return Err(CgalError::Refused("an arc given by its radius".into())),
        Bend::Bulge(bulge) => Rational::from_f64(bulge),
    };
    let Some(bulge) = bulge else { return Err(CgalError::Refused("a bulge that is not finite".into())) };
    if bulge.is_zero() {
        return Ok("l".into());
    }
    let off = (1 - Rational::from(bulge.square_ref())) / Rational::from(4 * &bulge);
    let chord = to.minus(from);
    let normal = Point { x: -chord.y.clone(), y: chord.x.clone() };
    let centre = from.plus(&chord.times(&Rational::from((1, 2)))).plus(&normal.times(&off));
    let sign = if bulge.is_positive() { '+' } else { '-' };
    Ok(format!("{sign} {} {}", centre.x, centre.y))
}

fn read(text: &str) -> Result<Curved, CgalError> {
    let (time, loops) = result(text)?;
    let loops = loops.split_terminator(';').map(read_ring).collect::<Result<_, _>>()?;
    Ok(Curved { loops, time: Duration::from_nanos(time) })
}

fn read_ring(text: &str) -> Result<Vec<Edge>, CgalError> {
    let mut words = text.split_whitespace().peekable();
    let mut ring = Vec::new();
    while words.peek().is_some() {
        let mut numbers = |count: usize| -> Result<Vec<Rational>, CgalError> {
            (0..count).map(|_| number(words.next().unwrap_or_default())).collect()
        };
        let tail = numbers(6)?;
        let way = words.next().unwrap_or_default();
        let circle = match way {
            "l" => None,
            "+" | "-" => {
                let mut number = || number(words.next().unwrap_or_default());
                let centre = Point { x: number()?, y: number()? };
                Some(Circle { centre, squared_radius: number()?, left: way == "+" })
            }
            other => return Err(nonsense(other)),
        };
        let [x, y] = [0, 3].map(|i| Coordinate([tail[i].clone(), tail[i + 1].clone(), tail[i + 2].clone()]));
        ring.push(Edge { tail: [x, y], circle });
    }
    Ok(ring)
}
