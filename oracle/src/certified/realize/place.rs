//! Step 2 of MS 4.2: the spans of a chain with exactly the stored angles.
//!
//! A span keeps the abscissas of its ends and is moved to where the one before it ended; its head gets the ordinate that
//! the angles ask for. All vectors are in the frame of the direction.

use super::chain::{Chain, Span};
use super::stored::Angle;
use super::track::Track;
use crate::certified::real::Real;
use crate::certified::vector::Vector;

/// A span in its place.
#[derive(Clone, Debug)]
pub struct Placed {
    /// The points at its marks.
    pub points: Vec<Vector>,
    /// The rightward normals at its marks, of the direction's length.
    pub normals: Vec<Vector>,
    /// Its circle; a line has none.
    pub round: Option<Round>,
    /// Whether it runs to the right.
    pub rightward: bool,
}

/// The circle of a span: the points `centre + radius n` for the normals n.
#[derive(Clone, Debug)]
pub struct Round {
    /// The centre.
    pub centre: Vector,
    /// The signed radius, positive when the centre is on the left, in the unit box.
    pub radius: Real,
}

/// The spans of a chain, the first one starting where the engine has it.
#[must_use]
pub fn place(track: &Track, chain: &Chain) -> Vec<Placed> {
    let first = &chain.spans[0];
    let mut at = track.on(&first.pieces, first.marks[0]);
    let place = |span| {
        let placed = placed(track, span, &at);
        at = placed.to().clone();
        placed
    };
    chain.spans.iter().map(place).collect()
}

fn placed(track: &Track, span: &Span, from: &Vector) -> Placed {
    let normals: Vec<Vector> = span.marks.iter().map(|&mark| track.normal(mark)).collect();
    let (first, last) = (&normals[0], &normals[normals.len() - 1]);
    let x = track.on(&span.pieces, span.marks[span.marks.len() - 1]).x;
    let width = &x - &from.x;
    if track.pieces[span.pieces.start].is_line() {
        let to = Vector { x, y: &from.y - &(&width * &first.x / &first.y) };
        return Placed { points: vec![from.clone(), to], normals, round: None, rightward: span.rightward };
    }
    let radius = width / (&last.x - &first.x);
    let centre = from - &(first * &radius);
    let mut points: Vec<Vector> = normals.iter().map(|normal| &centre + &(normal * &radius)).collect();
    points[0] = from.clone();
    let end = points.len() - 1;
    points[end].x = x;
    Placed { points, normals, round: Some(Round { centre, radius }), rightward: span.rightward }
}

impl Placed {
    /// Where it starts.
    #[must_use]
    pub fn from(&self) -> &Vector {
        &self.points[0]
    }

    /// Where it ends.
    #[must_use]
    pub fn to(&self) -> &Vector {
        &self.points[self.points.len() - 1]
    }

    /// The same span higher by an exact double.
    #[must_use]
    pub fn lifted(mut self, by: f64) -> Self {
        for point in &mut self.points {
            point.y = &point.y + by;
        }
        if let Some(round) = &mut self.round {
            round.centre.y = &round.centre.y + by;
        }
        self
    }

    /// Whether it certainly runs its way, and bends to the side that the sign of its stored radius says.
    #[must_use]
    pub fn is_sound(&self, left: bool) -> bool {
        let width = &self.to().x - &self.from().x;
        let forward = if self.rightward { width.is_positive() } else { width.is_negative() };
        let bent = |round: &Round| if left { round.radius.is_positive() } else { round.radius.is_negative() };
        forward && self.round.as_ref().is_none_or(bent)
    }

    /// The ordinate at an abscissa between those of its ends. The circle is in the frame, so its radius is scaled by the
    /// direction's length, `scale`.
    #[must_use]
    pub fn ordinate(&self, x: &Real, scale: &Real) -> Real {
        match &self.round {
            None => &self.from().y - &(&(x - &self.from().x) * &self.normals[0].x / &self.normals[0].y),
            Some(Round { centre, radius }) => {
                let height = ((radius * scale).square() - (x - &centre.x).square()).sqrt();
                // Counter-clockwise, the upper half of a circle runs to the left.
                if radius.is_positive() == self.rightward { &centre.y - &height } else { &centre.y + &height }
            }
        }
    }

    /// The slope at an abscissa as the abscissa of the upward unit normal: the same for the same slopes, and linear in x.
    #[must_use]
    pub fn slope(&self, x: &Real) -> Real {
        let (first, last) = (&self.normals[0].x, &self.normals[self.normals.len() - 1].x);
        let slope = match self.round {
            None => first.clone(),
            Some(_) => {
                let part = (x - &self.from().x) / (&self.to().x - &self.from().x);
                first + &(part * (last - first))
            }
        };
        if self.rightward { -&slope } else { slope }
    }

    /// The point at a normal angle of this span's circle; for a line its start.
    #[must_use]
    pub fn point(&self, track: &Track, angle: Angle) -> Vector {
        match &self.round {
            None => self.from().clone(),
            Some(Round { centre, radius }) => centre + &(&track.at(angle) * radius),
        }
    }

    /// The box `[x0, y0, x1, y1]` around it in doubles.
    #[must_use]
    pub fn bounds(&self, scale: &Real) -> [f64; 4] {
        let (from, to) = (self.from(), self.to());
        let mut y = from.y.hull(&to.y);
        if let Some(Round { centre, radius }) = &self.round {
            let (first, last) = (&self.normals[0].x, &self.normals[self.normals.len() - 1].x);
            if (first * last).sign() != Some(std::cmp::Ordering::Greater) {
                // The highest or lowest point may lie inside.
                let middle = &(&from.x + &to.x) * 0.5;
                let size = (radius * scale).abs();
                let up = self.ordinate(&middle, scale) - &centre.y;
                y = y.hull(&if up.is_positive() { &centre.y + &size } else { &centre.y - &size });
            }
        }
        let x = from.x.hull(&to.x);
        [x.lo(), y.lo(), x.hi(), y.hi()]
    }
}
