//! Contacts of two pieces against exact answers: lines between grid points, circles with integer centres and radii, and
//! pieces that come near each other by a known distance.

use std::cmp::Ordering;

use arcsum_oracle::certified::meet::{Contact, LIMIT, Meeting, ZONE, meet};
use arcsum_oracle::certified::piece::{Circle, Piece};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::stretch::along;
use arcsum_oracle::certified::vector::Vector;
use proptest::prelude::*;
use rug::{Float, Rational};

/// The answer of the first precision from a coarsest one on that has one.
fn answer_from(coarsest: Precision, make: impl Fn(Precision) -> [Piece; 2]) -> (Meeting, Precision) {
    let ask = |precision| {
        let [first, second] = make(precision);
        match meet(&first, &second, precision) {
            Meeting::Unclear => None,
            meeting => Some((meeting, precision)),
        }
    };
    let answer = LIMIT.up_to().filter(|&precision| precision >= coarsest).find_map(ask);
    answer.expect("nothing here is a near coincidence")
}

fn answer(make: impl Fn(Precision) -> [Piece; 2]) -> (Meeting, Precision) {
    answer_from(Precision::DOUBLE, make)
}

fn contacts(meeting: &Meeting) -> &[Contact] {
    match meeting {
        Meeting::Contacts { contacts, .. } => contacts,
        _ => &[],
    }
}

/// The bounds of a number, exactly.
fn bounds(real: &Real) -> [Rational; 2] {
    match real {
        Real::Double(i) => [i.lo(), i.hi()].map(|x| Rational::from_f64(x).expect("finite")),
        Real::Long(ends) => ends.as_ref().each_ref().map(|x| x.to_rational().expect("finite")),
    }
}

fn contains(place: &Vector, [x, y]: &[Rational; 2]) -> bool {
    [(&place.x, x), (&place.y, y)].into_iter().all(|(real, exact)| {
        let [low, high] = bounds(real);
        low <= *exact && *exact <= high
    })
}

/// Whether two boxes have a point in common.
fn touches(a: &Vector, b: &Vector) -> bool {
    [(&a.x, &b.x), (&a.y, &b.y)].into_iter().all(|(p, q)| !p.is_below(q) && !q.is_below(p))
}

type Grid = (i32, i32);

fn line([p, q]: [Grid; 2], precision: Precision) -> Piece {
    let [from, to] = [p, q].map(|(x, y)| Vector::new(f64::from(x), f64::from(y), precision));
    Piece { from, to, circle: None }
}

fn cross((ax, ay): Grid, (bx, by): Grid) -> i32 {
    ax * by - ay * bx
}

fn minus((ax, ay): Grid, (bx, by): Grid) -> Grid {
    (ax - bx, ay - by)
}

/// The side of a line on which a point lies.
fn side([p, q]: [Grid; 2], r: Grid) -> i32 {
    cross(minus(q, p), minus(r, p)).signum()
}

/// Whether a grid point lies on a closed segment.
fn is_on(r: Grid, segment: [Grid; 2]) -> bool {
    let [p, q] = segment;
    let (a, b) = (minus(r, p), minus(r, q));
    side(segment, r) == 0 && a.0 * b.0 + a.1 * b.1 <= 0
}

fn segment() -> impl Strategy<Value = [Grid; 2]> {
    let point = || (-3i32..=3, -3i32..=3);
    (point(), point()).prop_filter("two points", |(p, q)| p != q).prop_map(|(p, q)| [p, q])
}

proptest! {
    #![proptest_config(crate::common::cases(3000))]

    #[test]
    fn lines_meet_where_they_do(a in segment(), b in segment()) {
        let (meeting, precision) = answer(|p| [line(a, p), line(b, p)]);
        let (found, turn) = (contacts(&meeting), cross(minus(a[1], a[0]), minus(b[1], b[0])));
        let sides = [side(a, b[0]), side(a, b[1]), side(b, a[0]), side(b, a[1])];
        let shared: Vec<Grid> = a.into_iter().filter(|&p| is_on(p, b)).chain(b.into_iter().filter(|&p| is_on(p, a))).collect();
        let exact = |(x, y): Grid| [Rational::from(x), Rational::from(y)];
        if sides[0] * sides[1] < 0 && sides[2] * sides[3] < 0 {
            // A certain crossing, found in doubles.
            prop_assert_eq!((found.len(), precision), (1, Precision::DOUBLE));
            prop_assert_eq!(found[0].crossing, Some(turn.cmp(&0)));
            let t = Rational::from((cross(minus(b[0], a[0]), minus(b[1], b[0])), turn));
            let (step, start) = (minus(a[1], a[0]), exact(a[0]));
            let point = [Rational::from(step.0) * &t + &start[0], Rational::from(step.1) * &t + &start[1]];
            prop_assert!(contains(&found[0].place, &point));
        } else if shared.is_empty() {
            prop_assert!(matches!(meeting, Meeting::Apart));
        } else {
            let parallel = turn == 0;
            let same = matches!(meeting, Meeting::Contacts { same: true, .. });
            prop_assert_eq!(same, parallel);
            prop_assert!(found.iter().all(|contact| contact.crossing.is_none()));
            for point in shared {
                prop_assert!(found.iter().any(|contact| contains(&contact.place, &exact(point))));
            }
        }
    }
}

/// Quarters of a circle with an exact centre and radius.
fn quarters(centre: Vector, radius: Real, left: bool) -> Vec<Piece> {
    let points: Vec<Vector> = [(1, 0), (0, 1), (-1, 0), (0, -1)]
        .map(|(x, y)| Vector { x: &centre.x + &(&radius * f64::from(x)), y: &centre.y + &(&radius * f64::from(y)) })
        .to_vec();
    (0..4)
        .map(|i| {
            let (p, q) = (points[i].clone(), points[(i + 1) % 4].clone());
            let (from, to) = if left { (p, q) } else { (q, p) };
            Piece { from, to, circle: Some(Circle { centre: centre.clone(), radius: radius.clone(), left }) }
        })
        .collect()
}

fn round((x, y): Grid, radius: i32, left: bool, precision: Precision) -> Vec<Piece> {
    let [x, y, radius] = [x, y, radius].map(|n| Real::new(f64::from(n), precision));
    quarters(Vector { x, y }, radius, left)
}

/// All contacts of the quarters of two circles, and whether any two had the same carrier.
fn all_contacts(coarsest: Precision, make: impl Fn(Precision) -> [Vec<Piece>; 2]) -> (Vec<Contact>, bool) {
    let mut found = Vec::new();
    let mut any_same = false;
    for (i, j) in (0..16).map(|k| (k / 4, k % 4)) {
        let (meeting, _) = answer_from(coarsest, |p| {
            let [a, b] = make(p);
            [a[i].clone(), b[j].clone()]
        });
        any_same |= matches!(meeting, Meeting::Contacts { same: true, .. });
        found.extend(contacts(&meeting).iter().cloned());
    }
    (found, any_same)
}

proptest! {
    #![proptest_config(crate::common::cases(200))]

    #[test]
    fn circles_meet_where_they_do(
        x in -6i32..=6, y in -6i32..=6, r in 1i32..=6, s in 1i32..=6, left in any::<[bool; 2]>()
    ) {
        let square = x * x + y * y;
        let (found, same) =
            all_contacts(Precision::DOUBLE, |p| [round((0, 0), r, left[0], p), round((x, y), s, left[1], p)]);
        let (near, far) = ((r - s) * (r - s), (r + s) * (r + s));
        prop_assert_eq!(same, square == 0 && r == s);
        if same {
            // All ends lie on both.
            for end in round((0, 0), r, true, Precision::FINEST) {
                prop_assert!(found.iter().any(|contact| touches(&contact.place, &end.from)));
            }
            prop_assert!(found.iter().all(|contact| contact.crossing.is_none()));
            return Ok(());
        }
        // The exact points: the foot on the line of centres, and the height over it, squared.
        let fine = |n: i32| Real::new(f64::from(n), Precision::FINEST);
        let height = Rational::from(r * r) - Rational::from((square + r * r - s * s, 2)).square() / square.max(1);
        let points: Vec<Vector> = if square < near || square > far || square == 0 {
            Vec::new()
        } else {
            let along = fine(square + r * r - s * s) / fine(2 * square);
            let square = Real::Long(Box::new([&height; 2].map(|h| Float::with_val(4096, h))));
            let across = (square / fine(x * x + y * y)).sqrt();
            let axis = Vector { x: fine(x), y: fine(y) };
            let foot = &axis * &along;
            [across.clone(), -&across].map(|step| &foot + &(&axis.left() * &step)).to_vec()
        };
        for point in &points {
            prop_assert!(found.iter().any(|contact| touches(&contact.place, point)));
        }
        prop_assert!(found.iter().all(|contact| points.iter().any(|point| touches(&contact.place, point))));
        let crossings: Vec<Ordering> = found.iter().filter_map(|contact| contact.crossing).collect();
        if height <= 0 {
            prop_assert!(crossings.is_empty());
        }
        // At the point left of the line of centres, counter-clockwise circles cross with the second turned to the left.
        for contact in found.iter().filter(|contact| contact.crossing.is_some()) {
            let upper = touches(&contact.place, &points[0]);
            let expected = if upper == (left[0] == left[1]) { Ordering::Greater } else { Ordering::Less };
            prop_assert_eq!(contact.crossing, Some(expected));
        }
        let on_axis = |point: &Vector| {
            let free = |c: &Real, centre: i32| (c - f64::from(centre)).abs().lo() > 1e-9;
            !(free(&point.x, 0) && free(&point.y, 0) && free(&point.x, x) && free(&point.y, y))
        };
        if height > 0 {
            prop_assert_eq!(crossings.len(), points.iter().filter(|point| !on_axis(point)).count());
        }
    }

    /// Circles that miss or cut a touch by a power of two: every point of one within the zone of the other is in a
    /// contact, however close the call.
    #[test]
    fn near_touches_are_contacts(
        (x, y, d) in prop::sample::select(vec![(3, 4, 5), (4, 3, 5), (-5, 12, 13), (8, -15, 17), (-20, -21, 29)]),
        r in 1i32..=4, inner in any::<bool>(), over in any::<bool>(), gap in 30i32..420, left in any::<[bool; 2]>(),
        fine in any::<bool>()
    ) {
        let circles = |p: Precision| {
            let near = Real::new(f64::from(-gap).exp2(), p) * if over { 1.0 } else { -1.0 };
            let second = if inner { &near + f64::from(d + r) } else { &near + f64::from(d - r) };
            let centre = Vector::new(f64::from(x), f64::from(y), p);
            [round((0, 0), r, left[0], p), quarters(centre, second.abs(), left[1])]
        };
        let (found, same) = all_contacts(if fine { LIMIT } else { Precision::DOUBLE }, circles);
        prop_assert!(!same);
        let [first, second] = circles(LIMIT);
        let limit = Real::new(f64::from(ZONE).exp2(), LIMIT);
        // The point of the first circle nearest to the other centre or farthest from it, and points to both sides of it.
        let sign = if inner { -1.0 } else { 1.0 };
        let touch = Vector::new(f64::from(x), f64::from(y), LIMIT).unit();
        let touch = &touch * &Real::from(sign * f64::from(r));
        let mut within = 0;
        for step in (0..440).step_by(7).flat_map(|k| [f64::from(-k).exp2(), -f64::from(-k).exp2(), 0.0]) {
            let point = &(&touch + &(&touch.left() * &Real::from(step))).unit() * &Real::from(f64::from(r));
            if first.iter().any(|piece| piece.spans(&point) != Some(false))
                && second.iter().any(|piece| piece.distance(&point).is_below(&limit))
            {
                within += 1;
                prop_assert!(found.iter().any(|contact| touches(&contact.place, &point)), "at {step}");
            }
        }
        prop_assert!(within > 0 || gap <= -ZONE);
        for contact in &found {
            let [low, high] = bounds(&contact.place.x);
            let size = (high - low).to_f64();
            prop_assert!(contact.crossing.is_some() || size < 1e-26, "a contact of size {size}");
        }
    }

    /// Two pieces of a random kind through one point that neither knows exactly: it is always in a contact, also where
    /// it is an end of one or both, and where the pieces touch there.
    #[test]
    fn a_common_point_is_a_contact(
        turn in 0.0..6.3f64, bends in [-2.0..2.0f64, -2.0..2.0], angle in prop_oneof![Just(0.0), -3.0..3.0f64],
        parts in [0usize..5, 0usize..5]
    ) {
        let part = [0.0, 0.25, 0.5, 0.75, 1.0];
        let make = |p: Precision| [0, 1].map(|i| {
            let tilt = turn + angle * f64::from(u8::from(i == 1));
            let point = Vector::new(turn.sin(), bends[0] / 3.0, p);
            let piece = arc(tilt, bends[i], p);
            let fraction = Real::new(part[parts[i]], p);
            let here = match parts[i] { 0 => piece.from.clone(), 4 => piece.to.clone(), _ => along(&piece, &fraction) };
            piece.moved(&(&point - &here))
        });
        // Pieces of the same carrier have no contact within their common stretch.
        prop_assume!(angle != 0.0 || curvature(bends[0]) != curvature(bends[1]));
        let (meeting, _) = answer(make);
        let point = Vector::new(turn.sin(), bends[0] / 3.0, Precision::FINEST);
        let here = contacts(&meeting).iter().find(|contact| touches(&contact.place, &point));
        let turn = make(Precision::DOUBLE).map(|piece| piece.tangent(&point).unit());
        let turn = turn[0].cross(&turn[1]);
        let inside = parts.iter().all(|&k| k != 0 && k != 4);
        let expected = if inside && turn.abs().lo() > 1e-6 { turn.sign() } else { None };
        prop_assert!(here.is_some());
        if expected.is_some() || !inside {
            prop_assert_eq!(here.and_then(|contact| contact.crossing), expected);
        }
    }
}

/// No smaller than makes a difference, but for lines.
fn curvature(bend: f64) -> f64 {
    if bend == 0.0 { 0.0 } else { bend.signum() * bend.abs().max(0.1) }
}

/// An arc of such a curvature that stays in one quadrant, or a line where it is 0, turned roughly by an angle.
fn arc(turn: f64, bend: f64, precision: Precision) -> Piece {
    let quadrant = std::f64::consts::FRAC_PI_2;
    let start = (turn / quadrant).floor() * quadrant;
    let (low, high) = (start + 0.1 + 0.2 * (turn - start) / quadrant, start + 1.2);
    let [p, q] = [low, high].map(|a| Vector::new(a.cos(), a.sin(), precision).unit());
    if bend == 0.0 {
        return Piece { from: p, to: q, circle: None };
    }
    let radius = Real::new(1.0 / curvature(bend).abs(), precision);
    let [p, q] = [p, q].map(|v| &v * &radius);
    let centre = Vector::new(0.0, 0.0, precision);
    let left = bend > 0.0;
    let (from, to) = if left { (p, q) } else { (q, p) };
    Piece { from, to, circle: Some(Circle { centre, radius, left }) }
}
