//! A2: the time of the arrangement (abstract of MS reference 5), by what it does: questions to the crossing module and events.
//!
//! Work by V log n, for n curves and V vertices, must not grow with n on any family. Times are fitted beside it.

use super::super::bench::Bench;
use super::super::control::Control;
use super::super::finding::{Finding, Verdict};
use super::super::plot::{Plot, Series};
use super::super::trend::Trend;
use super::super::{Claim, Test, Whole};
use super::audit::Told;
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
use std::time::Instant;

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
    steps: f64,
    work: f64,
    seconds: f64,
}

pub(super) fn claim() -> Claim {
    let whole = Whole {
        quantity: "exponent of growth of questions and events by V log n",
        unit: "1",
        run: |bench| run(bench, false),
        control: Control::Run { plants: "questions about all pairs", run: |bench| run(bench, true) },
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
    let mut worst: Option<Trend> = None;
    let (mut verdict, mut note, mut series, mut cases) = (Verdict::Confirmed, Vec::new(), Vec::new(), 0);
    for (name, family) in FAMILIES {
        let sets = sets(bench, name, family, all_pairs);
        let ratio = |set: &Arranged| [set.curves, set.work / set.steps];
        let (Some(growth), Some(time)) =
            (Trend::of(sets.iter().map(ratio)), Trend::of(sets.iter().map(|set| [set.steps, set.seconds])))
        else {
            continue;
        };
        verdict = worse(verdict, growth.no_growth());
        cases += sets.len();
        let [lo, hi] = time.exponent;
        note.push(format!("{name}: time as (V log n)^[{lo:.2}, {hi:.2}], R^2 {:.3}", time.r2));
        series.push(Series::new(name, sets.iter().map(ratio)));
        if worst.is_none_or(|known| growth.exponent[1] > known.exponent[1]) {
            worst = Some(growth);
        }
    }
    let exponent = worst.map_or([f64::NAN; 2], |trend| trend.exponent);
    Finding::new(verdict, exponent, cases).against(0.0).saying(note.join("; ")).drawn(Plot::log_log(
        "curves",
        "questions and events by V log n",
        series,
    ))
}

/// Refuted if one is, confirmed if both are.
fn worse(p: Verdict, q: Verdict) -> Verdict {
    if p == Verdict::Refuted || q == Verdict::Confirmed { p } else { q }
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
    let start = Instant::now();
    let map = arrange_with(pieces, &module);
    let seconds = start.elapsed().as_secs_f64();
    if all_pairs {
        Told::new(pieces, &module);
    }
    let curves = map.audit.curves as f64;
    let steps = map.audit.vertices as f64 * log2(curves);
    Arranged { curves, steps, work: (module.asked() + map.audit.queued) as f64, seconds }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worse_verdict_counts() {
        let all = [Verdict::Confirmed, Verdict::Undecided, Verdict::Refuted];
        for (i, p) in all.into_iter().enumerate() {
            for (j, q) in all.into_iter().enumerate() {
                assert_eq!(worse(p, q), all[i.max(j)]);
            }
        }
    }
}
