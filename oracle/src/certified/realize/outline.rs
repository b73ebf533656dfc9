//! Step 4 of MS 4.2 and the way back from the frame: the boundary of a realization as pieces at any precision.

use std::sync::{Arc, OnceLock};

use rug::Float;
use rug::float::Round as Direction;

use super::path::Round;
use super::place::Placed;
use super::plan::Plan;
use crate::certified::curve::Curve;
use crate::certified::piece::{Circle, Piece};
use crate::certified::precision::Precision;
use crate::certified::real::Real;
use crate::certified::shape::{Shape, Side};
use crate::certified::vector::Vector;

/// The pieces of a plan at every precision of the ladder.
struct Outline {
    plan: Plan,
    known: [OnceLock<Vec<Piece>>; Precision::LADDER.len()],
}

/// The region of a plan, in input units over the side of the unit box.
#[must_use]
pub fn shape(plan: &Plan) -> Shape {
    let outline = Arc::new(Outline { plan: plan.clone(), known: Default::default() });
    let mut loops: Vec<Vec<Side>> = vec![Vec::new(); plan.region.loops.len()];
    for (index, (ring, corner, vertex)) in sides(plan).into_iter().enumerate() {
        let outline = Arc::clone(&outline);
        let curve = Arc::new(Curve::new(move |precision| outline.at(precision)[index].clone()));
        loops[ring].push(Side { curve, corner, vertex });
    }
    Shape { loops, unbounded: plan.region.unbounded }
}

/// What is known of every piece without numbers: its loop, whether it starts at a corner, and the corner that its
/// segment leaves. The order is that of [`Outline::pieces`].
fn sides(plan: &Plan) -> Vec<(usize, bool, usize)> {
    let mut sides = Vec::new();
    for (index, chain) in plan.chains.iter().enumerate() {
        let track = plan.track(index, Precision::LADDER[1]);
        let mut before = None;
        for span in &chain.spans {
            let edge = track.pieces[span.pieces.start].edge;
            for (i, &mark) in span.marks[..span.marks.len() - 1].iter().enumerate() {
                // A chain starts at a connection, into which a circle segment goes over smoothly where it turns back.
                let corner = match before {
                    None => !track.turns(mark),
                    Some(end) => i == 0 && end != track.pieces[mark.piece()].start,
                };
                sides.push((chain.ring, corner, edge));
                before = Some(track.pieces[mark.piece()].end);
            }
        }
        let last = &chain.spans[chain.spans.len() - 1];
        let next = &plan.chains[plan.next(index)].spans[0];
        let turns = track.turns(last.marks[last.marks.len() - 1]);
        sides.push((chain.ring, !turns, track.pieces[next.pieces.start].edge));
    }
    sides
}

impl Outline {
    fn at(&self, precision: Precision) -> &[Piece] {
        self.known[precision.rung()].get_or_init(|| self.pieces(precision))
    }

    /// All pieces, computed two steps of the ladder finer so that little more than the last bit is uncertain.
    fn pieces(&self, precision: Precision) -> Vec<Piece> {
        let fine = Precision::LADDER[(precision.rung() + 2).min(Precision::LADDER.len() - 1)];
        let back = |v: &Vector| self.plan.up.from_frame(v, fine);
        let shift = Vector::new(self.plan.region.shift.0, self.plan.region.shift.1, fine);
        let place = |v: &Vector| rounded(&(&back(v) + &shift), precision);
        let chains = self.plan.placed(fine);
        let mut pieces = Vec::new();
        for (index, chain) in chains.iter().enumerate() {
            for span in chain {
                let points: Vec<Vector> = span.points.iter().map(place).collect();
                let circle = span.path.round.as_ref().map(|Round { centre, radius }| Circle {
                    centre: place(centre),
                    radius: round(&radius.abs(), precision),
                    left: radius.is_positive(),
                });
                let piece =
                    |ends: &[Vector]| Piece { from: ends[0].clone(), to: ends[1].clone(), circle: circle.clone() };
                pieces.extend(points.windows(2).map(piece));
            }
            let [from, to] = [end(chain), &chains[self.plan.next(index)][0].path.from].map(place);
            pieces.push(Piece { from, to, circle: None });
        }
        pieces
    }
}

fn end(chain: &[Placed]) -> &Vector {
    &chain[chain.len() - 1].path.to
}

fn rounded(v: &Vector, precision: Precision) -> Vector {
    Vector { x: round(&v.x, precision), y: round(&v.y, precision) }
}

/// A number rounded outwards.
fn round(x: &Real, precision: Precision) -> Real {
    match x {
        Real::Long(bounds) if precision != Precision::DOUBLE => {
            let bits = precision.bits();
            let end = |i: usize, direction| Float::with_val_round(bits, &bounds[i], direction).0;
            Real::Long(Box::new([end(0, Direction::Down), end(1, Direction::Up)]))
        }
        _ => Real::Double(x.enclosure()),
    }
}
