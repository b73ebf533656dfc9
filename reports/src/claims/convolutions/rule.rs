//! M21: two segments count as convexly compatible when their sum runs forward, which leaves no gap in a crust in floating
//! point, or when their curvatures add up to no negative number, which does (MS 6).

use super::super::control::Control;
use super::super::draw::{self, input};
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use crate::cases::rng::Rng;
use crate::cases::shape::{Point, polygon, region};
use crate::kept;
use arcsum::convolution::monotonic_by;
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::region::{Curve, Node, Region};
use arcsum::robustness::{Robustness, Step};
use arcsum::smooth::Smooth;
use arcsum::validate::validate;
use glam::DVec2;
use libm::{cos, scalbn, sin};
use rug::{Float, Rational};
use std::cmp::Ordering;
use std::f64::consts::{FRAC_PI_2, PI};

const EPS: f64 = f64::EPSILON / 2.0;

/// What the numbers are: signed radii, and the least and greatest shared angle in radians.
const ARCS: &str = "r_a, r_b, low, high";

/// Bits that tell cosines of different doubles apart, and their products with sums of radii.
const PRECISION: u32 = 2400;

pub(super) fn claims() -> [Claim; 3] {
    [gaps(), gaps_by_curvature(), equivalence()]
}

fn gaps() -> Claim {
    Claim {
        id: "M21",
        place: "MS 6",
        says: "With the rule by end points the convolution has no gaps in floating point.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "widest gap",
            unit: "eps",
            rule: Rule::AtMost(0.0),
            draws: [6_000, 600_000],
            draw,
            measure: |input| widest(input, Robustness::ALL),
            kept: kept!("M21"),
            control: Control::Measure {
                plants: "the rule by curvatures",
                measure: |input| widest(input, Robustness::ALL.without(Step::Forward)),
            },
        }),
    }
}

fn gaps_by_curvature() -> Claim {
    Claim {
        id: "M21 curvature",
        place: "MS 6",
        says: "With the rule by curvatures it has gaps.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "widest gap",
            unit: "eps",
            rule: Rule::Exceeds(0.0),
            draws: [6_000, 600_000],
            draw,
            measure: |input| widest(input, Robustness::ALL.without(Step::Forward)),
            kept: kept!("M21_curvature"),
            control: Control::Measure {
                plants: "the rule by end points",
                measure: |input| widest(input, Robustness::ALL),
            },
        }),
    }
}

fn equivalence() -> Claim {
    Claim {
        id: "M21 exact",
        place: "MS 6",
        says: "In exact arithmetic both rules take the same sums of circle segments.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "different answers",
            unit: "1",
            rule: Rule::AtMost(0.0),
            draws: [10_000, 1_000_000],
            draw: draw_arcs,
            measure: |input| different(input, curvature),
            kept: kept!("M21_exact"),
            control: Control::Measure {
                plants: "the sum of the radii for that of the curvatures",
                measure: |input| different(input, radii),
            },
        }),
    }
}

/// The widest gap in the convolution with these robustness steps, in eps of the unit box, and where it is.
fn widest(input: &Input, robustness: Robustness) -> Option<Measured> {
    let case = input.as_pair()?;
    let frames = Frame::pair(&case.a, &case.b);
    let a = Smooth::by(&case.a, &frames.0, robustness).ok()?;
    let b = Smooth::by(&case.b, &frames.1, robustness).ok()?;
    let (pieces, _) = monotonic_by(&a, &b, robustness)?;
    let mut widest = Measured::exactly(0.0);
    for (gap, place) in not_vertical(&pieces).chain(not_joined(&pieces)) {
        if gap / EPS > widest.lo {
            let spot = frames.0.sum_to_input(&frames.1, place);
            widest = Measured::exactly(gap / EPS).at([spot.x, spot.y]);
        }
    }
    Some(widest)
}

/// A crust is closed by lines that come from no pair of segments. Where it has no gap these are vertical: their widths.
fn not_vertical(pieces: &Pieces) -> impl Iterator<Item = (f64, DVec2)> {
    pieces.pieces.iter().filter(|piece| piece.source.first == u32::MAX).map(|piece| {
        let [tail, head] = [piece.tail, piece.head].map(|v| pieces.points[v as usize]);
        ((head.x - tail.x).abs(), 0.5 * (tail + head))
    })
}

/// Where more pieces come in than go out: how far it is to the nearest vertex where it is the other way round.
fn not_joined(pieces: &Pieces) -> impl Iterator<Item = (f64, DVec2)> {
    let mut balance = vec![0; pieces.points.len()];
    for piece in &pieces.pieces {
        balance[piece.tail as usize] -= 1;
        balance[piece.head as usize] += 1;
    }
    let of = |sign: i32| -> Vec<DVec2> {
        (0..balance.len()).filter(|&v| balance[v] * sign > 0).map(|v| pieces.points[v]).collect()
    };
    let (ends, starts) = (of(1), of(-1));
    let gap = move |end: DVec2| starts.iter().map(|start| end.distance(*start)).fold(f64::INFINITY, f64::min);
    ends.into_iter().map(move |end| (gap(end), end))
}

/// Whether both rules differ on the sum of two segments of upper chains over their shared angles.
fn different(input: &Input, curvature: fn([f64; 2]) -> Ordering) -> Option<Measured> {
    let [r_a, r_b, low, high]: [f64; 4] = input.as_numbers(ARCS)?.try_into().ok()?;
    let compatible = curvature([r_a, r_b]).is_gt();
    Some(Measured::count(usize::from(runs_forward(r_a, r_b, [low, high])? != compatible)))
}

/// Whether the head of the sum is left of its tail (memo B1): it runs from low to high if both are convex or both are
/// concave, else from high to low. The point of a segment at an angle is the centre and the normal times the radius.
fn runs_forward(r_a: f64, r_b: f64, [low, high]: [f64; 2]) -> Option<bool> {
    let float = |x: f64| Float::with_val(PRECISION, x);
    let abscissa = |angle: f64| float(angle).cos() * (float(r_a) + r_b);
    let (from, to) = if (r_a > 0.0) == (r_b > 0.0) { (low, high) } else { (high, low) };
    abscissa(to).partial_cmp(&abscissa(from)).map(Ordering::is_lt)
}

/// The sign of the sum of the curvatures 1/r_a + 1/r_b.
fn curvature([r_a, r_b]: [f64; 2]) -> Ordering {
    let inverse = |r: f64| Rational::from_f64(r).map(Rational::recip).unwrap_or_default();
    (inverse(r_a) + inverse(r_b)).cmp0()
}

/// The sign of the sum of the radii.
fn radii([r_a, r_b]: [f64; 2]) -> Ordering {
    (Float::with_val(PRECISION, r_a) + r_b).cmp0().unwrap_or(Ordering::Equal)
}

/// Radii of any sizes and signs, often nearly opposite, and shared angles of upper chains, often few units wide. Opposite
/// radii are left out: their sum is a point.
fn draw_arcs(rng: &mut Rng, _: usize) -> Input {
    loop {
        let r_a = scalbn(rng.between(0.5, 1.0), 20 - rng.below(60) as i32) * [1.0, -1.0][rng.below(2)];
        let nearly = -r_a * (1.0 + (rng.below(129) as f64 - 64.0) * f64::EPSILON);
        let r_b = if rng.below(2) == 0 { nearly } else { scalbn(rng.between(-1.0, 1.0), 20 - rng.below(60) as i32) };
        let low = [rng.between(0.0, PI), FRAC_PI_2, scalbn(rng.unit(), -(rng.below(60) as i32))][rng.below(3)];
        let width = if rng.below(2) == 0 { rng.unit() } else { (1 + rng.below(8)) as f64 * f64::EPSILON };
        let high = (low + width).min(PI);
        if r_a + r_b != 0.0 && r_b != 0.0 && low < high {
            return Input::numbers(ARCS, [r_a, r_b, low, high]);
        }
    }
}

/// Pairs of any kind; blocks with a convex and a concave top of nearly the same radius, whole or over few units of
/// angle; and polygons with lines that are hardly wider than a rounding.
fn draw(rng: &mut Rng, number: usize) -> Input {
    match number % 4 {
        0 => draw::pair(rng, number),
        1 => input("nearly vertical", upright(rng), upright(rng)),
        kind => {
            let radius = rng.between(0.3, 0.9);
            let nearly = radius * (1.0 + (rng.below(129) as f64 - 64.0) * f64::EPSILON);
            let other = if rng.below(3) > 0 { nearly } else { rng.between(0.3, 0.9) };
            let sweep = [rng.between(0.1, 1.0), rng.between(0.1, 1.0)];
            let wide = scalbn(rng.between(0.0, 0.2), -(rng.below(48) as i32));
            let shared = if kind == 2 { wide } else { (1 + rng.below(8)) as f64 * f64::EPSILON };
            let first = rng.between(0.9, 1.4);
            let round = |radius: f64, from: f64, sweep: f64| topped(radius, [from, from + sweep]);
            let b = round(-other, first + sweep[0] - shared, sweep[1]);
            input("nearly opposite", round(radius, first, sweep[0]), b)
        }
    }
}

/// A block whose top is a circle segment of this signed radius between two normals, most of them pointing up.
fn topped(radius: f64, [low, high]: [f64; 2]) -> Region {
    // A concave one runs from the greater normal to the smaller one.
    let [from, to] = if radius > 0.0 { [low, high] } else { [high, low] };
    let at = |angle: f64| [radius * cos(angle), radius * sin(angle)];
    let ([x0, y0], [x1, y1]) = (at(from), at(to));
    let floor = y0.min(y1) - 1.0;
    let arc = Node { x: x0, y: y0, curve: Curve::Radius(radius) };
    region(vec![vec![Node::line(x1, floor), Node::line(x0, floor), arc, Node::line(x1, y1)]])
}

/// A star of small integers, of whose abscissas some are off by less than a rounding of 1.
fn upright(rng: &mut Rng) -> Region {
    let n = 4 + rng.below(3);
    let corner = |i: usize, rng: &mut Rng| -> Point {
        let angle = 2.0 * PI * (i as f64 + 0.3) / n as f64;
        let size = 1.0 + rng.below(3) as f64;
        let [x, y] = [(size * cos(angle)).round(), (size * sin(angle)).round()];
        let off = scalbn(rng.between(-1.0, 1.0), -50 - rng.below(10) as i32);
        [if rng.below(2) == 0 { x + off } else { x }, y]
    };
    loop {
        let points: Vec<Point> = (0..n).map(|i| corner(i, rng)).collect();
        let star = polygon(&points);
        if validate(&star).is_ok() {
            return star;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rules_agree_on_the_four_cases_of_the_paper() {
        for ([r_a, r_b], forward) in
            [([1.0, 2.0], true), ([1.0, -2.0], true), ([2.0, -1.0], false), ([-1.0, -2.0], false)]
        {
            assert_eq!(runs_forward(r_a, r_b, [1.0, 2.0]), Some(forward));
            assert_eq!(curvature([r_a, r_b]).is_gt(), forward);
        }
    }

    #[test]
    fn a_known_pair_has_a_gap_by_curvatures_only() {
        let a = polygon(&[[1.0, 0.0], [2.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [2.0, -2.0], [1.0, -1.0]]);
        let b = polygon(&[[1.0, 0.0], [0.0, 1.0], [-1.387_778_780_781_445_7e-17, -1.0], [2.0, -2.0]]);
        let pair = input("known", a, b);
        assert_eq!(widest(&pair, Robustness::ALL).unwrap().hi, 0.0);
        assert!(widest(&pair, Robustness::ALL.without(Step::Forward)).unwrap().lo > 0.0);
    }
}
