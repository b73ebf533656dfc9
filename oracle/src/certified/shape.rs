//! A region as loops of monotone pieces: the circle segments are taken literally and split at the axis directions.
//!
//! A segment of signed radius r from p to q is the minor arc of the circle through both points with that radius, the
//! centre on the left for r > 0. A segment of bulge b = tan(sweep/4) has the centre m + (1-b²)/(4b) n for the middle m of
//! the chord and the chord n turned left.

use std::cmp::Ordering;
use std::sync::Arc;

use super::curve::Curve;
use super::piece::{Circle, Piece};
use super::precision::Precision;
use super::real::Real;
use super::vector::{Vector, sector};
use crate::error::OracleError;
use crate::plain::{Bend, Corner, PlainRegion};

/// A region bounded by monotone pieces.
#[derive(Clone, Debug)]
pub struct Shape {
    /// The loops, each piece ending where the next one starts; the interior is on the left.
    pub loops: Vec<Vec<Side>>,
    /// Whether everything far away belongs to the region.
    pub unbounded: bool,
}

/// A piece of a loop.
#[derive(Clone, Debug)]
pub struct Side {
    /// The piece.
    pub curve: Arc<Curve>,
    /// Whether it starts at a corner of the region rather than inside a circle segment that was split.
    pub corner: bool,
    /// Index of the corner that the whole segment leaves.
    pub vertex: usize,
}

/// A circle segment of a region, as it is given.
#[derive(Clone, Copy)]
struct Segment {
    from: Corner,
    to: (f64, f64),
}

/// Where a piece of a circle segment ends.
#[derive(Clone, Copy, PartialEq)]
enum Mark {
    From,
    To,
    /// The point of the circle in the direction of this axis: right, up, left, down.
    Axis(usize),
}

impl Shape {
    /// The region of these numbers. Lines of length 0 are left out.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for numbers that are not finite and radii that no arc over the chord has.
    pub fn new(region: &PlainRegion) -> Result<Self, OracleError> {
        let mut loops = Vec::with_capacity(region.loops.len());
        for (ring, corners) in region.loops.iter().enumerate() {
            let mut sides = Vec::with_capacity(corners.len());
            for (vertex, &from) in corners.iter().enumerate() {
                let next = corners[(vertex + 1) % corners.len()];
                let bad = |reason| OracleError::BadNumber { ring, vertex, reason };
                let segment = Segment { from, to: (next.x, next.y) };
                let curves = segment.pieces().map_err(bad)?;
                let side = |(i, curve)| Side { curve: Arc::new(curve), corner: i == 0, vertex };
                sides.extend(curves.into_iter().enumerate().map(side));
            }
            loops.push(sides);
        }
        Ok(Self { loops, unbounded: region.unbounded })
    }

    /// All pieces of all loops.
    pub fn sides(&self) -> impl Iterator<Item = &Side> {
        self.loops.iter().flatten()
    }
}

impl Segment {
    /// Its pieces in order, none if it is a line of length 0.
    fn pieces(self) -> Result<Vec<Curve>, &'static str> {
        if ![self.from.x, self.from.y, self.to.0, self.to.1].iter().all(|c| c.is_finite()) {
            return Err("a coordinate is not finite");
        }
        if (self.from.x, self.from.y) == self.to {
            return if self.is_line()? { Ok(Vec::new()) } else { Err("the ends of a circle segment coincide") };
        }
        if self.is_line()? {
            return Ok(vec![Curve::new(move |p| {
                let [from, to] = self.ends(p);
                Piece { from, to, circle: None }
            })]);
        }
        let marks = self.marks();
        let piece = |pair: &[Mark]| {
            let ends = [pair[0], pair[1]];
            Curve::new(move |p| self.arc(ends, p))
        };
        Ok(marks.windows(2).map(piece).collect())
    }

    fn is_line(self) -> Result<bool, &'static str> {
        match self.from.bend {
            Bend::Line => Ok(true),
            Bend::Bulge(bulge) if !bulge.is_finite() => Err("the bulge is not finite"),
            Bend::Bulge(bulge) => Ok(bulge == 0.0),
            Bend::Radius(radius) if !radius.is_finite() => Err("the radius is not finite"),
            Bend::Radius(0.0) => Err("the radius is 0"),
            Bend::Radius(radius) => {
                let short = Precision::FINEST.decide(|p| {
                    let [from, to] = self.ends(p);
                    let diameter = Real::new(radius, p) * 2.0;
                    ((&to - &from).square() - diameter.square()).sign()
                });
                if short == Some(Ordering::Greater) { Err("the chord is longer than the diameter") } else { Ok(false) }
            }
        }
    }

    fn ends(self, precision: Precision) -> [Vector; 2] {
        [Vector::new(self.from.x, self.from.y, precision), Vector::new(self.to.0, self.to.1, precision)]
    }

    fn circle(self, precision: Precision) -> Circle {
        let [from, to] = self.ends(precision);
        let chord = &to - &from;
        let middle = &(&from + &to) * &Real::from(0.5);
        match self.from.bend {
            Bend::Bulge(bulge) => {
                let bulge = Real::new(bulge, precision);
                let square = bulge.square();
                let rise = &(Real::from(1.0) - &square) / &(&bulge * 4.0);
                let radius = chord.length() * (&square + 1.0) / (bulge.abs() * 4.0);
                let left = bulge.is_positive();
                Circle { centre: &middle + &(&chord.left() * &rise), radius, left }
            }
            Bend::Radius(radius) => {
                let size = Real::new(radius.abs(), precision);
                let rise = (&(size.square() / chord.square()) - &Real::from(0.25)).sqrt();
                let rise = if radius > 0.0 { rise } else { -&rise };
                Circle { centre: &middle + &(&chord.left() * &rise), radius: size, left: radius > 0.0 }
            }
            Bend::Line => unreachable!("a line has no circle"),
        }
    }

    /// The piece of the circle segment between two marks.
    fn arc(self, marks: [Mark; 2], precision: Precision) -> Piece {
        let circle = self.circle(precision);
        let [start, end] = self.ends(precision);
        let [from, to] = marks.map(|mark| match mark {
            Mark::From => start.clone(),
            Mark::To => end.clone(),
            Mark::Axis(axis) => {
                let Vector { x, y } = circle.centre.clone();
                match axis {
                    0 => Vector { x: x + &circle.radius, y },
                    1 => Vector { x, y: y + &circle.radius },
                    2 => Vector { x: x - &circle.radius, y },
                    _ => Vector { x, y: y - &circle.radius },
                }
            }
        });
        Piece { from, to, circle: Some(circle) }
    }

    /// The ends and, between them in order, the axis directions that the segment passes.
    fn marks(self) -> Vec<Mark> {
        let left = self.circle(Precision::DOUBLE).left;
        let [from, to] = [0, 1].map(|i| self.sector(i));
        let (first, last) = if left { (from, to) } else { (to, from) };
        // Axes are the even sectors, quadrants the odd ones.
        let mut passed: Vec<Mark> = Vec::new();
        let mut sector = first + 1;
        let turns = if first == last && self.is_major() { 8 } else { (last + 8 - first) % 8 };
        while sector < first + turns {
            if sector % 2 == 0 {
                passed.push(Mark::Axis(sector / 2 % 4));
            }
            sector += 1;
        }
        if !left {
            passed.reverse();
        }
        std::iter::once(Mark::From).chain(passed).chain([Mark::To]).collect()
    }

    /// Whether it is more than half a circle.
    fn is_major(self) -> bool {
        matches!(self.from.bend, Bend::Bulge(bulge) if bulge.abs() > 1.0)
    }

    /// The direction from the centre to an end: twice the axis it lies on, or one more for the quadrant that follows it. A
    /// coordinate that is undecided at the finest precision counts as 0.
    fn sector(self, end: usize) -> usize {
        let sign = |coordinate: fn(&Vector) -> &Real| {
            let sign = Precision::FINEST.decide(|p| {
                let arm = &self.ends(p)[end] - &self.circle(p).centre;
                coordinate(&arm).sign()
            });
            sign.unwrap_or(Ordering::Equal)
        };
        sector(sign(|v| &v.x), sign(|v| &v.y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn bent(x: f64, y: f64, bend: Bend) -> PlainRegion {
        let corner = |x, y, bend| Corner { x, y, bend };
        PlainRegion { loops: vec![vec![corner(0.0, 0.0, bend), corner(x, y, Bend::Line)]], unbounded: false }
    }

    fn arc_of(region: &PlainRegion) -> Vec<Arc<Curve>> {
        let shape = Shape::new(region).expect("valid numbers");
        shape.sides().filter(|side| side.vertex == 0).map(|side| side.curve.clone()).collect()
    }

    /// The angle an arc runs through, by its pieces.
    fn sweep(pieces: &[Arc<Curve>]) -> f64 {
        let one = |curve: &Arc<Curve>| {
            let piece = curve.rough();
            let circle = piece.circle.as_ref().expect("an arc");
            let [p, q] = [&piece.from, &piece.to].map(|end| (end - &circle.centre).nearest());
            (p.0 * q.1 - p.1 * q.0).atan2(p.0 * q.0 + p.1 * q.1)
        };
        pieces.iter().map(one).sum()
    }

    proptest! {
        #[test]
        fn pieces_are_quarters_that_make_up_the_sweep(x in -2.0..2.0f64, y in -2.0..2.0f64, bulge in -8.0..8.0f64) {
            prop_assume!(x.hypot(y) > 1e-3 && bulge.abs() > 1e-3);
            let pieces = arc_of(&bent(x, y, Bend::Bulge(bulge)));
            prop_assert!((sweep(&pieces) - 4.0 * bulge.atan()).abs() < 1e-6);
            for curve in &pieces {
                let piece = curve.at(Precision::LADDER[2]);
                let circle = piece.circle.as_ref().expect("an arc");
                for end in [&piece.from, &piece.to] {
                    prop_assert!((end.distance(&circle.centre) - &circle.radius).is_within(-200));
                }
                let middle = &(&piece.from + &piece.to) * &Real::from(0.5);
                let arms = [&piece.from, &piece.to, &middle].map(|p| p - &circle.centre);
                for axis in [|v: &Vector| v.x.clone(), |v: &Vector| v.y.clone()] {
                    let signs: Vec<f64> = arms.iter().map(|v| axis(v).mid()).collect();
                    prop_assert!(signs.iter().all(|&s| s > -1e-12) || signs.iter().all(|&s| s < 1e-12));
                }
                prop_assert_eq!(piece.spans(&middle), Some(true));
            }
        }

        #[test]
        fn a_radius_is_the_minor_arc(x in 0.1..2.0f64, y in -2.0..2.0f64, more in 0.0..3.0f64, left in any::<bool>()) {
            let size = 0.5 * x.hypot(y) * (1.0 + more) * (1.0 + 1e-15);
            let pieces = arc_of(&bent(x, y, Bend::Radius(if left { size } else { -size })));
            let expected = 2.0 * (0.5 * x.hypot(y) / size).min(1.0).asin();
            prop_assert!((sweep(&pieces).abs() - expected).abs() < 1e-6 && (sweep(&pieces) > 0.0) == left);
        }
    }

    #[test]
    fn a_full_circle_of_two_half_circles_has_four_quarters() {
        let corner = |x| Corner { x, y: 0.0, bend: Bend::Bulge(1.0) };
        let circle = PlainRegion { loops: vec![vec![corner(-1.0), corner(1.0)]], unbounded: false };
        let shape = Shape::new(&circle).expect("valid");
        assert_eq!(shape.sides().map(|side| side.corner).collect::<Vec<_>>(), [true, false, true, false]);
        assert!(Shape::new(&bent(2.0, 0.0, Bend::Radius(0.99))).is_err());
        assert!(Shape::new(&bent(2.0, 0.0, Bend::Radius(1.0))).is_ok());
    }
}
