//! Realizations of MS 4.2: closed, simple, with exactly the stored angles, and near. The oracle builds them from the
//! numbers that the engine stores.

use arcsum::angle::Ang;
use arcsum::arc::Arc;
use arcsum::region::{Curve, Node, Region};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::realize::order::relations;
use arcsum_oracle::certified::realize::plan::{Plan, WORK};
use arcsum_oracle::certified::realize::{
    Angle, Realization, RealizeError, StoredRegion, Up, outline, realize, realize_along,
};
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::vector::Vector;
use arcsum_reports::bridge::{plain, stored, unit};
use arcsum_reports::cases::family::{FAMILIES, Family};
use arcsum_tests::boundary::{FINE, away, has_stored_angles, is_simple, samples};
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, any_region, bars, nudged_integers, simple};
use arcsum_tests::valid::{single, square};
use glam::DVec2;
use proptest::prelude::*;

/// The unit of the theorems.
const EPS: f64 = f64::EPSILON / 2.0;

/// Two regions of any kind, complements among them.
fn operands() -> impl Strategy<Value = (Region, Region)> {
    let region = || prop_oneof![4 => any_region(), 1 => bars(), 1 => nudged_integers(8, 4)];
    (region(), region(), any::<bool>()).prop_map(|(a, b, outside)| (if outside { a.complement() } else { a }, b))
}

fn both(a: &Region, b: &Region) -> [StoredRegion; 2] {
    stored(a, b).expect("valid regions")
}

/// The realization along a clear direction, and that along the vertical unless the region touches itself there.
fn along_both(region: &StoredRegion) -> Vec<Realization> {
    let clear = realize_along(region, Up::clear_of(region)).expect("a realization");
    std::iter::once(clear).chain(realize_along(region, Up::VERTICAL)).collect()
}

fn meets(a: &Vector, b: &Vector) -> bool {
    (&a.x - &b.x).is_within(-900) && (&a.y - &b.y).is_within(-900)
}

/// The region in units of the unit box, as it was given.
fn given(region: &Region, unit: f64) -> Shape {
    let mut plain = plain(region);
    for corner in plain.loops.iter_mut().flatten() {
        (corner.x, corner.y) = (corner.x / unit, corner.y / unit);
    }
    Shape::new(&plain).expect("valid region")
}

/// A bound on the distance of a realization in the terms of its construction. An angle of a line is right to 3 eps,
/// those of a circle segment to 12 eps over its chord, most of which is what a joint may move them; so a span moves
/// by at most 12 eps over the sine of its angle with the direction, which is at least half that of its ends, and all
/// that spans move may add up in a lift.
fn bound(region: &StoredRegion, up: Up, spans: usize) -> f64 {
    let ends = region.loops.iter().flatten().flat_map(|p| [p.start, p.end]);
    let sine = ends.map(|angle| up.normal(angle, WORK).y.abs().lo()).fold(1.0, f64::min);
    2.0 * 24.0 * EPS * spans as f64 / sine
}

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn a_realization_is_closed_and_its_arcs_are_on_their_circles((a, b) in operands()) {
        for region in both(&a, &b) {
            let shape = realize(&region).expect("a realization").shape;
            prop_assert_eq!(shape.unbounded, region.unbounded);
            for sides in &shape.loops {
                for (i, side) in sides.iter().enumerate() {
                    let (piece, next) = (side.curve.at(FINE), sides[(i + 1) % sides.len()].curve.at(FINE));
                    prop_assert!(meets(&piece.to, &next.from));
                    if let Some(circle) = &piece.circle {
                        for end in [&piece.from, &piece.to] {
                            prop_assert!((end.distance(&circle.centre) - &circle.radius).is_within(-900));
                        }
                        let arms = samples(piece).map(|p| &p - &circle.centre);
                        let quadrant = |f: fn(&Vector) -> f64| f(&arms[0]) * f(&arms[1]) > -1e-12;
                        prop_assert!(quadrant(|v| v.x.mid()) && quadrant(|v| v.y.mid()));
                    }
                }
            }
        }
    }

    #[test]
    fn coarse_pieces_contain_fine_ones((a, b) in operands()) {
        let shape = realize(&both(&a, &b)[0]).expect("a realization").shape;
        for side in shape.sides() {
            let fine = side.curve.at(FINE);
            for coarse in [Precision::DOUBLE, Precision::LADDER[1]] {
                let coarse = side.curve.at(coarse);
                for (rough, sharp) in [(&coarse.from, &fine.from), (&coarse.to, &fine.to)] {
                    for (rough, sharp) in [(&rough.x, &sharp.x), (&rough.y, &sharp.y)] {
                        prop_assert!(!rough.is_below(sharp) && !sharp.is_below(rough));
                        prop_assert!(rough.hi() - rough.lo() <= 4.0 * EPS);
                    }
                }
            }
        }
    }

    #[test]
    fn a_realization_has_the_stored_angles_and_no_others((a, b) in operands()) {
        for region in both(&a, &b) {
            prop_assert!(along_both(&region).iter().all(|r| has_stored_angles(&r.shape, &region, r.up)));
        }
    }

    #[test]
    fn a_unit_in_the_last_place_of_an_angle_shows((a, b) in operands(), which: prop::sample::Index) {
        let [region, _] = both(&a, &b);
        let mut wrong = region.clone();
        let pieces: Vec<_> = wrong.loops.iter_mut().flatten().collect();
        let at = which.index(pieces.len());
        let piece = pieces.into_iter().nth(at).expect("in range");
        let moved = |angle: Angle| Angle { offset: angle.offset.abs().max(EPS).next_up(), ..angle };
        (piece.start, piece.end) = if piece.is_line() {
            (moved(piece.start), moved(piece.start))
        } else {
            (moved(piece.start), piece.end)
        };
        if let Ok(realization) = realize(&wrong) {
            prop_assert!(!has_stored_angles(&realization.shape, &region, realization.up));
        }
    }

    #[test]
    fn a_realization_does_not_cross_itself((a, b) in operands()) {
        for region in both(&a, &b) {
            prop_assert!(along_both(&region).iter().all(|r| is_simple(&r.shape, r.up)));
        }
    }

    #[test]
    fn a_realization_is_near((a, b) in operands()) {
        let unit = unit(&a, &b);
        for (region, input) in both(&a, &b).iter().zip([&a, &b]) {
            let up = Up::clear_of(region);
            let realization = realize_along(region, up).expect("a realization");
            let spans = realization.chains.iter().map(|chain| chain.spans).sum();
            prop_assert!(realization.moved.greatest() <= bound(region, up, spans));
            prop_assert!(realize(region).expect("a realization").moved.greatest() <= realization.moved.greatest());
            // Angles and cuts of the engine add 16 eps, derived as above for a circle segment, to what is certified.
            let near = realization.moved.boundary + 16.0 * EPS;
            let given = given(input, unit);
            prop_assert!(away(&realization.shape, &given) <= near && away(&given, &realization.shape) <= near);
        }
    }

    #[test]
    fn nearly_vertical_lines_realize_as_printed((a, b) in (bars(), bars())) {
        for region in both(&a, &b) {
            let realization = realize_along(&region, Up::VERTICAL).expect("a realization");
            prop_assert!(is_simple(&realization.shape, Up::VERTICAL));
            // Angles of lines are right to 3 eps of their offsets, so heads to 6 eps of the heights.
            let spans: usize = realization.chains.iter().map(|chain| chain.spans).sum();
            prop_assert!(realization.moved.boundary <= 12.0 * EPS * spans as f64);
        }
    }

    #[test]
    fn the_excess_of_a_chain_over_the_next_is_its_greatest((a, b) in operands()) {
        let [region, _] = both(&a, &b);
        let plan = Plan::new(region.clone(), Up::clear_of(&region)).expect("a plan");
        let chains = plan.doubles();
        let scale = plan.up.square(WORK).sqrt();
        for relation in relations(&chains, &scale) {
            let [lower, upper] = [relation.lower, relation.upper].map(|i| chains[i].placed.iter().map(|p| &p.path));
            for (low, high) in lower.flat_map(|l| upper.clone().map(move |h| (l, h))) {
                let (a, b) = (low.range(), high.range());
                let (left, right) = (a[0].max(b[0]), a[1].min(b[1]));
                let steps = if right.is_below(&left) { 0 } else { 17 };
                for i in 0..steps {
                    let x = &left + &((&right - &left) * (f64::from(i) / 16.0));
                    let excess = low.ordinate(&x, &scale) - high.ordinate(&x, &scale);
                    prop_assert!(excess.lo() <= relation.excess + 2.0_f64.powi(-100));
                }
            }
        }
    }
}

/// The regions of the built-in families with arcs.
fn bent_regions() -> Vec<StoredRegion> {
    let families = ["parts", "arcs", "bulges", "mixed"].map(|name| Family::named(name).expect("a family"));
    families.iter().flat_map(|f| f.cases(2)).filter(|c| c.segments() < 70).flat_map(|c| both(&c.a, &c.b)).collect()
}

#[test]
fn without_lifts_chains_cross() {
    let crossed = |region: &StoredRegion| {
        let up = Up::clear_of(region);
        let plan = Plan::new(region.clone(), up).expect("a plan");
        let flat = Plan { lifts: vec![0.0; plan.lifts.len()], ..plan.clone() };
        assert!(is_simple(&outline::shape(&plan), up));
        !is_simple(&outline::shape(&flat), up)
    };
    let regions = bent_regions();
    let count = regions.iter().filter(|region| crossed(region)).count();
    assert!(count >= 10, "{count} of {}", regions.len());
}

#[test]
fn a_rectangle_stays_where_it_is() {
    let square = single(square(0.0, 1.0));
    for region in both(&square, &square) {
        for realization in [realize(&region), realize_along(&region, Up::VERTICAL)] {
            assert!(realization.expect("a realization").moved.greatest() < 2.0_f64.powi(-70));
        }
    }
}

/// A rectangle whose right side goes over into a circle segment of this sweep tangentially, up to the rounding of its
/// end.
fn tangent(sweep: f64) -> Region {
    let r = 0.4 / sweep;
    let end = (0.9 - 2.0 * r * libm::pow(libm::sin(sweep / 2.0), 2.0), 0.5 + r * libm::sin(sweep));
    let arc = Node { x: 0.9, y: 0.5, curve: Curve::Bulge(libm::tan(sweep / 4.0)) };
    single(vec![Node::line(0.1, 0.1), Node::line(0.9, 0.1), arc, Node::line(end.0, end.1), Node::line(0.2, 1.0)])
}

#[test]
fn theorem_1_as_printed_fails_next_to_vertical_tangents() {
    let worst = |along: fn(&StoredRegion) -> Up, exponent: i32| {
        let one = |j: i32| {
            let region = tangent(10.0_f64.powi(exponent) * (1.0 + 0.037 * f64::from(j)));
            let [stored, _] = both(&region, &region);
            let realization = realize_along(&stored, along(&stored)).expect("a realization");
            let shape = given(&region, unit(&region, &region));
            (realization.moved.greatest(), away(&realization.shape, &shape))
        };
        (0..20).map(one).fold((0.0, 0.0), |a: (f64, f64), b| (a.0.max(b.0), a.1.max(b.1)))
    };
    for exponent in [-3, -5, -7] {
        let (_, printed) = worst(|_| Up::VERTICAL, exponent);
        let (certified, clear) = worst(Up::clear_of, exponent);
        println!("sweep 1e{exponent}: printed {:.1} eps, clear {:.2} eps", printed / EPS, certified / EPS);
        assert!(printed > 0.1 * EPS * 10.0_f64.powi(-exponent));
        assert!(certified < 16.0 * EPS && clear < 16.0 * EPS);
    }
}

#[test]
fn splitting_at_float_points_would_swap_them() {
    // Abscissas of a convex arc right of its centre, above it, fall as the angle grows; the engine's need not.
    let (a, b) = (Ang::of_normal(1.0, -0.9).expect("a normal"), Ang::of_normal(1.0, 0.9).expect("a normal"));
    let swapped = |i: u32| {
        let tail = DVec2::new(0.1 + f64::from(i) * 1e-4, 0.2);
        let arc = Arc::minor(tail, DVec2::new(tail.x, 0.9), a, b, false);
        let theta = Ang::of_normal(1.0, 0.1 + 3e-4 * f64::from(i)).expect("a normal");
        let next = theta.plus(2.0_f64.powi(-54));
        let ((end, way), (other, after)) = (arc.offset(theta), arc.offset(next));
        theta < next && end == other && way.x < after.x
    };
    assert!((0..2000).filter(|&i| swapped(i)).count() > 10);
}

#[test]
fn numbers_that_make_no_boundary_are_refused() {
    let square = single(square(0.0, 1.0));
    let [good, _] = both(&square, &square);
    let broken = |change: fn(&mut StoredRegion)| {
        let mut region = good.clone();
        change(&mut region);
        realize(&region).err()
    };
    assert_eq!(broken(|r| r.loops[0][1].tail.0 = 2.0), Some(RealizeError::Open { ring: 0, piece: 1 }));
    assert_eq!(broken(|r| r.loops[0][2].start.offset = f64::NAN), Some(RealizeError::BadNumber { ring: 0, piece: 2 }));
    assert_eq!(broken(|r| r.loops[0].truncate(0)), Some(RealizeError::Turnless { ring: 0 }));
    let around = |r: &mut StoredRegion| {
        for piece in &mut r.loops[0] {
            for angle in [&mut piece.start, &mut piece.end] {
                angle.quarter = (angle.quarter + 2) % 4;
            }
        }
    };
    assert!(matches!(broken(around), Some(RealizeError::Backward { ring: 0, .. })));
}

#[test]
fn the_worst_of_the_families() {
    let mut worst = (0.0_f64, String::new());
    for case in FAMILIES.iter().flat_map(|f| f.cases(1)).filter(|case| case.segments() < 200) {
        for (region, operand) in both(&case.a, &case.b).iter().zip(["A", "B"]) {
            let moved = realize(region).expect("a realization").moved;
            if moved.greatest() > worst.0 {
                worst = (
                    moved.greatest(),
                    format!("{} {operand}, {:.2} eps translated", case.name, moved.translated() / EPS),
                );
            }
        }
    }
    println!("worst realization of the built-in families: {:.2} eps, {}", worst.0 / EPS, worst.1);
    assert!(worst.0 > 0.0);
}

#[test]
fn half_circles_and_holes_realize() {
    let arc = |x, y, bulge| Node { x, y, curve: Curve::Bulge(bulge) };
    let ring = Region {
        loops: vec![
            vec![arc(-1.0, 0.1, 1.0), arc(1.0, 0.1, 1.0)],
            vec![arc(0.5, 0.0, -3.0), arc(0.4, 0.2, -1.0 / 3.0)],
        ],
        ..Region::default()
    };
    for region in both(&ring, &ring.complement()) {
        let realization = realize(&region).expect("a realization");
        assert!(has_stored_angles(&realization.shape, &region, realization.up));
        assert!(is_simple(&realization.shape, realization.up));
    }
}

proptest! {
    #![proptest_config(cases(20))]

    #[test]
    fn stops_are_near((a, b) in (simple(8, 0.6, Lattice::Fine), simple(8, 0.6, Lattice::Fine))) {
        for region in both(&a, &b) {
            let realization = realize(&region).expect("a realization");
            // A point is right to 6 eps of a chord, and the stored piece to what is certified.
            prop_assert!(realization.moved.stops <= realization.moved.boundary + 12.0 * EPS);
            let mut wrong = region.clone();
            if let Some(stop) = wrong.loops.iter_mut().flatten().flat_map(|p| &mut p.stops).next() {
                stop.way.0 += 1e-12;
                prop_assert!(realize(&wrong).expect("a realization").moved.stops > 0.9e-12);
            }
        }
    }
}

fn points(corners: &[(f64, f64)]) -> Vec<Node> {
    corners.iter().map(|&(x, y)| Node::line(x, y)).collect()
}

#[test]
fn regions_that_touch_themselves_realize() {
    // Two holes with a common corner, a hole with a corner on that of the outer loop, and a loop that does so.
    let holes = [[(-3.0, -2.0), (-4.0, 0.0), (-2.0, -1.0)], [(0.0, -2.0), (-2.0, -1.0), (0.0, 0.0)]];
    let outer = points(&[(3.0, 0.0), (8.0, 4.0), (2.0, 2.0), (-8.0, 3.0), (-4.0, -10.0)]);
    let apart = Region { loops: vec![outer, points(&holes[0]), points(&holes[1])], ..Region::default() };
    let outer = points(&[(3.0, 0.0), (2.0, 2.0), (-4.0, 6.0), (-7.0, 0.0), (0.0, -5.0)]);
    let within = Region { loops: vec![outer, points(&[(0.0, -5.0), (-2.0, -1.0), (0.0, -1.0)])], ..Region::default() };
    // The loop starts where its bays from the left and the right meet, so that its first and its last chain turn there.
    let right = [(0.0, 0.0), (2.0, 1.0), (2.0, 2.0), (-2.0, 2.0), (-2.0, 1.0)];
    let left = right.map(|(x, y): (f64, f64)| (-x, -y));
    let pinched = single(points(&[right, left].concat()));
    let outside = within.complement();
    let regions = [&apart, &within, &outside, &pinched];
    for region in regions.into_iter().flat_map(|region| both(region, &region.negated())) {
        let realization = realize_along(&region, Up::clear_of(&region)).expect("a realization");
        assert!(is_simple(&realization.shape, realization.up));
        assert!(realization.moved.greatest() < 8.0 * EPS);
    }
}
