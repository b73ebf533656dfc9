//! Circle segments against MPFR (memo A3, A5, facts 2 and 3), what is cut, reversed and refused; the errors of formulas are in `formulas`.

use arcsum::angle::Ang;
use arcsum::arc::{Arc, ArcError, half_sweep_of_radius};
use arcsum::sum3::Rounding;
use arcsum_reports::cases::rng::Rng;
use arcsum_reports::claims::formulas::arc::{by_bulge, by_radius, pick};
use arcsum_reports::claims::formulas::formula::ends;
use arcsum_tests::cases;
use glam::DVec2;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

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
        let input = by_radius(&mut Rng::new(seed, "tests"));
        let (tail, head) = ends(&input);
        Some((Arc::with_radius(tail, head, input[4]).ok()?, input[5]))
    });
    let by_bulge = any::<u64>().prop_filter_map("an arc", |seed| {
        let input = by_bulge(&mut Rng::new(seed, "tests"));
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
