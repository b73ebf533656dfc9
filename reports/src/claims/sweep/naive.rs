//! A4, its second half: the time of the arrangement against the same sweep in plain doubles (abstract of MS reference 5).
//!
//! Both run in turn on the kinetic convolutions of degenerate pairs; the middle of the ratios of a pair counts.

use super::super::bench::Bench;
use super::super::control::Control;
use super::super::finding::{Finding, Verdict};
use super::super::plot::{Plot, Series};
use super::super::{Claim, Test, Whole};
use super::clock::timed;
use super::degenerate::pairs;
use super::perturbed::convolutions;
use crate::bench::middle::Sorted;
use arcsum::arrangement::arrange_by;
use arcsum::piece::Pieces;
use arcsum::robustness::Robustness;

/// What counts as near, as for M50 in the memo.
const NEAR: f64 = 1.25;

pub(super) fn claim() -> Claim {
    let whole = Whole {
        quantity: "time by that of the sweep in plain doubles, mean of the pairs",
        unit: "1",
        run: |bench| run(bench, 1),
        control: Control::Run { plants: "everything arranged twice", run: |bench| run(bench, 2) },
    };
    Claim {
        id: "A4 time",
        place: "MS reference 5, abstract",
        says: "On hard data the time is near that of the naive algorithm, here: at most 1.25 times.",
        erratum: "",
        test: Test::Whole(whole),
    }
}

/// Seconds of so many arrangements.
fn seconds(pieces: &Pieces, robustness: Robustness, times: usize) -> f64 {
    let work = || (0..times).map(|_| arrange_by(pieces, robustness).audit.vertices).sum::<usize>();
    timed(|| std::hint::black_box(work())).0
}

fn run(bench: &Bench, times: usize) -> Finding {
    let (size, rounds) = bench.either([(2, 15), (8, 101)]);
    let (mut note, mut ratios) = (Vec::new(), Vec::new());
    for (name, a, b) in pairs(&mut bench.rng("A4 time"), size) {
        let Some(pieces) = convolutions(&a, &b).into_iter().next() else { continue };
        let round = |_| seconds(&pieces, Robustness::ALL, times) / seconds(&pieces, Robustness::NONE, 1);
        let Some(middle) = Sorted::new((0..rounds).map(round)).map(|sorted| sorted.median()) else { continue };
        note.push(format!("{name}: {middle:.2}"));
        ratios.push(middle);
    }
    let Some(mean) = Sorted::new(ratios.iter().copied()).map(|sorted| sorted.geometric_mean()) else {
        return Finding::new(Verdict::Undecided, [f64::NAN; 2], 0);
    };
    let verdict = if mean <= NEAR { Verdict::Confirmed } else { Verdict::Refuted };
    let points: Vec<[f64; 2]> = ratios.iter().enumerate().map(|(i, ratio)| [i as f64, *ratio]).collect();
    Finding::new(verdict, [mean; 2], ratios.len()).against(NEAR).saying(note.join("; ")).drawn(Plot::linear(
        "pair",
        "ratio of time",
        vec![Series::new("", points)],
    ))
}
