//! The vertical decomposition: every maximal interval of a gap between events is a trapezoid (memo C3).

use super::curve::Curve;
use glam::DVec2;

/// A part of a face between two curves with no event on either between its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trapezoid {
    /// The face.
    pub face: u32,
    /// Left end.
    pub from: f64,
    /// Right end, greater than `from`.
    pub to: f64,
    /// The curve below.
    pub bottom: u32,
    /// The curve above.
    pub top: u32,
}

impl Trapezoid {
    /// The lesser of width and height at mid x, the number of MS 8.2, by the curves of the map.
    #[must_use]
    pub fn size(&self, curves: &[Curve]) -> f64 {
        let [low, high] = self.heights(curves, self.from.midpoint(self.to));
        (self.to - self.from).min(high - low)
    }

    /// The point at these fractions of its width and of the height there.
    #[must_use]
    pub fn spot(&self, curves: &[Curve], [across, up]: [f64; 2]) -> DVec2 {
        let x = self.from + across * (self.to - self.from);
        let [low, high] = self.heights(curves, x);
        DVec2::new(x, low + up * (high - low))
    }

    fn heights(&self, curves: &[Curve], x: f64) -> [f64; 2] {
        [self.bottom, self.top].map(|curve| curves[curve as usize].y_at(x))
    }
}
