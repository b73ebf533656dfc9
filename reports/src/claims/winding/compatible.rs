//! M17b: only convexly compatible sums bound (MS 5, Fig. 9).

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::draw;
use super::pieces::Convolved;
use super::probes::exact;
use crate::cases::rng::Rng;
use crate::kept;
use arcsum_oracle::certified::membership::{Membership, State};
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::convolve::Ties;
use arcsum_oracle::decompose;
use arcsum_oracle::error::Budget;
use arcsum_oracle::kinetic::{Holes, Kinetic};
use arcsum_oracle::point::{Place, Point, dot_sign, orient};
use rug::Rational;

/// Shorter chords, and radii that cancel to less, are left out: a point computed in doubles may be free there only because
/// it is rounded. In units of the frame.
const SIZABLE: f64 = 1e-3;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "edges of the sum off all compatible sum segments (polygons), or incompatible sum segments with a middle \
                   not certainly inside the sum (arcs)",
        unit: "1",
        rule: Rule::AtMost(0.0),
        draws: [600, 40_000],
        draw: drawn,
        measure: |input| of_polygons(input, true).or_else(|| of_arcs(input, true)),
        kept: kept!("M17b"),
        control: Control::Measure {
            plants: "compatible and incompatible sum segments are exchanged",
            measure: |input| of_polygons(input, false).or_else(|| of_arcs(input, false)),
        },
    };
    [Claim {
        id: "M17b",
        place: "MS 5",
        says: "The boundary of the sum consists of parts of the convex convolution: where the curvatures of two boundary \
               segments add up to less than nothing, their sum lies inside.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

fn drawn(rng: &mut Rng, number: usize) -> Input {
    if number.is_multiple_of(2) { draw::arcs(rng, number / 2) } else { draw::any(rng, number / 2) }
}

/// Edges of the exact sum by decomposition that sum segments of a kind do not cover.
fn of_polygons(input: &Input, compatible: bool) -> Option<Measured> {
    let [a, b] = exact(input)?;
    let kinetic = Kinetic::new(&a, &b, Holes::All, Ties::FIRST_A).ok()??;
    let segments = if compatible { kinetic.forward() } else { kinetic.backward() };
    let segments: Vec<[Place<Rational>; 2]> =
        segments.iter().map(|s| s.each_ref().map(|p| Place::from(p.clone()))).collect();
    let sum = decompose::sum(&a, &b, Budget::default()).ok()?;
    let bare = sum.edges().filter(|(tail, head)| !is_covered(tail, head, &segments));
    let bare: Vec<(f64, f64)> = bare.map(|(tail, _)| tail.nearest()).collect();
    let measured = Measured::count(bare.len());
    Some(match bare.first() {
        Some(&(x, y)) => measured.at([x, y]),
        None => measured,
    })
}

/// Whether segments that run along an edge cover all of it.
fn is_covered(tail: &Point<Rational>, head: &Point<Rational>, segments: &[[Place<Rational>; 2]]) -> bool {
    let [p, q] = [tail, head].map(|end| Place::from(end.clone()));
    let run = head.minus(tail);
    let length = run.dot(&run);
    let along = segments.iter().filter(|[from, to]| {
        orient(&p, &q, from).is_eq() && orient(&p, &q, to).is_eq() && dot_sign(from, to, &p, &q).is_gt()
    });
    let parameter = |place: &Place<Rational>| place.exact.minus(tail).dot(&run) / &length;
    let mut spans: Vec<[Rational; 2]> = along.map(|[from, to]| [parameter(from), parameter(to)]).collect();
    spans.sort();
    let mut reached = Rational::new();
    for [from, to] in spans {
        if from > reached {
            break;
        }
        reached = reached.max(to);
    }
    reached >= 1
}

/// Sum segments of a kind with a middle that is not certainly inside the sum.
fn of_arcs(input: &Input, incompatible: bool) -> Option<Measured> {
    let case = input.as_pair()?;
    let convolved = Convolved::new(case)?;
    let shape = |region| Shape::new(&crate::bridge::plain(region)).ok();
    let membership = Membership::new(&shape(&case.a)?, &shape(&case.b)?);
    let (mut free, mut open, mut spot) = (0, 0, None);
    for piece in &convolved.pieces.pieces {
        let parents = convolved.parents(piece);
        let radius = parents[0].radius + parents[1].radius;
        let backward = if piece.delta == 0.0 { parents.iter().any(|p| p.sign < 0) } else { radius * piece.r < 0.0 };
        let [tail, head] = [piece.tail, piece.head].map(|v| convolved.pieces.points[v as usize]);
        let vanishes = piece.delta != 0.0 && radius.abs() < SIZABLE;
        if backward != incompatible || vanishes || (head - tail).length() < SIZABLE {
            continue;
        }
        let middle = 0.5 * (tail + head) - 0.5 * libm::tan(0.5 * piece.delta) * (head - tail).perp();
        let t = convolved.in_input(middle);
        match membership.state(&Spot::exact(t[0], t[1])) {
            State::Blocked => (),
            State::Free => {
                free += 1;
                spot = Some(t);
            }
            State::Undecided => open += 1,
        }
    }
    let measured = Measured::between(f64::from(free), f64::from(free + open));
    Some(spot.map_or_else(|| measured.clone(), |spot| measured.clone().at(spot)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_is_covered_by_parts_that_overlap() {
        let point = |x: i32| Point { x: Rational::from(x), y: Rational::from(2 * x) };
        let segment = |from, to| [Place::from(point(from)), Place::from(point(to))];
        let covered = |segments: &[[Place<Rational>; 2]]| is_covered(&point(0), &point(4), segments);
        assert!(covered(&[segment(2, 5), segment(-1, 3)]) && covered(&[segment(0, 2), segment(2, 4)]));
        assert!(!covered(&[segment(0, 2), segment(3, 4)]) && !covered(&[segment(5, -1)]) && !covered(&[]));
    }
}
