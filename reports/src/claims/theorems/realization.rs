//! M13: Theorem 1, the distance of a region and its realization (MS 4.2; memo I5, fact 4).
//!
//! As printed it is the vertical distance, angles are radians in [0, 2 pi), and chains are adjusted along the y axis. It
//! grows with the steepness of lines, whose angles lose their relative accuracy near 180 and 360 degrees, and with
//! that of short circle segments. Corrected, angles are offsets from an axis, chains are adjusted along a direction
//! clear of the boundary, and the distance is that of matched points, which is no less than the Hausdorff distance.

use super::super::control::Control;
use super::super::draw::input;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::{EPS, families};
use crate::bridge::stored_by;
use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::cases::shape::{Point, lines, polygon, region, regular};
use crate::kept;
use arcsum::region::{Curve, Node, Region};
use arcsum::robustness::{Robustness, Step};
use arcsum_oracle::certified::realize::{StoredRegion, realize, vertical_distance};
use libm::{scalbn, sin, tan};

/// The most segments a region has.
const MOST: u32 = 8192;

/// Draws of quick effort: all kinds with 8 to 512 segments.
const QUICK: usize = families::ALL * 7;

pub(super) fn claims() -> [Claim; 2] {
    let printed = Claim {
        id: "M13 printed",
        place: "MS 4.2",
        says: "Theorem 1: the vertical distance of a region of n segments and its realization is O(n eps).",
        erratum: "With angles in radians it grows with the steepness of lines. With any angles it grows as 1/s where a \
                  circle segment of sweep s meets a vertical tangentially.",
        test: Test::Sup(Sup {
            quantity: "vertical distance / (n eps), over the steepness",
            unit: "1",
            rule: Rule::Flat,
            draws: [400, 20_000],
            draw: draw_steep,
            measure: |input| as_printed(input, Robustness::ALL.without(Step::Angles)),
            kept: kept!("M13_printed"),
            control: Control::Itself,
        }),
    };
    let corrected = Claim {
        id: "M13 corrected",
        place: "MS 4.2",
        says: "The Hausdorff distance of a region of n segments and its realization is O(n eps), with angles stored as \
               offsets from an axis and chains adjusted along a clear direction.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "distance of matched points / (n eps), over n",
            unit: "1",
            rule: Rule::Flat,
            draws: [QUICK, families::ALL * 11 * 3],
            draw,
            measure: |input| as_corrected(input, |_| 0.0),
            kept: kept!("M13_corrected"),
            control: Control::Measure {
                plants: "all normals turned by n^2 eps",
                measure: |input| as_corrected(input, |n| (n * n) as f64 * EPS),
            },
        }),
    };
    [printed, corrected]
}

/// The first operand as the engine stores it, against a small one.
fn stored(case: &Case, robustness: Robustness) -> Option<StoredRegion> {
    stored_by(&case.a, &case.b, robustness).ok().map(|[a, _]| a)
}

/// The vertical distance over n eps; the size is the steepness.
fn as_printed(input: &Input, robustness: Robustness) -> Option<Measured> {
    let case = input.as_pair()?;
    let [lo, hi] = vertical_distance(&stored(case, robustness)?).ok()?;
    let unit = case.a.segments() as f64 * EPS;
    Some(Measured { size: steepness(&case.a)?, ..Measured::between(lo / unit, hi / unit) })
}

/// The greatest power of two below the steepness of the lines and chords.
fn steepness(region: &Region) -> Option<f64> {
    let slope = |nodes: &[Node], i: usize| {
        let (p, q) = (nodes[i], nodes[(i + 1) % nodes.len()]);
        ((q.y - p.y) / (q.x - p.x)).abs()
    };
    let slopes = region.loops.iter().flat_map(|nodes| (0..nodes.len()).map(move |i| slope(nodes, i)));
    let steepest = slopes.filter(|slope| slope.is_finite()).reduce(f64::max)?;
    Some(scalbn(0.5, libm::frexp(steepest).1))
}

/// The distance of matched points over n eps, with all normals turned by an angle.
fn as_corrected(input: &Input, turn: fn(usize) -> f64) -> Option<Measured> {
    let case = input.as_pair()?;
    let n = case.a.segments();
    let mut region = stored(case, Robustness::ALL)?;
    for piece in region.loops.iter_mut().flatten() {
        // Away from the ends of the range of offsets, which must not be left.
        for angle in [&mut piece.start, &mut piece.end] {
            angle.offset = (angle.offset + turn(n)).min(std::f64::consts::FRAC_PI_4);
        }
    }
    let moved = realize(&region).ok()?.moved.boundary;
    Some(Measured::exactly(moved / (n as f64 * EPS)).of_size(n))
}

fn draw(rng: &mut Rng, number: usize) -> Input {
    // All sizes of quick effort come first.
    let most = if number < QUICK { 512 } else { MOST };
    let (kind, a) = families::region(number, families::ALL, most, rng);
    input(kind, a, polygon(&regular(3, 0.3, 0.1)))
}

/// Boxes with a nearly vertical side, or with a short circle segment that continues a vertical one.
fn draw_steep(rng: &mut Rng, number: usize) -> Input {
    let lean = scalbn(rng.between(1.0, 2.0), -8 - (number / 2 % 30) as i32);
    let (kind, a) =
        if number.is_multiple_of(2) { ("leaning", leaning(lean, rng)) } else { ("tangent", tangent(lean, rng)) };
    input(kind, a, polygon(&regular(3, 0.3, 0.1)))
}

fn leaning(lean: f64, rng: &mut Rng) -> Region {
    let (width, height) = (rng.between(0.3, 0.9), rng.between(0.5, 1.0));
    let corners: [Point; 4] = [[0.0, 0.0], [width, 0.0], [width + lean, height], [lean, height]];
    // Either both sides lean, or one, and to either hand.
    let mut corners = corners.to_vec();
    if rng.below(2) == 0 {
        corners[3][0] = 0.0;
    }
    if rng.below(2) == 0 {
        corners = corners.iter().rev().map(|p| [1.0 - p[0], p[1]]).collect();
    }
    region(vec![lines(&corners)])
}

/// A box whose right side goes over into a circle segment of this sweep tangentially, up to the rounding of its end.
fn tangent(sweep: f64, rng: &mut Rng) -> Region {
    let (r, x) = (0.4 / sweep, rng.between(0.7, 1.0));
    let end = (x - 2.0 * r * sin(sweep / 2.0) * sin(sweep / 2.0), 0.5 + r * sin(sweep));
    let arc = Node { x, y: 0.5, curve: Curve::Bulge(tan(sweep / 4.0)) };
    let line = Node::line;
    region(vec![vec![line(0.1, 0.1), line(x, 0.1), arc, line(end.0, end.1), line(0.2, 1.0)]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_leaning_side_costs_radians_its_steepness() {
        let lean = scalbn(1.1, -20);
        let a = polygon(&[[0.0, 0.0], [0.5, 0.0], [0.5 + lean, 1.0], [0.0, 1.0]]);
        let pair = input("leaning", a, polygon(&regular(3, 0.3, 0.1)));
        let radians = as_printed(&pair, Robustness::ALL.without(Step::Angles)).unwrap();
        let offsets = as_printed(&pair, Robustness::ALL).unwrap();
        assert_eq!(radians.size, scalbn(1.0, 19));
        assert!(radians.lo > 1e3 && offsets.hi < 4.0, "{radians:?} {offsets:?}");
        let corrected = as_corrected(&pair, |_| 0.0).unwrap();
        assert!(corrected.hi < 4.0 && corrected.size == 4.0);
    }
}
