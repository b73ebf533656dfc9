//! Circle segments against MPFR (memo A3, A5, facts 2 and 3), with the formulas as MS print them.

use super::formula::{Formula, ends, value};
use crate::cases::rng::Rng;
use arcsum::angle::Ang;
use arcsum::arc::{Arc, half_sweep_of_bulge, half_sweep_of_radius, radius_of_bulge};
use arcsum::sum3::Rounding;
use arcsum_oracle::precise::{Circular, Vector, big, in_eps, reduced, relative};
use glam::DVec2;
use rug::Float;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// The half sweep of an arc by its radius, relative.
pub(super) const HALF_SWEEP: Formula =
    Formula { name: "half_sweep_of_radius", bound: 4.0, draw: by_radius, error: sweep_of_radius };

/// A point of a monotone arc: its distance from the circle.
pub(super) const POINT: Formula = Formula { name: "point_normal", bound: 4.0, draw: by_radius, error: normal_error };

/// Formulas about arcs. Bounds, in eps of the value: the arc tangent of two doubles has 3, and taken from a right angle at most as
/// much again plus one rounding; the radius of a bulge has 1 from the chord, 2 from its length, 3.5 from the sine and 1 from the
/// division. Near half circles memo fact 3 has 1.3 eps.
///
/// Points of monotone pieces: 4 eps from the circle, the promise of memo A5. The way there has at most 4.3 eps from turning the
/// chord (two products and a sum a coordinate, with sine, cosine and chord off by 1 eps each) and 6 along it from its length, so
/// 10.3 times sin u / sin delta <= 0.54 of the chord. Longer arcs, before they are cut, reach 4.3 + 6 eps of a way of length 1
/// in all, and 0.7 from the last rounding.
pub const ARCS: [Formula; 8] = [
    HALF_SWEEP,
    Formula { name: "half_circle", bound: 1.3, draw: by_radius, error: sweep_near_half_circle },
    Formula { name: "half_sweep_of_bulge", bound: 2.0, draw: any_bulge, error: sweep_of_bulge },
    Formula { name: "radius_of_bulge", bound: 7.5, draw: by_bulge, error: radius },
    POINT,
    Formula { name: "point_realized", bound: 5.6, draw: by_radius, error: realized_error },
    Formula { name: "bulge_normal", bound: 11.0, draw: by_bulge, error: bulge_normal_error },
    Formula { name: "cut", bound: 11.0, draw: by_bulge, error: cut_error },
];

/// Formulas as printed in MS 4.1, and the promise about points as vectors: delta by an arc sine, points by sines and a
/// cotangent, and points along the arc.
pub const PRINTED: [Formula; 3] = [
    Formula { name: "arc_sine", bound: f64::INFINITY, draw: by_radius, error: sweep_by_asin },
    Formula { name: "printed_point", bound: f64::INFINITY, draw: by_radius, error: printed_point_error },
    Formula { name: "tangential", bound: f64::INFINITY, draw: by_radius, error: tangential_error },
];

fn any_bulge(rng: &mut Rng) -> Vec<f64> {
    vec![rng.sign() * rng.decade(-300.0, 300.0)]
}

/// A chord and half a sweep in (0, 90] degrees: any, tiny, near 45, near 90.
fn chord_and_half_sweep(rng: &mut Rng) -> (Vec<f64>, f64) {
    let delta = match rng.below(4) {
        0 => rng.between(0.0, FRAC_PI_2),
        1 => rng.decade(-15.5, 0.0),
        2 => FRAC_PI_4 - rng.decade(-17.0, -1.0),
        _ => FRAC_PI_2 - rng.decade(-17.0, -1.0),
    };
    (rng.chord().to_vec(), delta)
}

/// An arc by radius, then a number in [0, 1) to pick an angle with.
#[must_use]
pub fn by_radius(rng: &mut Rng) -> Vec<f64> {
    let (mut input, delta) = chord_and_half_sweep(rng);
    let (tail, head) = ends(&input);
    let r = (head - tail).length() / 2.0 / libm::sin(delta);
    input.push(rng.sign() * rng.jitter(r, 4));
    input.push(rng.between(0.0, 1.0));
    input
}

/// An arc by bulge, minor or major up to nearly a full circle, of radius at most 1/2; then a number in [0, 1).
#[must_use]
pub fn by_bulge(rng: &mut Rng) -> Vec<f64> {
    let (mut input, delta) = chord_and_half_sweep(rng);
    let bulge = match rng.below(3) {
        0 => libm::tan(delta / 2.0),
        1 => 1.0 / libm::tan(delta / 2.0),
        _ => rng.decade(-15.0, 20.0),
    };
    if bulge > 1.0 {
        let shrink = 1.0 / bulge;
        (input[2], input[3]) = (input[0] + (input[2] - input[0]) * shrink, input[1] + (input[3] - input[1]) * shrink);
    }
    input.push(rng.sign() * bulge);
    input.push(rng.between(0.0, 1.0));
    input
}

fn sweep_of_radius(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    in_unit_box(input).then_some(())?;
    let delta = half_sweep_of_radius(tail, head, input[4]).ok()?;
    // Numbers that underflow have no relative error to speak of.
    let exact = Circular::with_radius(tail.into(), head.into(), input[4])?.delta;
    (delta.abs() > f64::MIN_POSITIVE).then(|| relative(delta, &exact))
}

/// Near half circles, as an absolute error in eps.
fn sweep_near_half_circle(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let delta = half_sweep_of_radius(tail, head, input[4]).ok()?;
    let exact = Circular::with_radius(tail.into(), head.into(), input[4])?.delta;
    (delta.abs() > 1.5).then(|| in_eps(&(exact - delta), &big(1.0)))
}

/// As MS 4.1 print it. The error is absolute, in eps.
fn sweep_by_asin(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let exact = Circular::with_radius(tail.into(), head.into(), input[4])?.delta;
    let delta = libm::asin(((head - tail).length() / 2.0 / input[4]).clamp(-1.0, 1.0));
    Some(in_eps(&(exact - delta), &big(1.0)))
}

fn sweep_of_bulge(input: &[f64]) -> Option<f64> {
    Some(relative(half_sweep_of_bulge(input[0]).ok()?, &(big(input[0]).atan() * 2u32)))
}

fn radius(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let r = radius_of_bulge(tail, head, input[4]).ok()?;
    Some(relative(r, &Circular::with_bulge(tail.into(), head.into(), input[4]).radius()))
}

/// The normal angle at a fraction of the sweep, and the exact half sweep up to there by the angles as stored.
#[must_use]
pub fn pick(arc: &Arc, fraction: f64) -> (Ang, Float) {
    // In two steps, as an angle takes at most half a turn at once.
    let theta = arc.a().plus(arc.delta() * fraction).plus(arc.delta() * fraction);
    let mut u = reduced(&(value(theta) - value(arc.a()))) / 2u32;
    if u.is_sign_negative() != (arc.delta() < 0.0) && !u.is_zero() {
        u += if arc.delta() < 0.0 { -value(Ang::LEFT) } else { value(Ang::LEFT) };
    }
    (theta, u)
}

/// Errors in eps of the unit box are about ends inside it.
fn in_unit_box(input: &[f64]) -> bool {
    let (tail, head) = ends(input);
    input[..4].iter().all(|c| c.abs() <= 1.0) && (head - tail).abs().max_element() <= 1.0
}

fn monotone_arc(input: &[f64]) -> Option<Arc> {
    let (tail, head) = ends(input);
    in_unit_box(input).then_some(())?;
    let arc = Arc::with_radius(tail, head, input[4]).ok()?;
    ((0.0..=1.0).contains(&input[5]) && arc.a() != arc.b() && arc.cuts().is_empty()).then_some(arc)
}

/// How far a point of a monotone arc is from the circle of the input, in eps of the unit box.
fn normal_error(input: &[f64]) -> Option<f64> {
    let arc = monotone_arc(input)?;
    let p = arc.point_plus(pick(&arc, input[5]).0, DVec2::ZERO, Rounding::Correct);
    let circle = Circular::with_radius(arc.tail().into(), arc.head().into(), input[4])?;
    Some(in_eps(&circle.off_circle(p.into()), &big(1.0)))
}

/// The same along the arc: unbounded for large radii, see memo A5.
fn tangential_error(input: &[f64]) -> Option<f64> {
    let arc = monotone_arc(input)?;
    let theta = pick(&arc, input[5]).0;
    let p = arc.point_plus(theta, DVec2::ZERO, Rounding::Correct);
    let circle = Circular::with_radius(arc.tail().into(), arc.head().into(), input[4])?;
    let exact = circle.centre().plus(&Vector::at(&value(theta)).times(&circle.radius()));
    Some(in_eps(&Vector::of(p.into()).minus(&exact).length(), &big(1.0)))
}

/// How far the way from the nearer end is wrong as a vector, against the arc with the stored angles (the realization),
/// in eps of the chord.
fn realized_error(input: &[f64]) -> Option<f64> {
    let arc = monotone_arc(input)?;
    let (theta, u) = pick(&arc, input[5]);
    let delta = reduced(&(value(arc.b()) - value(arc.a()))) / 2u32;
    let realization = Circular::new(arc.tail().into(), arc.head().into(), delta);
    let (end, way) = arc.offset(theta);
    let exact = realization.at_half_sweep(&u).minus(&Vector::of(end.into()));
    Some(in_eps(&Vector::of(way.into()).minus(&exact).length(), &realization.chord.length()))
}

/// Points of arcs by bulge, major ones too: distance from the circle in eps of the unit box.
fn bulge_normal_error(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let arc = Arc::with_bulge(tail, head, input[4]).ok()?;
    let circle = Circular::with_bulge(tail.into(), head.into(), input[4]);
    let fits = big(input[4]).abs() <= 1 || circle.radius().abs() <= 0.5;
    (fits && (0.0..=1.0).contains(&input[5])).then_some(())?;
    let (end, way) = arc.offset(pick(&arc, input[5]).0);
    Some(in_eps(&circle.off_circle((end + way).into()), &big(1.0)))
}

/// The cuts of arcs by bulge: distance from the extreme point of the circle, in eps of the unit box, of arcs of at most
/// its size. Tangential errors count.
fn cut_error(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let arc = Arc::with_bulge(tail, head, input[4]).ok()?;
    let circle = Circular::with_bulge(tail.into(), head.into(), input[4]);
    let r = circle.radius();
    (r.clone().abs() <= 0.5).then_some(())?;
    let exact = |angle: Ang| circle.centre().plus(&Vector::at(&value(angle)).times(&r));
    let error = |(angle, p): (Ang, DVec2)| in_eps(&Vector::of(p.into()).minus(&exact(angle)).length(), &big(1.0));
    arc.cuts().into_iter().map(error).reduce(f64::max)
}

/// The coordinates as MS 4.1 print them: d_x by sines, d_y by a cotangent.
fn printed_point_error(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let arc = Arc::with_radius(tail, head, input[4]).ok()?;
    let (theta, alpha) = (pick(&arc, input[5].clamp(0.0, 1.0)).0.radians(), arc.a().radians());
    let gamma = libm::atan2(tail.x - head.x, head.y - tail.y);
    let dx = libm::sin((theta + alpha) / 2.0) * libm::sin((theta - alpha) / 2.0)
        / (libm::sin(gamma) * libm::sin(arc.delta()))
        * (head.x - tail.x);
    let p = tail + DVec2::new(dx, -dx / libm::tan((theta + alpha) / 2.0));
    let circle = Circular::with_radius(tail.into(), head.into(), input[4])?;
    (in_unit_box(input) && arc.delta().abs() > 1e-4 && p.is_finite())
        .then(|| in_eps(&circle.off_circle(p.into()), &big(1.0)))
}
