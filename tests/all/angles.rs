//! Angles against MPFR (memo A2, facts 1 and 4), and the properties of their order.

use arcsum::angle::Ang;
use arcsum_oracle::precise::{Vector, big, in_eps, pi};
use arcsum_reports::cases::rng::Rng;
use arcsum_reports::claims::formulas::formula::value;
use arcsum_tests::cases;
use glam::DVec2;
use proptest::prelude::*;
use std::f64::consts::PI;
use std::hash::{BuildHasher, RandomState};

/// Memo fact 1: the fraction printed in MS 4.1 is the cotangent of the normal angle.
#[test]
fn printed_gamma_is_inverted() {
    let mut random = Rng::new(5, "tests");
    let (mut right, mut printed_right) = (0, 0);
    for _ in 0..1000 {
        let [x, y] = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
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
        let input = Rng::new(seed, "tests").direction();
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
