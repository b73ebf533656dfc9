//! The sum by the monotonic convolution in two ways: beside the kinetic one, and of operands that are turned, mirrored or
//! written down otherwise (memo E7). Distances are certified.

use arcsum::arrangement::cross::EPS;
use arcsum::convolution::monotonic;
use arcsum::convolution::order::Kind;
use arcsum::frame::Frame;
use arcsum::region::{Curve, Node, Region};
use arcsum::smooth::Smooth;
use arcsum::sum::{Convolution, Options, sum};
use arcsum::sum3::Rounding;
use arcsum_oracle::certified::hausdorff::{Outline, between};
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::measure;
use arcsum_oracle::region::ExactRegion;
use arcsum_reports::bridge::{plain, unit};
use arcsum_reports::cases::shape::{polygon, regular};
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, any_region, simple};
use proptest::prelude::*;
use rug::Rational;

/// Two sums of polygons, each within 20 eps of the exact one as the tests against that show.
const TWICE: f64 = 40.0 * EPS;

/// Two sums with circle segments.
const ARCS: f64 = 64.0 * EPS;

fn mapped(region: &Region, f: impl Fn(Node) -> Node) -> Region {
    Region { loops: region.loops.iter().map(|l| l.iter().map(|n| f(*n)).collect()).collect(), ..region.clone() }
}

fn plus(a: &Region, b: &Region, convolution: Convolution) -> Region {
    sum(a, b, &Options { convolution, ..Options::default() }).expect("valid").region
}

/// The certified distance of two polygons, no less than it is.
fn apart(one: &Region, other: &Region, unit: f64) -> f64 {
    let exact: ExactRegion<Rational> = ExactRegion::from_plain(&plain(other)).expect("a region");
    measure::hausdorff(&plain(one), &exact, unit).expect("measurable").hi
}

/// A polygon turned by 90 degrees counter-clockwise.
fn turned(region: &Region) -> Region {
    mapped(region, |n| Node { x: -n.y, y: n.x, ..n })
}

/// A polygon mirrored in x.
fn mirrored(region: &Region) -> Region {
    let mut region = mapped(region, |n| Node { x: -n.x, ..n });
    region.loops.iter_mut().for_each(|nodes| nodes.reverse());
    region
}

fn integers() -> impl Strategy<Value = Region> {
    simple(9, 0.0, Lattice::Integers(4))
}

fn convex() -> impl Strategy<Value = Region> {
    simple(6, 0.0, Lattice::Integers(4)).prop_filter("not convex", |region| {
        let nodes = &region.loops[0];
        let turn = |i: usize| {
            let [p, q, r] = [0, 1, 2].map(|k| nodes[(i + k) % nodes.len()]);
            (q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x)
        };
        (0..nodes.len()).all(|i| turn(i) > 0.0)
    })
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn operands_may_be_turned_mirrored_and_begin_anywhere(a in integers(), b in integers(), by in 0..9_usize) {
        let unit = unit(&a, &b);
        let plus = |a: &Region, b: &Region| plus(a, b, Convolution::Monotonic);
        let straight = plus(&a, &b);
        prop_assert!(apart(&plus(&turned(&a), &turned(&b)), &turned(&straight), unit) <= TWICE);
        prop_assert!(apart(&plus(&mirrored(&a), &mirrored(&b)), &mirrored(&straight), unit) <= TWICE);
        let mut later = a.clone();
        let by = by % a.loops[0].len();
        later.loops[0].rotate_left(by);
        prop_assert!(apart(&plus(&later, &b), &straight, unit) <= TWICE);
    }

    /// Two convex polygons have a lower and an upper crust and nothing else: their edges, and one vertical on either side
    /// that has any.
    #[test]
    fn convex_polygons_have_crusts_alone(a in convex(), b in convex()) {
        let frames = Frame::pair(&a, &b);
        let (x, y) = (Smooth::new(&a, &frames.0).expect("valid"), Smooth::new(&b, &frames.1).expect("valid"));
        let (pieces, order) = monotonic(&x, &y, Rounding::Correct).expect("bounded");
        for i in 0..pieces.pieces.len() as u32 {
            prop_assert!(order.roles(i).iter().all(|(_, kind)| matches!(kind, Kind::LowerCrust | Kind::UpperCrust)));
        }
        let edges = |region: &Region, way: f64| {
            let nodes = &region.loops[0];
            let rise = |i: usize| (nodes[i].x == nodes[(i + 1) % nodes.len()].x).then(|| nodes[(i + 1) % nodes.len()].y - nodes[i].y);
            (0..nodes.len()).filter(|i| if way == 0.0 { rise(*i).is_none() } else { rise(*i).is_some_and(|r| r * way > 0.0) }).count()
        };
        let verticals = [1.0, -1.0].map(|way| usize::from(edges(&a, way) + edges(&b, way) > 0));
        prop_assert_eq!(pieces.pieces.len(), edges(&a, 0.0) + edges(&b, 0.0) + verticals[0] + verticals[1]);
    }
}

/// Regular polygons and themselves: every sum segment has its like.
#[test]
fn equal_copies_are_doubled() {
    for corners in 3..40 {
        let one = polygon(&regular(corners, 1.0, 0.1));
        let twice = mapped(&one, |n| Node { x: 2.0 * n.x, y: 2.0 * n.y, ..n });
        let sum = plus(&one, &one, Convolution::Monotonic);
        assert_eq!(sum.loops.len(), 1, "{corners}");
        assert!(apart(&sum, &twice, unit(&one, &one)) <= TWICE, "{corners}");
    }
}

/// The boundary of a result in the unit box.
fn outline(region: &Region, unit: f64) -> Outline {
    let curve = |curve| if let Curve::Radius(r) = curve { Curve::Radius(r / unit) } else { curve };
    let scaled = mapped(region, |n| Node { x: n.x / unit, y: n.y / unit, curve: curve(n.curve) });
    Outline::from(&Shape::new(&plain(&scaled)).expect("a region"))
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn kinetic_and_monotonic_agree(a in any_region(), b in any_region()) {
        let unit = unit(&a, &b);
        let [one, other] =
            [Convolution::Monotonic, Convolution::Kinetic].map(|convolution| outline(&plus(&a, &b, convolution), unit));
        let bracket = between(&one, &other).expect("closed").expect("decided").bracket;
        prop_assert!(bracket.hi <= ARCS, "{bracket:?}");
    }
}

/// Radii that add up to a few roundings, of either sign: what runs forward on a crust is decided by rounded ends (memo E7).
#[test]
fn radii_that_nearly_cancel_leave_no_gap() {
    for ulps in (0..=64_i32).filter(|k| *k < 9 || k.count_ones() == 1).flat_map(|k| [k, -k]) {
        let radius = 1.0 + f64::from(ulps) * f64::EPSILON;
        // A quarter disc, and a block with a bite of nearly its radius.
        let arc = |x, y, r| Node { x, y, curve: Curve::Radius(r) };
        let quarter = vec![Node::line(0.0, 0.0), arc(1.0, 0.0, 1.0), Node::line(0.0, 1.0)];
        let bitten =
            vec![Node::line(-2.0, -2.0), Node::line(radius, -2.0), arc(radius, 0.0, -radius), Node::line(0.0, -radius)];
        let a = Region { loops: vec![quarter], ..Region::default() };
        for b in [bitten.clone(), bitten.iter().map(|n| Node { x: n.x + 0.1, ..*n }).collect()] {
            let b = Region { loops: vec![b], ..Region::default() };
            let unit = unit(&a, &b);
            let [one, other] = [Convolution::Monotonic, Convolution::Kinetic]
                .map(|convolution| outline(&plus(&a, &b, convolution), unit));
            let bracket = between(&one, &other).expect("closed").expect("decided").bracket;
            assert!(bracket.hi <= ARCS, "{ulps}: {bracket:?}");
        }
    }
}

/// Staircases turned by a tiny angle: their verticals are none any more, and the sum is as near as before.
#[test]
fn verticals_may_lean() {
    let steps =
        polygon(&[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0], [1.0, 3.0], [0.0, 3.0]]);
    let slot =
        polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [3.0, 2.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]]);
    for exponent in [-53, -50, -40, -30, -20] {
        for angle in [libm::scalbn(1.0, exponent), -libm::scalbn(1.0, exponent)] {
            let lean = |region: &Region| mapped(region, |n| Node { x: n.x - angle * n.y, y: n.y + angle * n.x, ..n });
            let (a, b) = (lean(&steps), lean(&slot));
            let exact: ExactRegion<Rational> =
                arcsum_oracle::polygon::sum(&plain(&a), &plain(&b)).expect("within budget");
            let sum = plus(&a, &b, Convolution::Monotonic);
            let bracket = measure::hausdorff(&plain(&sum), &exact, unit(&a, &b)).expect("measurable");
            assert!(bracket.hi <= TWICE, "{angle:e}: {bracket:?}");
        }
    }
}
