//! The measures of falsely free points: closed forms, the relations that hold between them, and samples.

use std::f64::consts::TAU;

use arcsum_oracle::certified::depth::{Depths, Probe, Summed};
use arcsum_oracle::certified::inside::inside;
use arcsum_oracle::certified::membership::{Membership, State};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::error::Budget;
use arcsum_oracle::interval::Interval;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::polygon;
use proptest::prelude::*;

/// A bracket of the inradius is relatively this narrow, or absolutely 2^-60, which roundings widen.
const WIDTH: f64 = 1.032;

fn region(corners: &[(f64, f64, f64)]) -> PlainRegion {
    let bend = |bulge: f64| if bulge == 0.0 { Bend::Line } else { Bend::Bulge(bulge) };
    let corner = |&(x, y, bulge): &(f64, f64, f64)| Corner { x, y, bend: bend(bulge) };
    PlainRegion { loops: vec![corners.iter().map(corner).collect()], unbounded: false }
}

fn disc(radius: f64) -> PlainRegion {
    region(&[(-radius, 0.0, 1.0), (radius, 0.0, 1.0)])
}

fn rectangle(width: f64, height: f64) -> PlainRegion {
    region(&[(0.0, 0.0, 0.0), (width, 0.0, 0.0), (width, height, 0.0), (0.0, height, 0.0)])
}

fn summed(a: &PlainRegion, b: &PlainRegion) -> Summed {
    let reference = Reference::new(a, b, 1.0, Budget::default()).expect("small");
    assert_eq!(reference.undecided(), 0);
    reference.summed().clone()
}

fn probe(sum: &Summed, x: f64, y: f64) -> Probe {
    Depths::new(sum).expect("small").probe(&Spot::exact(x, y)).expect("consistent")
}

fn contains(bracket: Interval, truth: f64) -> bool {
    // The truth is a double near it.
    bracket.lo() <= truth * (1.0 + 1e-14) && truth * (1.0 - 1e-14) <= bracket.hi()
}

fn is_narrow(bracket: Interval) -> bool {
    bracket.hi() <= bracket.lo() * WIDTH || bracket.hi() - bracket.lo() <= 2f64.powi(-59)
}

#[test]
fn discs_overlap_in_lenses() {
    let (a, b) = (0.5, 0.25);
    let sum = summed(&disc(a), &disc(b));
    for k in [1, 2, 3, 8, 20, 40, 52] {
        let overlap = 2f64.powi(-k);
        for (x, y) in [(a + b - overlap, 0.0), (0.0, overlap - a - b)] {
            let found = probe(&sum, x, y);
            assert_eq!(found.state, State::Blocked);
            let rho = (0.5 * overlap).min(b);
            assert!(contains(found.rho, rho) && is_narrow(found.rho), "{rho:e} in {found:?}");
            assert!(contains(found.pd, overlap), "{overlap:e} in {found:?}");
        }
    }
    let free = probe(&sum, 0.76, 0.0);
    assert_eq!((free.state, free.rho, free.pd, free.trap), (State::Free, Interval::ZERO, Interval::ZERO, 0.0));
    assert_eq!(probe(&sum, a + b, 0.0).state, State::Undecided);
}

#[test]
fn rectangles_overlap_in_rectangles() {
    let sum = summed(&rectangle(1.0, 0.5), &rectangle(0.5, 0.25));
    for k in [3, 10, 30, 50, 54] {
        let low = 2f64.powi(-k);
        // t - B is the rectangle from (x - 1/2, y - 1/4) to (x, y).
        let found = probe(&sum, 0.75, low);
        assert!(contains(found.rho, 0.5 * low) && is_narrow(found.rho), "{found:?}");
        assert!(contains(found.pd, low) && found.trap == low, "{found:?}");
        let corner = probe(&sum, low, 2.0 * low);
        assert!(contains(corner.rho, 0.5 * low) && is_narrow(corner.rho), "{corner:?}");
        assert!(contains(corner.pd, low) && corner.trap == low, "{corner:?}");
    }
}

#[test]
fn steep_slivers_are_as_deep_as_they_are_wide() {
    let triangle = region(&[(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]);
    let sum = summed(&triangle, &triangle);
    for k in [4, 20, 51] {
        // The lines x + y = 1 and x + y = 1 - 2e.
        let e = 2f64.powi(-k);
        let found = probe(&sum, 1.0 - e, 1.0 - e);
        assert!(contains(found.rho, e * 0.5f64.sqrt()) && is_narrow(found.rho), "{found:?}");
        assert!(contains(found.pd, e * 2f64.sqrt()), "{found:?}");
        // The trapezoid number takes the height for the width.
        assert!(!contains(found.rho, 0.5 * found.trap), "{found:?}");
    }
}

#[test]
fn a_wrong_place_shows() {
    // The check of discs fails if what is measured is off by no more than the overlap itself.
    let sum = summed(&disc(0.5), &disc(0.25));
    let overlap = 2f64.powi(-50);
    let found = probe(&sum, 0.75 - 2.0 * overlap, 0.0);
    assert!(!contains(found.rho, 0.5 * overlap) && !contains(found.pd, overlap), "{found:?}");
}

#[test]
fn a_container_is_unbounded() {
    let outside = PlainRegion { unbounded: true, ..reversed(&rectangle(1.0, 1.0)) };
    let found = probe(&summed(&outside, &rectangle(0.5, 0.5)), 0.75, 0.49);
    // t - B leaves the container by 1/100 at the bottom.
    assert_eq!(found.state, State::Blocked);
    assert!(contains(found.rho, 0.5 * (0.5 - 0.49)) && contains(found.pd, 0.5 - 0.49), "{found:?}");
}

fn reversed(region: &PlainRegion) -> PlainRegion {
    let loops = region.loops.iter().map(|ring| ring.iter().rev().copied().collect()).collect();
    PlainRegion { loops, unbounded: region.unbounded }
}

/// A star-shaped region around the origin with slightly bent sides.
fn star() -> impl Strategy<Value = PlainRegion> {
    let corner = (0.15..0.5f64, prop_oneof![Just(0.0), -0.08..0.08f64]);
    prop::collection::vec(corner, 4..8).prop_map(|corners| {
        let step = TAU / corners.len() as f64;
        let place = |(i, &(r, bulge)): (usize, &(f64, f64))| {
            let (sin, cos) = (step * i as f64).sin_cos();
            (r * cos, r * sin, bulge)
        };
        region(&corners.iter().enumerate().map(place).collect::<Vec<_>>())
    })
}

/// How deep a point is inside a region, from below; 0 unless it certainly is inside.
fn depth(shape: &Shape, x: f64, y: f64) -> f64 {
    let spot = Spot::exact(x, y);
    if inside(shape, &spot) != Some(true) {
        return 0.0;
    }
    let place = spot.at(Precision::DOUBLE);
    shape.sides().map(|side| side.curve.rough().distance(&place).lo()).fold(f64::INFINITY, f64::min)
}

/// How far the nearest of the free points is that are found on rays from a place, by the distance to the sum without the sum.
fn nearest_free(a: &PlainRegion, b: &PlainRegion, x: f64, y: f64) -> f64 {
    let [first, second] = [a, b].map(|region| Shape::new(region).unwrap());
    let membership = Membership::new(&first, &second);
    let is_free = |r: f64, turn: f64| {
        let spot = Spot::exact(x + r * turn.cos(), y + r * turn.sin());
        membership.distance(&spot, Precision::DOUBLE).is_positive()
    };
    let mut least = 4.0;
    for turn in (0..180).map(|i| f64::from(i) * TAU / 180.0) {
        // Whatever is nearer than the best so far and a little more counts.
        while is_free(0.99 * least, turn) {
            least *= 0.99;
        }
    }
    least
}

/// Two stars with the origin inside, and places of the second where they overlap.
fn stars() -> [PlainRegion; 2] {
    let a = region(&[(0.5, 0.0, 0.05), (0.1, 0.2, 0.0), (-0.4, 0.3, -0.06), (-0.2, -0.1, 0.0), (0.1, -0.4, 0.04)]);
    let b = region(&[(0.3, 0.05, 0.0), (0.0, 0.25, 0.03), (-0.3, 0.0, 0.0), (0.05, -0.2, -0.02)]);
    [a, b]
}

const PLACES: [(f64, f64); 4] = [(0.0, 0.0), (0.35, 0.1), (-0.45, 0.2), (0.1, -0.4)];

#[test]
fn the_nearest_free_point_is_as_far_as_the_depth() {
    let [a, b] = stars();
    let sum = summed(&a, &b);
    for (x, y) in PLACES {
        let (found, free) = (probe(&sum, x, y), nearest_free(&a, &b, x, y));
        assert_eq!(found.state, State::Blocked);
        assert!(found.pd.lo() <= free && free <= 1.03 * found.pd.hi(), "{free} and {found:?}");
    }
}

#[test]
fn a_boundary_that_is_none_shows() {
    let [a, b] = stars();
    let shapes = [&a, &b].map(|region| Shape::new(region).unwrap());
    // The boundary of A belongs to the sum's interior, as B has the origin inside.
    let wrong = Summed::new(shapes.clone(), shapes[0].sides().map(|side| side.curve.clone()).collect(), 0.0);
    let depths = Depths::new(&wrong).unwrap();
    for (x, y) in PLACES {
        let (pd, free) = (depths.pd(&Spot::exact(x, y)), nearest_free(&a, &b, x, y));
        assert!(free > 1.03 * pd.hi(), "{free} and {pd:?}");
    }
}

proptest! {
    #![proptest_config(crate::common::cases(128))]

    #[test]
    fn measures_agree_with_samples_and_each_other(
        a in star(), b in star(), x in -0.8..0.8f64, y in -0.8..0.8f64, step in -40..-3i32, turn in 0.0..TAU
    ) {
        let sum = summed(&a, &b);
        let found = probe(&sum, x, y);
        if found.state == State::Blocked {
            prop_assert!(is_narrow(found.rho) && found.rho.lo() > 0.0, "{found:?}");
            prop_assert!(found.rho.lo() <= 0.5 * found.pd.hi() && found.trap > 0.0, "{found:?}");
        }
        let [first, second] = [&a, &b].map(|region| Shape::new(region).unwrap());
        let most = (0..225).map(|i| {
            let (p, q) = ((f64::from(i / 15) - 7.0) / 14.0, (f64::from(i % 15) - 7.0) / 14.0);
            depth(&first, p, q).min(depth(&second, x - p, y - q) + 1e-15)
        });
        let most = most.fold(0.0, f64::max);
        prop_assert!(most <= found.rho.hi() + 1e-14, "{most:e} in {found:?}");
        // Both are 1-Lipschitz.
        let step = f64::from(step).exp2();
        let (u, v) = (x + step * turn.cos(), y + step * turn.sin());
        let (moved, far) = (probe(&sum, u, v), (u - x).hypot(v - y) * (1.0 + 1e-15));
        for (here, there) in [(found.rho, moved.rho), (found.pd, moved.pd), (moved.rho, found.rho), (moved.pd, found.pd)] {
            prop_assert!(here.lo() <= there.hi() + far, "{here:?} {there:?} {far:e}");
        }
    }

    #[test]
    fn depths_by_the_exact_sum_are_the_same(x in -0.2..1.7f64, y in -0.2..1.4f64, height in 0.2..1.0f64) {
        let a = region(&[(0.0, 0.0, 0.0), (1.0, 0.25, 0.0), (0.5, height, 0.0)]);
        let b = region(&[(0.0, 0.0, 0.0), (0.5, 0.0, 0.0), (0.25, 0.125, 0.0), (0.0, 0.75, 0.0)]);
        let arcs = probe(&summed(&a, &b), x, y);
        let exact = polygon::sum(&a, &b).unwrap();
        let lines = probe(&Summed::of_polygons([&a, &b], &exact, 1.0).unwrap(), x, y);
        prop_assert_eq!(arcs.state, lines.state);
        prop_assert!(arcs.pd.lo() <= lines.pd.hi() && lines.pd.lo() <= arcs.pd.hi(), "{arcs:?} {lines:?}");
        prop_assert!((arcs.pd.hi() - lines.pd.hi()).abs() < 1e-15);
    }
}
