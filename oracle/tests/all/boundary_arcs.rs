//! Boundaries of sums of regions with arcs: against membership, against offsets and areas known in closed form, and the
//! laws of sums, on random regions and on regions full of equal radii, tangent joints and coincident arcs.

use std::f64::consts::PI;

use crate::common::outline::{FINE, area, distance, edges, is_simple, length, runs_along, sides, winds};
use crate::common::pairs::{bulgy, exact_pair, mapped, mirrored, pair, region, rounded};
use crate::common::{disc, radial};
use arcsum_oracle::certified::boundary::{Boundary, boundary};
use arcsum_oracle::certified::membership::{Membership, State};
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::certified::stretch::along;
use arcsum_oracle::certified::sums::sums;
use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::error::Budget;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use proptest::prelude::*;

fn shape(region: &PlainRegion) -> Shape {
    Shape::new(region).expect("valid numbers")
}

fn walk(a: &PlainRegion, b: &PlainRegion) -> Boundary {
    let boundary = boundary(&shape(a), &shape(b), Budget::NONE).expect("no budget");
    boundary.check_closed().expect("closed");
    assert!(boundary.undecided.is_empty() && boundary.blur < 1e-20);
    boundary
}

fn points(n: usize) -> impl Strategy<Value = Vec<(f64, f64)>> {
    prop::collection::vec((-4.0..7.0f64, -5.0..5.0f64), n)
}

proptest! {
    #![proptest_config(crate::common::cases(120))]

    /// The boundary winds once around what is blocked and not around what is free.
    #[test]
    fn the_boundary_separates_blocked_from_free((a, b) in pair(), points in points(30)) {
        let found = edges(&walk(&a, &b));
        let membership = Membership::new(&shape(&a), &shape(&b));
        for (x, y) in points {
            let expected = match membership.state(&Spot::exact(x, y)) {
                State::Blocked => 1,
                State::Free => 0,
                State::Undecided => continue,
            };
            if let Some(number) = winds(&found, x, y) {
                prop_assert_eq!(number, expected, "at ({}, {})", x, y);
            }
        }
    }

    /// Sum curves consist of points of the sum, and its inside is on their left.
    #[test]
    fn sum_curves_have_the_inside_on_their_left((a, b) in pair()) {
        let (a, b) = (shape(&a), shape(&b));
        let membership = Membership::new(&a, &b);
        for sum in sums(&a, &b) {
            for part in [(&a, &sum.first), (&b, &sum.second)] {
                prop_assert!(part.1.side < part.0.loops[part.1.ring].len());
            }
            let chord = sum.curve.rough().chord().length().lo();
            let spot = |left: f64| {
                let curve = sum.curve.clone();
                Spot::new(move |p| {
                    let piece = curve.at(p);
                    let point = along(piece, &Real::from(0.4375));
                    &point + &(&piece.tangent(&point).unit().left() * &Real::from(left))
                })
            };
            prop_assert!(!membership.distance(&spot(0.0), FINE).is_positive());
            if chord > 1e-6 {
                prop_assert_eq!(membership.state(&spot(f64::from(-60).exp2())), State::Blocked);
            }
        }
    }

    #[test]
    fn the_order_of_operands_does_not_matter((a, b) in pair()) {
        let (one, other) = (walk(&a, &b), walk(&b, &a));
        prop_assert!(runs_along(&one, &other, Vector::clone) && runs_along(&other, &one, Vector::clone));
        prop_assert!((length(&edges(&one)) - length(&edges(&other))).abs() < 1e-9);
    }

    #[test]
    fn sums_move_and_scale_with_their_operands((a, b) in exact_pair(), x in -4i32..=4, y in -4i32..=4, k in -3i32..=1) {
        let (x, y, scale) = (f64::from(x) / 4.0, f64::from(y) / 4.0, f64::from(k).exp2());
        let image = walk(&mapped(&a, |u, v| (scale * (u + x), scale * (v + y))), &mapped(&b, |u, v| (scale * u, scale * v)));
        let whole = walk(&a, &b);
        let there = |p: &Vector| &(p + &Vector { x: Real::from(x), y: Real::from(y) }) * &Real::from(scale);
        let back = |p: &Vector| &(p * &Real::from(1.0 / scale)) - &Vector { x: Real::from(x), y: Real::from(y) };
        prop_assert!(runs_along(&whole, &image, there) && runs_along(&image, &whole, back));
        prop_assert!((scale * length(&edges(&whole)) - length(&edges(&image))).abs() < 1e-9);
    }

    /// The sum with a disc holds the points no farther from the region than the radius.
    #[test]
    fn a_sum_with_a_disc_is_an_offset(a in prop_oneof![bulgy(), rounded()], r in 0.01..1.5f64, points in points(30)) {
        let found = edges(&walk(&a, &region(vec![disc(0.0, 0.0, r)])));
        let sides = sides(&a);
        for (x, y) in points {
            let (Some(inside), Some(number)) = (winds(&sides, x, y), winds(&found, x, y)) else { continue };
            prop_assert_eq!(number == 1, inside == 1 || distance(&sides, x, y) < r);
            prop_assert!(number == 0 || number == 1);
        }
        for piece in &found {
            let (x, y) = (&(&piece.from + &piece.to) * &Real::from(0.5)).nearest();
            if piece.circle.is_none() {
                prop_assert!((distance(&sides, x, y) - r).abs() < 1e-9);
            }
        }
    }

    /// Steiner's formula: area + perimeter r + π r², perimeter + 2 π r.
    #[test]
    fn offsets_of_convex_polygons_have_the_area_of_steiner(
        corners in prop::collection::vec(0.0..1.0f64, 3..9), r in 0.01..2.0f64
    ) {
        let n = corners.len() as f64;
        let corner = |(k, jitter): (usize, f64)| {
            let (y, x) = ((k as f64 + 0.4 * jitter) / n * std::f64::consts::TAU).sin_cos();
            Corner { x, y, bend: Bend::Line }
        };
        let a = region(vec![corners.into_iter().enumerate().map(corner).collect()]);
        let sides = sides(&a);
        let found = walk(&a, &region(vec![disc(0.25, -0.5, r)]));
        let pieces = edges(&found);
        prop_assert!((area(&pieces) - area(&sides) - r * length(&sides) - PI * r * r).abs() < 1e-9);
        prop_assert!((length(&pieces) - length(&sides) - 2.0 * PI * r).abs() < 1e-9);
        // A line for every side and an arc for every corner, cut at the axes.
        let lines = pieces.iter().filter(|piece| piece.circle.is_none()).count();
        prop_assert_eq!(lines, sides.len());
        prop_assert_eq!(pieces.len(), 2 * sides.len() + 4);
    }

    /// A bulge b over a chord c is an arc of radius c (1+b²) / 4b, which is a double here.
    #[test]
    fn radius_and_bulge_give_the_same_boundary((a, b) in (rounded(), rounded())) {
        let by_radius = |region: &PlainRegion| {
            let mut region = region.clone();
            for ring in &mut region.loops {
                for k in 0..ring.len() {
                    let (here, next) = (ring[k], ring[(k + 1) % ring.len()]);
                    if let Bend::Bulge(bulge) = here.bend && bulge != 0.0 {
                        let chord = (next.x - here.x).hypot(next.y - here.y);
                        ring[k].bend = Bend::Radius(chord * (1.0 + bulge * bulge) / (4.0 * bulge));
                    }
                }
            }
            region
        };
        let one = walk(&a, &b);
        for other in [walk(&by_radius(&a), &b), walk(&by_radius(&a), &by_radius(&b))] {
            prop_assert!(runs_along(&one, &other, Vector::clone) && runs_along(&other, &one, Vector::clone));
            prop_assert!((length(&edges(&one)) - length(&edges(&other))).abs() < 1e-9);
        }
    }

    /// What a hole lets through: a ring and a disc that is smaller than its hole, fits it, or is larger.
    #[test]
    fn a_disc_closes_a_hole_that_is_no_larger(outer in 5i32..9, hole in 1i32..5, r in 1i32..5, x in -2i32..=2) {
        let [outer, hole, r, x] = [outer, hole, r, x].map(f64::from);
        let ring = region(vec![disc(x, 1.0, outer), disc(x, 1.0, -hole)]);
        let found = edges(&walk(&ring, &region(vec![disc(-x, 0.0, r)])));
        let left = (hole - r).max(0.0);
        prop_assert!((area(&found) - PI * ((outer + r).powi(2) - left * left)).abs() < 1e-9);
        prop_assert!((length(&found) - 2.0 * PI * (outer + r + left)).abs() < 1e-9);
        prop_assert_eq!(found.len(), if left > 0.0 { 8 } else { 4 });
    }

    /// The complement of a notched disc and the disc that fills it: the sum has the same free space as by membership, and
    /// a free path as narrow as a point is no part of the boundary.
    #[test]
    fn complements_have_boundaries_too((a, b) in pair(), points in points(20)) {
        let outside = crate::common::complement(&a);
        let small = mapped(&b, |x, y| (0.125 * x, 0.125 * y));
        let found = edges(&walk(&outside, &small));
        let membership = Membership::new(&shape(&outside), &shape(&small));
        for (x, y) in points {
            let expected = match membership.state(&Spot::exact(x, y)) {
                State::Blocked => 0,
                State::Free => -1,
                State::Undecided => continue,
            };
            if let Some(number) = winds(&found, x, y) {
                prop_assert_eq!(number, expected);
            }
        }
    }
}

fn corner(x: f64, y: f64, bulge: f64) -> Corner {
    Corner { x, y, bend: if bulge == 0.0 { Bend::Line } else { Bend::Bulge(bulge) } }
}

/// A notch that a disc of the same radius fits exactly: the concave arc and the disc give a point, not a curve.
#[test]
fn a_disc_in_a_notch_of_its_own_radius_leaves_no_boundary() {
    let notched = vec![
        corner(-2.0, 0.0, 0.0),
        corner(-2.0, -2.0, 0.0),
        corner(2.0, -2.0, 0.0),
        corner(2.0, 0.0, 0.0),
        corner(1.0, 0.0, -1.0),
        corner(-1.0, 0.0, 0.0),
    ];
    let found = edges(&walk(&region(vec![notched]), &region(vec![disc(0.0, 0.0, 1.0)])));
    // The rectangle and its border, the notch filled but for what the circles around its rim leave above: nothing.
    let filled = 8.0 + 12.0 + PI;
    let dent = 2.0 - PI / 2.0;
    assert!((area(&found) - (filled - dent)).abs() < 1e-9, "{} {}", area(&found), filled - dent);
}

/// Cusps: three equal circles that touch leave a gap with three cusps; it and its complement.
#[test]
fn cusps_are_corners() {
    let height = 3f64.sqrt() / 2.0;
    let bulge = -(PI / 12.0).tan();
    let cusped = vec![corner(-0.5, 0.0, bulge), corner(0.5, 0.0, bulge), corner(0.0, height, bulge)];
    let a = region(vec![cusped]);
    assert!(is_simple(&a));
    let square = region(vec![vec![
        corner(-0.5, -0.5, 0.0),
        corner(0.5, -0.5, 0.0),
        corner(0.5, 0.5, 0.0),
        corner(-0.5, 0.5, 0.0),
    ]]);
    for b in [&square, &mirrored(&a), &region(vec![disc(0.0, 0.0, 0.25)])] {
        let membership = Membership::new(&shape(&a), &shape(b));
        let found = edges(&walk(&a, b));
        for k in 0..400 {
            let (x, y) = (-1.5 + 0.1501 * f64::from(k % 20), -1.5 + 0.1503 * f64::from(k / 20));
            let blocked = membership.state(&Spot::exact(x, y)) == State::Blocked;
            assert!(winds(&found, x, y).is_none_or(|number| (number == 1) == blocked), "at ({x}, {y})");
        }
    }
}

/// The region between three half circles has a cusp at each corner, exactly, and the square around it three notches.
#[test]
fn exact_cusps_are_corners() {
    let cusped = vec![corner(1.0, 0.0, 1.0), corner(-1.0, 0.0, -1.0), corner(-0.25, 0.0, -1.0)];
    let notched = crate::common::complement(&region(vec![cusped.clone()])).loops.remove(0);
    let around = crate::common::rectangle(-2.0, -2.0, 2.0, 2.0);
    let small = region(vec![vec![corner(-0.125, 0.0, 1.0), corner(0.125, 0.0, 0.0)]]);
    for a in [region(vec![cusped.clone()]), region(vec![around, notched])] {
        for b in [small.clone(), mirrored(&small), region(vec![cusped.clone()]), region(vec![disc(0.0, 0.0, 0.375)])] {
            let membership = Membership::new(&shape(&a), &shape(&b));
            let found = edges(&walk(&a, &b));
            for k in 0..400 {
                let (x, y) = (-2.0 + 0.2001 * f64::from(k % 20), -2.0 + 0.2003 * f64::from(k / 20));
                let blocked = membership.state(&Spot::exact(x, y)) == State::Blocked;
                assert!(winds(&found, x, y).is_none_or(|number| (number == 1) == blocked), "at ({x}, {y})");
            }
        }
    }
}

/// Stadiums with parallel sides: tangent joints, and arcs that continue each other.
#[test]
fn stadiums_add_up() {
    let stadium = |length: f64, r: f64| {
        region(vec![vec![corner(0.0, -r, 0.0), corner(length, -r, 1.0), corner(length, r, 0.0), corner(0.0, r, 1.0)]])
    };
    let found = edges(&walk(&stadium(3.0, 0.5), &stadium(1.0, 0.25)));
    assert!((area(&found) - (4.0 * 1.5 + PI * 0.75 * 0.75)).abs() < 1e-12);
    let turned = mapped(&stadium(1.0, 0.5), |x, y| (0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y));
    let found = edges(&walk(&stadium(3.0, 0.5), &turned));
    assert!((area(&found) - (2.0 * 4.0 + 3.0 * 0.8 + PI)).abs() < 1e-12);
}

proptest! {
    #![proptest_config(crate::common::cases(100))]

    /// Leaving out or doubling any edge is noticed.
    #[test]
    fn a_boundary_with_a_wrong_edge_is_not_closed((a, b) in pair(), k in any::<prop::sample::Index>(), c in radial(3..6)) {
        for b in [b, c] {
            let mut found = walk(&a, &b);
            // Not among those that a cluster may swallow.
            let long = |k: &usize| found.edges[*k].curve.rough().chord().length().lo() > 1e-12;
            let edges: Vec<usize> = (0..found.edges.len()).filter(long).collect();
            let k = *k.get(&edges);
            found.edges.push(found.edges[k].clone());
            prop_assert!(found.check_closed().is_err());
            found.edges.pop();
            found.edges.remove(k);
            prop_assert!(found.check_closed().is_err());
        }
    }
}
