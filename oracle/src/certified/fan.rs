//! The normals of a boundary: fans of directions, and the boundary point that has each of them as its outward normal.
//!
//! An arc has a fan of one quadrant; a convex corner has the cone between the normals of the two pieces that meet there,
//! cut at the axes; a line is a single direction. A reflex corner and a smooth joint have none. At a corner whose two
//! pieces leave in exactly the same direction the cone is half a turn: it is included whether the corner is a spike or a
//! notch, since a superset of the sum curves does no harm.

use std::cmp::Ordering;
use std::sync::Arc;

use super::curve::Curve;
use super::direction::{Direction, End};
use super::piece::Circle;
use super::precision::Precision;
use super::real::Real;
use super::shape::{Shape, Side};
use super::vector::Vector;

/// A part of a boundary: a piece of a loop or the corner at its start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Index of the loop.
    pub ring: usize,
    /// Index of the piece within the loop.
    pub side: usize,
    /// Whether the corner where the piece starts is meant.
    pub corner: bool,
}

/// The centre and signed radius of a part: the point with the unit normal n is c + r n.
pub struct Round {
    /// The centre of an arc, a corner itself.
    pub centre: Vector,
    /// Positive for a convex arc, negative for a concave one, 0 for a corner.
    pub radius: Real,
}

/// Directions of one closed quadrant, each the outward normal at one point of a part.
#[derive(Clone, Debug)]
pub struct Fan {
    /// The part.
    pub part: Part,
    /// The quadrant: counter-clockwise from the axis of this index.
    pub quadrant: usize,
    /// The first direction, counter-clockwise.
    pub low: Direction,
    /// The last direction.
    pub high: Direction,
    /// The arc, or the piece that starts at the corner.
    curve: Arc<Curve>,
}

/// A point of a fan.
#[derive(Clone, Debug)]
pub enum Spoke {
    /// That of its first direction.
    Low,
    /// That of its last direction.
    High,
    /// That of any direction.
    Along(Direction),
}

/// A straight piece and its normal.
#[derive(Clone, Debug)]
pub struct Flat {
    /// The part.
    pub part: Part,
    /// The outward normal.
    pub normal: Direction,
    /// The piece.
    pub curve: Arc<Curve>,
}

impl Fan {
    /// The centre and signed radius.
    #[must_use]
    pub fn round(&self, precision: Precision) -> Round {
        let piece = self.curve.at(precision);
        match &piece.circle {
            Some(Circle { centre, radius, left }) if !self.part.corner => {
                Round { centre: centre.clone(), radius: if *left { radius.clone() } else { -radius } }
            }
            _ => Round { centre: piece.from.clone(), radius: Real::new(0.0, precision) },
        }
    }

    /// The boundary point with a direction as its normal.
    #[must_use]
    pub fn point(&self, spoke: &Spoke, precision: Precision) -> Vector {
        let piece = self.curve.at(precision);
        let Some(circle) = piece.circle.as_ref().filter(|_| !self.part.corner) else { return piece.from.clone() };
        match spoke {
            Spoke::Along(direction) => {
                let Round { centre, radius } = self.round(precision);
                &centre + &(&direction.at(precision).unit() * &radius)
            }
            // Along a convex arc the normals turn counter-clockwise.
            Spoke::Low => if circle.left { &piece.from } else { &piece.to }.clone(),
            Spoke::High => if circle.left { &piece.to } else { &piece.from }.clone(),
        }
    }

    /// Whether it belongs to an arc that is concave.
    #[must_use]
    pub fn is_concave(&self) -> bool {
        !self.part.corner && self.curve.rough().circle.as_ref().is_some_and(|circle| !circle.left)
    }

    /// The point with the normal of a line; none if that normal is outside the fan, which counts as closed at the end
    /// that `tie` names and as open at the other.
    #[must_use]
    pub fn spoke(&self, flat: &Flat, tie: Spoke) -> Option<Spoke> {
        flat.normal.rank(self.quadrant)?;
        let low = self.low.order(&flat.normal, self.quadrant);
        let high = flat.normal.order(&self.high, self.quadrant);
        match (low, high, &tie) {
            (Ordering::Less, Ordering::Less, _) => Some(Spoke::Along(flat.normal.clone())),
            (Ordering::Equal, Ordering::Less, Spoke::Low) | (Ordering::Less, Ordering::Equal, Spoke::High) => Some(tie),
            _ => None,
        }
    }
}

/// The fans and lines of a boundary.
#[derive(Clone, Debug, Default)]
pub struct Normals {
    /// The fans of arcs and convex corners.
    pub fans: Vec<Fan>,
    /// The lines.
    pub flats: Vec<Flat>,
}

impl Normals {
    /// Those of a region.
    #[must_use]
    pub fn new(shape: &Shape) -> Self {
        let mut normals = Self::default();
        for (ring, sides) in shape.loops.iter().enumerate() {
            for (index, side) in sides.iter().enumerate() {
                let part = Part { ring, side: index, corner: false };
                if side.corner {
                    let before = &sides[(index + sides.len() - 1) % sides.len()];
                    normals.add_corner(before, side, Part { corner: true, ..part });
                }
                normals.add_side(side, part);
            }
        }
        normals
    }

    fn add_side(&mut self, side: &Side, part: Part) {
        let curve = Arc::clone(&side.curve);
        let normal = |end| Direction::normal(&side.curve, end);
        let Some(circle) = &side.curve.rough().circle else {
            return self.flats.push(Flat { part, normal: normal(End::From), curve });
        };
        let ends = if circle.left { [End::From, End::To] } else { [End::To, End::From] };
        let [low, high] = ends.map(normal);
        let quadrant = low.sector() / 2;
        // An arc that 1024 bits cannot tell from a point of an axis has no fan.
        if high.rank(quadrant).is_some() && low.order(&high, quadrant).is_lt() {
            self.fans.push(Fan { part, quadrant, low, high, curve });
        }
    }

    fn add_corner(&mut self, before: &Side, after: &Side, part: Part) {
        let low = Direction::normal(&before.curve, End::To);
        let high = Direction::normal(&after.curve, End::From);
        let opposite = || low.at(Precision::DOUBLE).dot(&high.at(Precision::DOUBLE)).is_negative();
        match low.turn_to(&high) {
            Ordering::Less => return,
            Ordering::Equal if !opposite() => return,
            _ => {}
        }
        let (first, steps) = (low.sector(), (high.sector() + 8 - low.sector()) % 8);
        let axes = (first + 1..first + steps)
            .filter(|sector| sector.is_multiple_of(2))
            .map(|sector| Direction::axis(sector / 2));
        let marks: Vec<_> = std::iter::once(low).chain(axes).chain([high]).collect();
        for pair in marks.windows(2) {
            let (low, high) = (pair[0].clone(), pair[1].clone());
            let quadrant = low.sector() / 2;
            self.fans.push(Fan { part, quadrant, low, high, curve: Arc::clone(&after.curve) });
        }
    }
}
