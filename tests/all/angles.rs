//! Angles against MPFR (memo A2, facts 1 and 4), and the properties of their order.

use arcsum::angle::Ang;
use arcsum_tests::cases;
use arcsum_tests::precise::{Vector, big, in_eps, pi, reduced, relative, value};
use arcsum_tests::random::Random;
use arcsum_tests::worst::Formula;
use glam::DVec2;
use proptest::prelude::*;
use rug::Float;
use std::f64::consts::{FRAC_PI_2, PI};
use std::hash::{BuildHasher, RandomState};

/// Errors count against the value, or against this where the value is smaller: pi/2 is carried with 106 bits.
const FLOOR: f64 = f64::EPSILON;

fn against(error: &Float, unit: f64) -> f64 {
    in_eps(error, &big(unit.abs().max(FLOOR)))
}

fn direction(random: &mut Random) -> Vec<f64> {
    random.direction().to_vec()
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
    let (tail, head) = (DVec2::new(input[0], input[1]), DVec2::new(input[2], input[3]));
    let angle = Ang::of_line(tail, head)?;
    let way = Vector::of(head).minus(&Vector::of(tail));
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
    let way = Vector::of(head).minus(&Vector::of(tail));
    in_eps(&(way.y + way.x * cot_phi), &big(1.0))
}

fn realized_line(input: &[f64]) -> Option<f64> {
    let (tail, head) = (DVec2::new(input[0], input[1]), DVec2::new(input[2], input[3]));
    ((head - tail).abs().max_element() <= 1.0 && tail.x != head.x).then_some(())?;
    let phi = Ang::of_line(tail, head)?;
    let tan = big(phi.offset()).tan();
    (phi.offset().abs() > f64::MIN_POSITIVE)
        .then(|| realized(&if phi.axis() % 2 == 0 { tan.recip() } else { -tan }, tail, head))
}

/// The same with angles kept in radians on [0, 2 pi), as MS have them.
fn realized_in_radians(input: &[f64]) -> Option<f64> {
    let (tail, head) = (DVec2::new(input[0], input[1]), DVec2::new(input[2], input[3]));
    ((head - tail).abs().max_element() <= 1.0 && tail.x != head.x).then_some(())?;
    let gamma = libm::atan2(tail.x - head.x, head.y - tail.y);
    let gamma = if gamma < 0.0 { gamma + 2.0 * PI } else { gamma };
    // A normal that rounds to the axis is the case of input modification 2.
    (libm::sin(gamma) != 0.0).then(|| realized(&big(gamma).cot(), tail, head))
}

fn two_directions(random: &mut Random) -> Vec<f64> {
    let mut input = direction(random);
    match random.below(3) {
        0 => input.extend(direction(random)),
        1 => input.extend(input.clone().iter().map(|&x| random.jitter(x, 4))),
        _ => input.extend(input.clone().iter().map(|&x| -random.jitter(x, 4))),
    }
    input
}

fn with_half_sweep(random: &mut Random) -> Vec<f64> {
    let mut input = direction(random);
    let near_quarter = f64::from(random.below(5) as u32) * FRAC_PI_2 / 2.0;
    let d = match random.below(3) {
        0 => random.uniform(0.0, PI),
        1 => random.decade(-300.0, 0.0),
        _ => (near_quarter + random.sign() * random.decade(-17.0, -3.0)).clamp(0.0, PI),
    };
    input.push(d * random.sign());
    input
}

fn line(random: &mut Random) -> Vec<f64> {
    random.chord().to_vec()
}

const DRAWS: usize = 5_000;

/// Bounds: the arc tangent has one unit in the last place, 2 eps, and its correction one more rounding; the sums of
/// angles round once, before and after which pi/2 has 106 bits; sine and cosine have one unit in the last place.
#[test]
fn functions_keep_their_bounds() {
    let formula = |name, bound, draw, error| Formula { name, bound, draw, error };
    formula("of_normal", 3.0, direction, of_normal).check(DRAWS);
    formula("of_line", 3.0, line, of_line).check(DRAWS);
    formula("plus", 2.0, with_half_sweep, plus).check(DRAWS);
    formula("turn_to", 2.0, two_directions, turn_to).check(DRAWS);
    formula("half_sum", 2.0, two_directions, half_sum).check(DRAWS);
    formula("sin_cos", 2.0, direction, sin_cos).check(DRAWS);
}

/// Memo fact 4: step 2 of the realization moves the head of a line by a few eps, while angles in radians break it.
/// An offset wrong by 3 eps of itself moves the head by at most 3 |dx| |off| / sin^2 phi <= 3 pi/2 for |dx|, |dy| <= 1,
/// as in the unit box.
#[test]
fn realized_lines_stay_put() {
    let name = "realized_line";
    Formula { name, bound: 4.72, draw: line, error: realized_line }.check(DRAWS);
    let radians = Formula { name, bound: f64::INFINITY, draw: line, error: realized_in_radians };
    let worst = radians.search(DRAWS, &[]).remove(0);
    println!("realized in radians: {:e} eps at {:?}", worst.error, worst.input);
    assert!(worst.error > 1e7, "the check must show that radians fail: {}", worst.error);
}

/// Memo fact 1: the fraction printed in MS 4.1 is the cotangent of the normal angle.
#[test]
fn printed_gamma_is_inverted() {
    let mut random = Random::new(5);
    let (mut right, mut printed_right) = (0, 0);
    for _ in 0..1000 {
        let [x, y] = [random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)];
        let gamma = value(Ang::of_line(DVec2::ZERO, DVec2::new(x, y)).expect("a line"));
        let way = Vector::at(&gamma);
        right += i32::from(in_eps(&(way.x * x + way.y * y), &big(1.0)) < 8.0);
        let way = Vector::at(&(big(y) / big(-x)).atan());
        printed_right += i32::from(in_eps(&(way.x * x + way.y * y), &big(1.0)) < 1e6);
    }
    assert_eq!((right, printed_right), (1000, 0));
}

#[test]
fn axes_are_exact_and_in_order() {
    let vectors = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
    for (axis, (x, y)) in Ang::AXES.into_iter().zip(vectors) {
        assert_eq!(Ang::of_normal(x, y), Some(axis));
        assert_eq!(Ang::of_normal(if x == 0.0 { -x } else { x }, if y == 0.0 { -y } else { y }), Some(axis));
        assert_eq!(axis.normal(), DVec2::new(x, y));
    }
    assert!(Ang::AXES.is_sorted());
    assert_eq!(Ang::of_normal(0.0, 0.0), None);
    assert_eq!(Ang::of_normal(f64::NAN, 1.0), None);
    assert_eq!(Ang::of_normal(1.0, f64::INFINITY), None);
    assert_eq!(Ang::of_line(DVec2::ONE, DVec2::ONE), None);
    let diagonal = Ang::of_normal(1.0, -1.0).expect("a direction");
    assert_eq!((diagonal.axis(), Ang::of_normal(1.0, 1.0).expect("a direction").axis()), (3, 0));
    assert_eq!(Ang::of_normal(1.0, -1e-300).map(Ang::axis), Some(4));
}

fn any_direction() -> impl Strategy<Value = (f64, f64)> {
    let grid = (-6i32..=6, -6i32..=6).prop_map(|(x, y)| (f64::from(x), f64::from(y)));
    let wide = any::<u64>().prop_map(|seed| {
        let input = direction(&mut Random::new(seed));
        (input[0], input[1])
    });
    prop_oneof![grid, wide].prop_filter("not zero", |&(x, y)| x != 0.0 || y != 0.0)
}

fn ang((x, y): (f64, f64)) -> Ang {
    Ang::of_normal(x, y).expect("a finite direction that is not zero")
}

proptest! {
    #![proptest_config(cases(2000))]

    /// The order on [0, 2 pi) is the true one wherever the angles differ by more than their errors.
    #[test]
    fn order_is_that_of_the_directions(u in any_direction(), v in any_direction()) {
        let exact = |(x, y): (f64, f64)| {
            let angle = Vector { x: big(x), y: big(y) }.angle();
            if angle < 0 { angle + pi() * 2u32 } else { angle }
        };
        let apart = exact(u) - exact(v);
        if in_eps(&apart, &big(1.0)) > 8.0 && exact(u) + 1e-15 < pi() * 2u32 && exact(v) + 1e-15 < pi() * 2u32 {
            prop_assert_eq!(ang(u) < ang(v), apart < 0);
        }
        prop_assert_eq!(ang(u) == ang(v), ang(u).cmp(&ang(v)).is_eq());
        let state = RandomState::new();
        prop_assert!(ang(u) != ang(v) || state.hash_one(ang(u)) == state.hash_one(ang(v)));
        prop_assert_eq!(ang(u).cmp(&ang(v)), ang(v).cmp(&ang(u)).reverse());
    }

    /// Quarter turns and reflections act on the representation without rounding.
    #[test]
    fn symmetries_are_exact((x, y) in any_direction()) {
        let angle = ang((x, y));
        prop_assert_eq!(ang((-x, -y)), angle.opposite());
        prop_assert_eq!(angle.opposite().opposite(), angle);
        prop_assert_eq!(angle.turn_to(angle.opposite()), PI);
        let turned = ang((-y, x));
        prop_assert_eq!(turned.offset(), angle.offset());
        prop_assert_eq!(turned.axis() % 4, (angle.axis() + 1) % 4);
        prop_assert!((-PI / 4.0..=PI / 4.0).contains(&angle.offset()) && angle.offset() != -PI / 4.0);
        prop_assert!(angle.axis() < 4 || angle.offset() < 0.0);
    }

    /// The turn has the sign that the order tells, and adding it leads to the other angle.
    #[test]
    fn turns_and_sums_agree(u in any_direction(), v in any_direction()) {
        let (from, to) = (ang(u), ang(v));
        let turn = from.turn_to(to);
        let back = to.turn_to(from);
        prop_assert!((-PI..=PI).contains(&turn));
        prop_assert_eq!(turn == 0.0, from == to);
        prop_assert!(back == -turn || (turn == PI && back == PI));
        prop_assert!(from.plus(turn).turn_to(to).abs() <= 4.0 * f64::EPSILON);
        let ccw = to > from;
        let crosses_zero = (turn > 0.0) != ccw;
        prop_assert!(turn == 0.0 || !crosses_zero || (from.radians() - to.radians()).abs() > PI - 1e-9);
    }

    #[test]
    fn any_half_sweep_keeps_the_form(u in any_direction(), d in any::<f64>()) {
        let sum = ang(u).plus(d);
        prop_assert!(sum.offset().abs() <= PI / 4.0 && sum.axis() <= 4);
    }
}
