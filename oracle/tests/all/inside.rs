//! Certified winding numbers against exact polygons and closed forms.

use crate::common::{bulged, cells, complement, disc, enclosed, exact, hull, radial};
use arcsum_oracle::certified::inside::{Winding, inside};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::locate::{Location, Locator};
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::point::{Place, Point};
use proptest::prelude::*;
use rug::Rational;

fn shape(region: &PlainRegion) -> Shape {
    Shape::new(region).expect("a sound region")
}

fn place(x: f64, y: f64) -> Place<Rational> {
    Place::from(Point::from_f64(x, y).expect("finite"))
}

/// What exact arithmetic says.
fn truth(locator: &Locator<Rational>, x: f64, y: f64) -> Option<bool> {
    match locator.locate(&place(x, y)) {
        Location::Inside => Some(true),
        Location::Outside => Some(false),
        Location::Boundary => None,
    }
}

/// The same point by a way that is inexact at every precision.
fn roundabout(x: f64, y: f64) -> Spot {
    let twice = |x: f64, p: Precision| Real::new(x, p) / 3.0 * 3.0;
    Spot::new(move |p| Vector { x: twice(x, p), y: twice(y, p) })
}

/// Points on and between the vertices of cells, so that many joints are level with them.
fn grid() -> impl Strategy<Value = Vec<(f64, f64)>> {
    let coordinate = || prop_oneof![4 => (-24..40i32).prop_map(|k| f64::from(k) / 4.0), 1 => -6.0..10.0f64];
    prop::collection::vec((coordinate(), coordinate()), 40)
}

proptest! {
    #![proptest_config(crate::common::cases(150))]

    #[test]
    fn points_of_polygons_are_located(a in cells(3), unbounded in any::<bool>(), points in grid()) {
        let a = if unbounded { complement(&a) } else { a };
        let (locator, shape) = (Locator::new(&exact(&a)).expect("finite"), shape(&a));
        for (x, y) in points {
            let expected = truth(&locator, x, y);
            prop_assert_eq!(inside(&shape, &Spot::exact(x, y)), expected, "({}, {})", x, y);
            prop_assert_eq!(inside(&shape, &roundabout(x, y)), expected, "({}, {})", x, y);
        }
    }

    #[test]
    fn vertices_of_polygons_are_on_the_boundary_and_neighbours_are_not(a in radial(3..12), k in 0usize..12) {
        let (locator, shape) = (Locator::new(&exact(&a)).expect("finite"), shape(&a));
        let corner = a.loops[0][k % a.loops[0].len()];
        prop_assert_eq!(inside(&shape, &Spot::exact(corner.x, corner.y)), None);
        for (x, y) in [(corner.x.next_up(), corner.y), (corner.x, corner.y.next_down())] {
            prop_assert_eq!(inside(&shape, &Spot::exact(x, y)), truth(&locator, x, y));
        }
    }

    #[test]
    fn a_point_known_badly_gets_an_answer_that_holds_for_all_its_places(
        a in prop_oneof![cells(3), bulged()], points in prop::collection::vec((-2.0..4.0f64, -2.0..4.0f64), 12), step in (-0.5..0.5f64, -0.5..0.5f64), rounded in any::<bool>()
    ) {
        let winding = Winding::new(&shape(&a));
        let ask = |point: &Vector| winding.inside_at(point, Precision::DOUBLE);
        for (x, y) in points {
            let (x, y) = if rounded { (x.round(), y.round()) } else { (x, y) };
            let place = |part: f64| Vector::new(x + part * step.0, y + part * step.1, Precision::DOUBLE);
            let answer = ask(&hull(&place(0.0), &place(1.0)));
            for part in 0..=8 {
                let one = ask(&place(f64::from(part) / 8.0));
                prop_assert!(answer.is_none() || answer == one, "{:?} for {:?} at {}", answer, one, part);
            }
        }
    }

    #[test]
    fn points_of_discs_are_located(r in 0.1..1.0f64, hole in 0.1..0.9f64, points in prop::collection::vec((-1.2..1.2f64, -1.2..1.2f64), 20)) {
        let s = r * hole;
        let (outer, inner) = (disc(0.0, 0.0, r), disc(0.0, 0.0, -s));
        let shape = shape(&PlainRegion { loops: vec![outer, inner], unbounded: false });
        // The heights and abscissas of the circles' extremes among them.
        let levels = [r, s, -r, -s, 0.0];
        let level = |k: usize| levels[k % levels.len()];
        let more = points.iter().enumerate().flat_map(|(k, p)| [(p.0, level(k)), (level(k), p.1)]);
        for (x, y) in points.iter().copied().chain(more) {
            let size = x.hypot(y);
            prop_assume!((size - r).abs() > 1e-13 && (size - s).abs() > 1e-13);
            let expected = Some(size < r && size > s);
            prop_assert_eq!(inside(&shape, &Spot::exact(x, y)), expected, "({}, {})", x, y);
            prop_assert_eq!(inside(&shape, &roundabout(x, y)), expected, "({}, {})", x, y);
        }
    }

    #[test]
    fn points_of_arcs_agree_with_enclosing_polygons(a in bulged(), unbounded in any::<bool>(), points in prop::collection::vec((-1.5..1.5f64, -1.5..1.5f64), 20)) {
        let a = if unbounded { complement(&a) } else { a };
        let (found, shape) = (enclosed(&a, 24), shape(&a));
        let [inner, outer] = [&found.inner, &found.outer].map(|region| Locator::new(region).expect("finite"));
        let corners = a.loops[0].iter().map(|corner| corner.x).zip(a.loops[0].iter().rev().map(|corner| corner.y));
        for (x, y) in points.into_iter().chain(corners) {
            let answer = inside(&shape, &Spot::exact(x, y));
            prop_assert!(answer == Some(true) || truth(&inner, x, y) != Some(true));
            prop_assert!(answer == Some(false) || truth(&outer, x, y) != Some(false));
        }
    }
}

#[test]
fn a_missing_loop_is_noticed() {
    let ring = |loops| shape(&PlainRegion { loops, unbounded: false });
    let centre = Spot::exact(0.0, 0.0);
    assert_eq!(inside(&ring(vec![disc(0.0, 0.0, 1.0), disc(0.0, 0.0, -0.5)]), &centre), Some(false));
    assert_eq!(inside(&ring(vec![disc(0.0, 0.0, 1.0)]), &centre), Some(true));
    assert_eq!(inside(&ring(Vec::new()), &centre), Some(false));
}
