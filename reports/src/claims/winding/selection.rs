//! M4: the boundary of the sum separates winding number zero from positive ones (MS 3; memo A8, D).

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::draw;
use super::probes::exact;
use crate::kept;
use arcsum_oracle::boolean::{Operation, combine};
use arcsum_oracle::convolve::Ties;
use arcsum_oracle::decompose;
use arcsum_oracle::error::Budget;
use arcsum_oracle::kinetic::{Holes, Kinetic};
use arcsum_oracle::number::Number;
use arcsum_oracle::region::ExactRegion;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "area between the cells of positive winding number and the sum by decomposition and union",
        unit: "square of the input unit",
        rule: Rule::AtMost(0.0),
        draws: [900, 60_000],
        draw: draw::any,
        measure: |input| off(input, Holes::Fitting),
        kept: kept!("M4"),
        control: Control::Measure {
            plants: "holes that the partner does not fit into are not filled",
            measure: |input| off(input, Holes::All),
        },
    };
    [Claim {
        id: "M4",
        place: "MS 3",
        says: "The boundary of the sum consists of the parts of sum segments that separate cells of winding number zero from \
               cells of positive winding number.",
        erratum: "With several loops only after holes are filled into which the partner does not fit.",
        test: Test::Sup(sup),
    }]
}

/// The area of the symmetric difference; infinite if one of the regions is the plane and the other one is not.
fn off(input: &Input, holes: Holes) -> Option<Measured> {
    let [a, b] = exact(input)?;
    let positive = match Kinetic::new(&a, &b, holes, Ties::FIRST_A).ok()? {
        Some(kinetic) => kinetic.region(|w| w[0] > 0).ok()?,
        None => ExactRegion::plane(),
    };
    let sum = decompose::sum(&a, &b, Budget::default()).ok()?;
    let between = combine(Operation::SymmetricDifference, &positive, &sum).ok()?;
    let area = if between.unbounded() { f64::INFINITY } else { between.area().enclosure().hi() };
    let equal = between.is_empty();
    Some(Measured::exactly(if equal { 0.0 } else { area.max(f64::MIN_POSITIVE) }))
}
