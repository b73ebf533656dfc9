//! Discs among regions: one loop of circle segments about one centre, which it goes around once.

use rug::Rational;

use crate::plain::{Bend, Corner, PlainRegion};
use crate::point::Point;
use crate::region::{ring_edges, ring_points};

/// A disc with rational centre and radius, in input units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Disc {
    /// The centre.
    pub centre: Point<Rational>,
    /// The radius, greater than 0.
    pub radius: Rational,
}

impl Disc {
    /// The disc that a region is, its numbers taken literally; `None` if it is none, or its centre or radius is irrational.
    #[must_use]
    pub fn of(region: &PlainRegion) -> Option<Self> {
        let [ring] = &region.loops[..] else { return None };
        let points = ring_points(0, ring).ok()?;
        let ends = || ring_edges(&points).zip(ring);
        let (centres, sweeps): (Vec<_>, Vec<_>) =
            ends().map(|((from, to), corner)| arc(from, to, corner)).collect::<Option<Vec<_>>>()?.into_iter().unzip();
        let centre = centres.first()?.clone();
        let arm = points[0].minus(&centre);
        let radius = root(&arm.dot(&arm))?;
        // All segments run counter-clockwise, so their sweeps add up to a whole number of turns.
        let turns = sweeps.iter().sum::<f64>() / std::f64::consts::TAU;
        let is_disc = !region.unbounded && centres.iter().all(|c| *c == centre) && (0.5..1.5).contains(&turns);
        is_disc.then_some(Self { centre, radius })
    }
}

/// The centre of a circle segment that runs counter-clockwise and its sweep as a float; none if the centre is irrational.
fn arc(from: &Point<Rational>, to: &Point<Rational>, corner: &Corner) -> Option<(Point<Rational>, f64)> {
    let chord = to.minus(from);
    let square = chord.dot(&chord);
    if square.is_zero() {
        return None;
    }
    let (rise, sweep) = match corner.bend {
        Bend::Bulge(bulge) if bulge > 0.0 => {
            let exact = Rational::from_f64(bulge)?;
            let rise = (1 - Rational::from(exact.square_ref())) / Rational::from(4 * &exact);
            (rise, 4.0 * bulge.atan())
        }
        Bend::Radius(radius) if radius > 0.0 => {
            let share = Rational::from_f64(radius)?.square() / &square;
            let sine = (0.5 / share.to_f64().sqrt()).min(1.0);
            (root(&(share - Rational::from((1, 4))))?, 2.0 * sine.asin())
        }
        Bend::Line | Bend::Bulge(_) | Bend::Radius(_) => return None,
    };
    let left = Point { x: -chord.y.clone(), y: chord.x.clone() };
    Some((from.plus(&chord.times(&Rational::from((1, 2)))).plus(&left.times(&rise)), sweep))
}

/// The square root of a number, if it is rational.
fn root(square: &Rational) -> Option<Rational> {
    let (above, below) = (square.numer(), square.denom());
    let is_square = !square.is_negative() && above.is_perfect_square() && below.is_perfect_square();
    is_square.then(|| Rational::from((above.clone().sqrt(), below.clone().sqrt())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn region(corners: &[(f64, f64, Bend)]) -> PlainRegion {
        let ring = corners.iter().map(|&(x, y, bend)| Corner { x, y, bend }).collect();
        PlainRegion { loops: vec![ring], unbounded: false }
    }

    fn disc(x: i64, y: i64, r: i64) -> Option<Disc> {
        Some(Disc { centre: Point { x: x.into(), y: y.into() }, radius: r.into() })
    }

    proptest! {
        #[test]
        fn circles_in_any_parts_are_discs(x in -9i32..9, y in -9i32..9, k in 1i32..5) {
            let (cx, cy, r) = (f64::from(x), f64::from(y), f64::from(5 * k));
            let (a, b) = (f64::from(3 * k), f64::from(4 * k));
            let expected = disc(x.into(), y.into(), (5 * k).into());
            // The bulge of an arc to the opposite end is 1; of a quarter it is irrational.
            let halves = [(cx - a, cy - b, Bend::Bulge(1.0)), (cx + a, cy + b, Bend::Bulge(1.0))];
            prop_assert_eq!(Disc::of(&region(&halves)), expected.clone());
            let by_radius = Bend::Radius(r);
            let quarters = [(r, 0.0), (0.0, r), (-r, 0.0), (0.0, -r)].map(|(u, v)| (cx + u, cy + v, by_radius));
            prop_assert_eq!(Disc::of(&region(&quarters)), expected);
            let mut hole = halves;
            hole.iter_mut().for_each(|corner| corner.2 = Bend::Bulge(-1.0));
            prop_assert_eq!(Disc::of(&region(&hole)), None);
            let mut flat = quarters;
            flat[0].2 = Bend::Line;
            prop_assert_eq!(Disc::of(&region(&flat)), None);
        }
    }

    #[test]
    fn other_regions_are_none() {
        let half = |x: f64, y: f64| (x, y, Bend::Bulge(1.0));
        assert_eq!(Disc::of(&PlainRegion::default()), None);
        assert_eq!(Disc::of(&region(&[half(0.0, 0.0), (2.0, 0.0, Bend::Bulge(0.5))])), None);
        let twice = [half(-1.0, 0.0), half(1.0, 0.0), half(-1.0, 0.0), half(1.0, 0.0)];
        assert_eq!(Disc::of(&region(&twice)), None);
        // The radius is the root of 2.
        assert_eq!(Disc::of(&region(&[half(-1.0, -1.0), half(1.0, 1.0)])), None);
        assert_eq!(Disc::of(&PlainRegion { unbounded: true, ..region(&[half(-1.0, 0.0), half(1.0, 0.0)]) }), None);
        assert_eq!(Disc::of(&region(&[half(-1.0, 0.0), half(1.0, 0.0)])), disc(0, 0, 1));
    }
}
