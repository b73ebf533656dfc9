//! Blocked, free and the distance to the sum, against exact sums of polygons, enclosing polygons and closed forms.

use crate::common::{bulged, cells, complement, disc, enclosed, exact, hull, radial, rectangle};
use arcsum_oracle::certified::distance::Nearest;
use arcsum_oracle::certified::gap::gap;
use arcsum_oracle::certified::membership::{Membership, State};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::convolve;
use arcsum_oracle::error::Budget;
use arcsum_oracle::locate::{Location, Locator};
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::point::{Place, Point};
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;
use rug::Rational;

/// Enough for everything but touches.
const LIMIT: Precision = Precision::LADDER[2];

fn membership(a: &PlainRegion, b: &PlainRegion) -> Membership {
    let [a, b] = [a, b].map(|region| Shape::new(region).expect("a sound region"));
    Membership::new(&a, &b)
}

fn region(loops: Vec<Vec<Corner>>) -> PlainRegion {
    PlainRegion { loops, unbounded: false }
}

fn sum(a: &ExactRegion<Rational>, b: &ExactRegion<Rational>) -> ExactRegion<Rational> {
    convolve::sum(a, b, Budget::NONE).expect("no budget")
}

fn place(x: f64, y: f64) -> Place<Rational> {
    Place::from(Point::from_f64(x, y).expect("finite"))
}

/// Whether the answer may be true of a point so placed. Only a translate that overlaps B is inside the sum, but one that
/// touches it from all sides can be, too.
fn may_be(state: State, location: Location) -> bool {
    match state {
        State::Blocked => location == Location::Inside,
        State::Free => location == Location::Outside,
        State::Undecided => location != Location::Outside,
    }
}

fn around(point: f64) -> Real {
    Real::from(point.next_down()).hull(&Real::from(point.next_up()))
}

fn overlap(a: &Real, b: &Real) -> bool {
    a.lo() <= b.hi() && b.lo() <= a.hi()
}

/// Whether the pair said to be nearest is as far apart as is said.
fn attains(asked: &Membership, regions: [&PlainRegion; 2], t: &Spot) -> bool {
    let Some(Nearest { distance, first, second }) = asked.nearest(t, LIMIT) else {
        return regions.iter().any(|region| region.loops.is_empty());
    };
    let [a, b] = regions.map(|region| Shape::new(region).expect("a sound region"));
    let piece = |shape: &Shape, side| shape.sides().nth(side).expect("a side").curve.at(LIMIT).clone();
    overlap(&gap(&piece(&a, first), &piece(&b, second).mirrored(&t.at(LIMIT))), &distance)
}

/// Small polygons of both kinds, or their complements.
fn polygon() -> impl Strategy<Value = PlainRegion> {
    let bounded = prop_oneof![2 => cells(3), 1 => radial(3..10)];
    (bounded, prop::bool::weighted(0.2)).prop_map(|(a, outside)| if outside { complement(&a) } else { a })
}

fn points(size: f64) -> impl Strategy<Value = Vec<(f64, f64)>> {
    prop::collection::vec((-size..size, -size..size), 12)
}

proptest! {
    #![proptest_config(crate::common::cases(100))]

    #[test]
    fn states_and_distances_are_those_of_exact_sums(a in polygon(), b in polygon(), generic in points(12.0), integers in points(12.0)) {
        let (asked, sum) = (membership(&a, &b), sum(&exact(&a), &exact(&b)));
        let locator = Locator::new(&sum).expect("finite");
        for (x, y) in generic {
            let (spot, place) = (Spot::exact(x, y), place(x, y));
            let (state, location) = (asked.state(&spot), locator.locate(&place));
            prop_assert!(may_be(state, location) && state != State::Undecided, "({x}, {y}) is {state:?}, {location:?}");
            let (rough, fine) = (asked.distance(&spot, Precision::DOUBLE), asked.distance(&spot, LIMIT));
            let expected = match state {
                State::Blocked => Real::from(0.0),
                _ => { let d = locator.nearest(&place).0; Real::from(d.lo()).hull(&Real::from(d.hi())) }
            };
            prop_assert!(overlap(&rough, &expected) && overlap(&fine, &expected), "{rough:?} {fine:?} {expected:?}");
            prop_assert!(attains(&asked, [&a, &b], &spot));
            prop_assert!(!fine.hi().is_finite() || (&fine - &Real::from(fine.mid())).is_within(-48));
        }
        for (x, y) in integers {
            let (x, y) = (x.round(), y.round());
            let (state, location) = (asked.state_within(&Spot::exact(x, y), LIMIT), locator.locate(&place(x, y)));
            prop_assert!(may_be(state, location), "({x}, {y}) is {state:?}, {location:?}");
        }
    }

    #[test]
    fn states_and_distances_of_arcs_lie_between_enclosing_sums(a in bulged(), b in bulged(), outside in prop::bool::weighted(0.2), points in points(2.5)) {
        let a = if outside { complement(&a) } else { a };
        let asked = membership(&a, &b);
        let sums = enclosed(&a, 16).sum(&enclosed(&b, 16), Budget::NONE).expect("no budget");
        let [inner, outer] = [&sums.inner, &sums.outer].map(|sum| Locator::new(sum).expect("finite"));
        for (x, y) in points {
            let (spot, place) = (Spot::exact(x, y), place(x, y));
            let state = asked.state(&spot);
            prop_assert!(state == State::Blocked || inner.locate(&place) != Location::Inside);
            prop_assert!(state == State::Free || outer.locate(&place) != Location::Outside);
            prop_assert!(state != State::Undecided);
            let distance = asked.distance(&spot, Precision::DOUBLE);
            prop_assert_eq!(state == State::Blocked, distance.hi() == 0.0);
            if state == State::Free {
                prop_assert!(distance.lo() <= inner.nearest(&place).0.hi());
            }
            if outer.locate(&place) == Location::Outside {
                prop_assert!(distance.hi() >= outer.nearest(&place).0.lo());
            }
        }
    }

    #[test]
    fn discs_in_rings_are_as_far_off_as_their_radii_say(
        r in 0.5..1.0f64, hole in 0.3..0.9f64, part in 0.01..0.4f64, centre in (-1.0..1.0f64, -1.0..1.0f64), points in points(2.0)
    ) {
        let ((x, y), hole) = (centre, r * hole);
        let asked = membership(&region(vec![disc(x, y, r), disc(x, y, -hole)]), &region(vec![disc(0.0, 0.0, part)]));
        for (s, t) in points {
            let size = (s - x).hypot(t - y);
            let expected = (size - r - part).max(hole - part - size);
            prop_assume!(expected.abs() > 1e-13);
            let spot = Spot::exact(s, t);
            let distance = asked.distance(&spot, LIMIT);
            // The ends of the half circles are rounded, and so is the expectation: 16 times at most, at sizes below 8.
            prop_assert!((distance.mid() - expected.max(0.0)).abs() < 16.0 * 51f64.exp2().recip());
            prop_assert!((&distance - &Real::from(distance.mid())).is_within(-50));
            prop_assert_eq!(asked.state(&spot), if expected > 0.0 { State::Free } else { State::Blocked });
        }
    }

    #[test]
    fn a_place_known_badly_gets_an_answer_that_holds_for_all_of_it(
        a in bulged(), hole in prop::bool::weighted(0.5), b in bulged(), size in -4..1i32, points in points(2.5), step in (-1.0..1.0f64, -1.0..1.0f64)
    ) {
        let a = if hole { complement(&a) } else { a };
        let quarter = |c: &Corner| Corner { x: 0.25 * c.x, y: 0.25 * c.y, ..*c };
        let b = region(vec![b.loops[0].iter().map(quarter).collect()]);
        let asked = membership(&a, &b);
        for (x, y) in points {
            let at = move |part: f64| (x + part * step.0 * f64::from(size).exp2(), y + part * step.1 * f64::from(size).exp2());
            let vague = Spot::new(move |p| hull(&Vector::new(at(0.0).0, at(0.0).1, p), &Vector::new(at(1.0).0, at(1.0).1, p)));
            let (state, distance) = (asked.state_within(&vague, LIMIT), asked.distance(&vague, Precision::DOUBLE));
            for part in 0..=4 {
                let (x, y) = at(f64::from(part) / 4.0);
                let one = Spot::exact(x, y);
                prop_assert!(state == State::Undecided || state == asked.state(&one));
                prop_assert!(overlap(&distance, &asked.distance(&one, Precision::DOUBLE)));
            }
        }
    }

    #[test]
    fn the_sum_is_symmetric_and_moves_and_scales_with_its_parts(a in bulged(), b in bulged(), shift in (-64..64i32, -64..64i32), k in -20..20i32, points in points(2.5)) {
        let scale = f64::from(k).exp2();
        let mapped = |region: &PlainRegion, map: &dyn Fn(f64, usize) -> f64| {
            let corner = |c: &Corner| Corner { x: map(c.x, 0), y: map(c.y, 1), bend: c.bend };
            let loops = region.loops.iter().map(|ring| ring.iter().map(corner).collect()).collect();
            PlainRegion { loops, unbounded: region.unbounded }
        };
        // Coordinates of 40 bits, so that moving is exact.
        let short = |x: f64, _: usize| (x * 40f64.exp2()).round() / 40f64.exp2();
        let (a, b) = (mapped(&a, &short), mapped(&b, &short));
        let step = [shift.0, shift.1].map(|s| f64::from(s) / 16.0);
        let here = membership(&a, &b);
        let swapped = membership(&b, &a);
        let moved = membership(&mapped(&a, &|c, axis| c + step[axis]), &b);
        let scaled = membership(&mapped(&a, &|c, _| c * scale), &mapped(&b, &|c, _| c * scale));
        for (x, y) in points {
            let (x, y) = (short(x, 0), short(y, 0));
            let spots = [Spot::exact(x, y), Spot::exact(x + step[0], y + step[1]), Spot::exact(x * scale, y * scale)];
            let [same, there, large] = &spots;
            let state = here.state(same);
            prop_assert_eq!([swapped.state(same), moved.state(there), scaled.state(large)], [state; 3]);
            let distance = here.distance(same, Precision::DOUBLE);
            prop_assert!(overlap(&distance, &swapped.distance(same, Precision::DOUBLE)));
            prop_assert!(overlap(&distance, &moved.distance(there, Precision::DOUBLE)));
            let large = scaled.distance(large, Precision::DOUBLE);
            prop_assert_eq!((large.lo(), large.hi()), (distance.lo() * scale, distance.hi() * scale));
        }
    }

    #[test]
    fn radius_and_bulge_give_the_same_sum(bulge in 0.1..0.9f64, b in bulged(), points in points(2.5)) {
        let radius = (1.0 + bulge * bulge) / (2.0 * bulge);
        let cap = |bend| region(vec![vec![Corner { x: -1.0, y: 0.0, bend }, Corner { x: 1.0, y: 0.0, bend: Bend::Line }]]);
        let [first, second] = [Bend::Bulge(bulge), Bend::Radius(radius)].map(|bend| membership(&cap(bend), &b));
        for (x, y) in points {
            let [p, q] = [&first, &second].map(|asked| asked.distance(&Spot::exact(x, y), LIMIT).mid());
            prop_assert!((p - q).abs() < 1e-14);
        }
    }
}

#[test]
fn the_closest_fits_are_told() {
    let hole = region(vec![rectangle(-1.0, -1.0, 1.0, 1.0), disc(0.0, 0.0, -0.5)]);
    let t = Spot::exact(0.0, 0.0);
    let with = |radius: f64| membership(&hole, &region(vec![disc(0.0, 0.0, radius)]));
    let (tight, loose) = (0.5f64.next_up(), 0.5f64.next_down());
    assert_eq!(with(tight).state(&t), State::Blocked);
    assert_eq!(with(loose).state(&t), State::Free);
    assert_eq!(with(0.5).state_within(&t, LIMIT), State::Undecided);
    assert!(overlap(&with(loose).distance(&t, LIMIT), &around(0.5 - loose)));
    assert_eq!(with(tight).distance(&t, LIMIT).hi(), 0.0);
    assert!(with(0.5).distance(&t, LIMIT).is_within(-200));
}

#[test]
fn translates_just_off_contact_are_told() {
    // Two discs, and a disc beside a square, moved away from contact in the direction (3/5, 4/5) or (1, 0).
    let unit = region(vec![disc(0.0, 0.0, 1.0)]);
    let square = region(vec![rectangle(-1.0, -1.0, 1.0, 1.0)]);
    for (a, direction, contact) in [(&unit, [3.0, 4.0, 5.0], 1.5), (&square, [1.0, 0.0, 1.0], 1.5)] {
        let asked = membership(a, &region(vec![disc(0.0, 0.0, 0.5)]));
        for (k, sign) in [10, 60, 300, 2000].into_iter().flat_map(|k| [(k, 1.0), (k, -1.0)]) {
            let off = move |p: Precision| (0..k).fold(Real::new(sign, p), |x, _| x * 0.5);
            let size = move |p: Precision| off(p) + contact;
            let part = move |axis: usize, p: Precision| size(p) * direction[axis] / direction[2];
            let t = Spot::new(move |p| Vector { x: part(0, p), y: part(1, p) });
            let distance = asked.distance(&t, Precision::FINEST);
            if sign > 0.0 {
                assert_eq!(asked.state(&t), State::Free, "2^-{k}");
                assert!((&distance - &off(Precision::FINEST)).is_within(-4000), "2^-{k}");
            } else {
                assert_eq!((asked.state(&t), distance.hi()), (State::Blocked, 0.0), "2^-{k}");
            }
        }
    }
}

#[test]
fn regions_that_coincide_in_part_or_as_a_whole_are_blocked() {
    let square = region(vec![rectangle(0.0, 0.0, 1.0, 1.0)]);
    let lens = region(vec![vec![
        Corner { x: 0.0, y: 0.0, bend: Bend::Bulge(0.3) },
        Corner { x: 1.0, y: 0.25, bend: Bend::Bulge(0.7) },
    ]]);
    let negative = |r: &PlainRegion| {
        let corner = |c: &Corner| Corner { x: -c.x, y: -c.y, bend: c.bend };
        region(r.loops.iter().map(|ring| ring.iter().map(corner).collect()).collect())
    };
    for a in [square, lens, region(vec![disc(0.0, 0.0, 1.0)])] {
        let asked = membership(&a, &negative(&a));
        for (x, y) in [(0.0, 0.0), (0.5, 0.0), (0.0, -0.5), (0.25, 0.25)] {
            assert_eq!(asked.state(&Spot::exact(x, y)), State::Blocked, "({x}, {y})");
        }
    }
}

#[test]
fn nested_regions_are_told_by_their_outer_loops() {
    let state = |a: &PlainRegion, b: &PlainRegion, x: f64| membership(a, b).state(&Spot::exact(x, 0.0));
    let ring = |r: f64, s: f64| region(vec![disc(0.0, 0.0, r), disc(0.0, 0.0, -s)]);
    let small = region(vec![disc(0.0, 0.0, 0.1)]);
    // In the hole, in the ring, outside; a ring in the hole of another; a ring in a disc, the hole of which holds nothing.
    assert_eq!([0.0, 0.75, 2.0].map(|x| state(&ring(1.0, 0.5), &small, x)), [State::Free, State::Blocked, State::Free]);
    assert_eq!(state(&ring(1.0, 0.5), &ring(0.4, 0.3), 0.05), State::Free);
    assert_eq!(state(&region(vec![disc(0.0, 0.0, 1.0)]), &ring(0.4, 0.3), 0.05), State::Blocked);
    // An island in a hole.
    let island = region(vec![disc(0.0, 0.0, 1.0), disc(0.0, 0.0, -0.8), disc(0.0, 0.0, 0.3)]);
    assert_eq!([0.0, 0.5, 0.9].map(|x| state(&island, &small, x)), [State::Blocked, State::Free, State::Blocked]);
    // Everything but a disc; everything; nothing.
    let outside = PlainRegion { loops: vec![disc(0.0, 0.0, -1.0)], unbounded: true };
    assert_eq!([0.0, 0.95, 3.0].map(|x| state(&outside, &small, x)), [State::Free, State::Blocked, State::Blocked]);
    assert_eq!(state(&outside, &outside, 0.0), State::Blocked);
    let (plane, nothing) = (PlainRegion { loops: Vec::new(), unbounded: true }, region(Vec::new()));
    assert_eq!([&small, &nothing].map(|b| state(&plane, b, 0.0)), [State::Blocked, State::Free]);
    assert_eq!(membership(&nothing, &small).distance(&Spot::exact(0.0, 0.0), LIMIT).lo(), f64::INFINITY);
    assert_eq!(membership(&plane, &small).distance(&Spot::exact(0.0, 0.0), LIMIT).hi(), 0.0);
}

#[test]
fn a_forgotten_loop_is_noticed() {
    let (a, b) = (region(vec![disc(0.0, 0.0, 1.0), disc(0.0, 0.0, -0.5)]), region(vec![disc(0.0, 0.0, 0.1)]));
    let sums = enclosed(&a, 16).sum(&enclosed(&b, 16), Budget::NONE).expect("no budget");
    let outer = Locator::new(&sums.outer).expect("finite");
    let filled = region(vec![disc(0.0, 0.0, 1.0)]);
    let state = |a| membership(a, &b).state(&Spot::exact(0.0, 0.0));
    assert!(may_be(state(&a), outer.locate(&place(0.0, 0.0))));
    assert!(!may_be(state(&filled), outer.locate(&place(0.0, 0.0))));
}
