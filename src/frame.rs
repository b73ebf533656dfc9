//! The unit box: the power of two and the shift that carry input units to it and back (memo A4 step 1).
//!
//! unit = (p - shift) 2^-exp. One `exp` serves all regions of a case, so that the larger side of the largest bounding
//! box lies in (1/2, 1] up to the rounding of arc extents; each region has its own shift. Both steps are exact as long
//! as no nonzero difference falls below 2^-1022 of the unit box; smaller ones lose bits or become zero. Coordinates
//! below 2^1020 do not overflow on the way.

use crate::arc::Arc;
use crate::region::{Curve, Node, Region};
use crate::sum3::Rounding;
use crate::twofold::two_sum;
use glam::DVec2;

/// The map from input units to units of the frame. See the module.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The unit box has side 2^exp in input units.
    pub exp: i32,
    /// The point that becomes the origin, in input units.
    pub shift: DVec2,
}

impl Frame {
    /// Frames for two operands of a sum: one scale, a shift for each.
    #[must_use]
    pub fn pair(a: &Region, b: &Region) -> (Self, Self) {
        let exp = [a, b].iter().filter_map(|r| scale(&[r])).max().unwrap_or(0);
        (Self { exp, shift: shift(&[a], exp) }, Self { exp, shift: shift(&[b], exp) })
    }

    /// One frame for all regions of a set operation, whose coordinates must stay comparable. The unit box holds the
    /// box of all of them.
    #[must_use]
    pub fn shared(regions: &[&Region]) -> Self {
        let exp = scale(regions).unwrap_or(0);
        Self { exp, shift: shift(regions, exp) }
    }

    /// From input units to units of the frame.
    #[must_use]
    pub fn to_unit(&self, p: DVec2) -> DVec2 {
        let d = p - self.shift;
        DVec2::new(self.length_to_unit(d.x), self.length_to_unit(d.y))
    }

    /// A length, such as a signed radius, from input units to units of the frame.
    #[must_use]
    pub fn length_to_unit(&self, length: f64) -> f64 {
        libm::ldexp(length, -self.exp)
    }

    /// A length from units of the frame to input units.
    #[must_use]
    pub fn length_to_input(&self, length: f64) -> f64 {
        libm::ldexp(length, self.exp)
    }

    /// From units of the frame to input units, rounded once.
    #[must_use]
    pub fn to_input(&self, p: DVec2) -> DVec2 {
        self.sum_to_input(&Self { exp: self.exp, shift: DVec2::ZERO }, p)
    }

    /// A point of the sum of a region in this frame and one in the other, which has the same `exp`, to input units:
    /// p 2^exp + both shifts, rounded once.
    #[must_use]
    pub fn sum_to_input(&self, other: &Self, p: DVec2) -> DVec2 {
        let scaled = DVec2::new(self.length_to_input(p.x), self.length_to_input(p.y));
        Rounding::Correct.sum_points(scaled, self.shift, other.shift)
    }
}

/// A bounding box, arc extents included, in input units times 2^-exponent: large and tiny coordinates alike stay far
/// from overflow in the arc formulas.
struct Bounds {
    exponent: i32,
    min: DVec2,
    max: DVec2,
}

impl Bounds {
    /// The bounds of all loops; `None` without any vertex or if some coordinate is not finite.
    fn of(regions: &[&Region]) -> Option<Self> {
        let size = coordinates(regions).map(f64::abs).fold(0.0, f64::max);
        if regions.iter().all(|r| r.segments() == 0) || !coordinates(regions).all(f64::is_finite) {
            return None;
        }
        let exponent = libm::frexp(size).1;
        let (min, max) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let mut bounds = Self { exponent, min, max };
        for nodes in regions.iter().flat_map(|r| &r.loops) {
            for (i, node) in nodes.iter().enumerate() {
                bounds.add(node, &nodes[(i + 1) % nodes.len()]);
            }
        }
        Some(bounds)
    }

    fn add(&mut self, from: &Node, to: &Node) {
        let scaled = |x: f64| libm::ldexp(x, -self.exponent);
        let (tail, head) = (DVec2::new(scaled(from.x), scaled(from.y)), DVec2::new(scaled(to.x), scaled(to.y)));
        let arc = match from.curve {
            Curve::Line => None,
            _ if is_flat(to.x - from.x, to.y - from.y, from.curve) => None,
            Curve::Radius(r) => Arc::with_radius(tail, head, scaled(r)).ok(),
            Curve::Bulge(b) => Arc::with_bulge(tail, head, b).ok(),
        };
        let cuts = arc.map(|arc| arc.cuts()).unwrap_or_default();
        for p in cuts.into_iter().map(|(_, p)| p).chain([tail]) {
            self.min = self.min.min(p);
            self.max = self.max.max(p);
        }
    }

    /// The exponent for which the larger side lies in (1/2, 1] times 2 to it. `None` for a single point.
    fn exponent_of_side(&self) -> Option<i32> {
        let side = (self.max - self.min).max_element();
        let (mantissa, exponent) = libm::frexp(side);
        let exponent = if mantissa == 0.5 { exponent - 1 } else { exponent };
        (side > 0.0 && side.is_finite()).then_some(self.exponent + exponent)
    }
}

/// Whether a segment turns so little, for the direction of its chord, that no normal on it is along an axis: then its ends
/// bound it. Where in doubt, not.
fn is_flat(dx: f64, dy: f64, curve: Curve) -> bool {
    let (low, high) = (dx.abs().min(dy.abs()), dx.abs().max(dy.abs()));
    let tangent_of_half_sweep = match curve {
        Curve::Line => 0.0,
        Curve::Bulge(b) if b.abs() < 0.5 => 2.0 * b.abs() / (1.0 - b * b),
        Curve::Radius(r) if high < r.abs() => {
            let sine = libm::hypot(low / r, high / r) / 2.0;
            sine / (1.0 - sine * sine).sqrt()
        }
        Curve::Bulge(_) | Curve::Radius(_) => return false,
    };
    low > 1.001 * tangent_of_half_sweep * high
}

fn scale(regions: &[&Region]) -> Option<i32> {
    Bounds::of(regions)?.exponent_of_side()
}

/// The centre of the bounding box on a grid of half the unit box, by coordinates, or 0 where nothing is gained (the box
/// is within one side of the origin) or where some difference would not be exact. Every vertex ends below 1.5 in
/// magnitude: coordinates that all exceed half a side share a last place coarse enough to shift exactly.
fn shift(regions: &[&Region], exp: i32) -> DVec2 {
    let Some(bounds) = Bounds::of(regions) else { return DVec2::ZERO };
    let to_grid = |x: f64| libm::ldexp(x, bounds.exponent - exp + 1);
    let along = |min: f64, max: f64, coordinate: fn(&Node) -> f64| {
        if to_grid(min.abs().max(max.abs())) <= 2.0 {
            return 0.0;
        }
        let centre = libm::ldexp(libm::rint(to_grid(min / 2.0 + max / 2.0)), exp - 1);
        let exact = |node: &Node| two_sum(coordinate(node), -centre).1 == 0.0;
        if regions.iter().flat_map(|r| r.loops.iter().flatten()).all(exact) { centre } else { 0.0 }
    };
    DVec2::new(along(bounds.min.x, bounds.max.x, |n| n.x), along(bounds.min.y, bounds.max.y, |n| n.y))
}

fn coordinates(regions: &[&Region]) -> impl Iterator<Item = f64> {
    regions.iter().flat_map(|r| r.loops.iter().flatten()).flat_map(|n| [n.x, n.y])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is called flat has no normal along an axis, and most of what has none is called flat.
    #[test]
    fn flat_arcs_are_bounded_by_their_ends() {
        let (mut flat, mut monotone) = (0, 0);
        for (i, j, k) in (-12..=12).flat_map(|i| (-12..=12).flat_map(move |j| (-24..=24).map(move |k| (i, j, k)))) {
            let head = DVec2::new(f64::from(i) / 8.0, f64::from(j) / 8.0);
            if head == DVec2::ZERO || k == 0 {
                continue;
            }
            let (bulge, radius) = (f64::from(k) / 30.0, head.length() * 12.0 / f64::from(k));
            for (curve, arc) in [
                (Curve::Bulge(bulge), Arc::with_bulge(DVec2::ZERO, head, bulge)),
                (Curve::Radius(radius), Arc::with_radius(DVec2::ZERO, head, radius)),
            ] {
                let is_monotone = arc.expect("an arc").cuts().is_empty();
                let is_flat = is_flat(head.x, head.y, curve);
                assert!(is_monotone || !is_flat, "{head} {curve:?}");
                (flat, monotone) = (flat + i32::from(is_flat), monotone + i32::from(is_monotone));
            }
        }
        assert!(10 * flat > 9 * monotone, "{flat} of {monotone}");
    }
}
