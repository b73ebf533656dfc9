//! A3: the error of the order in an arrangement, near the tails of curves and elsewhere (abstract of MS reference 5; memo C,
//! C4). A tail is a left end.

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::audit::{Told, order, vertices};
use super::tangle::{Tangle, draw, extent};
use crate::kept;
use arcsum::angle::Ang;
use arcsum::arrangement::arrange_with;
use arcsum::arrangement::cross::CrossingModule;
use arcsum::piece::{Piece, Pieces};
use glam::DVec2;

/// The constant of the bound, that of M14 in the memo.
const CONSTANT: f64 = 4.0;

/// Which part of an arrangement is looked at, and which arrangement.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Look {
    /// What is farther than k n eps from the tails.
    AwayFromTails,
    /// All of it.
    Everywhere,
    /// All of the arrangement of the curves with horizontal lines of length k n eps at their tails.
    Extended,
}

pub(super) fn claims() -> [Claim; 3] {
    let sup = |measure, kept, control| Sup {
        quantity: "perturbation of order and vertices by eps (1 + k n), eps the tolerance of the module",
        unit: "1",
        rule: Rule::AtMost(CONSTANT),
        draws: [600, 20_000],
        draw,
        measure,
        kept,
        control: Control::Measure {
            plants: "lies 1000 times larger than the accuracy that is counted",
            measure: control,
        },
    };
    let claim =
        |id, says, sup| Claim { id, place: "MS reference 5, abstract", says, erratum: "", test: Test::Sup(sup) };
    [
        claim(
            "A3",
            "Away from the tails of curves by k n eps the arrangement is that of curves O(eps + k n eps) from the given ones.",
            sup(
                |input| measure(input, Look::AwayFromTails, 1.0),
                kept!("A3"),
                |input| measure(input, Look::AwayFromTails, 1000.0),
            ),
        ),
        claim(
            "A3 extended",
            "With tiny horizontal extensions at the tails it is so everywhere.",
            sup(
                |input| measure(input, Look::Extended, 1.0),
                kept!("A3_extended"),
                |input| measure(input, Look::Extended, 1000.0),
            ),
        ),
        claim(
            "A3 tails",
            "The sweep of the memo needs no extensions: the bound holds at the tails as well (memo C).",
            sup(
                |input| measure(input, Look::Everywhere, 1.0),
                kept!("A3_tails"),
                |input| measure(input, Look::Everywhere, 1000.0),
            ),
        ),
    ]
}

/// The perturbation of an arrangement whose module lies so many times more than it owns up to.
fn measure(input: &Input, look: Look, times: f64) -> Option<Measured> {
    let tangle = Tangle::of(input)?;
    let plain = tangle.pieces();
    let accuracy = tangle.module(&plain).tolerance();
    let lying = if times > 1.0 { tangle.lying(times) } else { tangle };
    let bound = |pieces: &Pieces| {
        let told = Told::new(pieces, &lying.module(pieces));
        accuracy * (1.0 + told.cyclic() as f64 * told.curves() as f64)
    };
    let most = bound(&plain);
    let pieces = if look == Look::Extended { extended(&plain, most.min(1e-3 * extent(&plain))) } else { plain };
    if pieces.pieces.len() < 2 {
        return None;
    }
    let map = arrange_with(&pieces, &lying.module(&pieces));
    let clear = if look == Look::AwayFromTails { most } else { 0.0 };
    let off = order(&map, clear).or(vertices(&map));
    let scale = if look == Look::Extended { bound(&pieces).max(most) } else { most };
    Some(Measured::between(off.lo / scale, off.hi / scale))
}

/// The pieces with a horizontal line of this length to the left of each.
fn extended(pieces: &Pieces, length: f64) -> Pieces {
    let mut longer = pieces.clone();
    for piece in &pieces.pieces {
        let [p, q] = [piece.tail, piece.head].map(|v| pieces.points[v as usize]);
        let left = if p.x <= q.x { piece.tail } else { piece.head };
        let from = longer.points.len() as u32;
        longer.points.push(pieces.points[left as usize] - DVec2::new(length, 0.0));
        longer.pieces.push(Piece::line(from, left, Ang::DOWN, piece.source));
    }
    longer
}
