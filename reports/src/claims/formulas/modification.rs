//! M11 and M12: the two modifications of the input, and what they cost (MS 4.1; memo A4).

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::formula::{self, Formula, ends};
use crate::cases::rng::Rng;
use crate::cases::shape::region;
use crate::kept;
use arcsum::frame::Frame;
use arcsum::region::{Curve, Node};
use arcsum::smooth::Smooth;
use arcsum_oracle::precise::{Circular, big, in_eps};
use glam::DVec2;
use libm::{atan2, hypot, scalbn};
use std::f64::consts::{PI, TAU};

const UNIT: Frame = Frame { exp: 0, shift: DVec2::ZERO };

/// The sagitta that the engine gives up with an arc whose end angles are equal, in eps of the unit box. Half an ulp of an offset
/// below pi/4 is 2^-54, and the sagitta L/2 tan(delta/2) with L <= sqrt 2, which makes 0.18 eps.
pub const SECANT: Formula = Formula { name: "secant", bound: 0.18, draw: flat_arc, error: given_up };

/// What the numbers of an arc given up with angles in radians are.
const RADIANS: &str = "chord and half sweep";

/// What the numbers of a line are.
const LINE: &str = "line";

pub(super) fn claims() -> [Claim; 4] {
    let secant = |id, erratum, test| Claim {
        id,
        place: "MS 4.1",
        says: "An arc whose end angles round to the same number is within eps/2 of its secant.",
        erratum,
        test: Test::Sup(test),
    };
    let split = |id, says, erratum, test| Claim { id, place: "MS 4.1", says, erratum, test: Test::Sup(test) };
    [
        secant(
            "M11 printed",
            "False for radians in [0, 2 pi); |sin gamma| >= 1/2 is neither true nor needed: the sagitta is (L/2) tan(delta/2).",
            Sup {
                quantity: "sagitta given up, radians in [0, 2 pi)",
                unit: "eps",
                rule: Rule::AtMost(0.5),
                draws: [100_000, 4_000_000],
                draw: |rng, _| Input::numbers(RADIANS, flat_arc_in_radians(rng)),
                measure: given_up_in_radians,
                kept: kept!("M11_printed"),
                control: Control::Itself,
            },
        ),
        secant(
            "M11 corrected",
            "",
            Sup {
                quantity: "sagitta given up, axis and offset",
                unit: "eps",
                rule: Rule::AtMost(0.5),
                draws: [40_000, 1_000_000],
                draw: |rng, _| Input::numbers(SECANT.name, flat_arc(rng)),
                measure: |input| formula::measure(&[SECANT], input),
                kept: kept!("M11_corrected"),
                control: Control::Claim("M11 printed"),
            },
        ),
        split(
            "M12 printed",
            "A line whose normal rounds to a horizontal one may be replaced by a horizontal and a vertical within eps.",
            "With eps = 2^-53 it is 3 eps for angles in (-pi, pi] and 4 eps for those in [0, 2 pi).",
            Sup {
                quantity: "width of a line with a horizontal normal in [0, 2 pi)",
                unit: "eps",
                rule: Rule::AtMost(1.0),
                draws: [100_000, 4_000_000],
                draw: upright,
                measure: split_in_radians,
                kept: kept!("M12_printed"),
                control: Control::Itself,
            },
        ),
        split(
            "M12 corrected",
            "With angles as axis and offset no line needs to be replaced.",
            "",
            Sup {
                quantity: "lines replaced",
                unit: "1",
                rule: Rule::AtMost(0.0),
                draws: [100_000, 4_000_000],
                draw: upright,
                measure: replaced,
                kept: kept!("M12_corrected"),
                control: Control::Measure { plants: "angles in radians", measure: replaced_in_radians },
            },
        ),
    ]
}

/// A chord and a radius so large that the half sweep is about half an ulp of an angle.
fn flat_arc(rng: &mut Rng) -> Vec<f64> {
    let mut input = if rng.below(2) == 0 { rng.chord().to_vec() } else { diagonal(rng).to_vec() };
    input.push(rng.sign() * rng.decade(14.0, 18.0));
    input
}

/// A chord near a diagonal of the unit box.
fn diagonal(rng: &mut Rng) -> [f64; 4] {
    let [x, y] = [rng.between(0.45, 0.5), rng.between(0.45, 0.5)].map(|c| c * rng.sign());
    [x, y, -x, -y]
}

fn given_up(input: &[f64]) -> Option<f64> {
    let (tail, head) = ends(input);
    let node = |x, y, curve| Node { x, y, curve };
    // A triangle on the arc, its third vertex to the left of the chord.
    let third = [head.x + 3.0, head.y - tail.y + 3.0];
    let triangle = region(vec![vec![
        node(tail.x, tail.y, Curve::Radius(input[4])),
        Node::line(head.x, head.y),
        Node::line(third[0], third[1]),
    ]]);
    let smooth = Smooth::new(&triangle, &UNIT).or_else(|_| Smooth::new(&triangle.complement(), &UNIT)).ok()?;
    let circle = Circular::with_radius(tail.into(), head.into(), input[4])?;
    let fits = (head - tail).abs().max_element() <= 1.0 && smooth.counts.secants == 1;
    fits.then(|| sagitta(&circle))
}

fn sagitta(circle: &Circular) -> f64 {
    in_eps(&(circle.chord.length() / 2u32 * (circle.delta.clone() / 2u32).tan()), &big(1.0))
}

/// The normal angle of a chord in [0, 2 pi).
fn in_radians(tail: DVec2, head: DVec2) -> f64 {
    let gamma = atan2(tail.x - head.x, head.y - tail.y);
    if gamma < 0.0 { gamma + TAU } else { gamma }
}

/// A chord of about the longest, and a half sweep of about an ulp of its normal angle.
fn flat_arc_in_radians(rng: &mut Rng) -> Vec<f64> {
    let mut input = diagonal(rng).to_vec();
    let (tail, head) = ends(&input);
    let gamma = in_radians(tail, head);
    input.push(rng.between(0.2, 1.0) * (gamma.next_up() - gamma));
    input
}

fn given_up_in_radians(input: &Input) -> Option<Measured> {
    let values = input.as_numbers(RADIANS)?;
    let (tail, head) = ends(values);
    let (gamma, delta) = (in_radians(tail, head), values[4]);
    let fits = tail != head && (head - tail).abs().max_element() <= 1.0 && (0.0..=1.0).contains(&delta);
    (fits && gamma - delta == gamma + delta).then_some(())?;
    Some(Measured::exactly(sagitta(&Circular::new(tail.into(), head.into(), big(delta)))))
}

/// A line of height 1 that is hardly wide.
fn upright(rng: &mut Rng, _: usize) -> Input {
    let dx = if rng.below(8) == 0 { scalbn(1.0, -(rng.below(1074) as i32)) } else { rng.decade(-17.0, -14.0) };
    Input::numbers(LINE, [0.0, 0.0, rng.sign() * dx, rng.sign()])
}

fn line(input: &Input) -> Option<(DVec2, DVec2)> {
    let (tail, head) = ends(input.as_numbers(LINE)?);
    let fits = tail.x != head.x && tail.y != head.y && (head - tail).abs().max_element() <= 1.0;
    fits.then_some((tail, head))
}

fn is_horizontal_in_radians((tail, head): (DVec2, DVec2)) -> bool {
    [0.0, PI, TAU].contains(&in_radians(tail, head))
}

/// The distance of the corner of horizontal and vertical from the line, where the line is replaced.
fn split_in_radians(input: &Input) -> Option<Measured> {
    let line = line(input).filter(|line| is_horizontal_in_radians(*line))?;
    let way = line.1 - line.0;
    Some(Measured::exactly(way.x.abs() * (way.y.abs() / hypot(way.x, way.y)) * scalbn(1.0, 53)))
}

fn replaced_in_radians(input: &Input) -> Option<Measured> {
    Some(Measured::count(usize::from(is_horizontal_in_radians(line(input)?))))
}

/// How many lines of a triangle on this one the engine would replace.
fn replaced(input: &Input) -> Option<Measured> {
    let (tail, head) = line(input)?;
    let third = Node::line(tail.x + 1.0, 0.5 * (tail.y + head.y));
    let triangle = region(vec![vec![Node::line(tail.x, tail.y), third, Node::line(head.x, head.y)]]);
    let smooth = Smooth::new(&triangle, &UNIT).or_else(|_| Smooth::new(&triangle.complement(), &UNIT)).ok()?;
    Some(Measured::count(smooth.counts.modification2 as usize))
}
