//! M7: cells of negative winding number do no harm (MS 4; memo D).

use super::super::control::Control;
use super::super::draw as drawing;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::draw;
use crate::bridge::plain;
use crate::cases::Case;
use crate::cases::place::turned;
use crate::cases::rng::Rng;
use crate::cases::shape::polygon;
use crate::kept;
use crate::winding::disturb;
use arcsum::arrangement::arrange;
use arcsum::coincide::merged;
use arcsum::convolution::kinetic;
use arcsum::extract::{outline, region};
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::region::Region;
use arcsum::smooth::{Seg, Smooth};
use arcsum::sum3::Rounding;
use arcsum::validate::validate;
use arcsum_oracle::certified::hausdorff::{Outline, between};
use arcsum_oracle::certified::shape::Shape;
use libm::scalbn;
use std::f64::consts::PI;

/// By how much angles are off: by rounding, allowing 8 eps as memo M14 does, and by noise.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
const NOISE: i32 = -10;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "where there are negative cells, distance between the cells of positive and those of nonzero winding number over n times the error of the \
                   angles: 8 eps, and 2^-10 of noise",
        unit: "1",
        rule: Rule::AtMost(1.0),
        draws: [1500, 100_000],
        draw: drawn,
        measure: |input| farthest(input, |_| ()),
        kept: kept!("M7"),
        control: Control::Measure {
            plants: "all loops of the convolution run backwards",
            measure: |input| farthest(input, |pieces| pieces.pieces.iter_mut().for_each(|piece| piece.weight = -1)),
        },
    };
    [Claim {
        id: "M7",
        place: "MS 4",
        says: "Cells of negative winding number, which only rounding makes, can be counted to the sum: this adds no error \
               beyond that of the convolution.",
        erratum: "They also occur in exact arithmetic if holes are not filled. Errors that exceed what a corner lacks to 180 \
                  degrees turn it the other way, and then such cells are as large as the other region; roundings were not seen to.",
        test: Test::Sup(sup),
    }]
}

fn drawn(rng: &mut Rng, number: usize) -> Input {
    match number % 8 {
        0 => draw::arcs(rng, number / 8),
        1 => draw::parallel(rng, number / 8),
        2..=5 => loop {
            let a = slotted(rng);
            let b = match rng.below(4) {
                0 => a.clone(),
                1 => a.negated(),
                2 => turned(&a.negated(), scalbn(rng.between(-1.0, 1.0), -(rng.below(52) as i32))),
                _ => slotted(rng),
            };
            if validate(&a).is_ok() && validate(&b).is_ok() {
                return drawing::input("slots", a, b);
            }
        },
        _ => drawing::pair(rng, number),
    }
}

/// A block with teeth and gaps of any width, down to a few eps: what rounding or noise turns inside out.
fn slotted(rng: &mut Rng) -> Region {
    let gap = scalbn(rng.between(0.5, 1.0), -([rng.below(16), 44 + rng.below(8)][rng.below(2)] as i32));
    let mut corners = Vec::new();
    let mut y = 0.0;
    for _ in 0..2 + rng.below(2) {
        let (reach, height) = (rng.between(0.5, 1.0), rng.between(0.02, 0.4));
        corners.extend([[0.2, y], [reach, y + rng.between(0.0, 0.1) * height], [reach, y + height], [0.2, y + height]]);
        y += height + gap;
    }
    corners.extend([[0.0, y], [0.0, 0.0]]);
    turned(&polygon(&corners), rng.angle())
}

/// Nothing is said about inputs without negative cells.
fn farthest(input: &Input, change: fn(&mut Pieces)) -> Option<Measured> {
    let case = input.as_pair()?;
    let mut rng = Rng::new(0, "noise");
    let noise: Vec<f64> = (0..97).map(|_| scalbn(rng.between(-1.0, 1.0), NOISE)).collect();
    let found = [apart(case, &[0.0; 97], ROUNDING, change), apart(case, &noise, scalbn(1.0, NOISE), change)];
    let worst = found.into_iter().flatten().reduce(|x, y| [x[0].max(y[0]), x[1].max(y[1])]);
    worst.map(|[lo, hi]| Measured::between(lo, hi))
}

/// A bracket of the distance between both selections over n times an error, with noise in the angles of A; none without negative
/// cells, or if the noise turns a corner around.
fn apart(case: &Case, noise: &[f64], error: f64, change: fn(&mut Pieces)) -> Option<[f64; 2]> {
    let frames = Frame::pair(&case.a, &case.b);
    let (mut a, b) = (Smooth::new(&case.a, &frames.0).ok()?, Smooth::new(&case.b, &frames.1).ok()?);
    let given = a.clone();
    a.loops.iter_mut().for_each(|ring| disturb(&mut ring.segs, noise));
    if turns_around(&given, &a) {
        return None;
    }
    let mut pieces = kinetic(&a, &b, Rounding::Correct)?;
    if let Some(parts) = merged(&pieces) {
        pieces = parts.pieces;
    }
    change(&mut pieces);
    let arrangement = arrange(&pieces);
    if arrangement.graph.windings.iter().all(|w| w[0] >= 0) {
        return None;
    }
    let selected = |inside: fn([i32; 2]) -> bool| {
        let loops = outline(&arrangement, &pieces, inside);
        let unbounded = inside(pieces.base);
        Shape::new(&plain(&region(&loops, unbounded, |p| p))).ok().map(|shape| Outline::from(&shape))
    };
    let (positive, nonzero) = (selected(|w| w[0] > 0)?, selected(|w| w[0] != 0)?);
    if positive.pieces.is_empty() != nonzero.pieces.is_empty() {
        return Some([f64::INFINITY; 2]);
    }
    let bracket = between(&nonzero, &positive).ok()?.map(|found| found.bracket);
    let mu = case.segments() as f64 * error;
    Some(bracket.map_or([0.0, f64::INFINITY], |bracket| [bracket.lo / mu, bracket.hi / mu]))
}

/// Whether some corner turns the other way by nearly as much: no small move of its edges does that.
fn turns_around(before: &Smooth, after: &Smooth) -> bool {
    let segs = |smooth: &Smooth| smooth.loops.iter().flat_map(|ring| ring.segs.clone()).collect::<Vec<_>>();
    let turned = |(p, q): (&Seg, &Seg)| (p.a.turn_to(p.b) - q.a.turn_to(q.b)).abs() > PI;
    segs(before).iter().zip(&segs(after)).any(turned)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::disc;

    /// A triangle 3e-17 wide, the corners of which lack less than the noise to 180 degrees.
    #[test]
    fn noise_that_turns_a_needle_around_is_not_asked_about() {
        let x = 0.124_290_372_910_379_78_f64;
        let needle = polygon(&[[-x.next_down(), 0.949], [-x, -0.309], [-x.next_down().next_down(), 0.609]]);
        assert!(validate(&needle).is_ok());
        let smooth = Smooth::new(&needle, &Frame::pair(&needle, &disc(0.75)).0).unwrap();
        let turned = |noise: f64| {
            let mut noisy = smooth.clone();
            let noise: Vec<f64> = (0..97).map(|i| if i % 2 == 0 { noise } else { -noise }).collect();
            noisy.loops.iter_mut().for_each(|ring| disturb(&mut ring.segs, &noise));
            turns_around(&smooth, &noisy)
        };
        assert!(turned(1e-3) && !turned(0.0));
    }
}
