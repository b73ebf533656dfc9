//! A1, M8 and A4: the vertices of an arrangement, what robustness adds to its work, and the triples in cyclic order (abstract
//! of MS reference 5; MS 4).
//!
//! n curves, N crossings that the module reports over all pairs, k triples in cyclic order over some abscissas, V vertices.

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::audit::Told;
use super::tangle::{Tangle, draw, draw_honest, draw_sized};
use crate::kept;
use arcsum::arrangement::arrange_with;

/// What an arrangement of a tangle counts.
struct Counts {
    curves: f64,
    crossings: f64,
    cyclic: f64,
    vertices: f64,
    /// Questions to the module and events.
    work: f64,
}

impl Counts {
    fn of(input: &Input) -> Option<Self> {
        let tangle = Tangle::of(input)?;
        let pieces = tangle.pieces();
        let module = tangle.module(&pieces);
        let map = arrange_with(&pieces, &module);
        let work = module.asked() + map.audit.queued;
        let told = Told::new(&pieces, &module);
        let [curves, crossings, cyclic, vertices, work] =
            [told.curves(), told.crossings(), told.cyclic(), map.audit.vertices, work].map(|count| count as f64);
        (curves > 1.0).then_some(Self { curves, crossings, cyclic, vertices, work })
    }

    /// The vertices beyond 2n + N that A1 allows.
    fn extra(&self) -> f64 {
        (3.0 * self.cyclic * self.curves).min(0.5 * self.curves * self.curves)
    }

    fn generic(&self) -> f64 {
        2.0 * self.curves + self.crossings
    }

    /// The work by so many times log n.
    fn work_by(&self, steps: f64) -> Measured {
        self.measured(self.work / steps / libm::log2(self.curves))
    }

    fn measured(&self, value: f64) -> Measured {
        Measured::exactly(value).of_size(self.curves as usize)
    }
}

pub(super) fn claims() -> [Claim; 3] {
    [size(), added_work(), cyclic()]
}

fn size() -> Claim {
    let test = Sup {
        quantity: "V by 2n + N + min(3kn, n^2/2)",
        unit: "1",
        rule: Rule::AtMost(1.0),
        draws: [2_000, 200_000],
        draw,
        measure: |input| Counts::of(input).map(|c| c.measured(c.vertices / (c.generic() + c.extra()))),
        kept: kept!("A1"),
        control: Control::Measure {
            plants: "the term in k left out",
            measure: |input| Counts::of(input).map(|c| c.measured(c.vertices / c.generic())),
        },
    };
    Claim {
        id: "A1",
        place: "MS reference 5, abstract",
        says: "An arrangement of n curves with N crossings has V = 2n + N + min(3kn, n^2/2) vertices at most.",
        erratum: "",
        test: Test::Sup(test),
    }
}

fn added_work() -> Claim {
    let test = Sup {
        quantity: "questions and events by (2n + N + k n) log n",
        unit: "1",
        rule: Rule::Flat,
        draws: [400, 20_000],
        draw: draw_sized,
        measure: |input| Counts::of(input).map(|c| c.work_by(c.generic() + c.cyclic * c.curves)),
        kept: kept!("M8"),
        control: Control::Measure {
            plants: "the term in k left out",
            measure: |input| Counts::of(input).map(|c| c.work_by(c.generic())),
        },
    };
    Claim {
        id: "M8",
        place: "MS 4",
        says: "The time is that of the exact algorithm and k m log m for m segments, k triples of which are in cyclic order.",
        erratum: "",
        test: Test::Sup(test),
    }
}

fn cyclic() -> Claim {
    let ratio = |input: &Input| {
        Counts::of(input).map(|c| c.measured(if c.cyclic == 0.0 { 0.0 } else { c.cyclic / c.crossings }))
    };
    let test = Sup {
        quantity: "k by N",
        unit: "1",
        rule: Rule::AtMost(3.0),
        draws: [2_000, 200_000],
        draw: draw_honest,
        measure: ratio,
        kept: kept!("A4"),
        control: Control::Inputs { plants: "crossing modules that lie", draw },
    };
    Claim {
        id: "A4",
        place: "MS reference 5, abstract",
        says: "On hard data k <= 3N, and the accuracy is near that of the module.",
        erratum: "",
        test: Test::Sup(test),
    }
}
