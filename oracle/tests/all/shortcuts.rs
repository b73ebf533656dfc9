//! The shortcuts of the convolution must not change its result: neither leaving out the segments at right turns nor what
//! lies in the squares of a cover.

use crate::common::{cells, complement, exact, fork, plain, radial, rectangle};
use arcsum_oracle::convolve;
use arcsum_oracle::cover::Cover;
use arcsum_oracle::error::Budget;
use arcsum_oracle::lattice::Lattice;
use arcsum_oracle::locate::{Location, Locator};
use arcsum_oracle::number::Number;
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::point::{Place, Point};
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;
use rug::Rational;

type Region = ExactRegion<Rational>;

fn unfiltered(a: &Region, b: &Region) -> Region {
    convolve::unfiltered_sum(a, b, Budget::NONE).expect("no budget")
}

fn assert_same(a: &PlainRegion, b: &PlainRegion) {
    let (a, b): (Region, Region) = (exact(a), exact(b));
    assert_eq!(convolve::sum(&a, &b, Budget::NONE).expect("no budget"), unfiltered(&a, &b));
}

/// A point on the way between two others.
fn between(tail: &Point<Rational>, head: &Point<Rational>, parameter: f64) -> Place<Rational> {
    Place::from(tail.toward(head, &Rational::from_f64(parameter).expect("finite")))
}

/// Whether every point of the segment that the cover hides, of a hundred looked at, is inside; and how many it hides.
fn hides_only_the_inside(cover: &Cover, sum: &Locator<Rational>, [tail, head]: [&Point<Rational>; 2]) -> (bool, usize) {
    let exposed = cover.exposed(&Place::from(tail.clone()), &Place::from(head.clone()));
    let hidden = |t: &f64| exposed.is_none_or(|[from, to]| *t < from || *t > to);
    let points: Vec<f64> = (0..=100).map(|k| f64::from(k) / 100.0).filter(hidden).collect();
    let inside = |t: &f64| sum.locate(&between(tail, head, *t)) == Location::Inside;
    (points.iter().all(inside), points.len())
}

fn point(x: f64, y: f64) -> Point<Rational> {
    Point::from_f64(x, y).expect("finite")
}

/// Triangles whose vertices lie on lattice points or so near that intervals cannot tell how their edges pass others.
fn nearly_on_the_lattice() -> impl Strategy<Value = PlainRegion> {
    let corner = [-6i32..7, -6i32..7, -2i32..3, -2i32..3].prop_map(|[x, y, dx, dy]| {
        let moved = |x: i32, ulps: i32| f64::from(x) * (1.0 + f64::from(ulps) * f64::EPSILON);
        (moved(x, dx), moved(y, dy))
    });
    [corner.clone(), corner.clone(), corner].prop_map(|corners| plain(&[&corners]))
}

proptest! {
    #![proptest_config(crate::common::cases(200))]

    #[test]
    fn degenerate_grids_keep_their_sums(a in cells(3), b in cells(4), outside in any::<bool>()) {
        assert_same(&if outside { complement(&a) } else { a }, &b);
    }

    #[test]
    fn a_cover_hides_only_the_inside(
        a in prop_oneof![cells(3), radial(3..20)], b in prop_oneof![cells(2), radial(3..20)], outside in any::<bool>(),
        ends in prop::collection::vec([-8.0..8.0f64, -8.0..8.0, -8.0..8.0, -8.0..8.0], 8), segments in 1usize..5000
    ) {
        let a: Region = exact(&if outside { complement(&a) } else { a });
        let b: Region = exact(&b);
        if let Some(cover) = Cover::new(&a, &b, segments) {
            let sum = Locator::new(&unfiltered(&a, &b)).expect("finite");
            for [x0, y0, x1, y1] in ends {
                prop_assert!(hides_only_the_inside(&cover, &sum, [&point(x0, y0), &point(x1, y1)]).0);
            }
        }
    }

    #[test]
    fn lattice_points_and_squares_are_inside(
        a in prop_oneof![cells(3), radial(3..30), nearly_on_the_lattice(), nearly_on_the_lattice()],
        outside in any::<bool>(), fineness in 0i32..5
    ) {
        let region: Region = exact(&if outside { complement(&a) } else { a });
        let side = 2f64.powi(-fineness);
        let lattice = Lattice::new(side);
        if let Some(bounds) = lattice.bounds(&region) {
            let locator = Locator::new(&region).expect("finite");
            let locate = |x: f64, y: f64| locator.locate(&Place::from(point(x * side, y * side)));
            let [points, squares] = lattice.inside(&region, bounds);
            for row in bounds[0][1]..=bounds[1][1] {
                for column in bounds[0][0]..=bounds[1][0] {
                    let (x, y) = (column as f64, row as f64);
                    if points.contains(row, column, column) {
                        prop_assert_ne!(locate(x, y), Location::Outside);
                    }
                    if squares.contains(row, column, column) {
                        for (dx, dy) in [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0), (0.5, 0.5)] {
                            prop_assert_eq!(locate(x + dx, y + dy), Location::Inside);
                        }
                    }
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(crate::common::cases(30))]

    #[test]
    fn random_polygons_keep_their_sums(a in radial(3..40), b in radial(3..40), outside in any::<bool>()) {
        assert_same(&if outside { complement(&a) } else { a }, &b);
    }
}

#[test]
fn forks_keep_their_sums() {
    let (a, b, _) = fork(4);
    assert_same(&a, &b);
}

#[test]
fn a_hole_that_touches_a_right_turn_keeps_its_sum() {
    // At (0, 0) the outer boundary turns right and a hole fills nearly all of the corner: two slivers are left, which
    // together fit into a half-plane.
    let outer: &[_] = &[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (-4.0, 4.0), (-4.0, -4.0), (0.0, -4.0)];
    let hole: &[_] = &[(0.0, 0.0), (-1.0, -3.0), (-3.0, -3.0), (-3.0, 3.0), (3.0, 3.0), (3.0, 1.0)];
    let square = plain(&[&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]]);
    let pinched = plain(&[outer, hole]);
    assert_same(&pinched, &square);
    assert_same(&square, &pinched);
    assert_same(&complement(&pinched), &square);
}

#[test]
fn the_cover_of_two_squares_leaves_little() {
    let square: Region = exact(&PlainRegion { loops: vec![rectangle(0.0, 0.0, 8.0, 8.0)], unbounded: false });
    let cover = Cover::new(&square, &square, 64).expect("bounded");
    let sum = Locator::new(&unfiltered(&square, &square)).expect("finite");
    let (from, to) = (point(8.0, 8.0), point(24.0, 8.0));
    let (inside, hidden) = hides_only_the_inside(&cover, &sum, [&from, &to]);
    assert!(inside);
    // Half of the way is inside; it is looked at in 16 parts, of which the last two may not be seen to be.
    assert!((38..=50).contains(&hidden), "{hidden}");
    let moved = square.translated(&point(2.0, 0.0));
    let wrong = Cover::new(&moved, &square, 64).expect("bounded");
    assert!(!hides_only_the_inside(&wrong, &sum, [&from, &to]).0, "a cover of another sum passes for one of this");
}

#[test]
fn regions_too_small_for_their_coordinates_have_no_cover() {
    let far = 2f64.powi(52);
    let square: Region =
        exact(&PlainRegion { loops: vec![rectangle(far, far, far + 1.0, far + 1.0)], unbounded: false });
    assert!(Cover::new(&square, &square, 64).is_none());
    let sum = convolve::sum(&square, &square, Budget::NONE).expect("no budget");
    assert_eq!(sum.area(), <Rational as Number>::from_i64(4));
}
