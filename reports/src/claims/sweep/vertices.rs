//! A1, M8 and A4: the vertices of an arrangement, what robustness adds to its work, and the triples in cyclic order (abstract
//! of MS reference 5; MS 4).
//!
//! n curves, N crossings that the module reports over all pairs, k triples in cyclic order for some part of the sweep, V
//! vertices.

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::audit::{Told, steps};
use super::liar::{Liar, Lie};
use super::perturbed::{convolutions, draw as draw_pair, is_small};
use super::tangle::{Tangle, draw, draw_honest, draw_sized, extent};
use crate::kept;
use arcsum::arrangement::cross::EPS;
use arcsum::arrangement::swept;
use arcsum::robustness::{Robustness, Step};

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
    /// Of the sweep as the reference has it: lines are not cut at vertices on them.
    fn of(input: &Input) -> Option<Self> {
        Self::by(input, Robustness::ALL.without(Step::Cuts))
    }

    /// The same where no two curves share an end.
    fn apart(input: &Input) -> Option<Self> {
        Tangle::of(input).filter(|tangle| !tangle.shares_ends()).and_then(|_| Self::of(input))
    }

    /// Of the sweep as it is.
    fn with_cuts(input: &Input) -> Option<Self> {
        Self::by(input, Robustness::ALL)
    }

    fn by(input: &Input, robustness: Robustness) -> Option<Self> {
        let tangle = Tangle::of(input)?;
        let pieces = tangle.pieces();
        let module = tangle.module(&pieces);
        let map = swept(&pieces, &module, robustness);
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

    /// The work by that which so many vertices may take.
    fn work_by(&self, vertices: f64) -> Measured {
        self.measured(self.work / vertices / steps(self.curves))
    }

    fn measured(&self, value: f64) -> Measured {
        Measured::exactly(value).of_size(self.curves as usize)
    }
}

pub(super) fn claims() -> [Claim; 6] {
    let ([printed, corrected, cut], [hard, bundles]) = (size(), cyclic());
    [printed, corrected, cut, added_work(), hard, bundles]
}

fn size() -> [Claim; 3] {
    let sup = Sup {
        quantity: "V by 2n + N + min(3kn, n^2/2)",
        unit: "1",
        rule: Rule::AtMost(1.0),
        draws: [2_000, 200_000],
        draw,
        measure: |input| Counts::of(input).map(|c| c.measured(c.vertices / (c.generic() + c.extra()))),
        kept: kept!("A1_corrected"),
        control: Control::Measure {
            plants: "the term in k left out",
            measure: |input| Counts::of(input).map(|c| c.measured(c.vertices / c.generic())),
        },
    };
    let says = "An arrangement of n curves with N crossings has V = 2n + N + min(3kn, n^2/2) vertices at most.";
    let erratum = "Where two curves end in one point and a third is said to run between them, it is swapped out though no triple is \
                   cyclic over an interval.";
    let printed = Claim {
        id: "A1 printed",
        place: "MS reference 5, abstract",
        says,
        erratum,
        test: Test::Sup(Sup { kept: kept!("A1_printed"), control: Control::Itself, ..sup.clone() }),
    };
    let corrected = Claim {
        id: "A1 corrected",
        says: "It has so many if no two of the curves share an end.",
        erratum: "",
        test: Test::Sup(Sup {
            measure: |input| Counts::apart(input).map(|c| c.measured(c.vertices / (c.generic() + c.extra()))),
            control: Control::Measure {
                plants: "the term in k left out",
                measure: |input| Counts::apart(input).map(|c| c.measured(c.vertices / c.generic())),
            },
            ..sup.clone()
        }),
        ..printed.clone()
    };
    let cut = Claim {
        id: "A1 cuts",
        says: "It has so many as well if lines are cut at vertices that lie on them exactly (memo C2).",
        erratum: "The parts of a cut line are ordered by direction where they begin, which the module may contradict elsewhere.",
        test: Test::Sup(Sup {
            measure: |input| Counts::with_cuts(input).map(|c| c.measured(c.vertices / (c.generic() + c.extra()))),
            kept: kept!("A1_cuts"),
            control: Control::Itself,
            ..sup
        }),
        ..printed.clone()
    };
    [printed, corrected, cut]
}

fn added_work() -> Claim {
    let test = Sup {
        quantity: "questions and events by (2n + N + 3 k n) (6 ln n + 8)",
        unit: "1",
        rule: Rule::AtMost(1.0),
        draws: [700, 20_000],
        draw: draw_sized,
        measure: |input| Counts::of(input).map(|c| c.work_by(c.generic() + 3.0 * c.cyclic * c.curves)),
        kept: kept!("M8"),
        control: Control::Measure {
            plants: "a question for every pair of curves",
            measure: |input| {
                let counts = Counts::of(input)?;
                let work = counts.work + counts.curves * counts.curves;
                Some(Counts { work, ..counts }.work_by(counts.generic()))
            },
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

fn cyclic() -> [Claim; 2] {
    let sup = Sup {
        quantity: "k by N",
        unit: "1",
        rule: Rule::AtMost(3.0),
        draws: [60, 6_000],
        draw: draw_pair,
        measure: |input| cyclic_by_crossings(input, Lie::None),
        kept: kept!("A4"),
        control: Control::Measure {
            plants: "crossing modules that lie by up to 1000 eps",
            measure: |input| cyclic_by_crossings(input, Lie::Shifts),
        },
    };
    let place = "MS reference 5, abstract";
    let hard = Claim {
        id: "A4",
        place,
        says: "On hard data, here convolutions of nearly degenerate regions, k <= 3N.",
        erratum: "An observation on some data, no bound: sum segments that all but coincide need not cross to be in cyclic order.",
        test: Test::Sup(sup.clone()),
    };
    let bundles = Claim {
        id: "A4 bundles",
        place,
        says: "Bundles of curves within a few roundings of each other have k <= 3N as well.",
        erratum: "An observation on some data, no bound: curves that all but coincide need not cross to be in cyclic order.",
        test: Test::Sup(Sup {
            draws: [2_000, 200_000],
            draw: draw_honest,
            quantity: "k - 3N",
            rule: Rule::AtMost(0.0),
            measure: |input| Counts::of(input).map(|c| c.measured(c.cyclic - 3.0 * c.crossings)),
            kept: kept!("A4_bundles"),
            control: Control::Itself,
            ..sup
        }),
    };
    [hard, bundles]
}

/// The ratio for the convolutions of a pair, the greater one.
fn cyclic_by_crossings(input: &Input, lie: Lie) -> Option<Measured> {
    let case = input.as_pair()?;
    let ratios = convolutions(&case.a, &case.b).into_iter().filter(is_small).map(|pieces| {
        let extent = extent(&pieces);
        let told = Told::new(&pieces, &Liar::new(lie, extent, 1000.0 * EPS * extent, 1));
        ratio(told.cyclic() as f64, told.crossings() as f64)
    });
    ratios.reduce(|p, q| if p.lo < q.lo { q } else { p })
}

/// k by N, 0 where there are no triples.
fn ratio(cyclic: f64, crossings: f64) -> Measured {
    Measured::exactly(if cyclic == 0.0 { 0.0 } else { cyclic / crossings })
}
