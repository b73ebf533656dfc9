//! Properties of sums and set operations that need no reference (memo I7).

use arcsum::boolean::{Operation, combine};
use arcsum::region::{Curve, Node, Region};
use arcsum::sum::{Options, sum};
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, any_region, holed, simple};
use proptest::prelude::*;

fn plus(a: &Region, b: &Region) -> Region {
    sum(a, b, &Options::default()).expect("valid").region
}

fn mapped(region: &Region, f: impl Fn(Node) -> Node) -> Region {
    Region { loops: region.loops.iter().map(|l| l.iter().map(|n| f(*n)).collect()).collect(), ..region.clone() }
}

fn disc(r: f64) -> Region {
    let half = |x| Node { x, y: 0.0, curve: Curve::Bulge(1.0) };
    Region { loops: vec![vec![half(r), half(-r)]], ..Region::default() }
}

/// Differences of measures of order 1 that rounding explains.
const SMALL: f64 = 1e-12;

proptest! {
    #![proptest_config(cases(3000))]

    /// Scaling both operands by a power of two scales the result bit by bit.
    #[test]
    fn powers_of_two_change_nothing(a in any_region(), b in any_region(), k in -40..40_i32) {
        let s = 2_f64.powi(k);
        let scaled = |r: &Region| mapped(r, |n| Node { x: s * n.x, y: s * n.y, ..n });
        prop_assert_eq!(scaled(&plus(&a, &b)), plus(&scaled(&a), &scaled(&b)));
    }

    /// Moving an operand by integers moves an integer result bit by bit.
    #[test]
    fn integer_moves_change_nothing(
        a in simple(8, 0.0, Lattice::Integers(6)),
        b in holed(8, 0.0, Lattice::Integers(12)),
        x in -1000..1000_i32,
        y in -1000..1000_i32,
    ) {
        let moved = |r: &Region| mapped(r, |n| Node { x: n.x + f64::from(x), y: n.y + f64::from(y), ..n });
        let (still, gone) = (plus(&a, &b), plus(&moved(&a), &b));
        prop_assert_eq!(still.loops.len(), gone.loops.len());
        prop_assert!((still.area() - gone.area()).abs() < 1e-9 * still.area());
    }

    #[test]
    fn sums_commute(a in any_region(), b in any_region()) {
        let (p, q) = (plus(&a, &b), plus(&b, &a));
        let size = p.area().max(1.0);
        prop_assert!((p.area() - q.area()).abs() < SMALL * size, "{} {}", p.area(), q.area());
    }

    #[test]
    fn negation_passes_through(a in any_region(), b in any_region()) {
        let (p, q) = (plus(&a, &b), plus(&a.negated(), &b.negated()));
        prop_assert!((p.area() - q.area()).abs() < SMALL * p.area().max(1.0));
    }

    #[test]
    fn sums_associate(a in simple(6, 0.4, Lattice::Fine), b in simple(6, 0.4, Lattice::Fine), c in simple(6, 0.0, Lattice::Fine)) {
        let (p, q) = (plus(&plus(&a, &b), &c), plus(&a, &plus(&b, &c)));
        prop_assert!((p.area() - q.area()).abs() < 100.0 * SMALL);
    }

    /// The sum with a disc of a convex region: area + perimeter r + pi r^2, and the perimeter grows by 2 pi r.
    #[test]
    fn offsets_follow_steiner(k in 3..9_usize, r in 0.01..2.0) {
        let corner = |i: usize| {
            let (s, c) = (std::f64::consts::TAU * i as f64 / k as f64).sin_cos();
            Node::line(c, s)
        };
        let polygon = Region { loops: vec![(0..k).map(corner).collect()], ..Region::default() };
        let offset = plus(&polygon, &disc(r));
        let pi = std::f64::consts::PI;
        prop_assert!((offset.area() - polygon.area() - r * polygon.perimeter() - pi * r * r).abs() < 1e-12 * (1.0 + r * r));
        prop_assert!((offset.perimeter() - polygon.perimeter() - 2.0 * pi * r).abs() < 1e-12 * (1.0 + r));
    }

    #[test]
    fn set_operations_measure_up(a in any_region(), b in any_region()) {
        let area = |op| combine(op, &a, &b).expect("valid").area();
        let (union, meet) = (area(Operation::Union), area(Operation::Intersection));
        let (minus, xor) = (area(Operation::Difference), area(Operation::SymmetricDifference));
        let scale = SMALL * (a.area() + b.area());
        prop_assert!((union + meet - a.area() - b.area()).abs() < scale);
        prop_assert!((union - meet - xor).abs() < scale);
        prop_assert!((a.area() - meet - minus).abs() < scale);
    }

    #[test]
    fn de_morgan(a in any_region(), b in any_region()) {
        let joined = combine(Operation::Union, &a, &b).expect("valid");
        let apart = combine(Operation::Intersection, &a.complement(), &b.complement()).expect("valid");
        prop_assert!(apart.unbounded && !joined.unbounded);
        prop_assert!((joined.area() + apart.area()).abs() < SMALL * joined.area());
    }

    #[test]
    fn a_region_with_itself(a in any_region()) {
        let op = |op| combine(op, &a, &a).expect("valid");
        for same in [op(Operation::Union), op(Operation::Intersection)] {
            prop_assert!((same.area() - a.area()).abs() < SMALL * a.area());
            prop_assert_eq!(same.loops.len(), a.loops.len());
        }
        prop_assert!(op(Operation::Difference).loops.is_empty());
    }

    /// The sum with the complement of a container leaves free what the container allows, and the whole plane if nothing.
    #[test]
    fn containers(a in simple(8, 0.4, Lattice::Fine), r in 0.1..4.0) {
        let free = plus(&disc(r).complement(), &a);
        prop_assert!(free.unbounded);
        if r > 2.0 {
            prop_assert!(!free.loops.is_empty());
            prop_assert!(-free.area() < disc(r).area());
        }
        prop_assert_eq!(plus(&disc(r).complement(), &disc(2.0).complement()), Region::plane());
    }
}
