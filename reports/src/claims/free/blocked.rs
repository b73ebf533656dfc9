//! M35: what an approximate sum of free spaces leaves out of the exact one is negligible (MS 7).

use super::mu::Mu;
use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::cases::shape::{Point, polygon, rectangle};
use crate::claims::control::Control;
use crate::claims::draw;
use crate::claims::finding::Measured;
use crate::claims::input::Input;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use arcsum::region::Region;
use arcsum::sum::{Options, sum};
use arcsum_oracle::measure::{Direction, hausdorff};
use arcsum_oracle::polygon;

/// How far the result is moved in the control, in mu.
const MOVED: f64 = 32.0;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "distance between the exact sum of a free space and the approximate one over mu",
        unit: "mu",
        rule: Rule::AtMost(2.0),
        draws: [60, 6_000],
        draw: slits,
        measure: |input| measured(input, 0.0),
        kept: kept!("M35"),
        control: Control::Measure { plants: "a result moved by 32 mu", measure: |input| measured(input, MOVED) },
    };
    [Claim {
        id: "M35",
        place: "MS 7",
        says: "What the approximate sum of a computed free space with another region leaves out of the exact sum of both has a \
               size of mu: falsely free points of this sum, which falsely block placements, are harmless.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

/// A region with a slit as wide as the partner or hardly wider, whose free space is summed with a small rectangle that closes
/// what is left of it or not; or any two polygons.
fn slits(rng: &mut Rng, number: usize) -> Input {
    if number.is_multiple_of(3) {
        return draw::polygons(rng, number);
    }
    let rise = rng.between(-0.2, 0.2);
    let width = rng.between(0.05, 0.2);
    let clear = [0.0, 1e-15, 1e-12, 1e-3][rng.below(4)] * rng.between(0.5, 8.0);
    let points: [Point; 8] = [
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 0.4 + rise],
        [0.3, 0.4],
        [0.3, 0.4 + width + clear],
        [1.0, 0.4 + rise + width + clear],
        [1.0, 0.95],
        [0.0, 0.95],
    ];
    let partner = polygon(&rectangle([0.0, 0.0], [rng.between(0.01, 0.1), width]));
    draw::input("slit", polygon(&points), partner)
}

/// The distance over mu between the exact and the approximate sum of the computed free space with B turned around, the result
/// moved by some mu. What the result leaves out of the exact sum contains no disc larger than that.
fn measured(input: &Input, by: f64) -> Option<Measured> {
    let case = input.as_pair().filter(|case| case.is_polygonal())?;
    let free = sum(&case.a, &case.b, &Options::default()).ok()?.region.complement();
    let second = Case { name: case.name.clone(), a: free, b: case.b.negated(), ..case.clone() };
    let mu = Mu::of(&second)?.whole();
    let (a, b) = (plain(&second.a), plain(&second.b));
    let exact = polygon::sum(&a, &b).ok()?;
    let side = unit(&second.a, &second.b);
    let mut result = sum(&second.a, &second.b, &Options::default()).ok()?.region;
    shift(&mut result, by * mu * side);
    let bracket = hausdorff(&plain(&result), &exact, side).ok()?;
    // The lower bound may be attained by a point of the result that is outside of the exact sum.
    let lo = if bracket.direction == Direction::FromResult { 0.0 } else { bracket.lo };
    Some(Measured::between(lo / mu, bracket.hi / mu).at([bracket.witness.0, bracket.witness.1]))
}

fn shift(region: &mut Region, by: f64) {
    region.loops.iter_mut().flatten().for_each(|node| node.x += by);
}
