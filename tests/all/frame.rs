//! Frames against exact arithmetic: the way to the unit box loses nothing, the way back rounds once (memo A4).

use arcsum::frame::Frame;
use arcsum::region::{Curve, Node, Region};
use arcsum_reports::cases::rng::Rng;
use arcsum_tests::cases;

use glam::DVec2;
use proptest::prelude::*;
use rug::Float;

/// Enough bits for the sum of any two doubles to be exact.
const EXACT: u32 = 2200;

fn polygon(points: &[(f64, f64)]) -> Region {
    Region { loops: vec![points.iter().map(|&(x, y)| Node::line(x, y)).collect()], ..Region::default() }
}

fn nodes(region: &Region) -> impl Iterator<Item = &Node> {
    region.loops.iter().flatten()
}

fn scaled(x: f64, exp: i32) -> Float {
    Float::with_val(EXACT, x) << exp
}

/// Points of about this size anywhere, on decimals or on a grid of the coarsest last place.
fn somewhere(random: &mut Rng) -> Region {
    let size = random.decade(-280.0, 280.0);
    let place = if random.below(3) == 0 { 0.0 } else { size * random.decade(-2.0, 12.0) };
    let digits = 10f64.powi(random.below(8) as i32);
    let snap = random.below(2) == 0;
    let mut coordinate = || {
        let x = random.between(-1.0, 1.0);
        place + size * if snap { (x * digits).round() / digits } else { x }
    };
    polygon(&[0; 5].map(|_| (coordinate(), coordinate())))
}

/// The larger side of the box of the vertices, exactly.
fn side(region: &Region) -> Float {
    let extent = |coordinate: fn(&Node) -> f64| {
        let max = nodes(region).map(coordinate).fold(f64::NEG_INFINITY, f64::max);
        let min = nodes(region).map(coordinate).fold(f64::INFINITY, f64::min);
        Float::with_val(EXACT, max) - min
    };
    extent(|n| n.x).max(&extent(|n| n.y))
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn there_is_exact_and_back_is_rounded_once(seed in any::<u64>(), relative in -3..4i32) {
        let mut random = Rng::new(seed, "tests");
        let a = somewhere(&mut random);
        let mut b = somewhere(&mut random);
        // Regions of comparable size: one that vanishes beside the other is the range the docs leave out.
        let ratio = Float::with_val(EXACT, side(&a) / side(&b)).to_f64();
        prop_assume!(ratio.is_finite() && ratio > 0.0);
        let factor = 2f64.powi(libm::frexp(ratio).1.clamp(-1000, 1000) + relative);
        b.loops[0].iter_mut().for_each(|n| (n.x, n.y) = (n.x * factor, n.y * factor));
        prop_assume!(nodes(&b).all(|n| n.x.is_finite() && n.y.is_finite()) && side(&a) > 0 && side(&b) > 0);
        let (fa, fb) = Frame::pair(&a, &b);
        prop_assert_eq!(fa.exp, fb.exp);
        let side = side(&a).max(&side(&b)) >> fa.exp;
        prop_assert!(side > 0.5 && side <= 1.0 + 4.0 * f64::EPSILON, "{}", side);
        for (region, frame) in [(&a, &fa), (&b, &fb)] {
            for node in nodes(region) {
                let unit = frame.to_unit(DVec2::new(node.x, node.y));
                prop_assert!(unit.abs().max_element() <= 1.5, "{:?} {:?}", unit, frame);
                prop_assert_eq!(scaled(unit.x, frame.exp) + frame.shift.x, node.x);
                prop_assert_eq!(scaled(unit.y, frame.exp) + frame.shift.y, node.y);
            }
        }
        for (p, q) in nodes(&a).zip(nodes(&b)) {
            let sum = fa.to_unit(DVec2::new(p.x, p.y)) + fb.to_unit(DVec2::new(q.x, q.y));
            let exact = |x: f64, one: f64, other: f64| (scaled(x, fa.exp) + one + other).to_f64();
            let back = fa.sum_to_input(&fb, sum);
            prop_assert_eq!(back.x, exact(sum.x, fa.shift.x, fb.shift.x));
            prop_assert_eq!(back.y, exact(sum.y, fa.shift.y, fb.shift.y));
            prop_assert_eq!(fa.to_input(fa.to_unit(DVec2::new(p.x, p.y))), DVec2::new(p.x, p.y));
        }
    }

    #[test]
    fn any_numbers_give_a_frame(numbers in prop::collection::vec(any::<f64>(), 0..12), bulge in any::<f64>()) {
        let node = |p: &[f64]| Node { x: p[0], y: p[1], curve: Curve::Bulge(bulge) };
        let region = Region { loops: vec![numbers.chunks_exact(2).map(node).collect()], ..Region::default() };
        let (frame, same) = Frame::pair(&region, &region);
        prop_assert_eq!(frame, same);
        prop_assert!(frame.shift.is_finite());
    }
}

/// Far from the origin a region is moved to it: no bit of its shape is lost, none of its place is carried along.
#[test]
fn far_regions_are_shifted() {
    let far = polygon(&[(1e6, 1e6), (1e6 + 0.1, 1e6), (1e6 + 0.1, 1e6 + 0.05)]);
    let (frame, _) = Frame::pair(&far, &far);
    assert!(frame.shift.cmpgt(DVec2::splat(999_999.0)).all());
    let near = polygon(&[(0.1, 0.2), (0.7, 0.1), (0.3, 0.9)]);
    assert_eq!(Frame::pair(&near, &far).0.shift, DVec2::ZERO);
    // The shift would be 1, but 0.3 - 1 takes one bit more than a double has.
    assert_eq!(Frame::pair(&polygon(&[(0.3, 0.0), (1.25, 0.0), (0.7, 0.1)]), &near).0.shift.x, 0.0);
    assert_eq!(Frame::pair(&polygon(&[(0.25, 0.0), (1.25, 0.0), (0.75, 0.1)]), &near).0.shift.x, 1.0);
}

/// A circle of two half circles is as wide as it is high, though its vertices are not.
#[test]
fn arcs_count_with_their_extent() {
    let half = |x: f64, curve| Node { x, y: 0.0, curve };
    for (curve, size) in [(Curve::Bulge(1.0), 3), (Curve::Radius(4.0), 3), (Curve::Bulge(100.0), 10)] {
        let region = Region { loops: vec![vec![half(4.0, curve), half(-4.0, curve)]], ..Region::default() };
        assert_eq!(Frame::pair(&region, &Region::default()).0.exp, size, "{curve:?}");
    }
}

#[test]
fn one_frame_for_all_holds_all() {
    let (left, right) =
        (polygon(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]), polygon(&[(7.0, 0.0), (8.0, 0.0), (7.0, 1.0)]));
    assert_eq!(Frame::shared(&[&left, &right]).exp, 3);
    assert_eq!(Frame::pair(&left, &right).0.exp, 0);
    assert_eq!(Frame::shared(&[]), Frame { exp: 0, shift: DVec2::ZERO });
}
