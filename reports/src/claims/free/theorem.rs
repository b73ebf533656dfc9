//! M34: the monotonic convolution has no falsely free points (MS 7.2, Theorem 4).

use super::mu::Mu;
use super::probes::deepest;
use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::claims::control::Control;
use crate::claims::draw;
use crate::claims::finding::Measured;
use crate::claims::input::Input;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use arcsum::sum::{Convolution, Options};

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "greatest inradius of the overlap at a free point of the monotonic sum over mu",
        unit: "mu",
        rule: Rule::AtMost(1.0),
        draws: [40, 4_000],
        draw: pair,
        measure: |input| measured(input, &Options::default()),
        kept: kept!("M34"),
        control: Control::Measure { plants: "the kinetic sum", measure: |input| measured(input, &kinetic()) },
    };
    [Claim {
        id: "M34",
        place: "MS 7.2, Theorem 4",
        says: "The approximate monotonic sum of 2 mu separated regions has no falsely free points: wherever it is free, \
               perturbations by mu make the parts free.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

fn kinetic() -> Options {
    Options { convolution: Convolution::Kinetic, ..Options::default() }
}

fn pair(rng: &mut Rng, number: usize) -> Input {
    draw::pair(rng, number)
}

/// The greatest inradius over mu; none if the operands may not be 2 mu separated.
fn measured(input: &Input, options: &Options) -> Option<Measured> {
    let case: &Case = input.as_pair()?;
    let mu = Mu::by(case, options).filter(|mu| mu.separates(case))?;
    deepest(case, options, mu)
}
