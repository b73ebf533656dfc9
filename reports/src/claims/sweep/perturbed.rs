//! M14: how far the curves of a convolution have to be moved for its arrangement to be exact (MS 4; memo C4).
//!
//! The arrangement is that of the kinetic and of the monotonic convolution of a pair, without what is known about the order of
//! the latter. n, the number of curves, is m of MS.

use super::super::control::Control;
use super::super::draw;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::audit::{Told, perturbation};
use super::liar::{Liar, Lie};
use super::tangle::extent;
use crate::cases::rng::Rng;
use crate::cases::shape::disc;
use crate::cases::{combs, fork, gear, parts, radial};
use crate::kept;
use arcsum::arrangement::arrange_with;
use arcsum::arrangement::cross::EPS;
use arcsum::convolution::{kinetic, monotonic};
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::region::Region;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;

/// Curves beyond which a convolution is not measured.
const MOST: usize = 300;

/// The memo's constant c.
const CONSTANT: f64 = 4.0;

/// What the memo has for practice, in eps.
const PRACTICE: f64 = 8.0;

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "perturbation of order and vertices by eps (1 + k m)",
        unit: "1",
        rule: Rule::AtMost(CONSTANT),
        draws: [120, 12_000],
        draw,
        measure: |input| measure(input, true, Lie::None),
        kept: kept!("M14"),
        control: Control::Measure {
            plants: "a crossing module that moves crossings and orders by up to 1000 eps",
            measure: |input| measure(input, true, Lie::Shifts),
        },
    };
    let claim = Claim {
        id: "M14",
        place: "MS 4, 4.3",
        says: "The arrangement of m sum segments is exact for segments O(eps + k m eps) from them, k the triples in cyclic \
               order, here: with the constant 4 of the memo.",
        erratum: "",
        test: Test::Sup(sup.clone()),
    };
    let practice = Claim {
        id: "M14 practice",
        place: "MS 4.3",
        says: "In practice the perturbation is O(eps).",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "perturbation of order and vertices",
            unit: "eps",
            rule: Rule::AtMost(PRACTICE),
            measure: |input| measure(input, false, Lie::None),
            kept: kept!("M14_practice"),
            control: Control::Measure {
                plants: "a crossing module that moves crossings and orders by up to 1000 eps",
                measure: |input| measure(input, false, Lie::Shifts),
            },
            ..sup
        }),
    };
    [claim, practice]
}

/// The greater perturbation of both arrangements, in eps of the larger side of the box of the curves.
fn measure(input: &Input, by_triples: bool, lie: Lie) -> Option<Measured> {
    let case = input.as_pair()?;
    let found: Vec<Measured> =
        convolutions(&case.a, &case.b).iter().filter_map(|pieces| measured(pieces, by_triples, lie)).collect();
    found.into_iter().reduce(|p, q| Measured { hi: p.hi.max(q.hi), ..if p.lo < q.lo { q } else { p } })
}

fn measured(pieces: &Pieces, by_triples: bool, lie: Lie) -> Option<Measured> {
    if !is_small(pieces) {
        return None;
    }
    let extent = extent(pieces);
    // What does not lie knows its tolerance, too.
    let size = if matches!(lie, Lie::None) { 0.0 } else { 1000.0 * EPS * extent };
    let module = Liar::new(lie, extent, size, 1);
    let off = perturbation(&arrange_with(pieces, &module));
    let scale = EPS * extent * if by_triples { triples(pieces) } else { 1.0 };
    Some(Measured::between(off.lo / scale, off.hi / scale))
}

/// Whether all triples can be looked at.
pub(super) fn is_small(pieces: &Pieces) -> bool {
    (1..=MOST).contains(&pieces.pieces.len())
}

/// 1 + k m by the honest module.
fn triples(pieces: &Pieces) -> f64 {
    let told = Told::new(pieces, &Liar::honest(extent(pieces)));
    1.0 + told.cyclic() as f64 * told.curves() as f64
}

/// The kinetic and the monotonic convolution of a pair, where there are any.
pub(super) fn convolutions(a: &Region, b: &Region) -> Vec<Pieces> {
    let frames = Frame::pair(a, b);
    let (Ok(a), Ok(b)) = (Smooth::new(a, &frames.0), Smooth::new(b, &frames.1)) else { return Vec::new() };
    let monotonic = monotonic(&a, &b, Rounding::Correct).map(|(pieces, _)| pieces);
    kinetic(&a, &b, Rounding::Correct).into_iter().chain(monotonic).collect()
}

/// Any pair, nearly degenerate or not, and every fourth time one of a family.
pub(super) fn draw(rng: &mut Rng, number: usize) -> Input {
    let small = |rng: &mut Rng| disc(rng.between(0.01, 0.5));
    let (kind, (a, b)) = match number % 32 {
        3 => ("fork", fork::fork(1 + rng.below(2) as u32)),
        7 => ("combs", combs::combs(2 + rng.below(3) as u32)),
        11 => ("gears", (gear::gear(12, rng), gear::gear(12, rng))),
        15 => ("gear and disc", (gear::gear(24, rng), small(rng))),
        19 => ("stars", radial::stars(8, rng)),
        23 => ("noisy", radial::noisy(10, rng)),
        27 => ("part", (crate::cases::shape::region(vec![parts::gear(5)]), small(rng))),
        31 => ("comb and polygon", combs::comb_and_polygon(3, 8)),
        _ => return draw::pair(rng, number),
    };
    draw::input(kind, a, b)
}
