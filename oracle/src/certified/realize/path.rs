//! A span as a curve over an abscissa.

use super::chain::Span;
use super::track::Track;
use crate::certified::real::Real;
use crate::certified::vector::Vector;

/// A line or circle segment that runs one way, in the frame.
#[derive(Clone, Debug)]
pub struct Path {
    /// Where it starts.
    pub from: Vector,
    /// Where it ends.
    pub to: Vector,
    /// Its circle; a line has none.
    pub round: Option<Round>,
    /// Whether it runs to the right.
    pub rightward: bool,
}

/// A circle: the points `centre + radius n` for the rightward normals n, which have the direction's length.
#[derive(Clone, Debug)]
pub struct Round {
    /// The centre.
    pub centre: Vector,
    /// The signed radius, positive when the centre is on the left, in the unit box.
    pub radius: Real,
}

impl Path {
    /// The span as the stored numbers have it, its circle segment by the two ends and their angles.
    #[must_use]
    pub fn stored(track: &Track, span: &Span) -> Self {
        let end = |i: usize| track.on(&span.pieces, span.marks[i]);
        let (from, to) = (end(0), end(span.marks.len() - 1));
        let line = track.pieces[span.pieces.start].is_line();
        let round = (!line).then(|| track.round(&span.pieces));
        Self { from, to, round, rightward: span.rightward }
    }

    /// The ordinate at an abscissa between those of its ends. `scale` is the direction's length.
    #[must_use]
    pub fn ordinate(&self, x: &Real, scale: &Real) -> Real {
        match &self.round {
            None => {
                let part = (x - &self.from.x) / (&self.to.x - &self.from.x);
                &self.from.y + &(part * (&self.to.y - &self.from.y))
            }
            Some(Round { centre, radius }) => {
                let height = ((radius * scale).square() - (x - &centre.x).square()).sqrt();
                // Counter-clockwise, the upper half of a circle runs to the left.
                if radius.is_positive() == self.rightward { &centre.y - &height } else { &centre.y + &height }
            }
        }
    }

    /// The abscissas from the left end to the right one.
    #[must_use]
    pub fn range(&self) -> [&Real; 2] {
        if self.rightward { [&self.from.x, &self.to.x] } else { [&self.to.x, &self.from.x] }
    }

    /// The box `[x0, y0, x1, y1]` around it in doubles.
    #[must_use]
    pub fn bounds(&self, scale: &Real) -> [f64; 4] {
        let [left, right] = self.range();
        let mut y = self.from.y.hull(&self.to.y);
        if let Some(Round { centre, radius }) = &self.round
            && !centre.x.is_below(left)
            && !right.is_below(&centre.x)
        {
            let size = (radius * scale).abs();
            let upper = radius.is_positive() != self.rightward;
            y = y.hull(&if upper { &centre.y + &size } else { &centre.y - &size });
        }
        [left.lo(), y.lo(), right.hi(), y.hi()]
    }
}
