//! M25: the kinetic convolution has falsely free points, whole cells of them, at any distance from the free space (MS 7).

use super::mu::Mu;
use super::probes::deepest;
use crate::cases::rng::Rng;
use crate::cases::shape::{backwards, lines, polygon, region, regular};
use crate::claims::control::Control;
use crate::claims::draw;
use crate::claims::finding::Measured;
use crate::claims::input::Input;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use arcsum::sum::{Convolution, Options};

/// So deep that no multiple of mu that could be meant reaches it.
const DEEP: f64 = 1e6;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "greatest inradius of the overlap inside a free cell of the kinetic sum over mu",
        unit: "mu",
        rule: Rule::Exceeds(DEEP),
        draws: [40, 4_000],
        draw: draw::pair,
        measure,
        kept: kept!("M25"),
        control: Control::Inputs {
            plants: "frames around small polygons, which are free where they fit in",
            draw: framed,
        },
    };
    [Claim {
        id: "M25",
        place: "MS 7",
        says: "The approximate kinetic sum can leave out cells inside the exact sum, bubbles, at whose points no perturbation \
               by mu makes the parts free: their overlap is not bounded by mu.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

/// The greatest inradius at points of free cells over mu, for operands that are 2 mu separated.
fn measure(input: &Input) -> Option<Measured> {
    let case = input.as_pair()?;
    let options = Options { convolution: Convolution::Kinetic, ..Options::default() };
    let mu = Mu::by(case, &options).filter(|mu| mu.separates(case))?;
    deepest(case, &options, mu)
}

/// A polygon with a hole in its middle, and one that fits into it.
fn framed(rng: &mut Rng, _number: usize) -> Input {
    let mut corners = || 3 + rng.below(6) as u32;
    let [outer, inner, part] = [corners(), corners(), corners()];
    let mut ring = |n: u32, radius: f64| regular(n, radius, rng.angle());
    let frame = region(vec![lines(&ring(outer, 1.0)), backwards(&ring(inner, 0.4))]);
    draw::input("frame", frame, polygon(&ring(part, 0.1)))
}
