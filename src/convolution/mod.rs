//! Convolutions: closed curves whose winding numbers tell the sum from the free space (MS 3; memo B).

mod buckets;
mod cancelled;
mod convex;
mod crust;
pub mod envelope;
pub mod fill;
mod kinetic;
mod monotonic;
pub mod order;
pub mod ordered;
mod sites;
mod stab;
mod sums;

use crate::angle::Ang;
use crate::arrangement::cross::{CrossingModule, FloatModule};
use crate::arrangement::plain::PlainModule;
use crate::piece::Pieces;
use crate::robustness::{Robustness, Step};
use crate::smooth::Smooth;
use crate::sum3::Rounding;
use crust::Rule;
use fill::{Filled, PairSum, fill};
use kinetic::Side;
use monotonic::Monotonic;
use order::Order;
use sums::Sums;

/// A place inside an arc of an operand at which sum segments end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Stop {
    /// The loop, an index of [`Smooth::loops`].
    pub of_loop: usize,
    /// The arc, an index of its [`crate::smooth::SmoothLoop::segs`].
    pub seg: usize,
    /// The normal angle there.
    pub angle: Ang,
}

/// The kinetic convolution of two regions in frames of one scale, with the fill rule applied to every pair of
/// components. `None` when the sum is the whole plane.
#[must_use]
pub fn kinetic(a: &Smooth, b: &Smooth, rounding: Rounding) -> Option<Pieces> {
    collect(a, b, rounding, kinetically).map(|(sums, base)| sums.finish(base))
}

/// The monotonic convolution, likewise, and the order of its pieces.
#[must_use]
pub fn monotonic(a: &Smooth, b: &Smooth, rounding: Rounding) -> Option<(Pieces, Order)> {
    crusts_and_boundaries(a, b, rounding, Rule::Ends, &FloatModule::new(EXTENT))
}

/// The kinetic convolution with these robustness steps only (MS 8.3).
#[must_use]
pub fn kinetic_by(a: &Smooth, b: &Smooth, robustness: Robustness) -> Option<Pieces> {
    kinetic(a, b, robustness.rounding())
}

/// The monotonic convolution with these robustness steps only. Without [`Step::Forward`] it may have gaps, closed by lines
/// that are not vertical.
#[must_use]
pub fn monotonic_by(a: &Smooth, b: &Smooth, robustness: Robustness) -> Option<(Pieces, Order)> {
    let rule = if robustness.takes(Step::Forward) { Rule::Ends } else { Rule::Curvature };
    if robustness.takes(Step::Crossings) {
        crusts_and_boundaries(a, b, robustness.rounding(), rule, &FloatModule::new(EXTENT))
    } else {
        crusts_and_boundaries(a, b, robustness.rounding(), rule, &PlainModule)
    }
}

/// The convex convolution with these robustness steps only, of which rounding matters here. Its pieces do not form closed
/// curves.
#[must_use]
pub fn convex_by(a: &Smooth, b: &Smooth, robustness: Robustness) -> Option<Pieces> {
    collect(a, b, robustness.rounding(), convex::convex).map(|(sums, base)| sums.finish(base))
}

fn crusts_and_boundaries<M: CrossingModule>(
    a: &Smooth,
    b: &Smooth,
    rounding: Rounding,
    rule: Rule,
    module: &M,
) -> Option<(Pieces, Order)> {
    let mut order = Order::default();
    let (sums, base) = collect(a, b, rounding, |sums, filled| {
        Monotonic::new(sums, &mut order, filled, (rule, module)).convolve();
    })?;
    Some((sums.finish(base), order))
}

/// The side of a box that holds every sum of regions in the unit box.
const EXTENT: f64 = 2.0;

/// The places inside the arcs of each operand at which the segments of their kinetic convolution end, in order: where
/// step 1 of MS 4.2 splits. Nothing when the sum is the whole plane.
#[must_use]
pub fn kinetic_stops(a: &Smooth, b: &Smooth) -> [Vec<Stop>; 2] {
    collect(a, b, Rounding::Correct, kinetically).map(|(sums, _)| sums.stops()).unwrap_or_default()
}

fn kinetically(sums: &mut Sums, filled: &Filled) {
    let (a, b) = sums.regions();
    kinetic::convolve(sums, [Side::of_loops(a, &filled.a), Side::of_loops(b, &filled.b)]);
}

/// The sum segments of all pairs of components and the winding number far away.
fn collect<'a>(
    a: &'a Smooth,
    b: &'a Smooth,
    rounding: Rounding,
    mut convolve: impl FnMut(&mut Sums<'a>, &Filled),
) -> Option<(Sums<'a>, i32)> {
    let mut sums = Sums::new(a, b, rounding);
    let mut base = 0;
    for i in &a.components {
        for j in &b.components {
            match fill(a, i, b, j) {
                PairSum::Plane => return None,
                PairSum::Loops(filled) => {
                    base += filled.base;
                    convolve(&mut sums, &filled);
                }
            }
        }
    }
    Some((sums, base))
}
