//! Somebody else's no-fit polygons (libnfporb's): the boundary they print against the outer boundary of the exact sum
//! A + (-B), shifted by their reference point, and the engine's result against the same.
//!
//! Only outer boundaries are compared: all three regions are filled first. A printed boundary can be no better than its
//! last digit; what is farther off is wrong.

use crate::bridge::plain;
use crate::cases::{Case, Golden};
use crate::engine::Answer;
use arcsum::region::Region;
use arcsum_oracle::error::OracleError;
use arcsum_oracle::measure::{Bracket, between};
use arcsum_oracle::point::Point;
use arcsum_oracle::region::{ExactRegion, ring_area};
use rug::Rational;
use serde::{Deserialize, Serialize};

/// Digits of the printed numbers, counted over the files that libnfporb comes with.
const DIGITS: i32 = 12;

/// Who is right about an outer boundary. Distances are in input units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// The case.
    pub case: String,
    /// The engine.
    pub engine: String,
    /// `agree`, `golden wrong`, `engine wrong`, `both wrong`, or `undecided` between the bounds.
    pub verdict: String,
    /// Distance of the printed region to the exact one: lower bound.
    pub golden_lo: f64,
    /// Upper bound.
    pub golden_hi: f64,
    /// Distance of the engine's region to the exact one: lower bound.
    pub engine_lo: f64,
    /// Upper bound.
    pub engine_hi: f64,
    /// How far the printed digits allow the printed region to be off.
    pub printed: f64,
    /// A point where the printed region is farthest off.
    pub x: Option<f64>,
    /// Its ordinate.
    pub y: Option<f64>,
}

impl Verdict {
    /// One sentence, empty when all agree.
    #[must_use]
    pub fn sentence(&self) -> String {
        match self.verdict.as_str() {
            "agree" => String::new(),
            other => {
                format!("{other}: the printed boundary is {:e} off, the engine's {:e}", self.golden_lo, self.engine_hi)
            }
        }
    }
}

/// Compares a golden and an answer with the exact sum.
pub(super) fn compare(
    case: &Case,
    engine: &str,
    golden: &Golden,
    answer: &Answer,
    exact: &ExactRegion<Rational>,
) -> Result<Verdict, OracleError> {
    let claimed = filled(&ExactRegion::from_plain(&plain(&golden.region))?)?;
    let engines = filled(&ExactRegion::from_plain(&plain(&answer.region))?)?;
    let exact = filled(exact)?;
    let shift = Point::from_f64(golden.shift[0], golden.shift[1]);
    let shifted = shift.map_or_else(|| exact.clone(), |by| exact.translated(&by));
    let theirs = between(&claimed, &shifted, 1.0)?;
    let ours = between(&engines, &exact, 1.0)?;
    let printed = printed(&golden.region);
    let (x, y) = theirs.witness;
    Ok(Verdict {
        case: case.name.clone(),
        engine: engine.to_owned(),
        verdict: verdict(&theirs, &ours, printed).to_owned(),
        golden_lo: theirs.lo,
        golden_hi: theirs.hi + 0.0,
        engine_lo: ours.lo,
        engine_hi: ours.hi + 0.0,
        printed,
        x: x.is_finite().then_some(x),
        y: y.is_finite().then_some(y),
    })
}

/// The same allowance for both; a bracket around it decides nothing.
fn verdict(theirs: &Bracket, ours: &Bracket, allowed: f64) -> &'static str {
    let right = |b: &Bracket| if b.hi <= allowed { Some(true) } else { (b.lo > allowed).then_some(false) };
    match (right(theirs), right(ours)) {
        (Some(true), Some(true)) => "agree",
        (Some(false), Some(true)) => "golden wrong",
        (Some(true), Some(false)) => "engine wrong",
        (Some(false), Some(false)) => "both wrong",
        _ => "undecided",
    }
}

/// The region without its holes.
fn filled(region: &ExactRegion<Rational>) -> Result<ExactRegion<Rational>, OracleError> {
    let outer = region.loops().iter().filter(|ring| ring_area(ring).cmp0().is_gt()).cloned().collect();
    ExactRegion::from_rings(outer, region.unbounded(), |w| w[0] != 0)
}

/// Half a unit of the last printed digit of the largest coordinate, in both coordinates at once.
fn printed(region: &Region) -> f64 {
    let largest = region.loops.iter().flatten().fold(0.0, |m: f64, n| m.max(n.x.abs()).max(n.y.abs()));
    let exponent = libm::floor(libm::log10(largest)) as i32;
    0.5 * std::f64::consts::SQRT_2 * libm::pow(10.0, f64::from(exponent + 1 - DIGITS))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{polygon, rectangle};

    fn square(side: f64) -> Region {
        polygon(&rectangle([0.0, 0.0], [side, side]))
    }

    fn judged(golden: Region, answer: Region) -> String {
        let golden = Golden { region: golden, shift: [1.0, 1.0] };
        let (a, b) = (square(2.0), square(1.0).negated());
        let exact = arcsum_oracle::polygon::sum(&plain(&a), &plain(&b)).unwrap();
        let case = Case { name: "c".into(), family: "f".into(), a, b, seed: None, golden: None };
        let answer = Answer { region: answer, ..Answer::default() };
        compare(&case, "e", &golden, &answer, &exact).unwrap().verdict
    }

    #[test]
    fn whoever_is_off_is_named() {
        // A + (-B) is the square from -1 to 2; shifted by the corner (1, 1) of B it is the square from 0 to 3.
        let right = polygon(&rectangle([-1.0, -1.0], [2.0, 2.0]));
        let wrong = polygon(&rectangle([-1.0, -1.0], [2.0, 2.5]));
        assert_eq!(judged(square(3.0), right.clone()), "agree");
        assert_eq!(judged(square(3.001), right), "golden wrong");
        assert_eq!(judged(square(3.0), wrong.clone()), "engine wrong");
        assert_eq!(judged(square(3.001), wrong), "both wrong");
    }

    #[test]
    fn the_last_digit_is_that_of_twelve() {
        let close = |value: f64, wanted: f64| (value / wanted - 1.0).abs() < 1e-12;
        assert!(close(printed(&square(2048.0)), 0.5e-8 * std::f64::consts::SQRT_2));
        assert!(close(printed(&square(9.0)), 0.5e-11 * std::f64::consts::SQRT_2));
    }
}
