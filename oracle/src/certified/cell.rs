//! A part of a trapezoid in an upright box, and how far it reaches: in a direction, from a point, from a boundary piece.
//!
//! A cell is what lies between two walls, the lower and the upper curve of a trapezoid, and in a box. It is bounded by
//! stretches of the walls and of the sides of the box, so a convex function is greatest on it at a corner or inside a
//! stretch of an arc. Corners that are only possibly there are counted, which can only make a bound larger.

use std::sync::Arc;

use super::curve::Curve;
use super::nearest::FINE;
use super::piece::Piece;
use super::real::Real;
use super::slabs::Trapezoid;
use super::uprights::runs_right;
use super::vector::Vector;

/// How far a point may be outside the span of a piece and still count as in it, with an allowance in the length. A rounding
/// of a common end must not matter, and this is nothing against 2^-58.
const SLIP: f64 = 1.0 / (1u128 << 100) as f64;

/// A part of a trapezoid.
#[derive(Clone, Debug)]
pub struct Cell {
    walls: [Arc<Curve>; 2],
    /// Left and right end.
    x: [Real; 2],
    /// Lower and upper end.
    y: [Real; 2],
}

/// The outline of a cell.
pub struct Outline {
    /// Its corners; all of them belong to the closed cell.
    pub corners: Vec<Vector>,
    /// The stretches of the walls that bound it.
    stretches: Vec<Piece>,
    /// The box around it: left, lower, right and upper end.
    bounds: [Real; 4],
}

impl Cell {
    /// All of a trapezoid.
    #[must_use]
    pub fn new(trapezoid: &Trapezoid) -> Self {
        let x = trapezoid.x.clone().map(|end| Real::from(end).rounded(FINE));
        let [lower, upper] = trapezoid.walls.each_ref().map(|wall| x.each_ref().map(|x| wall.at(FINE).ordinate(x)));
        let y = [lower[0].min(&lower[1]), upper[0].max(&upper[1])];
        Self { walls: trapezoid.walls.clone(), x, y }
    }

    /// The lower and the upper wall.
    #[must_use]
    pub fn walls(&self) -> &[Arc<Curve>; 2] {
        &self.walls
    }

    /// The two parts on either side of a cut across the longer side of the box, at this abscissa or ordinate.
    #[must_use]
    pub fn cut(&self, across_x: bool, at: &Real) -> [Self; 2] {
        let mut parts = [self.clone(), self.clone()];
        let axis =
            |cell: &mut Self, end: usize| if across_x { cell.x[end] = at.clone() } else { cell.y[end] = at.clone() };
        axis(&mut parts[0], 1);
        axis(&mut parts[1], 0);
        parts
    }

    /// Its outline; `None` if it is certainly empty.
    #[must_use]
    pub fn outline(&self) -> Option<Outline> {
        let mut corners = Vec::with_capacity(8);
        let mut stretches = Vec::with_capacity(2);
        let ends = self.walls.each_ref().map(|wall| self.x.each_ref().map(|x| wall.at(FINE).ordinate(x)));
        let mut has_side = [false; 2];
        for (i, x) in self.x.iter().enumerate() {
            let (low, high) = (ends[0][i].max(&self.y[0]), ends[1][i].min(&self.y[1]));
            if !high.is_below(&low) {
                corners.extend([low, high].map(|y| Vector { x: x.clone(), y }));
                has_side[i] = true;
            }
        }
        for (wall, ends) in self.walls.iter().zip(&ends) {
            let clamped = [0, 1].map(|i| self.clamped(wall, i, &ends[i]));
            let [Some(left), Some(right)] = clamped else { continue };
            // An end of a wall on a side of the box is a corner already.
            for (i, end) in [&left, &right].into_iter().enumerate() {
                if end.moved || !has_side[i] {
                    corners.push(end.point.clone());
                }
            }
            let (left, right) = (left.point, right.point);
            let (from, to) = if runs_right(wall) { (left, right) } else { (right, left) };
            stretches.push(Piece { from, to, circle: wall.at(FINE).circle.clone() });
        }
        let first = corners.first()?;
        let start = [first.x.clone(), first.y.clone(), first.x.clone(), first.y.clone()];
        let bounds = corners.iter().fold(start, |[a, b, c, d], p| [a.min(&p.x), b.min(&p.y), c.max(&p.x), d.max(&p.y)]);
        Some(Outline { corners, stretches, bounds })
    }

    /// A point between the walls, in the middle of the box across; `None` if it is not certain to be in the cell.
    #[must_use]
    pub fn inner(&self) -> Option<Vector> {
        let x = (&self.x[0] + &self.x[1]) * 0.5;
        let [lower, upper] = self.walls.each_ref().map(|wall| wall.at(FINE).ordinate(&x));
        let (low, high) = (lower.max(&self.y[0]), upper.min(&self.y[1]));
        let y = (&low + &high) * 0.5;
        (low.is_below(&y) && y.is_below(&high)).then_some(Vector { x, y })
    }

    /// The end of a wall at the left or right side, moved along the wall into the box; `None` if the wall certainly does not
    /// pass the box.
    fn clamped(&self, wall: &Arc<Curve>, side: usize, y: &Real) -> Option<Clamped> {
        let end = Vector { x: self.x[side].clone(), y: y.clone() };
        let level = if y.is_below(&self.y[0]) {
            &self.y[0]
        } else if self.y[1].is_below(y) {
            &self.y[1]
        } else {
            return Some(Clamped { point: end, moved: false });
        };
        let other = wall.at(FINE).ordinate(&self.x[1 - side]);
        let same_side =
            y.is_below(level) == other.is_below(level) && (level - &other).sign().is_some_and(|s| s.is_ne());
        if same_side {
            return None;
        }
        let x = wall.at(FINE).abscissa(level).max(&self.x[0]).min(&self.x[1]);
        Some(Clamped { point: Vector { x, y: level.clone() }, moved: true })
    }
}

/// The end of a wall in a box, and whether it had to be moved there.
struct Clamped {
    point: Vector,
    moved: bool,
}

impl Outline {
    /// Width and height.
    #[must_use]
    pub fn extent(&self) -> [Real; 2] {
        let [x0, y0, x1, y1] = &self.bounds;
        [x1 - x0, y1 - y0]
    }

    /// The middle of the box.
    #[must_use]
    pub fn middle(&self) -> Vector {
        let [x0, y0, x1, y1] = &self.bounds;
        Vector { x: (x0 + x1) * 0.5, y: (y0 + y1) * 0.5 }
    }

    /// An upper bound of (t - origin)·direction over the cell.
    fn support(&self, origin: &Vector, direction: &Vector) -> Real {
        let value = |p: &Vector| (p - origin).dot(direction);
        let mut most = greatest(self.corners.iter().map(value));
        for stretch in &self.stretches {
            if let Some(circle) = &stretch.circle
                && stretch.spans(&(&circle.centre + direction)) != Some(false)
            {
                most = most.max(&(value(&circle.centre) + &circle.radius * &direction.length()));
            }
        }
        most
    }

    /// An upper bound of the distance of a point to the points of the cell.
    #[must_use]
    pub fn farthest(&self, point: &Vector) -> Real {
        let mut most = greatest(self.corners.iter().map(|corner| (corner - point).square())).sqrt();
        for stretch in &self.stretches {
            if let Some(circle) = &stretch.circle {
                let away = &circle.centre - point;
                if stretch.spans(&(&circle.centre + &away)) != Some(false) {
                    most = most.max(&(away.length() + &circle.radius));
                }
            }
        }
        most
    }

    /// A lower bound of the distance of a point to the points of the cell.
    fn nearest(&self, point: &Vector) -> Real {
        let [x0, y0, x1, y1] = &self.bounds;
        let beside = point.x.is_below(x0) || x1.is_below(&point.x);
        let above = point.y.is_below(y0) || y1.is_below(&point.y);
        if !beside && !above {
            return Real::from(0.0);
        }
        let mut least = greatest(self.corners.iter().map(|corner| -&corner.distance(point)));
        if !above {
            [x0, x1].into_iter().for_each(|x| least = least.max(&-&(&point.x - x).abs()));
        }
        if !beside {
            [y0, y1].into_iter().for_each(|y| least = least.max(&-&(&point.y - y).abs()));
        }
        for stretch in &self.stretches {
            if stretch.spans(point) != Some(false) {
                least = least.max(&-&stretch.offset(point));
            }
        }
        (-&least).max(&Real::from(0.0))
    }

    /// Whether the foot or ray of every point of the cell is in the span of a piece.
    fn is_spanned(&self, piece: &Piece) -> bool {
        let rays = match &piece.circle {
            None => {
                let chord = piece.chord();
                [(piece.from.clone(), -&chord), (piece.to.clone(), chord)]
            }
            Some(circle) => {
                let (start, end) = if circle.left { (&piece.from, &piece.to) } else { (&piece.to, &piece.from) };
                let [start, end] = [start, end].map(|p| (p - &circle.centre).left());
                [(circle.centre.clone(), -&start), (circle.centre.clone(), end)]
            }
        };
        rays.iter().all(|(origin, outward)| {
            let beyond = self.support(origin, outward);
            beyond.hi() <= SLIP * outward.length().lo()
        })
    }

    /// An upper bound of the distance of the points of the cell to a piece.
    #[must_use]
    pub fn reach(&self, piece: &Piece) -> f64 {
        if !self.is_spanned(piece) {
            return self.farthest(&piece.from).min(&self.farthest(&piece.to)).hi();
        }
        let offset = match &piece.circle {
            None => {
                let across = piece.chord().left();
                let most = self.support(&piece.from, &across).max(&self.support(&piece.from, &-&across));
                most / across.length()
            }
            Some(circle) => {
                let out = self.farthest(&circle.centre) - &circle.radius;
                out.max(&(&circle.radius - self.nearest(&circle.centre)))
            }
        };
        offset.max(&Real::from(0.0)).hi() + SLIP
    }

    /// An upper bound of the distance of the points of the cell to the nearer one of two pieces: half the sum of both
    /// distances. It is sharp in a slit, straight or curved, where no piece is the nearest one everywhere.
    #[must_use]
    pub fn reach_between(&self, pieces: [&Piece; 2]) -> f64 {
        if !pieces.iter().all(|piece| self.is_spanned(piece)) {
            return f64::INFINITY;
        }
        let [Some(first), Some(second)] = pieces.map(|piece| self.beyond(piece)) else { return f64::INFINITY };
        let middle = self.middle();
        let radius = self.farthest(&middle);
        let [a, b] = [(first, pieces[0]), (second, pieces[1])].map(|(side, piece)| Slope::new(piece, side, &middle));
        let bend = a.bend(&radius) + b.bend(&radius);
        let turning = &radius * &((&a.direction + &b.direction).length() + &radius * &bend * 0.5);
        let rise = match (&pieces[0].circle, &pieces[1].circle) {
            // The directions from two centres differ by at most 2|c-d| / (|p-c| + |p-d|).
            (Some(c), Some(d)) if first != second => {
                let arms = [c, d].map(|circle| middle.distance(&circle.centre) - &radius);
                let [near, far] = &arms;
                if arms.iter().all(Real::is_positive) {
                    turning.min(&(c.centre.distance(&d.centre) * &radius * 2.0 / (near + far)))
                } else {
                    turning
                }
            }
            _ => turning,
        };
        ((a.height + b.height + rise) * 0.5).hi() + 2.0 * SLIP
    }

    /// On which side of a piece's carrier the cell lies: true left of a line or outside a circle; `None` if on both.
    fn beyond(&self, piece: &Piece) -> Option<bool> {
        match &piece.circle {
            None => {
                let across = piece.chord().left();
                let limit = SLIP * across.length().lo();
                if self.support(&piece.from, &-&across).hi() <= limit {
                    return Some(true);
                }
                (self.support(&piece.from, &across).hi() <= limit).then_some(false)
            }
            Some(circle) => {
                if (&circle.radius - self.nearest(&circle.centre)).hi() <= SLIP {
                    return Some(true);
                }
                ((self.farthest(&circle.centre) - &circle.radius).hi() <= SLIP).then_some(false)
            }
        }
    }

    /// An upper bound of half the height between the walls: how far any point of the cell is from the nearer one.
    #[must_use]
    pub fn half_gap(&self, cell: &Cell) -> f64 {
        let gap = |x: &Real| {
            let [low, high] = cell.walls.each_ref().map(|wall| wall.at(FINE).ordinate(x));
            high - low
        };
        let sag = |stretch: &Piece| match &stretch.circle {
            Some(circle) => stretch.chord().square() / (&circle.radius * 4.0),
            None => Real::from(0.0),
        };
        let gap = gap(&cell.x[0]).max(&gap(&cell.x[1]));
        if self.stretches.len() < 2 {
            return f64::INFINITY;
        }
        let gap = self.stretches.iter().fold(gap, |gap, stretch| gap + sag(stretch));
        (gap * 0.5).hi()
    }
}

/// The distance from a carrier, positive on one of its sides, near a point.
struct Slope {
    height: Real,
    /// In which it grows, of length 1.
    direction: Vector,
    /// The distance of the point from the centre of a circle.
    arm: Option<Real>,
}

impl Slope {
    fn new(piece: &Piece, side: bool, point: &Vector) -> Self {
        let (height, direction, arm) = match &piece.circle {
            None => {
                let normal = piece.chord().left().unit();
                (normal.dot(&(point - &piece.from)), normal, None)
            }
            Some(circle) => {
                let arm = point - &circle.centre;
                let length = arm.length();
                (&length - &circle.radius, arm.unit(), Some(length))
            }
        };
        if side { Self { height, direction, arm } } else { Self { height: -&height, direction: -&direction, arm } }
    }

    /// How fast the direction turns at most within so far of the point.
    fn bend(&self, radius: &Real) -> Real {
        match &self.arm {
            None => Real::from(0.0),
            Some(arm) if radius.is_below(arm) => Real::from(1.0) / (arm - radius),
            Some(_) => Real::from(f64::INFINITY),
        }
    }
}

/// The greatest of some numbers, of which there is at least one.
fn greatest(mut numbers: impl Iterator<Item = Real>) -> Real {
    let first = numbers.next().expect("an outline has corners");
    numbers.fold(first, |most, x| most.max(&x))
}
