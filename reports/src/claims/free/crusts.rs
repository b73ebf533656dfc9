//! M32: points that the crusts alone call free are not falsely free (MS 7.2, Lemma 4).

use super::mu::Mu;
use super::probes::{Probes, summed};
use crate::claims::control::Control;
use crate::claims::draw;
use crate::claims::finding::Measured;
use crate::claims::input::Input;
use crate::claims::order::swept::{Member, Swept};
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::judge::places::Place;
use crate::kept;
use arcsum::frame::Frame;
use arcsum::robustness::Robustness;
use arcsum_oracle::certified::depth::Depths;
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::certified::vector::Vector;
use glam::DVec2;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "greatest inradius of the overlap at a point with O - F = 0 over mu",
        unit: "mu",
        rule: Rule::AtMost(1.0),
        draws: [40, 4_000],
        draw: draw::pair,
        measure: |input| measured(input, 0),
        kept: kept!("M32"),
        control: Control::Measure {
            plants: "one upper crust more below every point than the sweep has there",
            measure: |input| measured(input, 1),
        },
    };
    [Claim {
        id: "M32",
        place: "MS 7.2, Lemma 4",
        says: "A point where as many crusts of lower chains as of upper chains are below it in the sweep is not falsely free, \
               if the regions are 2 mu separated.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

/// The greatest inradius over mu at the middles of the trapezoids with this O - F in the sweep; none if the operands may not
/// be 2 mu separated.
fn measured(input: &Input, count: i32) -> Option<Measured> {
    let case = input.as_pair()?;
    let mu = Mu::of(case).filter(|mu| mu.separates(case))?;
    let swept = Swept::new(case, Robustness::ALL)?;
    let frames = Frame::pair(&case.a, &case.b);
    let origin = [&frames.0, &frames.1].map(|frame| [frame.shift.x, frame.shift.y].map(|c| frame.length_to_unit(c)));
    let (summed, mut greatest) = (summed(case).ok()??, Measured::exactly(0.0));
    let depths = Depths::new(&summed).ok()?;
    let probes = Probes { depths: &depths, mu: mu.whole() };
    for (_, middle, curves, below) in swept.middles() {
        if crusts_below(&swept, middle.x, &curves, below) != Some(count) {
            continue;
        }
        let (lo, hi) = probes.inradius(&Place { spot: spot(middle, origin), off: 0.0 }, greatest.lo);
        if lo > greatest.lo {
            greatest.spot = Some(frames.0.sum_to_input(&frames.1, middle).into());
        }
        (greatest.lo, greatest.hi) = (greatest.lo.max(lo), greatest.hi.max(hi));
    }
    Some(greatest)
}

/// The lower crusts below a point less the upper ones: O - F. None where some crust has cancelled, so that the sweep does not
/// know where it is.
fn crusts_below(swept: &Swept, x: f64, curves: &[u32], below: usize) -> Option<i32> {
    let crusts: Vec<(usize, bool)> = curves
        .iter()
        .enumerate()
        .filter_map(|(place, curve)| match swept.member(*curve) {
            Member::Crust { upper, .. } => Some((place, upper)),
            Member::Moved { .. } => None,
        })
        .collect();
    let count = |kind: bool| crusts.iter().filter(|(place, upper)| *place < below && *upper == kind).count() as i32;
    (crusts.len() == swept.crusts_at(x)).then(|| count(false) - count(true))
}

/// A point of the arrangement as an exact place.
fn spot(point: DVec2, origin: [[f64; 2]; 2]) -> Spot {
    let parts = [point.to_array(), origin[0], origin[1]];
    Spot::new(move |precision: Precision| {
        let [p, q, r] = parts.map(|[x, y]| Vector::new(x, y, precision));
        &(&p + &q) + &r
    })
}
