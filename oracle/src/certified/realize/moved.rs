//! How far a realization is from the boundary that the engine stores (Theorem 1 and Lemma 1 of MS, measured).
//!
//! Points are matched as in Lemma 1: by the place on a line, by the angle on a circle segment, and the connections of
//! step 4 with the point between the chains. On a stored circle segment the difference of matched points is c + q n
//! for a complex q and the normals n, an arc of the same sweep 2 delta <= 90 degrees as the segment; it exceeds the
//! larger of its ends d, e by at most its sagitta |e - d| / 2 tan(delta / 2), tan(22.5 degrees) < 0.4143. So the
//! bounds are certified, and the Hausdorff distance is not above them.

use super::place::Placed;
use super::plan::{Plan, WORK};
use super::track::{Mark, Track};
use crate::certified::precision::Precision;
use crate::certified::real::Real;
use crate::certified::vector::Vector;

/// The precision for stops, of which there can be as many as sum segments.
const STOPS: Precision = Precision::LADDER[2];

/// More than half of tan(pi/8).
const SAGITTA: f64 = 0.207_2;

/// Upper bounds of distances, in the unit box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    /// Of matched points of the stored boundary and the realization.
    pub boundary: f64,
    /// Of the places where the convolution ends sum segments inside circle segments, from where the engine has them.
    pub stops: f64,
    /// The translation that was subtracted for the next two: about the best for the boundary.
    pub translation: (f64, f64),
    /// As `boundary`, after the translation.
    pub boundary_translated: f64,
    /// As `stops`, after the translation.
    pub stops_translated: f64,
}

/// How far one chain has moved, in the unit box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainMove {
    /// The loop.
    pub ring: usize,
    /// How many lines and circle segments it consists of.
    pub spans: usize,
    /// Upper bound of the distance of matched points after step 2, before the lift.
    pub drift: f64,
    /// By how much step 3 lifts it along the direction.
    pub lift: f64,
}

/// The difference vectors of a chain, in input coordinates, as intervals of doubles: relatively as sharp as they need
/// be.
struct Differences {
    /// Those at the ends of every piece, and whether it is a circle segment.
    pieces: Vec<([Vector; 2], bool)>,
    stops: Vec<Vector>,
}

impl Moved {
    /// The greater of both distances after the best translation.
    #[must_use]
    pub fn translated(&self) -> f64 {
        self.boundary_translated.max(self.stops_translated)
    }

    /// The greater of both distances.
    #[must_use]
    pub fn greatest(&self) -> f64 {
        self.boundary.max(self.stops)
    }
}

/// The distances of a plan's region and of its chains.
#[must_use]
pub fn moved(plan: &Plan) -> (Moved, Vec<ChainMove>) {
    let (placed, coarse) = (plan.placed(WORK), plan.placed(STOPS));
    let differences = |chain: usize| Differences {
        pieces: pieces(plan, chain, &placed[chain]),
        stops: stops(plan, chain, &coarse[chain]),
    };
    let all: Vec<Differences> = (0..placed.len()).map(differences).collect();
    let none = Vector::new(0.0, 0.0, Precision::DOUBLE);
    let length = plan.up.square(WORK).sqrt();
    let unlifted = |chain: usize| {
        let lift = plan.up.from_frame(&Vector::new(0.0, plan.lifts[chain], WORK), WORK);
        ChainMove {
            ring: plan.chains[chain].ring,
            spans: plan.chains[chain].spans.len(),
            drift: all[chain].boundary(&rough(&lift)),
            lift: (Real::from(plan.lifts[chain]) / &length).hi(),
        }
    };
    let chains = (0..placed.len()).map(unlifted).collect();
    let greatest = |by: &Vector, measure: fn(&Differences, &Vector) -> f64| {
        all.iter().map(|chain| measure(chain, by)).fold(0.0, f64::max)
    };
    let translation = middle(&all);
    let by = Vector::new(translation.0, translation.1, Precision::DOUBLE);
    let moved = Moved {
        boundary: greatest(&none, Differences::boundary),
        stops: greatest(&none, Differences::stops),
        translation,
        boundary_translated: greatest(&by, Differences::boundary),
        stops_translated: greatest(&by, Differences::stops),
    };
    (moved, chains)
}

/// The middle of the box of all differences.
fn middle(all: &[Differences]) -> (f64, f64) {
    let ends = all.iter().flat_map(|chain| &chain.pieces).flat_map(|(ends, _)| ends);
    let mut bounds = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
    for (x, y) in ends.map(Vector::nearest) {
        bounds = [bounds[0].min(x), bounds[1].max(x), bounds[2].min(y), bounds[3].max(y)];
    }
    (0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]))
}

fn pieces(plan: &Plan, chain: usize, placed: &[Placed]) -> Vec<([Vector; 2], bool)> {
    let track = plan.track(chain, WORK);
    let mut pieces = Vec::new();
    for (span, placed) in plan.chains[chain].spans.iter().zip(placed) {
        let difference = |(&mark, point)| rough(&plan.up.from_frame(&(point - &track.stored(mark)), WORK));
        let ends: Vec<Vector> = span.marks.iter().zip(&placed.points).map(difference).collect();
        pieces.extend(ends.windows(2).map(|pair| ([pair[0].clone(), pair[1].clone()], placed.path.round.is_some())));
    }
    pieces
}

fn stops(plan: &Plan, chain: usize, placed: &[Placed]) -> Vec<Vector> {
    let track = plan.track(chain, STOPS);
    let mut stops = Vec::new();
    for (span, placed) in plan.chains[chain].spans.iter().zip(placed) {
        for pair in span.marks.windows(2) {
            stops.extend(stops_between(&track, pair, placed).iter().map(|v| rough(&plan.up.from_frame(v, STOPS))));
        }
    }
    stops
}

/// The differences at the stops between two marks, in the frame.
fn stops_between(track: &Track, pair: &[Mark], placed: &Placed) -> Vec<Vector> {
    let turns = pair.iter().any(|mark| matches!(mark, Mark::Turn(_)));
    let own = if matches!(pair[0], Mark::Turn(_)) { pair[1] } else { pair[0] };
    let side = track.normal(own).y.sign();
    let mut found = Vec::new();
    for stop in &track.pieces[pair[0].piece()].stops {
        let normal = track.at(stop.angle);
        if turns && normal.y.sign() != side {
            continue;
        }
        let engine = &track.point(stop.end) + &track.point(stop.way);
        found.push(&placed.point(&normal) - &engine);
    }
    found
}

fn rough(v: &Vector) -> Vector {
    Vector { x: Real::Double(v.x.enclosure()), y: Real::Double(v.y.enclosure()) }
}

impl Differences {
    fn boundary(&self, translation: &Vector) -> f64 {
        let bound = |(ends, round): &([Vector; 2], bool)| {
            let ends = ends.each_ref().map(|d| d - translation);
            if *round { farthest(&ends).hi() } else { ends[0].length().max(&ends[1].length()).hi() }
        };
        self.pieces.iter().map(bound).fold(0.0, f64::max)
    }

    fn stops(&self, translation: &Vector) -> f64 {
        self.stops.iter().map(|d| (d - translation).length().hi()).fold(0.0, f64::max)
    }
}

/// A bound on the distance to the origin of an arc of at most 90 degrees between two points.
fn farthest(ends: &[Vector; 2]) -> Real {
    ends[0].length().max(&ends[1].length()) + ends[0].distance(&ends[1]) * SAGITTA
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::FRAC_PI_2;

    proptest! {
        #[test]
        fn no_point_of_a_quarter_is_farther_than_the_bound(
            centre in (-2.0..2.0f64, -2.0..2.0f64), radius in 0.0..3.0f64, start in 0.0..7.0f64,
            sweep in prop_oneof![Just(FRAC_PI_2), 0.0..FRAC_PI_2],
        ) {
            let point = |angle: f64| (centre.0 + radius * angle.cos(), centre.1 + radius * angle.sin());
            let ends = [start, start + sweep].map(point).map(|(x, y)| Vector::new(x, y, Precision::DOUBLE));
            for i in 0..=16 {
                let (x, y) = point(start + sweep * f64::from(i) / 16.0);
                prop_assert!(x.hypot(y) <= farthest(&ends).hi() + 1e-14);
            }
        }
    }
}
