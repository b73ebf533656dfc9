//! Sums that are known beforehand, by every exact method.

use crate::common::{Ring, ask, child, exact_methods, loops, rectangle, region, reversed, square};
use arcsum_cgal::sum::Sum;
use arcsum_oracle::point::Point;
use rug::Rational;

#[test]
fn squares_add_up() {
    for method in exact_methods(false).filter(|_| arcsum_cgal::built_in()) {
        let answer = ask(&mut child(), method, &[square(3)], &[square(2)]).expect("valid input");
        assert_eq!(answer.region(), Ok(region(&[square(5)])), "{method}");
        assert!(!answer.time.is_zero());
    }
}

#[test]
fn holes_shrink_and_vanish() {
    for method in exact_methods(true).filter(|_| arcsum_cgal::built_in()) {
        let frame = |hole: Ring| vec![square(20), reversed(&hole)];
        let wide = frame(rectangle(5, 5, 12, 12));
        let expected = region(&[square(23), reversed(&rectangle(8, 8, 12, 12))]);
        let answer = ask(&mut child(), method, &wide, &[square(3)]).expect("valid input");
        assert_eq!(answer.region(), Ok(expected), "{method}");
        let tight = frame(rectangle(5, 5, 8, 12));
        let answer = ask(&mut child(), method, &[square(3)], &tight).expect("valid input");
        assert_eq!(answer.region(), Ok(region(&[square(23)])), "{method}");
    }
}

/// The order of the loops does not matter.
#[test]
fn holes_may_come_first() {
    for method in exact_methods(true).filter(|_| arcsum_cgal::built_in()) {
        let hole = reversed(&rectangle(5, 5, 12, 12));
        let [one, other] = [[square(20), hole.clone()], [hole, square(20)]];
        let sum = |a| ask(&mut child(), method, a, &[square(3)]).and_then(|answer| answer.region());
        assert_eq!(sum(&one), sum(&other), "{method}");
    }
}

/// Thirds and numbers beyond doubles come back to the digit.
#[test]
fn nothing_is_rounded() {
    let huge = Rational::from((1, 3)) + (Rational::from(1) << 200);
    let scaled = |side: i64| -> Vec<_> {
        let point = |p: &Point<Rational>| p.times(&huge);
        loops(&[square(side)]).iter().map(|ring| ring.iter().map(point).collect()).collect()
    };
    for method in exact_methods(false).filter(|_| arcsum_cgal::built_in()) {
        let answer = child().ask(&Sum { method, a: scaled(1), b: scaled(2) }).expect("valid input");
        let area = answer.region().expect("a region").area();
        assert_eq!(area, Rational::from(huge.square_ref()) * 9, "{method}");
    }
}

#[test]
fn the_inexact_kernel_takes_doubles_only() {
    if !arcsum_cgal::built_in() {
        return;
    }
    let method = "reduced:inexact".parse().expect("a method");
    let answer = ask(&mut child(), method, &[square(3)], &[square(2)]).expect("valid input");
    assert_eq!(answer.region(), Ok(region(&[square(5)])));
    let third = vec![
        vec![(0, 0), (1, 0), (0, 1)]
            .into_iter()
            .map(|(x, y)| Point { x: Rational::from((x, 3)), y: Rational::from(y) })
            .collect(),
    ];
    assert!(child().ask(&Sum { method, a: third, b: loops(&[square(1)]) }).is_err());
}
