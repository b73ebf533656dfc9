//! F16: the sum is the set of collisions (FH 1).

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::draw;
use crate::bridge::plain;
use crate::cases::rng::Rng;
use crate::kept;
use arcsum_oracle::certified::membership::State;
use arcsum_oracle::decompose;
use arcsum_oracle::error::Budget;
use arcsum_oracle::locate::{Location, Locator};
use arcsum_oracle::overlap::Overlap;
use arcsum_oracle::point::{Place, Point};
use arcsum_oracle::region::ExactRegion;
use rug::Rational;

/// Placements of each kind tried for a pair.
const PLACEMENTS: usize = 8;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "placements t at which P meets t-Q and t is not in the sum, or the other way round",
        unit: "1",
        rule: Rule::AtMost(0.0),
        draws: [300, 20_000],
        draw: draw::pair,
        measure: |input| wrong(input, |state| state != State::Free),
        kept: kept!("F16"),
        control: Control::Measure {
            plants: "regions that only touch are taken for disjoint",
            measure: |input| wrong(input, |state| state == State::Blocked),
        },
    };
    [Claim {
        id: "F16",
        place: "FH 1",
        says: "The sum of P and Q turned by half a turn is the set of placements of Q's reference point at which Q meets P, \
               contact included.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

/// How many placements are judged differently by the sum (decomposition and union) and by intersecting P with Q placed.
fn wrong(input: &Input, meets: fn(State) -> bool) -> Option<Measured> {
    let case = input.as_pair().filter(|case| case.is_polygonal())?;
    let read = |region| ExactRegion::<Rational>::from_plain(&plain(region)).ok();
    let (p, q) = (read(&case.a)?, read(&case.b)?);
    let sum = decompose::sum(&p, &q, Budget::default()).ok()?;
    let locator = Locator::new(&sum).ok()?;
    let overlap = Overlap::new(p, q).ok()?;
    let mut measured = Measured::exactly(0.0);
    for t in placements(&sum) {
        let inside = locator.locate(&Place::from(t.clone())) != Location::Outside;
        if inside != meets(overlap.state(&t).ok()?) {
            measured = Measured { spot: Some(t.nearest().into()), ..Measured::exactly(measured.lo + 1.0) };
        }
    }
    Some(measured)
}

/// Vertices of the sum, points of its edges, and points anywhere in its box and next to vertices.
fn placements(sum: &ExactRegion<Rational>) -> Vec<Point<Rational>> {
    let mut rng = Rng::new(0, "placements");
    let edges: Vec<_> = sum.edges().collect();
    let vertices: Vec<_> = sum.loops().iter().flatten().collect();
    if vertices.is_empty() {
        return Vec::new();
    }
    let mut points = Vec::new();
    for k in 0..PLACEMENTS {
        let (tail, head) = edges[rng.below(edges.len())];
        points.push(tail.clone());
        points.push(tail.toward(head, &Rational::from((1 + rng.below(6) as u32, 7u32))));
        let (p, q) = (vertices[rng.below(vertices.len())], vertices[rng.below(vertices.len())]);
        points.push(Point { x: p.x.clone(), y: q.y.clone() });
        // From an edge to its left or right, by a part of its length.
        let way = head.minus(tail);
        let part = Rational::from((if rng.below(2) == 0 { 1 } else { -1 }, 1u64 << (7 * k)));
        let normal = Point { x: Rational::from(-&way.y), y: way.x };
        points.push(tail.toward(head, &Rational::from((1, 2))).plus(&normal.times(&part)));
    }
    points
}
