//! Circle segments against MPFR (memo A3, A5, facts 2 and 3), with the formulas as MS print them as negative controls.

use arcsum::angle::Ang;
use arcsum::arc::{Arc, ArcError, half_sweep_of_bulge, half_sweep_of_radius, radius_of_bulge};
use arcsum::sum3::Rounding;
use arcsum_tests::cases;
use arcsum_tests::precise::{Circular, Vector, big, in_eps, reduced, relative, value};
use arcsum_tests::random::Random;
use arcsum_tests::worst::{Formula, Worst};
use glam::DVec2;
use proptest::prelude::*;
use rug::Float;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

const DRAWS: usize = 3_000;

fn ends(input: &[f64]) -> (DVec2, DVec2) {
    (DVec2::new(input[0], input[1]), DVec2::new(input[2], input[3]))
}

/// A chord and half a sweep in (0, 90] degrees: any, tiny, near 45, near 90.
fn chord_and_half_sweep(random: &mut Random) -> (Vec<f64>, f64) {
    let delta = match random.below(4) {
        0 => random.uniform(0.0, FRAC_PI_2),
        1 => random.decade(-15.5, 0.0),
        2 => FRAC_PI_4 - random.decade(-17.0, -1.0),
        _ => FRAC_PI_2 - random.decade(-17.0, -1.0),
    };
    (random.chord().to_vec(), delta)
}

/// An arc by radius, then a number in [0, 1) to pick an angle with.
fn by_radius(random: &mut Random) -> Vec<f64> {
    let (mut input, delta) = chord_and_half_sweep(random);
    let (tail, head) = ends(&input);
    let r = (head - tail).length() / 2.0 / libm::sin(delta);
    input.push(random.sign() * random.jitter(r, 4));
    input.push(random.uniform(0.0, 1.0));
    input
}

/// An arc by bulge, minor or major up to nearly a full circle, of radius at most 1/2; then a number in [0, 1).
fn by_bulge(random: &mut Random) -> Vec<f64> {
    let (mut input, delta) = chord_and_half_sweep(random);
    let bulge = match random.below(3) {
        0 => libm::tan(delta / 2.0),
        1 => 1.0 / libm::tan(delta / 2.0),
        _ => random.decade(-15.0, 20.0),
    };
    if bulge > 1.0 {
        let shrink = 1.0 / bulge;
        (input[2], input[3]) = (input[0] + (input[2] - input[0]) * shrink, input[1] + (input[3] - input[1]) * shrink);
    }
    input.push(random.sign() * bulge);
    input.push(random.uniform(0.0, 1.0));
    input
}

fn sweep_of_radius(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let delta = half_sweep_of_radius(tail, head, input[4]).ok()?;
    Some(relative(delta, &Circular::with_radius(tail, head, input[4])?.delta))
}

/// Near half circles, as an absolute error in eps.
fn sweep_near_half_circle(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let delta = half_sweep_of_radius(tail, head, input[4]).ok()?;
    let exact = Circular::with_radius(tail, head, input[4])?.delta;
    (delta.abs() > 1.5).then(|| in_eps(&(exact - delta), &big(1.0)))
}

/// As MS 4.1 print it. The error is absolute, in eps.
fn sweep_by_asin(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let exact = Circular::with_radius(tail, head, input[4])?.delta;
    let delta = libm::asin(((head - tail).length() / 2.0 / input[4]).clamp(-1.0, 1.0));
    Some(in_eps(&(exact - delta), &big(1.0)))
}

fn sweep_of_bulge(input: &[f64]) -> Option<f64> {
    Some(relative(half_sweep_of_bulge(input[0]).ok()?, &(big(input[0]).atan() * 2u32)))
}

fn radius(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let r = radius_of_bulge(tail, head, input[4]).ok()?;
    Some(relative(r, &Circular::with_bulge(tail, head, input[4]).radius()))
}

/// The normal angle at a fraction of the sweep, and the exact half sweep up to there by the angles as stored.
fn pick(arc: &Arc, fraction: f64) -> (Ang, Float) {
    // In two steps, as an angle takes at most half a turn at once.
    let theta = arc.a().plus(arc.delta() * fraction).plus(arc.delta() * fraction);
    let mut u = reduced(&(value(theta) - value(arc.a()))) / 2u32;
    if u.is_sign_negative() != (arc.delta() < 0.0) && !u.is_zero() {
        u += if arc.delta() < 0.0 { -value(Ang::LEFT) } else { value(Ang::LEFT) };
    }
    (theta, u)
}

fn monotone_arc(input: &[f64]) -> Option<Arc> {
    let (tail, head) = ends(input);
    let arc = Arc::with_radius(tail, head, input[4]).ok()?;
    ((0.0..=1.0).contains(&input[5]) && arc.a() != arc.b() && arc.cuts().is_empty()).then_some(arc)
}

/// How far a point of a monotone arc is from the circle of the input, in eps of the unit box.
fn normal_error(input: &[f64]) -> Option<f64> {
    let arc = monotone_arc(input)?;
    let p = arc.point_plus(pick(&arc, input[5]).0, DVec2::ZERO, Rounding::Correct);
    let circle = Circular::with_radius(arc.tail(), arc.head(), input[4])?;
    Some(in_eps(&circle.off_circle(p), &big(1.0)))
}

/// The same along the arc: unbounded for large radii, see memo A5.
fn tangential_error(input: &[f64]) -> Option<f64> {
    let arc = monotone_arc(input)?;
    let theta = pick(&arc, input[5]).0;
    let p = arc.point_plus(theta, DVec2::ZERO, Rounding::Correct);
    let circle = Circular::with_radius(arc.tail(), arc.head(), input[4])?;
    let exact = circle.centre().plus(&Vector::at(&value(theta)).times(&circle.radius()));
    Some(in_eps(&Vector::of(p).minus(&exact).length(), &big(1.0)))
}

/// How far the way from the nearer end is wrong as a vector, against the arc with the stored angles (the realization),
/// in eps of the chord.
fn realized_error(input: &[f64]) -> Option<f64> {
    let arc = monotone_arc(input)?;
    let (theta, u) = pick(&arc, input[5]);
    let delta = reduced(&(value(arc.b()) - value(arc.a()))) / 2u32;
    let realization = Circular::new(arc.tail(), arc.head(), delta);
    let (end, way) = arc.offset(theta);
    let exact = realization.at_half_sweep(&u).minus(&Vector::of(end));
    Some(in_eps(&Vector::of(way).minus(&exact).length(), &realization.chord.length()))
}

/// Points of arcs by bulge, major ones too: distance from the circle in eps of the unit box.
fn bulge_normal_error(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let arc = Arc::with_bulge(tail, head, input[4]).ok()?;
    let circle = Circular::with_bulge(tail, head, input[4]);
    let fits = big(input[4]).abs() <= 1 || circle.radius().abs() <= 0.5;
    (fits && (0.0..=1.0).contains(&input[5])).then_some(())?;
    let (end, way) = arc.offset(pick(&arc, input[5]).0);
    Some(in_eps(&circle.off_circle(end + way), &big(1.0)))
}

/// The cuts of arcs by bulge: distance from the extreme point of the circle, in eps of the unit box, of arcs of at most
/// its size. Tangential errors count.
fn cut_error(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let arc = Arc::with_bulge(tail, head, input[4]).ok()?;
    let circle = Circular::with_bulge(tail, head, input[4]);
    let r = circle.radius();
    (r.clone().abs() <= 0.5).then_some(())?;
    let exact = |angle: Ang| circle.centre().plus(&Vector::at(&value(angle)).times(&r));
    let error = |(angle, p): (Ang, DVec2)| in_eps(&Vector::of(p).minus(&exact(angle)).length(), &big(1.0));
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
    let circle = Circular::with_radius(tail, head, input[4])?;
    (arc.delta().abs() > 1e-4 && p.is_finite()).then(|| in_eps(&circle.off_circle(p), &big(1.0)))
}

fn formula(
    name: &'static str,
    bound: f64,
    draw: fn(&mut Random) -> Vec<f64>,
    error: fn(&[f64]) -> Option<f64>,
) -> Formula {
    Formula { name, bound, draw, error }
}

fn fails(name: &'static str, draw: fn(&mut Random) -> Vec<f64>, error: fn(&[f64]) -> Option<f64>, least: f64) {
    let worst = formula(name, f64::INFINITY, draw, error).search(DRAWS, &[]).remove(0);
    println!("{name:28} worst {:12.4e} eps at {:?}", worst.error, worst.input);
    assert!(worst.error > least, "the check must show that this formula fails: {worst:?}");
}

/// Bounds, in eps of the value: [`twofold_atan`](arcsum::twofold::twofold_atan) has 3, and taken from a right angle at
/// most as much again plus one rounding; the radius of a bulge has 1 from the chord, 2 from its length, 3.5 from the
/// sine and 1 from the division. Near half circles memo fact 3 has 1.3 eps.
#[test]
fn half_sweeps_and_radii() {
    formula("half_sweep_of_radius", 4.0, by_radius, sweep_of_radius).check(DRAWS);
    formula("half_circle", 1.3, by_radius, sweep_near_half_circle).check(DRAWS);
    formula("half_sweep_of_bulge", 2.0, |random| vec![random.sign() * random.decade(-300.0, 300.0)], sweep_of_bulge)
        .check(DRAWS);
    formula("radius_of_bulge", 7.5, by_bulge, radius).check(DRAWS);
    fails("asin", by_radius, sweep_by_asin, 1e7);
}

/// Points of monotone pieces: 4 eps from the circle, the promise of memo A5. The way there has at most 4.3 eps from
/// turning the chord (two products and a sum a coordinate, with sine, cosine and chord off by 1 eps each) and 6 along
/// it from its length, so 10.3 times sin u / sin delta <= 0.54 of the chord. Longer arcs, before they are cut, reach
/// 4.3 + 6 eps of a way of length 1 in all, and 0.7 from the last rounding.
#[test]
fn points() {
    formula("point_normal", 4.0, by_radius, normal_error).check(DRAWS);
    formula("point_realized", 5.6, by_radius, realized_error).check(DRAWS);
    formula("bulge_normal", 11.0, by_bulge, bulge_normal_error).check(DRAWS);
    formula("cut", 11.0, by_bulge, cut_error).check(DRAWS);
    fails("printed point", by_radius, printed_point_error, 1e6);
    fails("tangential", by_radius, tangential_error, 1e6);
}

/// The search itself finds what is wrong with the arc sine.
#[test]
#[should_panic(expected = "exceeds 1.3 eps")]
fn arc_sine_exceeds_the_bound() {
    formula("arc_sine", 1.3, by_radius, sweep_by_asin).check(DRAWS);
}

#[test]
#[should_panic(expected = "rose to")]
fn worse_than_kept_is_told() {
    let kept = Worst { error: 0.1, input: vec![0.1, 0.2, 0.3, 0.5, 1.0] };
    let _ = formula("half_sweep", 4.0, by_radius, sweep_of_radius).again(vec![kept]);
}

#[test]
fn impossible_arcs_are_told() {
    let (o, e) = (DVec2::ZERO, DVec2::X);
    assert_eq!(Arc::with_radius(o, o, 1.0), Err(ArcError::ZeroChord));
    assert_eq!(Arc::with_bulge(o, o, 1.0), Err(ArcError::ZeroChord));
    assert_eq!(Arc::with_radius(o, e, 0.49), Err(ArcError::ChordTooLong));
    assert_eq!(Arc::with_radius(o, e, 1e-320), Err(ArcError::ChordTooLong));
    assert_eq!(Arc::with_radius(o, e, 0.0), Err(ArcError::ZeroSweep));
    assert_eq!(Arc::with_bulge(o, e, 0.0), Err(ArcError::ZeroSweep));
    assert_eq!(Arc::with_bulge(o, e, f64::INFINITY), Err(ArcError::NotFinite));
    assert_eq!(Arc::with_radius(o, e, f64::NAN), Err(ArcError::NotFinite));
    assert_eq!(Arc::with_radius(o, e, f64::INFINITY), Err(ArcError::NotFinite));
    assert!(half_sweep_of_radius(o, e * 1e-300, 1e300).is_ok_and(|delta| (0.0..1e-300).contains(&delta)));
    assert_eq!(Arc::with_radius(o, DVec2::new(f64::NAN, 0.0), 1.0), Err(ArcError::NotFinite));
    // A radius printed with 15 digits may fall short of half the chord.
    let printed = Arc::with_radius(o, DVec2::splat(0.1), -0.0707106781186547).expect("a half circle but for rounding");
    assert_eq!(printed.delta(), -FRAC_PI_2);
    assert_eq!(Arc::with_radius(o, DVec2::splat(0.1), 0.07071067811865), Err(ArcError::ChordTooLong));
}

/// A circle of two half circles is cut at its four extreme points, exactly.
#[test]
fn half_circles_are_cut_at_their_extremes() {
    let (left, right) = (DVec2::new(-0.5, 0.0), DVec2::new(0.5, 0.0));
    for (tail, head, bulge, cut, angle) in [
        (right, left, 1.0, DVec2::new(0.0, 0.5), Ang::UP),
        (left, right, 1.0, DVec2::new(0.0, -0.5), Ang::DOWN),
        (right, left, -1.0, DVec2::new(0.0, -0.5), Ang::UP),
    ] {
        let arc = Arc::with_bulge(tail, head, bulge).expect("a half circle");
        assert_eq!(arc, Arc::with_radius(tail, head, bulge / 2.0).expect("a half circle"));
        assert_eq!(arc.cuts(), [(angle, cut)]);
    }
}

fn any_arc() -> impl Strategy<Value = (Arc, f64)> {
    let by_radius = any::<u64>().prop_filter_map("a minor arc", |seed| {
        let input = by_radius(&mut Random::new(seed));
        let (tail, head) = ends(&input);
        Some((Arc::with_radius(tail, head, input[4]).ok()?, input[5]))
    });
    let by_bulge = any::<u64>().prop_filter_map("an arc", |seed| {
        let input = by_bulge(&mut Random::new(seed));
        let (tail, head) = ends(&input);
        Some((Arc::with_bulge(tail, head, input[4]).ok()?, input[5]))
    });
    prop_oneof![by_radius, by_bulge]
}

proptest! {
    #![proptest_config(cases(2000))]

    /// Between its cuts an arc runs in one quadrant, by angles and, after rounding, by coordinates.
    #[test]
    fn cuts_make_monotone_pieces((arc, _) in any_arc()) {
        let clockwise = arc.delta() < 0.0;
        let mut stations = vec![(arc.a(), arc.tail())];
        stations.extend(arc.cuts());
        stations.push((arc.b(), arc.head()));
        let mut total = 0.0;
        for pair in stations.windows(2) {
            let ((a, from), (b, to)) = (pair[0], pair[1]);
            let half = Arc::minor(from, to, a, b, clockwise).delta();
            total += half;
            prop_assert!(half.abs() <= FRAC_PI_4, "{:?}", pair);
            if a != b {
                // The direction of travel is the rightward normal turned left.
                let travel = a.plus(half).normal().perp();
                prop_assert!(((to - from) * travel).cmpge(DVec2::ZERO).all(), "{:?}", pair);
            }
        }
        prop_assert!(stations.len() <= 6);
        prop_assert!((total - arc.delta()).abs() <= 16.0 * f64::EPSILON, "{} {}", total, arc.delta());
    }

    /// Traversed backwards, an arc has the same angles, turned by exactly 180 degrees, and the same points.
    #[test]
    fn reversal_is_exact((arc, fraction) in any_arc()) {
        let back = Arc::minor(arc.head(), arc.tail(), arc.b().opposite(), arc.a().opposite(), arc.delta() > 0.0);
        if arc.delta().abs() < FRAC_PI_2 {
            prop_assert_eq!(back.delta(), -arc.delta());
            let theta = pick(&arc, fraction).0;
            let point = |(end, way): (DVec2, DVec2)| end + way;
            let difference = point(arc.offset(theta)) - point(back.offset(theta.opposite()));
            prop_assert!(difference.length() <= 16.0 * f64::EPSILON);
        }
    }

    /// A point plus q never leaves the box of the ends plus q, and the ends are exact.
    #[test]
    fn points_stay_in_the_box((arc, fraction) in any_arc(), x in -1.0..1.0f64, y in -1.0..1.0f64) {
        let q = DVec2::new(x, y);
        prop_assert_eq!(arc.offset(arc.a()), (arc.tail(), DVec2::ZERO));
        if arc.a() != arc.b() {
            prop_assert_eq!(arc.offset(arc.b()), (arc.head(), DVec2::ZERO));
        }
        if arc.cuts().is_empty() {
            for rounding in [Rounding::Correct, Rounding::Plain] {
                let p = arc.point_plus(pick(&arc, fraction).0, q, rounding);
                let (one, other) = (arc.tail() + q, arc.head() + q);
                prop_assert!(p.cmpge(one.min(other)).all() && p.cmple(one.max(other)).all());
            }
        }
    }
}
