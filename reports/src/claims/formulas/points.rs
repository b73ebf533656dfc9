//! M9: angles of segments and points of arcs err by O(eps) (MS 4.1; memo A3, A5, facts 1 to 3).

use super::super::control::Control;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::angle::{OF_LINE, PRINTED_GAMMA};
use super::arc::{HALF_SWEEP, POINT, PRINTED};
use super::formula::{Formula, draw, measure};
use crate::kept;

/// What is corrected: gamma and delta of a segment, and points as places on their circle.
const CORRECTED: [Formula; 3] = [OF_LINE, HALF_SWEEP, POINT];

/// What is printed, and points as vectors.
const AS_PRINTED: [Formula; 4] = [PRINTED_GAMMA, PRINTED[0], PRINTED[1], PRINTED[2]];

/// The bound of memo H.
const BOUND: f64 = 4.0;

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "error of an angle or of a point",
        unit: "eps",
        rule: Rule::AtMost(BOUND),
        draws: [12_000, 2_000_000],
        draw: |rng, number| draw(&AS_PRINTED, rng, number),
        measure: |input| measure(&AS_PRINTED, input),
        kept: kept!("M9_printed"),
        control: Control::Itself,
    };
    let printed = Claim {
        id: "M9 printed",
        place: "MS 4.1",
        says: "Normal angles and points of segments, by the printed formulas, have errors O(eps).",
        erratum: "The fraction for gamma is inverted; delta = arcsin(d/r) is badly conditioned near half circles; the points lose \
                  everything where gamma is near 180 degrees; along flat arcs a point errs by r eps.",
        test: Test::Sup(sup.clone()),
    };
    let corrected = Claim {
        id: "M9 corrected",
        place: "MS 4.1",
        says: "Normal angles, by axis and offset, and distances of points from their arcs have errors of a few eps.",
        erratum: "",
        test: Test::Sup(Sup {
            draw: |rng, number| draw(&CORRECTED, rng, number),
            measure: |input| measure(&CORRECTED, input),
            kept: kept!("M9_corrected"),
            control: Control::Claim("M9 printed"),
            ..sup
        }),
    };
    [printed, corrected]
}
