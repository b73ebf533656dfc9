//! Step 2 of MS 4.2: the spans of a chain with exactly the stored angles.
//!
//! A span keeps the abscissas of its ends and is moved to where the one before it ended; its head gets the ordinate
//! that the angles ask for. All vectors are in the frame of the direction.

use super::chain::{Chain, Span};
use super::path::{Path, Round};
use super::track::Track;
use crate::certified::real::Real;
use crate::certified::vector::Vector;

/// A span in its place.
#[derive(Clone, Debug)]
pub struct Placed {
    /// Its curve.
    pub path: Path,
    /// The points at its marks.
    pub points: Vec<Vector>,
    /// The rightward normals at its ends, of the direction's length.
    pub normals: [Vector; 2],
}

/// The spans of a chain, the first one starting where the engine has it.
#[must_use]
pub fn place(track: &Track, chain: &Chain) -> Vec<Placed> {
    let first = &chain.spans[0];
    let mut at = track.on(&first.pieces, first.marks[0]);
    let place = |span| {
        let placed = placed(track, span, &at);
        at = placed.path.to.clone();
        placed
    };
    chain.spans.iter().map(place).collect()
}

fn placed(track: &Track, span: &Span, from: &Vector) -> Placed {
    let normals: Vec<Vector> = span.marks.iter().map(|&mark| track.normal(mark)).collect();
    let (first, last) = (&normals[0], &normals[normals.len() - 1]);
    let x = track.on(&span.pieces, span.marks[span.marks.len() - 1]).x;
    let width = &x - &from.x;
    let (points, round) = if track.pieces[span.pieces.start].is_line() {
        let to = Vector { x, y: &from.y - &(&width * &first.x / &first.y) };
        (vec![from.clone(), to], None)
    } else {
        let radius = width / (&last.x - &first.x);
        let centre = from - &(first * &radius);
        let mut points: Vec<Vector> = normals.iter().map(|normal| &centre + &(normal * &radius)).collect();
        let end = points.len() - 1;
        points[0] = from.clone();
        points[end].x = x;
        (points, Some(Round { centre, radius }))
    };
    let path = Path { from: from.clone(), to: points[points.len() - 1].clone(), round, rightward: span.rightward };
    Placed { path, points, normals: [first.clone(), last.clone()] }
}

impl Placed {
    /// The same span higher by an exact double.
    #[must_use]
    pub fn lifted(mut self, by: f64) -> Self {
        let Path { from, to, round, .. } = &mut self.path;
        let centre = round.as_mut().map(|round| &mut round.centre);
        for point in self.points.iter_mut().chain([from, to]).chain(centre) {
            point.y = &point.y + by;
        }
        self
    }

    /// Whether it certainly runs its way, and bends to the side that the sign of its stored radius says.
    #[must_use]
    pub fn is_sound(&self, left: bool) -> bool {
        let [start, end] = self.path.range();
        let bent = |round: &Round| if left { round.radius.is_positive() } else { round.radius.is_negative() };
        start.is_below(end) && self.path.round.as_ref().is_none_or(bent)
    }

    /// The slope at an abscissa as the abscissa of the upward normal: the same for the same slopes, and linear in x.
    #[must_use]
    pub fn slope(&self, x: &Real) -> Real {
        let [first, last] = &self.normals;
        let Path { from, to, round, rightward } = &self.path;
        let slope = match round {
            None => first.x.clone(),
            Some(_) => {
                let part = (x - &from.x) / (&to.x - &from.x);
                &first.x + &(part * (&last.x - &first.x))
            }
        };
        if *rightward { -&slope } else { slope }
    }

    /// The point of this span's circle with a rightward normal of the direction's length; for a line its start.
    #[must_use]
    pub fn point(&self, normal: &Vector) -> Vector {
        match &self.path.round {
            None => self.path.from.clone(),
            Some(Round { centre, radius }) => centre + &(normal * radius),
        }
    }
}
