//! Brackets of the region Hausdorff distance against errors planted by construction.

use crate::common::{cells, complement, exact, plain, radial, rectangle, ring};
use arcsum_oracle::locate::{Location, Locator};
use arcsum_oracle::measure::{Bracket, Direction, hausdorff};
use arcsum_oracle::number::Number;
use arcsum_oracle::plain::{Corner, PlainRegion};
use arcsum_oracle::point::{Place, Point};
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;
use rug::Rational;

const TIGHT: f64 = 1.04;

fn rational(x: f64) -> Rational {
    <Rational as Number>::from_f64(x).expect("finite")
}

fn measure(result: &PlainRegion, truth: &PlainRegion) -> Bracket {
    hausdorff::<Rational>(result, &exact(truth), 1.0).expect("polygonal and finite")
}

/// The bracket contains the root of the exact square, tightly, in this direction.
fn assert_is_root(found: Bracket, square: &Rational, direction: Direction) {
    assert!(rational(found.lo).square() <= *square, "{found:?} is above the root of {square}");
    assert!(rational(found.hi).square() >= *square, "{found:?} is below the root of {square}");
    assert!(found.hi <= TIGHT * found.lo, "{found:?} is loose");
    assert_eq!(found.direction, direction);
}

fn assert_is(found: Bracket, distance: f64, direction: Direction) {
    assert_is_root(found, &rational(distance).square(), direction);
}

fn region(loops: Vec<Vec<Corner>>) -> PlainRegion {
    PlainRegion { loops, unbounded: false }
}

fn square() -> PlainRegion {
    region(vec![rectangle(0.0, 0.0, 1.0, 1.0)])
}

/// A square plate with n by n square holes, and their side.
fn grid(n: u32) -> (PlainRegion, f64) {
    let pitch = f64::from(2 * n).log2().ceil().exp2().recip();
    let mut loops = vec![rectangle(0.0, 0.0, 2.0 * f64::from(n) * pitch + pitch, 2.0 * f64::from(n) * pitch + pitch)];
    for k in 0..n * n {
        let (x, y) = (f64::from(2 * (k % n) + 1) * pitch, f64::from(2 * (k / n) + 1) * pitch);
        loops.push(hole(x, y, pitch, pitch));
    }
    (region(loops), pitch)
}

fn hole(x: f64, y: f64, width: f64, height: f64) -> Vec<Corner> {
    let mut hole = rectangle(x, y, x + width, y + height);
    hole.reverse();
    hole
}

/// A bubble or hole in the shape of the 3-4-5 triangle, whose inradius is `scale`.
fn egyptian(x: f64, y: f64, scale: f64) -> Vec<Corner> {
    ring([(x, y), (x, y + 4.0 * scale), (x + 3.0 * scale, y)])
}

proptest! {
    #![proptest_config(crate::common::cases(300))]

    #[test]
    fn a_vertex_moved_outwards(k in 10i32..=50, a in 0i32..6, b in 0i32..6) {
        prop_assume!(a + b > 0);
        let delta = 2f64.powi(-k);
        let mut result = square();
        result.loops[0][2].x += f64::from(a) * delta;
        result.loops[0][2].y += f64::from(b) * delta;
        let truth = rational(delta).square() * (a * a + b * b);
        assert_is_root(measure(&result, &square()), &truth, Direction::FromResult);
        // The same bracket the other way round, and for the complements.
        assert_is_root(measure(&square(), &result), &truth, Direction::FromSum);
        let outside = measure(&complement(&square()), &complement(&result));
        prop_assert!(outside.hi > 0.0 && rational(outside.lo).square() <= truth);
    }

    #[test]
    fn a_vertex_moved_inwards(k in 10i32..=50) {
        let delta = 2f64.powi(-k);
        let mut result = square();
        result.loops[0][2].x -= delta;
        result.loops[0][2].y -= delta;
        assert_is_root(measure(&result, &square()), &(rational(delta).square() * 2), Direction::FromSum);
    }

    #[test]
    fn a_convex_region_shifted(k in 10i32..=49, a in -9i32..9, b in -9i32..9, n in 3usize..12) {
        prop_assume!(a != 0 || b != 0);
        let delta = 2f64.powi(-k);
        // Coordinates with few bits, so that the shift is exact.
        let grain = |x: f64| (x * 256.0).round() / 256.0;
        let corner = |i: usize| (i as f64 / n as f64 * std::f64::consts::TAU).sin_cos();
        let shape = |dx: f64, dy: f64| ring((0..n).rev().map(corner).map(|(x, y)| (grain(x) + dx, grain(y) + dy)));
        let (start, end) = (region(vec![shape(0.0, 0.0)]), region(vec![shape(f64::from(a) * delta, f64::from(b) * delta)]));
        let found = measure(&end, &start);
        let truth = rational(delta).square() * (a * a + b * b);
        prop_assert!(rational(found.lo).square() <= truth && truth <= rational(found.hi).square());
        prop_assert!(found.hi <= TIGHT * found.lo);
    }

    #[test]
    fn a_lost_hole_and_a_bubble(k in 4i32..=50, x in 0.25..0.5f64, y in 0.25..0.5f64) {
        let scale = 2f64.powi(-k);
        // The triangle's corners are exact on a coarse grid.
        let grain = |x: f64| (x / scale).round() * scale;
        let mut holed = square();
        holed.loops.push(egyptian(grain(x), grain(y), scale));
        assert_is(measure(&square(), &holed), scale, Direction::FromResult);
        assert_is(measure(&holed, &square()), scale, Direction::FromSum);
    }

    #[test]
    fn a_sliver_of_a_bubble(k in 3i32..=50, length in 0.25..0.5f64) {
        let width = 2f64.powi(-k);
        let mut holed = square();
        holed.loops.push(hole(0.25, 0.25, length, width));
        assert_is(measure(&holed, &square()), width / 2.0, Direction::FromSum);
        assert_is(measure(&square(), &holed), width / 2.0, Direction::FromResult);
    }

    #[test]
    fn an_island_off_the_shore(k in 4i32..=50, gap in 1i32..9, side in 1i32..9) {
        let scale = 2f64.powi(-k);
        let (gap, side) = (f64::from(gap) * scale, f64::from(side) * scale);
        let mut result = square();
        result.loops.push(rectangle(1.0 + gap, 0.25, 1.0 + gap + side, 0.25 + side));
        assert_is(measure(&result, &square()), gap + side, Direction::FromResult);
        assert_is(measure(&square(), &result), gap + side, Direction::FromSum);
    }
}

proptest! {
    #![proptest_config(crate::common::cases(60))]

    #[test]
    fn a_grid_hole_lost_or_moved_or_doubled(n in 2u32..6, pick in any::<prop::sample::Index>(), k in 2i32..=45) {
        let (truth, side) = grid(n);
        let i = 1 + pick.index((n * n) as usize);
        let mut lost = truth.clone();
        lost.loops.remove(i);
        assert_is(measure(&lost, &truth), side / 2.0, Direction::FromResult);
        let mut moved = truth.clone();
        let step = side * 2f64.powi(-k);
        moved.loops[i].iter_mut().for_each(|c| c.x += step);
        let found = measure(&moved, &truth);
        prop_assert!(found.lo <= step && step <= found.hi && found.hi <= TIGHT * found.lo);
        // Swapped for its neighbour in the wall between the two.
        let mut swapped = truth.clone();
        swapped.loops[i].iter_mut().for_each(|c| c.y += side);
        let found = measure(&swapped, &truth);
        let half = side / 2.0;
        prop_assert!(found.lo <= half && half <= found.hi && found.hi <= TIGHT * found.lo);
    }

    #[test]
    fn brackets_hold_for_sampled_points(
        a in radial(4..14), noise in prop::collection::vec(-1.0..1.0f64, 28), k in 1i32..=50,
        samples in prop::collection::vec((-2.0..2.0f64, -2.0..2.0f64), 40)
    ) {
        let mut b = a.clone();
        for (corner, step) in b.loops[0].iter_mut().zip(noise.chunks(2)) {
            corner.x += step[0] * 2f64.powi(-k);
            corner.y += step[1] * 2f64.powi(-k);
        }
        let found = measure(&b, &a);
        prop_assert!(found.lo <= found.hi && found.hi <= TIGHT * found.lo.max(2f64.powi(-61)));
        let (result, sum) = (exact(&b), exact(&a));
        for (x, y) in samples {
            check_sample(&result, &sum, x, y, found.hi);
            check_sample(&sum, &result, x, y, found.hi);
        }
        for corner in b.loops[0].iter() {
            check_sample(&result, &sum, corner.x, corner.y, found.hi);
        }
        check_witness(&result, &sum, found);
    }

    #[test]
    fn brackets_of_grids_are_symmetric(a in cells(4), b in cells(4)) {
        let (there, back) = (measure(&a, &b), measure(&b, &a));
        prop_assert!(there.lo <= back.hi && back.lo <= there.hi);
        prop_assert_eq!(there.hi == 0.0, exact::<Rational>(&a) == exact::<Rational>(&b));
        if there.hi.is_finite() && there.hi > 0.0 {
            prop_assert!(there.hi <= TIGHT * there.lo);
        }
    }
}

/// A point of one region is not farther from the other than the bracket allows.
fn check_sample(from: &ExactRegion<Rational>, to: &ExactRegion<Rational>, x: f64, y: f64, hi: f64) {
    let place = Place::from(Point::from_f64(x, y).expect("finite"));
    let outside = |region| Locator::new(region).expect("finite").locate(&place) == Location::Outside;
    if !outside(from) && outside(to) {
        assert!(Locator::new(to).expect("finite").nearest(&place).0.lo() <= hi);
    }
}

/// The witness is within rounding of a point that attains the lower bound.
fn check_witness(result: &ExactRegion<Rational>, sum: &ExactRegion<Rational>, found: Bracket) {
    if found.lo < 2f64.powi(-40) {
        return;
    }
    let to = if found.direction == Direction::FromResult { sum } else { result };
    let place = Place::from(Point::from_f64(found.witness.0, found.witness.1).expect("finite"));
    let distance = Locator::new(to).expect("finite").nearest(&place).0.mid();
    assert!((distance - found.lo).abs() <= 2f64.powi(-50), "{distance} at the witness of {found:?}");
}

#[test]
fn equal_regions_have_no_distance() {
    let found = measure(&square(), &square());
    assert_eq!((found.lo, found.hi), (0.0, 0.0));
    let (grid, _) = grid(4);
    assert_eq!(measure(&grid, &grid).hi, 0.0);
}

#[test]
fn cracks_and_spikes_without_area_count_for_nothing() {
    let crack: &[_] = &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.5, 1.0), (0.5, 0.25), (0.5, 1.0), (0.0, 1.0)];
    let spike: &[_] = &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.5, 1.0), (0.5, 7.0), (0.5, 1.0), (0.0, 1.0)];
    assert_eq!(measure(&plain(&[crack]), &square()).hi, 0.0);
    assert_eq!(measure(&plain(&[spike]), &square()).hi, 0.0);
}

#[test]
fn a_sliver_of_the_sum_is_not_matched_by_a_spike_without_area() {
    // The two edges of the spike run along the sliver's, yet the result has no point there.
    let sliver: &[_] = &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.5 + 1e-12, 1.0), (0.5, 7.0), (0.5, 1.0), (0.0, 1.0)];
    let spike: &[_] = &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.5, 1.0), (0.5, 7.0), (0.5, 1.0), (0.0, 1.0)];
    assert_is(measure(&plain(&[spike]), &plain(&[sliver])), 6.0, Direction::FromSum);
}

#[test]
fn a_loop_twisted_by_rounding_is_measured_as_the_region_it_winds_around() {
    let delta = 2f64.powi(-40);
    let twisted: &[_] = &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (-delta, 0.75), (delta, 0.25)];
    let found = measure(&plain(&[twisted]), &square());
    assert!(found.hi <= TIGHT * delta && found.lo > 0.9 * delta, "{found:?}");
    // Wound twice around a corner is still inside.
    let twice = region(vec![rectangle(0.0, 0.0, 1.0, 1.0), rectangle(0.5, 0.5, 1.0, 1.0)]);
    assert_eq!(measure(&twice, &square()).hi, 0.0);
}

/// Three lines through one point with the inside and the outside in turn around it: no winding number changes along any of
/// them there, and yet all must be cut.
#[test]
fn boundaries_that_cross_in_one_point_are_cut_there() {
    let corners = [(1.0, 0.0), (-1.0, 0.0), (-0.5, -1.0), (0.5, 1.0), (-0.5, 1.0), (0.5, -1.0)];
    let three = region(vec![ring(corners)]);
    let loops = exact::<Rational>(&three).loops().to_vec();
    assert_eq!(loops.iter().map(Vec::len).collect::<Vec<_>>(), [3, 3, 3]);
    let one = region(vec![ring([(0.0, 0.0), (0.5, 1.0), (-0.5, 1.0)])]);
    assert_is_root(measure(&three, &one), &rational(1.25), Direction::FromResult);
}

#[test]
fn nothing_and_everything_are_infinitely_far() {
    let (nothing, all) = (PlainRegion::default(), complement(&PlainRegion::default()));
    for (result, truth) in [(&nothing, &square()), (&square(), &nothing), (&all, &square()), (&square(), &all)] {
        let found = measure(result, truth);
        assert_eq!((found.lo, found.hi), (f64::INFINITY, f64::INFINITY));
    }
    assert_eq!(measure(&nothing, &nothing).hi, 0.0);
    assert_eq!(measure(&all, &all).hi, 0.0);
    assert_is(measure(&all, &complement(&square())), 0.5, Direction::FromResult);
    assert_is(measure(&complement(&square()), &all), 0.5, Direction::FromSum);
}

#[test]
fn lengths_are_in_units_of_the_box() {
    let mut result = square();
    result.loops[0][2].x += 0.5;
    let found = hausdorff::<Rational>(&result, &exact(&square()), 4.0).expect("finite");
    assert_is(found, 0.125, Direction::FromResult);
}
