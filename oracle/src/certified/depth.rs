//! How deep two regions overlap: the measures of falsely free points (memo F), all in the unit of the coordinates.
//!
//! For A and t - B:
//! - `rho`, the inradius of the intersection. If it is greater than mu, no mu-perturbation of the regions is free of overlap:
//!   t is falsely free. The distance of a point of the intersection to the boundaries of both regions is the one to the
//!   intersection's own boundary, so the search of [`super::reach`] over the trapezoids of the intersection brackets it.
//! - `pd`, the penetration depth: the distance of t to the free space, that is to the boundary of the sum. If it is at most mu,
//!   a translation shows t to be innocent. Slits of the free space without width do not count.
//! - `trap`, the number of MS 8.3: the size of the largest trapezoid of the intersection.
//!
//! A disc of radius rho inside both regions must be moved by 2 rho to leave itself, so 2 rho <= pd.

use std::sync::Arc;

use rug::Rational;

use super::curve::Curve;
use super::membership::{Membership, State};
use super::nearest::{FINE, Nearest};
use super::piece::Piece;
use super::precision::Precision;
use super::reach::Reach;
use super::real::Real;
use super::reference::scaled;
use super::shape::Shape;
use super::slabs::{Layer, Trapezoid, intersection};
use super::spot::Spot;
use super::strips::Span;
use super::vector::Vector;
use crate::error::OracleError;
use crate::interval::Interval;
use crate::plain::PlainRegion;
use crate::point::Point;
use crate::region::ExactRegion;

/// An inradius is not refined further when it is this well known.
const FLOOR: f64 = 1.0 / (1u64 << 60) as f64;

/// Contacts are told from overlaps with numbers of this precision: a few times what the predicates need of doubles.
const LIMIT: Precision = Precision::LADDER[3];

/// What the places where curves meet may hide ([`super::meet::CLUSTER`]), with room to spare.
const HIDDEN: f64 = 1.0 / (1u128 << 80) as f64;

/// Two regions and the boundary of their sum.
#[derive(Clone, Debug)]
pub struct Summed {
    shapes: [Shape; 2],
    boundary: Vec<Arc<Curve>>,
    /// How far the boundary may be from that of the sum.
    blur: f64,
}

impl Summed {
    /// Two regions and the boundary of their sum, which may be `blur` off.
    #[must_use]
    pub fn new(shapes: [Shape; 2], boundary: Vec<Arc<Curve>>, blur: f64) -> Self {
        Self { shapes, boundary, blur }
    }

    /// Two polygons and their exact sum, all in input units; `unit` is the unit box's side, a power of two. Questions about
    /// them are asked and answered in the unit box.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for numbers that are no regions or not representable in the unit box.
    pub fn of_polygons([a, b]: [&PlainRegion; 2], sum: &ExactRegion<Rational>, unit: f64) -> Result<Self, OracleError> {
        let shape = |region| scaled(region, unit).and_then(|region| Shape::new(&region));
        let Some(side) = Rational::from_f64(unit).filter(|side| *side > 0) else {
            return Err(OracleError::BadNumber { ring: 0, vertex: 0, reason: "the unit is not positive" });
        };
        let in_box = |p: &Point<Rational>| [&p.x, &p.y].map(|c| Rational::from(c / &side));
        let edge = |(from, to)| Arc::new(line([in_box(from), in_box(to)]));
        Ok(Self::new([shape(a)?, shape(b)?], sum.edges().map(edge).collect(), 0.0))
    }

    pub(super) fn blur(&self) -> f64 {
        self.blur
    }
}

/// Two regions prepared for questions about many translates.
pub struct Depths<'a> {
    membership: Membership,
    first: Vec<Span>,
    second: Vec<Arc<Curve>>,
    bases: [i32; 2],
    boundary: Nearest<'a>,
    blur: f64,
}

/// The overlap of A and t - B.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// The inradius, a bracket that is at most 1/32 of it or 2^-60 wide unless the search is given up.
    pub rho: Interval,
    /// The size of the largest trapezoid, a float; NaN if the regions cannot be cut into trapezoids.
    pub trap: f64,
}

/// What is known about a translate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// Blocked, free, or too near to contact to tell.
    pub state: State,
    /// The inradius of the overlap; 0 if free, from 0 up if undecided.
    pub rho: Interval,
    /// The penetration depth; 0 if free, from 0 up if undecided.
    pub pd: Interval,
    /// The size of the largest trapezoid of the overlap, a float; 0 if free, NaN if undecided.
    pub trap: f64,
}

impl<'a> Depths<'a> {
    /// Prepares two regions.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn new(sum: &'a Summed) -> Result<Self, OracleError> {
        let [a, b] = &sum.shapes;
        Ok(Self {
            membership: Membership::new(a, b),
            first: a.sides().map(|side| Span::from(&side.curve)).collect(),
            second: b.sides().map(|side| Arc::clone(&side.curve)).collect(),
            bases: [a, b].map(|shape| i32::from(shape.unbounded)),
            boundary: Nearest::new(&sum.boundary)?,
            blur: sum.blur,
        })
    }

    /// Whether t is blocked or free; contacts, and what 512 bits do not tell from them, are undecided.
    #[must_use]
    pub fn state(&self, t: &Spot) -> State {
        self.membership.state_within(t, LIMIT)
    }

    /// The same as far as doubles tell.
    #[must_use]
    pub fn rough_state(&self, t: &Spot) -> State {
        self.membership.state_within(t, Precision::DOUBLE)
    }

    /// The penetration depth of a blocked t; infinite if nothing is free.
    #[must_use]
    pub fn pd(&self, t: &Spot) -> Interval {
        let Some((distance, _)) = self.boundary.distance(&t.at(FINE)) else {
            return Interval::point(f64::INFINITY);
        };
        let blur = Interval::new(-self.blur, self.blur);
        let pd = distance.enclosure() + blur;
        Interval::new(pd.lo().max(0.0), pd.hi())
    }

    /// The overlap of A and t - B for a blocked t of this penetration depth.
    ///
    /// # Errors
    /// [`OracleError::Inconsistent`] for boundaries that do not close or if 2 rho is greater than pd,
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn overlap(&self, t: &Spot, pd: Interval) -> Result<Overlap, OracleError> {
        if self.bases == [1, 1] {
            return Ok(Overlap { rho: Interval::point(f64::INFINITY), trap: f64::INFINITY });
        }
        let most = (0.5 * pd.hi()).next_up();
        let second: Vec<Span> = self.second.iter().map(|curve| Span::from(&mirrored(curve, t))).collect();
        let layers = [(&self.first, 0), (&second, 1)].map(|(pieces, i)| Layer { pieces, base: self.bases[i] });
        let Some(found) = intersection(layers)? else {
            return Ok(Overlap { rho: Interval::new(0.0, most), trap: f64::NAN });
        };
        let [common, _] = &found.parts;
        let rho = inradius(common, &found.edges.concat(), found.blur)?;
        if rho.lo() > most {
            return Err(OracleError::Inconsistent("an overlap is deeper than the sum"));
        }
        let trap = common.iter().map(size).fold(0.0, f64::max);
        Ok(Overlap { rho: Interval::new(rho.lo(), rho.hi().min(most)), trap })
    }

    /// All measures of t.
    ///
    /// # Errors
    /// As [`Self::overlap`].
    pub fn probe(&self, t: &Spot) -> Result<Probe, OracleError> {
        let state = self.state(t);
        if state == State::Free {
            return Ok(Probe { state, rho: Interval::ZERO, pd: Interval::ZERO, trap: 0.0 });
        }
        let pd = self.pd(t);
        if state == State::Undecided {
            let up_to = |most: f64| Interval::new(0.0, most);
            return Ok(Probe { state, rho: up_to((0.5 * pd.hi()).next_up()), pd: up_to(pd.hi()), trap: f64::NAN });
        }
        let Overlap { rho, trap } = self.overlap(t, pd)?;
        Ok(Probe { state, rho, pd, trap })
    }
}

/// The greatest distance from the boundary over the parts of an intersection.
fn inradius(parts: &[Trapezoid], boundary: &[Arc<Curve>], blur: f64) -> Result<Interval, OracleError> {
    let boundary = Nearest::new(boundary)?;
    let mut search = Reach::new(&boundary, parts);
    let hi = search.refine(0.0, FLOOR);
    let lo = search.reached().0;
    let hidden = blur + HIDDEN;
    let rho = Interval::new(lo, hi.max(lo)) + Interval::new(-hidden, hidden);
    Ok(Interval::new(rho.lo().max(0.0), rho.hi()))
}

/// The curve turned by half a turn and moved: t - p for its points p.
fn mirrored(curve: &Arc<Curve>, t: &Spot) -> Arc<Curve> {
    let (curve, t) = (Arc::clone(curve), t.clone());
    Arc::new(Curve::new(move |precision| curve.at(precision).mirrored(&t.at(precision))))
}

/// The line between two points.
fn line(ends: [[Rational; 2]; 2]) -> Curve {
    Curve::new(move |precision| {
        let [from, to] =
            ends.each_ref().map(|[x, y]| Vector { x: Real::rational(x, precision), y: Real::rational(y, precision) });
        Piece { from, to, circle: None }
    })
}

/// The lesser of the width of a trapezoid and its height half way (MS 8).
fn size(trapezoid: &Trapezoid) -> f64 {
    let [left, right] = trapezoid.x.clone().map(|end| Real::from(end).rounded(FINE));
    let middle = (&left + &right) * 0.5;
    let [low, high] = trapezoid.walls.each_ref().map(|wall| wall.at(FINE).ordinate(&middle));
    (high - low).mid().min((right - left).mid())
}
