//! M17: the sizes of the three convolutions (MS 5, Fig. 8).
//!
//! Ratios of sizes are followed over growing members of families.

use super::super::bench::Bench;
use super::super::control::Control;
use super::super::finding::{Finding, Verdict};
use super::super::plot::{Plot, Series};
use super::super::trend::Trend;
use super::super::{Claim, Test, Whole};
use crate::cases::fig8::fig8;
use crate::cases::rng::Rng;
use crate::cases::shape::{disc, polar, polygon};
use crate::cases::{combs, fork, gear, place, radial};
use arcsum::convolution::{convex_by, kinetic, monotonic};
use arcsum::frame::Frame;
use arcsum::region::Region;
use arcsum::robustness::Robustness;
use arcsum::smooth::Smooth;
use arcsum::sum::{Convolution, Options, sum};
use arcsum::sum3::Rounding;
use std::f64::consts::{FRAC_PI_2, PI};

/// What counts as slightly larger, as for "unchanged" times in the memo (M50).
const SLIGHTLY: f64 = 1.25;

/// Pairs of about so many segments.
type Family = (&'static str, fn(&mut Rng, u32) -> (Region, Region));

const FAMILIES: [Family; 7] = [
    ("fork", |_, n| fork::fork(n / 8)),
    ("combs", |_, n| combs::combs(n / 4)),
    ("stars", |rng, n| radial::stars(n, rng)),
    ("noisy", |rng, n| radial::noisy(n, rng)),
    ("gear and disc", |rng, n| (gear::gear(n, rng), disc(0.1))),
    ("fig. 8", |_, n| fig8(n)),
    ("teeth and a round back", |_, n| (place::quarter_turned(&combs::combs(n / 4).0), half_disc(n))),
];

/// A polygon of so many corners whose long side is round and faces away from the tips of teeth: no tip has a normal in common
/// with its edges, so all that the gaps between the teeth move has to cancel.
fn half_disc(corners: u32) -> Region {
    let corner = |i: u32| polar(0.5, PI * (f64::from(i) + 0.5) / f64::from(corners) - FRAC_PI_2);
    polygon(&(0..corners).map(corner).collect::<Vec<_>>())
}

/// Segments of the kinetic, the monotonic and the convex convolution.
fn sizes(a: &Region, b: &Region) -> Option<[f64; 3]> {
    let frames = Frame::pair(a, b);
    let (a, b) = (Smooth::new(a, &frames.0).ok()?, Smooth::new(b, &frames.1).ok()?);
    let kinetic = kinetic(&a, &b, Rounding::Correct)?;
    let (monotonic, _) = monotonic(&a, &b, Rounding::Correct)?;
    let convex = convex_by(&a, &b, Robustness::ALL)?;
    Some([kinetic, monotonic, convex].map(|pieces| pieces.pieces.len() as f64))
}

/// The cells of the arrangement of a convolution.
fn cells(convolution: Convolution, a: &Region, b: &Region) -> f64 {
    let options = Options { convolution, ..Options::default() };
    sum(a, b, &options).map_or(f64::NAN, |sum| sum.arrangement.graph.windings.len() as f64)
}

pub(super) fn claims() -> [Claim; 3] {
    let claim = |id, says, erratum, whole| Claim { id, place: "MS 5", says, erratum, test: Test::Whole(whole) };
    [
        claim(
            "M17 convex",
            "The monotonic convolution is only slightly larger than the convex one in the worst case, here: at most 1.25 times.",
            "On stars it is twice, on combs nearly three times as large: what concave turning points move does not all cancel. The factor levels off.",
            Whole {
                quantity: "greatest ratio of monotonic to convex segments",
                unit: "1",
                run: |bench| greatest(bench, SLIGHTLY, |[_, monotonic, convex]| monotonic / convex),
                control: Control::Itself,
            },
        ),
        claim(
            "M17 kinetic",
            "The monotonic convolution is no larger than the kinetic one.",
            "It mostly is smaller, but larger on combs.",
            Whole {
                quantity: "greatest ratio of monotonic to kinetic segments",
                unit: "1",
                run: |bench| greatest(bench, 1.0, |[kinetic, monotonic, _]| monotonic / kinetic),
                control: Control::Itself,
            },
        ),
        claim(
            "M17 figure",
            "Of a convex part in a convex container (Fig. 8) the kinetic convolution has a cell a corner, the monotonic one a few in all.",
            "",
            Whole {
                quantity: "exponent of growth of the cells of the kinetic arrangement",
                unit: "1",
                run: |bench| figure(bench, Convolution::Kinetic),
                control: Control::Run {
                    plants: "the convex convolution in place of the kinetic one",
                    run: |bench| figure(bench, Convolution::Convex),
                },
            },
        ),
    ]
}

/// Number of segments and sizes of the members of a family.
fn members(bench: &Bench, (name, family): Family) -> Vec<(f64, [f64; 3])> {
    let doublings = bench.either([4, 6]);
    let member = |doubling: u32| {
        let (a, b) = family(&mut bench.rng(&format!("M17 {name} {doubling}")), 16 << doubling);
        Some(((a.segments() + b.segments()) as f64, sizes(&a, &b)?))
    };
    (0..doublings).filter(|_| !bench.stopped()).filter_map(member).collect()
}

/// Whether a ratio of sizes is at most this on all families.
fn greatest(bench: &Bench, most: f64, ratio: fn([f64; 3]) -> f64) -> Finding {
    let (mut greatest, mut note, mut series, mut cases) = (0.0_f64, Vec::new(), Vec::new(), 0);
    for family in FAMILIES {
        let points: Vec<[f64; 2]> = members(bench, family).into_iter().map(|(n, sizes)| [n, ratio(sizes)]).collect();
        let own = points.iter().map(|point| point[1]).fold(0.0, f64::max);
        cases += points.len();
        greatest = greatest.max(own);
        let steps: Vec<String> = points.iter().map(|point| format!("{:.2}", point[1])).collect();
        note.push(format!("{}: {}", family.0, steps.join(" ")));
        series.push(Series::new(family.0, points).joined());
    }
    let verdict = if greatest <= most { Verdict::Confirmed } else { Verdict::Refuted };
    Finding::new(verdict, [greatest; 2], cases).against(most).saying(note.join("; ")).drawn(Plot::log_log(
        "segments of both operands",
        "ratio of sizes",
        series,
    ))
}

/// Most cells that are a few.
const FEW: f64 = 4.0;

/// Whether a convolution has cells in proportion to the corners, the monotonic one no more than a few.
fn figure(bench: &Bench, convolution: Convolution) -> Finding {
    let doublings = bench.either([6, 9]);
    let sizes = (0..doublings).map(|doubling| 8_u32 << doubling);
    let counted = |n: u32| {
        let (a, b) = fig8(n);
        (f64::from(n), [convolution, Convolution::Monotonic].map(|convolution| cells(convolution, &a, &b)))
    };
    let counts: Vec<(f64, [f64; 2])> = sizes.map(counted).collect();
    let series = |name, which: usize| Series::new(name, counts.iter().map(|(n, cells)| [*n, cells[which]])).joined();
    let plot = Plot::log_log("corners", "cells", vec![series("kinetic", 0), series("monotonic", 1)]);
    let most = counts.iter().map(|(_, cells)| cells[1]).fold(0.0, f64::max);
    let Some(trend) = Trend::of(counts.iter().map(|(n, cells)| [*n, cells[0]])) else {
        return Finding::new(Verdict::Undecided, [f64::NAN; 2], counts.len());
    };
    // A cell a corner: at least as many, and no other power.
    let enough = counts.iter().all(|(n, cells)| cells[0] >= *n);
    let holds = enough && trend.exponent[1] < 1.5 && most <= FEW;
    Finding::new(if holds { Verdict::Confirmed } else { Verdict::Refuted }, trend.exponent, counts.len())
        .against(1.0)
        .saying(format!("the monotonic arrangement has {most} cells at most"))
        .drawn(plot)
}
