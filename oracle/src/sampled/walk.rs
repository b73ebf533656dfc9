//! Samples on the boundary of the sum: how near the boundary of the result is.
//!
//! Between a point in the interior of the sum and one that is not lies a point of its boundary, which halving finds. For
//! polygons, the sum of the vertices that are extreme in one direction is a vertex of the sum.

use crate::certified::membership::State;
use crate::error::OracleError;
use crate::number::Number;
use crate::point::Point;
use crate::region::ExactRegion;
use rug::Rational;

use super::Sample;
use super::boundary::exact;
use super::sides::{Place, Sampler};

/// The distance of two points is halved so many times.
const HALVINGS: i32 = 60;

impl Sampler<'_> {
    /// A place of the sum's boundary between two points, given in shares of the box around the result made half as large again;
    /// none if both are in the interior of the sum, or neither.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn between(&self, from: [f64; 2], to: [f64; 2]) -> Result<Option<Sample>, OracleError> {
        let (Some(from), Some(to)) = (self.at(from), self.at(to)) else { return Ok(None) };
        let mut ends = [exact(from), exact(to)];
        let blocked = |t: &Place| Ok::<bool, OracleError>(self.state(t)? == State::Blocked);
        let first = blocked(&ends[0])?;
        if first == blocked(&ends[1])? {
            return Ok(None);
        }
        let half = Rational::from((1, 2));
        for _ in 0..HALVINGS {
            let middle = ends[0].plus(&ends[1]).times(&half);
            let side = usize::from(blocked(&middle)? != first);
            ends[side] = middle;
        }
        let step = ends[1].minus(&ends[0]);
        let gap = step.dot(&step).enclosure().sqrt().hi();
        let near = (self.off(&ends[0]).1 + gap).next_up();
        Ok(Some(self.sample(&ends[0], Some(near), 0.0, false)))
    }

    /// The vertex of the sum that is extreme in a direction, which is not 0; none but for two bounded polygons.
    #[must_use]
    pub fn extreme(&self, direction: [f64; 2]) -> Option<Sample> {
        let [a, b] = self.regions.polygons.as_ref()?;
        let along = exact(direction);
        let vertex = extreme(a, &along)?.plus(extreme(b, &along)?);
        let (least, most) = self.off(&vertex);
        let inside = self.contains(&vertex);
        let far = if inside == Some(false) { least } else { 0.0 };
        Some(self.sample(&vertex, most.is_finite().then_some(most), far, false))
    }
}

fn extreme<'r>(region: &'r ExactRegion<Rational>, along: &Point<Rational>) -> Option<&'r Point<Rational>> {
    let vertices = region.loops().iter().flatten().filter(|_| !region.unbounded());
    vertices.map(|p| (p.dot(along), p)).max_by(|p, q| p.0.cmp(&q.0)).map(|(_, p)| p)
}
