//! M6: symbolic perturbation repairs tangential degeneracy (MS 3, Fig. 3; memo A7, fact 7).

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::components;
use super::draw;
use super::pieces::Convolved;
use super::probes::points;
use crate::kept;
use arcsum_oracle::convolve::Ties;

/// Points asked about for each pair with circle segments.
const PROBES: usize = 12;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "winding number of t less the Euler characteristic of A and t-B together",
        unit: "1",
        rule: Rule::AtMost(0.0),
        draws: [1400, 100_000],
        draw: draw::parallel,
        measure: |input| exact(input, Ties::FIRST_A).or_else(|| certified(input)),
        kept: kept!("M6"),
        control: Control::Measure {
            plants: "at equal angles an edge takes part with the turns at both ends of the other one (polygons)",
            measure: |input| exact(input, Ties::BOTH),
        },
    };
    [Claim {
        id: "M6",
        place: "MS 3",
        says: "If vertices with equal normal angles are ordered by labels, those of A first, the kinetic convolution of \
               regions with parallel edges and tangential junctions has the right winding numbers.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

fn exact(input: &Input, ties: Ties) -> Option<Measured> {
    components::off(input, ties, |[components, holes]| components - holes)
}

/// The same for regions with circle segments, with the engine's convolution.
fn certified(input: &Input) -> Option<Measured> {
    let case = input.as_pair()?;
    let convolved = Convolved::new(case)?;
    let places: Vec<_> = points(case, PROBES).into_iter().map(|p| convolved.framed(p)).collect();
    let (off, spot) = convolved.off(case, places)?;
    let measured = Measured::exactly(f64::from(off));
    Some(spot.map_or_else(|| measured.clone(), |spot| measured.clone().at(spot)))
}
