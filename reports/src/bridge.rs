//! Regions crossing the line to the oracle as plain numbers, and the unit box (section 3 of the design).

use arcsum::region::{Curve, Node, Region};
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};

/// The region as the oracle takes it.
#[must_use]
pub fn plain(region: &Region) -> PlainRegion {
    let bend = |curve| match curve {
        Curve::Line => Bend::Line,
        Curve::Radius(r) => Bend::Radius(r),
        Curve::Bulge(b) => Bend::Bulge(b),
    };
    let corner = |n: &Node| Corner { x: n.x, y: n.y, bend: bend(n.curve) };
    PlainRegion {
        loops: region.loops.iter().map(|l| l.iter().map(corner).collect()).collect(),
        unbounded: region.unbounded,
    }
}

/// The side of the unit box in input units: the power of two that brings the larger side of the larger bounding box of
/// the operands into (1/2, 1]. Boxes are those of the vertices; with arcs the true box can be a little larger.
#[must_use]
pub fn unit(a: &Region, b: &Region) -> f64 {
    let side = crate::cases::shape::extent(a).max(crate::cases::shape::extent(b));
    if side == 0.0 || !side.is_finite() {
        return 1.0;
    }
    let (fraction, exponent) = libm::frexp(side);
    libm::scalbn(1.0, if fraction == 0.5 { exponent - 1 } else { exponent })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{polygon, rectangle};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_unit_is_a_power_of_two_that_fits(side in 1e-200_f64..1e200) {
            let square = polygon(&rectangle([0.0, 0.0], [side, side / 3.0]));
            let unit = unit(&square, &polygon(&rectangle([0.0, 0.0], [side / 2.0, side])));
            prop_assert!(side / unit > 0.5 && side / unit <= 1.0);
            prop_assert_eq!(libm::frexp(unit).0, 0.5);
        }
    }
}
