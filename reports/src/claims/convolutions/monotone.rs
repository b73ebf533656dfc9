//! M20: the winding number of the monotonic convolution is O - F - T, which is not negative and 0 at free points only
//! (MS 5.1; memo E, facts 6 and 8).
//!
//! O, F and T are counted exactly from chains and turning points; the winding number exactly in the engine's pieces at
//! probes that are farther from these than they are rounded; freeness in the exact sum.

use super::super::control::Control;
use super::super::draw::{self, input};
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use crate::bridge::plain;
use crate::cases::Case;
use crate::cases::orthogonal::{Corners, Style, cells};
use crate::cases::rng::Rng;
use crate::cases::{many, shape};
use crate::kept;
use crate::lines::{around, distance, in_input_units};
use arcsum::convolution::monotonic;
use arcsum::convolution::order::{Kind, Order};
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::region::Region;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_oracle::chains::{Point, winding};
use arcsum_oracle::monotone::Monotone;
use arcsum_oracle::polygon;
use glam::DVec2;
use rug::Rational;

/// Probes this close to a piece, in unit-box lengths, are not asked about: pieces end at rounded points.
const NEAR: f64 = 1e-9;

/// Probes a pair.
const PROBES: usize = 30;

/// How the definition is read.
#[derive(Clone, Copy, PartialEq)]
enum Reading {
    /// Moved boundaries run as they do where they come from.
    Printed,
    /// They run backwards, and holes that no partner fits into are filled.
    Corrected,
    /// They run backwards, and all holes stay.
    Unfilled,
}

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "probes with another winding number or a wrong answer",
        unit: "1",
        rule: Rule::AtMost(0.0),
        draws: [300, 30_000],
        draw,
        measure: |input| wrong(input, Reading::Printed),
        kept: kept!("M20_printed"),
        control: Control::Itself,
    };
    let printed = Claim {
        id: "M20 printed",
        place: "MS 5.1",
        says: "The monotonic convolution of crusts and the boundaries moved by concave turning points tells by its \
               winding number, not 0 or 0, whether a point is in the sum.",
        erratum: "The moved boundaries must run backwards, and holes that no partner fits into must be filled.",
        test: Test::Sup(sup.clone()),
    };
    let corrected = Claim {
        id: "M20 corrected",
        place: "MS 5.1",
        says: "With moved boundaries run backwards and holes filled the winding number is O - F - T, never negative, and 0 \
               exactly at free points.",
        erratum: "",
        test: Test::Sup(Sup {
            measure: |input| wrong(input, Reading::Corrected),
            kept: kept!("M20_corrected"),
            control: Control::Measure {
                plants: "holes that should be filled are kept",
                measure: |input| wrong(input, Reading::Unfilled),
            },
            ..sup
        }),
    };
    [printed, corrected]
}

/// How many probes contradict the claim.
fn wrong(input: &Input, reading: Reading) -> Option<Measured> {
    let case = input.as_pair()?;
    let convolved = Convolved::new(case, reading)?;
    // The same probes whenever this pair is measured, others for other pairs.
    let name = format!("{:?} {:?}", case.a.loops, case.b.loops);
    let probes = convolved.probes(&mut Rng::new(1, &name));
    let wrong = probes.iter().filter(|probe| convolved.is_wrong(**probe, reading)).count();
    (!probes.is_empty()).then(|| Measured::count(wrong))
}

/// Two polygons, the monotonic convolution by definition and by the engine, and the exact sum.
struct Convolved {
    frames: (Frame, Frame),
    definition: Monotone,
    pieces: Pieces,
    sum: Vec<[Point; 2]>,
}

impl Convolved {
    fn new(case: &Case, reading: Reading) -> Option<Self> {
        let frames = Frame::pair(&case.a, &case.b);
        let [a, b] = [Smooth::new(&case.a, &frames.0).ok()?, Smooth::new(&case.b, &frames.1).ok()?];
        let (mut pieces, order) = monotonic(&a, &b, Rounding::Correct)?;
        if reading == Reading::Printed {
            turn_around(&mut pieces, &order);
        }
        let [a, b] = [&case.a, &case.b].map(plain);
        let point = |p: &arcsum_oracle::point::Point<Rational>| [p.x.clone(), p.y.clone()];
        let sum = polygon::sum(&a, &b).ok()?.edges().map(|(p, q)| [point(p), point(q)]).collect();
        let definition = if reading == Reading::Unfilled { Monotone::unfilled(&a, &b) } else { Monotone::new(&a, &b) };
        Some(Self { frames, definition, pieces, sum })
    }

    /// Points in the unit box of the sum away from all pieces: near ends of pieces, nearer, and anywhere.
    fn probes(&self, rng: &mut Rng) -> Vec<DVec2> {
        let points = &self.pieces.points;
        let low = points.iter().copied().reduce(DVec2::min).unwrap_or_default();
        let high = points.iter().copied().reduce(DVec2::max).unwrap_or_default();
        let mut probe = |k: usize| {
            let way = DVec2::new(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0));
            match k % 3 {
                0 => points[rng.below(points.len())] + 0.25 * way,
                1 => points[rng.below(points.len())] + 0.005 * way,
                _ => 0.5 * (low + high) + 0.5 * (high - low) * way,
            }
        };
        let probes: Vec<DVec2> = (0..PROBES).map(&mut probe).collect();
        probes.into_iter().filter(|p| distance(&self.pieces, *p) > NEAR).collect()
    }

    fn is_wrong(&self, probe: DVec2, reading: Reading) -> bool {
        let t = in_input_units(&self.frames, probe);
        let free = winding(self.sum.iter().map(|[p, q]| [p, q]), &t) == 0;
        let defined = self.definition.counts(&t).winding();
        // The engine fills, and the definition does not say how moved boundaries run.
        let found = if reading == Reading::Unfilled { defined } else { around(&self.pieces, probe) };
        let differs = reading == Reading::Corrected && found != defined;
        differs || found < 0 || (found == 0) != free
    }
}

/// Lets the moved boundaries run forwards.
fn turn_around(pieces: &mut Pieces, order: &Order) {
    let crust = |kind: Kind| matches!(kind, Kind::LowerCrust | Kind::UpperCrust);
    for (i, piece) in pieces.pieces.iter_mut().enumerate() {
        if order.roles(i as u32).iter().any(|(_, kind)| !crust(*kind)) {
            std::mem::swap(&mut piece.tail, &mut piece.head);
        }
    }
}

/// Polygons of any kind, cells with verticals and holes, and islands with lakes.
fn draw(rng: &mut Rng, number: usize) -> Input {
    let mut region = |holes: bool, cells_of: [usize; 2], side: i32| -> Region {
        let corners = if rng.below(2) == 0 { Corners::Sharp } else { Corners::Chamfered };
        let cells_of = cells_of[0] + rng.below(cells_of[1]);
        cells(Style { side, cells: cells_of, holes, collinear: rng.below(2) == 0, corners }, rng)
    };
    match number % 6 {
        0 => input("cells", region(false, [3, 6], 4), region(false, [2, 5], 4)),
        1 => input("holes", region(true, [14, 8], 5), region(false, [1, 5], 3)),
        2 => {
            let (a, b) = ring(rng);
            input("ring", a, b)
        }
        3 => {
            let (a, b) = many::islands(1 + rng.below(2) as u32, rng);
            input("islands", a, b)
        }
        _ => draw::polygons(rng, number),
    }
}

/// A square with a hole of random size, and a rectangle that fits into it or not, or covers it.
fn ring(rng: &mut Rng) -> (Region, Region) {
    let mut side = |least: f64| least + 0.5 * rng.below(6) as f64;
    ring_of([side(0.25), side(0.25)], [side(0.5), side(0.5)])
}

/// A square with a hole of this width and height, and a rectangle.
fn ring_of(hole: [f64; 2], part: [f64; 2]) -> (Region, Region) {
    let outer = shape::lines(&shape::rectangle([0.0, 0.0], [4.0, 4.0]));
    let inner = shape::backwards(&shape::rectangle([0.75, 0.75], [0.75 + hole[0], 0.75 + hole[1]]));
    (shape::region(vec![outer, inner]), shape::polygon(&shape::rectangle([0.0, 0.0], part)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_larger_than_the_hole_needs_it_filled() {
        let (a, b) = ring_of([0.25, 0.25], [3.0, 3.0]);
        let pair = input("annulus", a, b);
        let wrong = |reading| wrong(&pair, reading).unwrap().hi;
        assert_eq!(wrong(Reading::Corrected), 0.0);
        assert!(wrong(Reading::Unfilled) > 0.0);
    }
}
