//! M17: the sizes of the three convolutions (MS 5, Fig. 8).
//!
//! Ratios of sizes are followed over growing members of families: what is only slightly larger in the worst case must not
//! grow on any.

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

/// A polygon of so many corners whose long side is round and faces away from the tips of the teeth, to the right. No tip has
/// a normal in common with its edges, so convex and kinetic convolution are small; but every gap between teeth moves all of it.
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
            "The monotonic convolution is only slightly larger than the convex one in the worst case.",
            "It can be larger by any factor: each concave turning point moves all of the other boundary, also what no sum runs along.",
            Whole {
                quantity: "exponent of growth of monotonic by convex segments, the family where it is greatest",
                unit: "1",
                run: |bench| growth(bench, |[_, monotonic, convex]| monotonic / convex),
                control: Control::Itself,
            },
        ),
        claim(
            "M17 kinetic",
            "The monotonic convolution is no larger than the kinetic one.",
            "It often is smaller, but for the same reason it can be larger by any factor.",
            Whole {
                quantity: "greatest ratio of monotonic to kinetic segments",
                unit: "1",
                run: |bench| greatest(bench, |[kinetic, monotonic, _]| monotonic / kinetic),
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

fn growth(bench: &Bench, ratio: fn([f64; 3]) -> f64) -> Finding {
    let (mut worst, mut note, mut series): (Option<Trend>, _, _) = (None, Vec::new(), Vec::new());
    let (mut all_flat, mut cases) = (true, 0);
    for family in FAMILIES {
        let points: Vec<[f64; 2]> = members(bench, family).into_iter().map(|(n, sizes)| [n, ratio(sizes)]).collect();
        cases += points.len();
        let Some(trend) = Trend::of(points.iter().copied()) else { continue };
        let last = points.last().map_or(f64::NAN, |point| point[1]);
        note.push(format!("{}: n^[{:.2}, {:.2}], {last:.2} at last", family.0, trend.exponent[0], trend.exponent[1]));
        series.push(Series::new(family.0, points).joined());
        all_flat &= trend.no_growth() == Verdict::Confirmed;
        if worst.is_none_or(|known| trend.exponent[0] > known.exponent[0]) {
            worst = Some(trend);
        }
    }
    let Some(worst) = worst else { return Finding::new(Verdict::Undecided, [f64::NAN; 2], cases) };
    let verdict = match worst.no_growth() {
        Verdict::Refuted => Verdict::Refuted,
        _ if all_flat => Verdict::Confirmed,
        _ => Verdict::Undecided,
    };
    Finding::new(verdict, worst.exponent, cases).against(0.0).saying(note.join("; ")).drawn(Plot::log_log(
        "segments of both operands",
        "ratio of sizes",
        series,
    ))
}

fn greatest(bench: &Bench, ratio: fn([f64; 3]) -> f64) -> Finding {
    let (mut greatest, mut note, mut series, mut cases) = (0.0_f64, Vec::new(), Vec::new(), 0);
    for family in FAMILIES {
        let points: Vec<[f64; 2]> = members(bench, family).into_iter().map(|(n, sizes)| [n, ratio(sizes)]).collect();
        let own = points.iter().map(|point| point[1]).fold(0.0, f64::max);
        cases += points.len();
        greatest = greatest.max(own);
        note.push(format!("{}: {own:.3}", family.0));
        series.push(Series::new(family.0, points).joined());
    }
    let verdict = if greatest <= 1.0 { Verdict::Confirmed } else { Verdict::Refuted };
    Finding::new(verdict, [greatest; 2], cases).against(1.0).saying(note.join("; ")).drawn(Plot::log_log(
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
