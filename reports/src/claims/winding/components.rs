//! M3: what the winding number of a point counts (MS 3; memo facts 6 and 8).

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::draw;
use super::probes::{exact, points, rational};
use crate::kept;
use arcsum_oracle::boolean::{Operation, combine};
use arcsum_oracle::convolve::Ties;
use arcsum_oracle::kinetic::{Holes, Kinetic, topology};
use arcsum_oracle::point::Place;
use rug::Rational;

/// Points asked about for each pair.
const PROBES: usize = 20;

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "winding number of t less the number of components of A and t-B together",
        unit: "1",
        rule: Rule::AtMost(0.0),
        draws: [800, 60_000],
        draw: draw::any,
        measure: |input| off(input, Ties::FIRST_A, |[components, _]| components),
        kept: kept!("M3_printed"),
        control: Control::Itself,
    };
    let printed = Claim {
        id: "M3 printed",
        place: "MS 2, 3",
        says: "A point of winding number K in the kinetic convolution is one for which A and t-B have K components in \
               common, also for regions of several loops.",
        erratum: "It is the Euler characteristic of the common part, components less holes: only without holes the number \
                  of components.",
        test: Test::Sup(sup.clone()),
    };
    let corrected = Claim {
        id: "M3 corrected",
        place: "MS 3",
        says: "The winding number of t in the kinetic convolution of all pairs of loops is the Euler characteristic of what A \
               and t-B have in common.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "winding number of t less the Euler characteristic of A and t-B together",
            measure: |input| off(input, Ties::FIRST_A, |[components, holes]| components - holes),
            kept: kept!("M3_corrected"),
            control: Control::Claim("M3 printed"),
            ..sup
        }),
    };
    [printed, corrected]
}

/// The greatest difference of a winding number and what it is said to count, over the points asked about.
pub(super) fn off(input: &Input, ties: Ties, counted: fn([i32; 2]) -> i32) -> Option<Measured> {
    let ([a, b], case) = (exact(input)?, input.as_pair()?);
    let locator = Kinetic::new(&a, &b, Holes::All, ties).ok()??.locator().ok()?;
    let mut worst = Measured::exactly(0.0);
    for spot in points(case, PROBES) {
        let t = rational(spot)?;
        let Some(winding) = locator.winding(&Place::from(t.clone())) else { continue };
        let moved = b.scaled(&Rational::from(-1)).translated(&t);
        let common = combine(Operation::Intersection, &a, &moved).ok()?;
        let off = f64::from((winding - counted(topology(&common))).abs());
        if off > worst.lo {
            worst = Measured::exactly(off).at(spot);
        }
    }
    Some(worst)
}
