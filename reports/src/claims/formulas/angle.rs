//! Normal angles against MPFR (memo A2, A3, facts 1 and 4).

use super::formula::{Formula, ends, value};
use crate::cases::rng::Rng;
use arcsum::angle::Ang;
use arcsum_oracle::precise::{self, Vector, big, in_eps, reduced, relative};
use glam::DVec2;
use rug::Float;
use std::f64::consts::{FRAC_PI_2, PI};

/// The normal angle of a line.
pub(super) const OF_LINE: Formula = Formula { name: "of_line", bound: 3.0, draw: line, error: of_line };

/// Formulas about angles. Bounds: the arc tangent has one unit in the last place, 2 eps, and its correction one more rounding;
/// the sums of angles round once, before and after which pi/2 has 106 bits; sine and cosine have one unit in the last place. A
/// line whose offset is wrong by 3 eps of itself has its head moved by at most 3 |dx| |off| / sin^2 phi <= 3 pi/2.
pub const ANGLES: [Formula; 7] = [
    Formula { name: "of_normal", bound: 3.0, draw: direction, error: of_normal },
    OF_LINE,
    Formula { name: "plus", bound: 2.0, draw: with_half_sweep, error: plus },
    Formula { name: "turn_to", bound: 2.0, draw: two_directions, error: turn_to },
    Formula { name: "half_sum", bound: 2.0, draw: two_directions, error: half_sum },
    Formula { name: "sin_cos", bound: 2.0, draw: direction, error: sin_cos },
    Formula { name: "realized_line", bound: 4.72, draw: line, error: realized_line },
];

/// The realization of lines whose angles are radians in [0, 2 pi), as MS store them.
pub const REALIZED_IN_RADIANS: Formula =
    Formula { name: "realized_in_radians", bound: f64::INFINITY, draw: line, error: realized_in_radians };

/// gamma as MS 4.1 print it, arctan((h_y - t_y)/(t_x - h_x)), as an absolute error in eps, up to half turns.
pub(super) const PRINTED_GAMMA: Formula =
    Formula { name: "printed_gamma", bound: f64::INFINITY, draw: line, error: printed_gamma };

/// Errors count against the value, or against this where the value is smaller: pi/2 is carried with 106 bits.
const FLOOR: f64 = f64::EPSILON;

fn against(error: &Float, unit: f64) -> f64 {
    in_eps(error, &big(unit.abs().max(FLOOR)))
}

fn direction(rng: &mut Rng) -> Vec<f64> {
    rng.direction().to_vec()
}

/// The exact offset of a vector from the axis that the angle names.
fn exact_offset(angle: Ang, x: &Float, y: &Float) -> Float {
    let (minor, major) = match angle.axis() % 4 {
        0 => (y.clone(), x.clone()),
        1 => (-x.clone(), y.clone()),
        2 => (-y.clone(), -x.clone()),
        _ => (x.clone(), -y.clone()),
    };
    minor.atan2(&major)
}

fn angle(input: &[f64]) -> Option<Ang> {
    Ang::of_normal(input[0], input[1])
}

fn of_normal(input: &[f64]) -> Option<f64> {
    let angle = angle(input)?;
    let exact = exact_offset(angle, &big(input[0]), &big(input[1]));
    let normal = exact.clone().abs() > f64::MIN_POSITIVE || exact.is_zero();
    normal.then(|| relative(angle.offset(), &exact))
}

fn of_line(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let angle = Ang::of_line(tail, head)?;
    let way = Vector::of(head.into()).minus(&Vector::of(tail.into()));
    let exact = exact_offset(angle, &way.y, &-way.x);
    let normal = exact.clone().abs() > f64::MIN_POSITIVE || exact.is_zero();
    normal.then(|| relative(angle.offset(), &exact))
}

fn plus(input: &[f64]) -> Option<f64> {
    let (angle, d) = (angle(input)?, input[2]);
    let sum = angle.plus(d);
    (d.abs() <= PI).then(|| against(&reduced(&(value(angle) + d - value(sum))), sum.offset()))
}

fn turn_to(input: &[f64]) -> Option<f64> {
    let (from, to) = (angle(input)?, angle(&input[2..])?);
    let turn = from.turn_to(to);
    Some(against(&reduced(&(value(to) - value(from) - turn)), turn))
}

fn half_sum(input: &[f64]) -> Option<f64> {
    let (one, other) = (angle(input)?, angle(&input[2..])?);
    let half = one.half_sum(other);
    Some(against(&reduced(&((value(one) + value(other)) / 2u32 - value(half))), half.offset()))
}

fn sin_cos(input: &[f64]) -> Option<f64> {
    let angle = angle(input)?;
    let (sin, cos) = angle.sin_cos();
    let (s, c) = big(angle.offset()).sin_cos(big(0.0));
    let (s, c) = match angle.axis() {
        1 => (c, -s),
        2 => (-s, -c),
        3 => (-c, s),
        _ => (s, c),
    };
    let error = |computed: f64, exact: &Float| if exact.is_zero() { computed.abs() } else { relative(computed, exact) };
    (angle.offset() == 0.0 || angle.offset().abs() > f64::MIN_POSITIVE).then(|| error(sin, &s).max(error(cos, &c)))
}

/// How far step 2 of the realization moves the head of a line, in eps of the unit box: h*_y = t_y - dx cot phi.
fn realized(cot_phi: &Float, tail: DVec2, head: DVec2) -> f64 {
    let way = Vector::of(head.into()).minus(&Vector::of(tail.into()));
    in_eps(&(way.y + way.x * cot_phi), &big(1.0))
}

fn realized_line(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    ((head - tail).abs().max_element() <= 1.0 && tail.x != head.x).then_some(())?;
    let phi = Ang::of_line(tail, head)?;
    let tan = big(phi.offset()).tan();
    (phi.offset().abs() > f64::MIN_POSITIVE)
        .then(|| realized(&if phi.axis() % 2 == 0 { tan.recip() } else { -tan }, tail, head))
}

/// The same with angles kept in radians on [0, 2 pi), as MS have them.
fn realized_in_radians(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    ((head - tail).abs().max_element() <= 1.0 && tail.x != head.x).then_some(())?;
    let gamma = libm::atan2(tail.x - head.x, head.y - tail.y);
    let gamma = if gamma < 0.0 { gamma + 2.0 * PI } else { gamma };
    // A normal that rounds to the axis is the case of input modification 2.
    (libm::sin(gamma) != 0.0).then(|| realized(&big(gamma).cot(), tail, head))
}

fn two_directions(rng: &mut Rng) -> Vec<f64> {
    let mut input = direction(rng);
    match rng.below(3) {
        0 => input.extend(direction(rng)),
        1 => input.extend(input.clone().iter().map(|&x| rng.jitter(x, 4))),
        _ => input.extend(input.clone().iter().map(|&x| -rng.jitter(x, 4))),
    }
    input
}

fn with_half_sweep(rng: &mut Rng) -> Vec<f64> {
    let mut input = direction(rng);
    let near_quarter = f64::from(rng.below(5) as u32) * FRAC_PI_2 / 2.0;
    let d = match rng.below(3) {
        0 => rng.between(0.0, PI),
        1 => rng.decade(-300.0, 0.0),
        _ => (near_quarter + rng.sign() * rng.decade(-17.0, -3.0)).clamp(0.0, PI),
    };
    input.push(d * rng.sign());
    input
}

fn line(rng: &mut Rng) -> Vec<f64> {
    rng.chord().to_vec()
}

fn printed_gamma(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let exact = value(Ang::of_line(tail, head)?);
    let printed = libm::atan((head.y - tail.y) / (tail.x - head.x));
    (tail.x != head.x).then_some(())?;
    let turned = |half_turns: f64| reduced(&(exact.clone() - printed - precise::pi() * half_turns)).abs();
    let error = turned(0.0).min(&turned(1.0));
    Some(in_eps(&error, &big(1.0)))
}
