//! M49: exact arrangements against ours on the same input (MS 1): CGAL's reduced convolution with exact numbers against our
//! kinetic one on polygons, and its exact unions of regions of arcs against ours.

use super::super::bench::Bench;
use super::super::control::Control;
use super::super::finding::{Finding, Verdict};
use super::super::plot::{Plot, Series};
use super::super::{Claim, Test, Whole};
use crate::bench::middle::Sorted;
use crate::bridge::plain;
use crate::cases::rng::Rng;
use crate::cases::{gear, place, radial};
use crate::engine::registry::engine;
use crate::engine::{Engine, cgal};
use arcsum::boolean;
use arcsum::region::Region;
use arcsum_cgal::child::Child;
use arcsum_cgal::curved::Combine;
use arcsum_oracle::boolean::Operation;
use std::time::{Duration, Instant};

/// How much slower MS have exact arithmetic.
const SLOWER: f64 = 10.0;

/// Student's 97.5% quantile for five degrees of freedom and more is at most this.
const STUDENT: f64 = 2.571;

/// The longest that CGAL may take for an answer.
const LIMIT: Duration = Duration::from_secs(60);

pub(super) fn claim() -> Claim {
    let whole = Whole {
        quantity: "time of an exact engine by ours, 95% interval of the geometric mean",
        unit: "1",
        run: |bench| run(bench, false),
        control: Control::Run { plants: "our engine in place of the exact one", run: |bench| run(bench, true) },
    };
    Claim {
        id: "M49",
        place: "MS 1",
        says: "Exact arrangement is an order of magnitude slower, here: at least ten times.",
        erratum: "The print compares 100 curves of degree 6; here they are lines and circle segments.",
        test: Test::Whole(whole),
    }
}

fn run(bench: &Bench, against_itself: bool) -> Finding {
    if !against_itself && !arcsum_cgal::built_in() {
        return Finding::new(Verdict::Undecided, [f64::NAN; 2], 0).against(SLOWER).saying("CGAL is not built in");
    }
    let (cases, rounds) = bench.either([(4, 3), (30, 9)]);
    let mut rng = bench.rng("M49");
    let sums: Vec<f64> = (0..cases).filter_map(|_| sum(&mut rng, rounds, against_itself)).collect();
    let unions: Vec<f64> = (0..cases).filter_map(|_| union(&mut rng, rounds, against_itself)).collect();
    let all: Vec<f64> = sums.iter().chain(&unions).copied().collect();
    if all.len() < 6 {
        return Finding::new(Verdict::Undecided, [f64::NAN; 2], all.len())
            .against(SLOWER)
            .saying("CGAL gave no answers");
    }
    let [lo, hi] = interval(&all);
    let verdict = if lo >= SLOWER {
        Verdict::Confirmed
    } else if hi < SLOWER {
        Verdict::Refuted
    } else {
        Verdict::Undecided
    };
    let mean = |values: &[f64]| Sorted::new(values.iter().copied()).map_or(f64::NAN, |sorted| sorted.geometric_mean());
    let note = format!("sums of polygons {:.1}, unions of arcs {:.1}", mean(&sums), mean(&unions));
    let points = |values: &[f64]| values.iter().enumerate().map(|(i, v)| [i as f64, *v]).collect::<Vec<_>>();
    let series = vec![Series::new("sums of polygons", points(&sums)), Series::new("unions of arcs", points(&unions))];
    Finding::new(verdict, [lo, hi], all.len())
        .against(SLOWER)
        .saying(note)
        .drawn(Plot { log: [false, true], ..Plot::linear("case", "exact by ours", series) })
}

/// The 95% interval of the geometric mean.
fn interval(values: &[f64]) -> [f64; 2] {
    let n = values.len() as f64;
    let logs: Vec<f64> = values.iter().map(|v| libm::log(*v)).collect();
    let mean = logs.iter().sum::<f64>() / n;
    let variance = logs.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / (n - 1.0);
    let half = STUDENT * libm::sqrt(variance / n);
    [libm::exp(mean - half), libm::exp(mean + half)]
}

/// The ratio for a sum of polygons.
fn sum(rng: &mut Rng, rounds: usize, against_itself: bool) -> Option<f64> {
    let (a, b) = radial::noisy(30, rng);
    let time = |engine: &mut dyn Engine| {
        let mut once = || engine.sum(&a, &b).ok()?.times.total.map(|t| t.as_secs_f64());
        Sorted::new((0..rounds).filter_map(|_| once())).map(|times| times.median())
    };
    let exact = if against_itself { "kinetic" } else { "cgal:reduced:exact" };
    Some(time(engine(exact).ok()?.as_mut())? / time(engine("kinetic").ok()?.as_mut())?)
}

/// The ratio for a union of two gears.
fn union(rng: &mut Rng, rounds: usize, against_itself: bool) -> Option<f64> {
    let (a, b) = (gear::gear(96, rng), place::moved(&gear::gear(96, rng), [0.3, 0.1]));
    let ours = || {
        let start = Instant::now();
        std::hint::black_box(boolean::combine(boolean::Operation::Union, &a, &b).ok()?);
        Some(start.elapsed().as_secs_f64())
    };
    let middle = |times: Vec<f64>| Sorted::new(times).map(|times| times.median());
    let exact =
        if against_itself { (0..rounds).filter_map(|_| ours()).collect() } else { exact_unions(&a, &b, rounds) };
    Some(middle(exact)? / middle((0..rounds).filter_map(|_| ours()).collect())?)
}

/// The times of CGAL's exact union.
fn exact_unions(a: &Region, b: &Region, rounds: usize) -> Vec<f64> {
    let (Ok(program), Ok(question)) = (std::env::current_exe(), Combine::new(Operation::Union, &plain(a), &plain(b)))
    else {
        return Vec::new();
    };
    let mut child = Child::new(program, &[cgal::COMMAND], LIMIT);
    (0..rounds).filter_map(|_| child.ask(&question).ok().map(|answer| answer.time.as_secs_f64())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_is_around_the_mean() {
        let [lo, hi] = interval(&[2.0, 8.0, 2.0, 8.0]);
        assert!(lo < 4.0 && 4.0 < hi && (lo * hi - 16.0).abs() < 1e-9);
    }
}
