//! A2: the time of the arrangement (abstract of MS reference 5), by what it does: questions to the crossing module and events.
//!
//! For n curves and V vertices, work must stay below what V vertices may take, of order V log n, at every size of every
//! family. How it grows, and the times, are fitted beside it.

use super::super::bench::Bench;
use super::super::control::Control;
use super::super::finding::{Finding, Verdict};
use super::super::plot::{Plot, Series};
use super::super::trend::Trend;
use super::super::{Claim, Test, Whole};
use super::audit::steps;
use super::clock::timed;
use super::liar::Liar;
use super::perturbed::convolutions;
use super::tangle::extent;
use crate::cases::radial;
use crate::cases::rng::Rng;
use arcsum::angle::Ang;
use arcsum::arrangement::arrange_with;
use arcsum::piece::{Piece, Pieces, Source};
use glam::DVec2;
use libm::{log2, sqrt};

/// Sets of about so many curves.
type Family = (&'static str, fn(&mut Rng, usize) -> Pieces);

const FAMILIES: [Family; 4] = [
    ("apart", |rng, n| segments(rng, n, 1.0 / (64.0 * n as f64))),
    ("short", |rng, n| segments(rng, n, 2.0 / sqrt(n as f64))),
    ("long", |rng, n| segments(rng, n, 0.5)),
    ("convolutions", |rng, n| {
        let (a, b) = radial::noisy(sqrt(n as f64) as u32, rng);
        convolutions(&a, &b).remove(0)
    }),
];

/// Curves of the smallest sets; the others have two, four, ... times as many.
const LEAST: usize = 64;

/// A set that was arranged.
struct Arranged {
    curves: f64,
    /// V log n.
    growth: f64,
    work: f64,
    /// What V vertices may take.
    most: f64,
    seconds: f64,
}

pub(super) fn claim() -> Claim {
    let whole = Whole {
        quantity: "questions and events by V (6 ln n + 8)",
        unit: "1",
        run: |bench| run(bench, false),
        control: Control::Run { plants: "a question for every pair of curves", run: |bench| run(bench, true) },
    };
    Claim {
        id: "A2",
        place: "MS reference 5, abstract",
        says: "The time of an arrangement of n curves with V vertices is O(V log n).",
        erratum: "",
        test: Test::Whole(whole),
    }
}

fn run(bench: &Bench, all_pairs: bool) -> Finding {
    let (mut greatest, mut note, mut series, mut cases) = (0.0_f64, Vec::new(), Vec::new(), 0);
    for (name, family) in FAMILIES {
        let sets = sets(bench, name, family, all_pairs);
        let ratio = |set: &Arranged| [set.curves, set.work / set.most];
        let fit = |of: fn(&Arranged) -> f64| Trend::of(sets.iter().map(|set| [set.growth, of(set)]));
        greatest = sets.iter().map(|set| ratio(set)[1]).fold(greatest, f64::max);
        cases += sets.len();
        if let (Some(work), Some(time)) = (fit(|set| set.work), fit(|set| set.seconds)) {
            let [[a, b], [c, d]] = [work.exponent, time.exponent];
            let r2 = time.r2;
            note.push(format!("{name}: V log n to [{a:.2}, {b:.2}], time to [{c:.2}, {d:.2}] with R^2 {r2:.3}"));
        }
        series.push(Series::new(name, sets.iter().map(ratio)));
    }
    let verdict = if greatest <= 1.0 { Verdict::Confirmed } else { Verdict::Refuted };
    Finding::new(verdict, [greatest; 2], cases).against(1.0).saying(note.join("; ")).drawn(Plot::log_log(
        "curves",
        "questions and events by V (6 ln n + 8)",
        series,
    ))
}

fn sets(bench: &Bench, name: &str, family: fn(&mut Rng, usize) -> Pieces, all_pairs: bool) -> Vec<Arranged> {
    let (doublings, repeats) = bench.either([(5, 2), (7, 10)]);
    let mut sets = Vec::new();
    for doubling in 0..doublings {
        for repeat in 0..repeats {
            if !bench.stopped() {
                let mut rng = bench.rng(&format!("A2 {name} {doubling} {repeat}"));
                sets.push(arranged(&family(&mut rng, LEAST << doubling), all_pairs));
            }
        }
    }
    sets
}

fn arranged(pieces: &Pieces, all_pairs: bool) -> Arranged {
    let module = Liar::honest(extent(pieces));
    let (seconds, map) = timed(|| arrange_with(pieces, &module));
    let curves = map.audit.curves as f64;
    let vertices = map.audit.vertices as f64;
    let pairs = if all_pairs { curves * curves } else { 0.0 };
    let work = (module.asked() + map.audit.queued) as f64 + pairs;
    Arranged { curves, growth: vertices * log2(curves), work, most: vertices * steps(curves), seconds }
}

/// Lines up to this long in the unit box.
fn segments(rng: &mut Rng, n: usize, length: f64) -> Pieces {
    let mut pieces = Pieces::default();
    for index in 0..n as u32 {
        let from = DVec2::new(rng.unit(), rng.unit());
        let angle = rng.angle();
        let to = from + length * rng.between(0.1, 1.0) * DVec2::new(libm::cos(angle), libm::sin(angle));
        let Some(normal) = Ang::of_line(from, to) else { continue };
        let tail = pieces.points.len() as u32;
        pieces.points.extend([from, to]);
        pieces.pieces.push(Piece::line(tail, tail + 1, normal, Source { first: index, second: 0 }));
    }
    pieces
}
