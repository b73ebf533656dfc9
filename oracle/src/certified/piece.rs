//! A monotone piece of a boundary: a line, or at most a quarter of a circle between two axis directions.
//!
//! Within a quadrant both coordinates are monotone along a piece, its box is that of its ends, and whether a direction
//! from the centre meets it is a matter of two cross products.

use std::cmp::Ordering;

use super::real::Real;
use super::vector::Vector;

/// The circle of a piece.
#[derive(Clone, Debug)]
pub struct Circle {
    /// The centre.
    pub centre: Vector,
    /// The radius, not negative.
    pub radius: Real,
    /// Whether the piece runs counter-clockwise: the centre on its left.
    pub left: bool,
}

/// A line from one point to another, or an arc between them that lies in one quadrant of its circle.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Where it starts.
    pub from: Vector,
    /// Where it ends.
    pub to: Vector,
    /// Its circle; a line has none.
    pub circle: Option<Circle>,
}

impl Piece {
    /// From the first point to the last.
    #[must_use]
    pub fn chord(&self) -> Vector {
        &self.to - &self.from
    }

    /// The direction in which it runs at a point of it, of any length.
    #[must_use]
    pub fn tangent(&self, point: &Vector) -> Vector {
        match &self.circle {
            None => self.chord(),
            Some(Circle { centre, left: true, .. }) => (point - centre).left(),
            Some(Circle { centre, left: false, .. }) => (centre - point).left(),
        }
    }

    /// The same points run through the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let circle = self.circle.clone().map(|circle| Circle { left: !circle.left, ..circle });
        Self { from: self.to.clone(), to: self.from.clone(), circle }
    }

    /// Turned by half a turn about the origin and moved by `by`: the points `by - p`.
    #[must_use]
    pub fn mirrored(&self, by: &Vector) -> Self {
        let circle = self.circle.as_ref().map(|c| Circle { centre: by - &c.centre, ..c.clone() });
        Self { from: by - &self.from, to: by - &self.to, circle }
    }

    /// Moved by a vector.
    #[must_use]
    pub fn moved(&self, by: &Vector) -> Self {
        let circle = self.circle.as_ref().map(|c| Circle { centre: by + &c.centre, ..c.clone() });
        Self { from: by + &self.from, to: by + &self.to, circle }
    }

    /// Whether the foot of the perpendicular from a point lies strictly between the ends of the piece; for an arc, whether
    /// the ray from the centre through the point does.
    #[must_use]
    pub fn spans(&self, point: &Vector) -> Option<bool> {
        let (after, before) = match &self.circle {
            None => {
                let chord = self.chord();
                ((point - &self.from).dot(&chord).sign(), (&self.to - point).dot(&chord).sign())
            }
            Some(circle) => {
                let arm = point - &circle.centre;
                let [mut start, mut end] = [&self.from, &self.to].map(|p| p - &circle.centre);
                if !circle.left {
                    std::mem::swap(&mut start, &mut end);
                }
                // Both cross products are positive in the cone only, which is narrower than half a turn.
                (start.turn(&arm), arm.turn(&end))
            }
        };
        match (after, before) {
            (Some(Ordering::Greater), Some(Ordering::Greater)) => Some(true),
            (Some(Ordering::Less | Ordering::Equal), _) | (_, Some(Ordering::Less | Ordering::Equal)) => Some(false),
            _ => None,
        }
    }

    /// The distance of a point to the line or circle that carries the piece.
    #[must_use]
    pub fn offset(&self, point: &Vector) -> Real {
        match &self.circle {
            None => {
                let chord = self.chord();
                chord.cross(&(point - &self.from)).abs() / chord.length()
            }
            Some(circle) => (point.distance(&circle.centre) - &circle.radius).abs(),
        }
    }

    /// The distance of a point to the piece.
    #[must_use]
    pub fn distance(&self, point: &Vector) -> Real {
        let ends = || point.distance(&self.from).min(&point.distance(&self.to));
        match self.spans(point) {
            Some(true) => self.offset(point),
            Some(false) => ends(),
            None => {
                // No point of a quarter of a circle is farther from an end than the other end.
                let ends = ends();
                let least = &ends - &self.chord().length();
                // An offset of unknown size, from a piece too short to have a direction, says nothing.
                let offset = Some(self.offset(point)).filter(|offset| offset.hi().is_finite());
                offset.map_or_else(|| least.clone(), |offset| least.max(&offset)).max(&Real::from(0.0)).hull(&ends)
            }
        }
    }

    /// How far along the chord a point lies, times the length of the chord: monotone along the piece, 0 at its start.
    #[must_use]
    pub fn progress(&self, point: &Vector) -> Real {
        (point - &self.from).dot(&self.chord())
    }

    /// The ordinate over an abscissa strictly between those of the ends.
    #[must_use]
    pub fn ordinate(&self, x: &Real) -> Real {
        match &self.circle {
            None => {
                let chord = self.chord();
                &self.from.y + &(&(&chord.y * &(x - &self.from.x)) / &chord.x)
            }
            Some(circle) => {
                let height = (circle.radius.square() - (x - &circle.centre.x).square()).sqrt();
                let [high, low] = [&circle.centre.y + &height, &circle.centre.y - &height];
                match self.is_upper() {
                    Some(true) => high,
                    Some(false) => low,
                    // An arc too small for the precision may be on either side of its centre.
                    None => low.hull(&high),
                }
            }
        }
    }

    /// The abscissa at an ordinate strictly between those of the ends.
    #[must_use]
    pub fn abscissa(&self, y: &Real) -> Real {
        self.transposed().ordinate(y)
    }

    /// Reflected in the diagonal: both coordinates exchanged.
    fn transposed(&self) -> Self {
        let swap = |v: &Vector| Vector { x: v.y.clone(), y: v.x.clone() };
        let circle = self.circle.as_ref().map(|c| Circle { centre: swap(&c.centre), left: !c.left, ..c.clone() });
        Self { from: swap(&self.from), to: swap(&self.to), circle }
    }

    /// Whether an arc lies in the upper half of its circle; none if its precision does not tell.
    fn is_upper(&self) -> Option<bool> {
        let circle = self.circle.as_ref()?;
        let middle = &(&self.from + &self.to) * &Real::from(0.5);
        (&middle.y - &circle.centre.y).sign().map(Ordering::is_gt)
    }

    /// The box `[x0, y0, x1, y1]` around it.
    #[must_use]
    pub fn bounds(&self) -> [f64; 4] {
        let low = |a: &Real, b: &Real| a.lo().min(b.lo());
        let high = |a: &Real, b: &Real| a.hi().max(b.hi());
        [
            low(&self.from.x, &self.to.x),
            low(&self.from.y, &self.to.y),
            high(&self.from.x, &self.to.x),
            high(&self.from.y, &self.to.y),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::super::precision::Precision;
    use super::*;

    /// The upper right quarter of a circle of radius r about (1/2, 1/2), its ends as uncertain as given, mostly downwards.
    fn quarter(r: f64, blur: f64) -> Piece {
        let exactly = |x: f64| Real::new(x, Precision::DOUBLE);
        let about = |x: f64| exactly(x - 2.0 * blur).hull(&exactly(x + blur));
        let at = |x: f64, y: f64| Vector { x: about(0.5 + x), y: about(0.5 + y) };
        let circle = Circle { centre: Vector { x: exactly(0.5), y: exactly(0.5) }, radius: exactly(r), left: true };
        Piece { from: at(r, 0.0), to: at(0.0, r), circle: Some(circle) }
    }

    /// A sum of the realizations of two nearly equal rings had a tiny arc taken for its lower half at the precision of
    /// doubles, and with it a false part of the sum 0.17 high.
    #[test]
    fn an_arc_that_may_be_on_either_side_of_its_centre_has_both_ordinates() {
        let height = 0.75_f64.sqrt();
        let middle = |piece: &Piece, r: f64| piece.ordinate(&Real::new(0.5 + 0.5 * r, Precision::DOUBLE));
        let sharp = middle(&quarter(0.25, 0.0), 0.25);
        assert!(sharp.lo() > 0.5 + 0.25 * height - 1e-12 && sharp.hi() < 0.5 + 0.25 * height + 1e-12, "{sharp:?}");
        let tiny = 16.0 * f64::EPSILON;
        let blurred = middle(&quarter(tiny, tiny), tiny);
        assert!(blurred.lo() < 0.5 - 0.8 * tiny && blurred.hi() > 0.5 + 0.8 * tiny, "{blurred:?}");
    }
}
