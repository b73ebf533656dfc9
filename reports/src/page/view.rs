//! A view: the window of the plane that a panel shows, and the map from input units to pixels.
//!
//! Pixels count upwards like the plane; only the writer of a path turns the ordinate over.

use super::edge::{self, Edge, Point};
use arcsum::region::Region;

/// An axis-parallel box in input units, finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Least abscissa and ordinate.
    pub low: Point,
    /// Greatest abscissa and ordinate.
    pub high: Point,
}

/// A frame and the pixels an input unit takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// What is shown.
    pub frame: Frame,
    /// Pixels per input unit.
    pub scale: f64,
}

impl Frame {
    /// The box of the points, or `None` when there are none or a number or the size is not finite.
    pub fn of(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = points.next()?;
        let mut frame = Self { low: first, high: first };
        let mut finite = first.iter().all(|v| v.is_finite());
        for p in points {
            finite &= p.iter().all(|v| v.is_finite());
            frame = frame.join(Self { low: p, high: p });
        }
        (finite && frame.side().is_finite()).then_some(frame)
    }

    /// The box of the region's boundary; arcs by their samples, so within 1% of their radius.
    pub fn of_region(region: &Region) -> Option<Self> {
        Self::of(edge::of_region(region).flat_map(|e| e.samples()))
    }

    /// The square of the given side around a point.
    pub fn around(centre: Point, side: f64) -> Self {
        Self { low: centre, high: centre }.grown(side / 2.0)
    }

    /// The smallest box that holds both.
    pub fn join(self, other: Self) -> Self {
        let low = [0, 1].map(|i| self.low[i].min(other.low[i]));
        let high = [0, 1].map(|i| self.high[i].max(other.high[i]));
        Self { low, high }
    }

    /// The Minkowski sum of two boxes: it holds the sum of what they hold.
    pub fn plus(self, other: Self) -> Self {
        let add = |a: Point, b: Point| [a[0] + b[0], a[1] + b[1]];
        Self { low: add(self.low, other.low), high: add(self.high, other.high) }
    }

    /// The common part; `self` when there is none.
    pub fn clipped(self, bound: Self) -> Self {
        let low = [0, 1].map(|i| self.low[i].max(bound.low[i]));
        let high = [0, 1].map(|i| self.high[i].min(bound.high[i]));
        if low[0] <= high[0] && low[1] <= high[1] { Self { low, high } } else { self }
    }

    /// The box with `margin` input units added on every side.
    pub fn grown(self, margin: f64) -> Self {
        Self { low: self.low.map(|v| v - margin), high: self.high.map(|v| v + margin) }
    }

    /// The width.
    pub fn width(&self) -> f64 {
        self.high[0] - self.low[0]
    }

    /// The height.
    pub fn height(&self) -> f64 {
        self.high[1] - self.low[1]
    }

    /// The larger side.
    pub fn side(&self) -> f64 {
        self.width().max(self.height())
    }

    /// Whether all of `other` lies inside.
    pub fn holds(&self, other: Self) -> bool {
        self.join(other) == *self
    }
}

impl View {
    /// Width and height in pixels.
    pub fn size(&self) -> Point {
        [self.frame.width() * self.scale, self.frame.height() * self.scale]
    }

    /// A point in pixels, counted from the lower left corner.
    pub fn point(&self, p: Point) -> Point {
        [0, 1].map(|i| (p[i] - self.frame.low[i]) * self.scale)
    }

    /// An edge in pixels.
    pub fn edge(&self, edge: &Edge) -> Edge {
        Edge { tail: self.point(edge.tail), head: self.point(edge.head), bulge: edge.bulge }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use arcsum::region::{Curve, Node};

    #[test]
    fn disc_is_framed() {
        let half = |x: f64| Node { x, y: 3.0, curve: Curve::Bulge(1.0) };
        let disc = Region { loops: vec![vec![half(1.0), half(5.0)]], ..Region::default() };
        let frame = Frame::of_region(&disc).unwrap();
        assert!((frame.width() - 4.0).abs() < 1e-12 && (frame.height() - 4.0).abs() < 1e-12);
    }

    #[test]
    fn no_points_or_bad_points_have_no_frame() {
        assert_eq!(Frame::of([]), None);
        assert_eq!(Frame::of([[0.0, 0.0], [f64::NAN, 1.0], [2.0, 2.0]]), None);
        assert_eq!(Frame::of([[-1e308, 0.0], [1e308, 1.0]]), None);
    }

    #[test]
    fn view_maps_corners() {
        let view = View { frame: Frame { low: [10.0, 20.0], high: [12.0, 21.0] }, scale: 50.0 };
        assert_eq!(view.size(), [100.0, 50.0]);
        assert_eq!(view.point([12.0, 20.0]), [100.0, 0.0]);
    }
}
