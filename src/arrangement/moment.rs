//! Moments of the sweep: places in lexicographic order whose abscissa is kept to twofold precision.
//!
//! A line may rise by much within one unit in the last place of x. A double does not say when something happens on it;
//! the double and its error do, to a few eps of the rise, because the sweep measures x from an end of the line.

use super::curve::by_size;
use glam::DVec2;
use std::cmp::Ordering;

/// When something happens: at the abscissa `at.x + low`, ties by the ordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// The place, rounded.
    pub at: DVec2,
    /// What rounding took from the abscissa.
    pub low: f64,
}

impl Moment {
    /// The order of events.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        let by_abscissa = by_size(self.at.x, other.at.x).then_with(|| by_size(self.low, other.low));
        by_abscissa.then_with(|| by_size(self.at.y, other.at.y))
    }

    /// The later of two.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if self.compare(&other).is_lt() { other } else { self }
    }

    /// The earlier of two.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        if self.compare(&other).is_gt() { other } else { self }
    }
}

impl From<DVec2> for Moment {
    /// The moment of a place that is exact.
    fn from(at: DVec2) -> Self {
        Self { at, low: 0.0 }
    }
}
