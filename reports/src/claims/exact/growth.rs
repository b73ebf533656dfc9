//! F3 and F4: how large sums get (FH 1, Fig. 1 and 2; memo J5).

use super::super::bench::Bench;
use super::super::control::Control;
use super::super::finding::{Finding, Verdict};
use super::super::plot::{Plot, Series};
use super::super::trend::Trend;
use super::super::{Claim, Test, Whole};
use crate::bridge::plain;
use crate::cases::combs::comb_and_polygon;
use crate::cases::fork::fork;
use crate::cases::shape::{polygon, rectangle};
use arcsum::region::Region;
use arcsum_oracle::convolve::{self, Ties};
use arcsum_oracle::error::Budget;
use arcsum_oracle::kinetic::{Holes, Kinetic};
use arcsum_oracle::region::ExactRegion;
use rug::Rational;

pub(super) fn claims() -> [Claim; 2] {
    let forks = Whole {
        quantity: "least number of holes of the sum of two forks of p by p teeth over (p^2-1)^2, where m = n = 8p+2",
        unit: "1",
        run: |bench| quartic(bench, fork),
        control: Control::Run {
            plants: "the second fork is a square",
            run: |bench| quartic(bench, |p| (fork(p).0, polygon(&rectangle([0.0, 0.0], [0.01, 0.01])))),
        },
    };
    let combs = Whole {
        quantity: "vertices of the sum of a comb and a regular polygon: greatest second difference in one of both sizes",
        unit: "1",
        run: |bench| bilinear(bench, comb_and_polygon),
        control: Control::Run {
            plants: "the comb and the polygon are two forks",
            run: |bench| bilinear(bench, |n, k| (fork(n / 4).0, fork(k / 4).1)),
        },
    };
    [
        Claim {
            id: "F3",
            place: "FH 1",
            says: "The sum of polygons of m and n vertices is part of an arrangement of sums of vertices and edges, so it has \
                   O(m^2 n^2) vertices, and forks have that many.",
            erratum: "There are 2mn such sums, an edge of either with a vertex of the other, not mn.",
            test: Test::Whole(forks),
        },
        Claim {
            id: "F4",
            place: "FH 1",
            says: "If P is convex the sum can have as many as mn vertices, and has no more than a multiple of that: that of a \
                   comb and a regular polygon grows linearly in each.",
            erratum: "",
            test: Test::Whole(combs),
        },
    ]
}

type Pairs = fn(u32) -> (Region, Region);

fn read(region: &Region) -> Option<ExactRegion<Rational>> {
    ExactRegion::from_plain(&plain(region)).ok()
}

/// Counts holes for pairs of p teeth. Confirmed if there are always at least (p^2-1)^2, and no more vertices than twice the pairs
/// of at most 2mn sum segments.
fn quartic(bench: &Bench, pairs: Pairs) -> Finding {
    let (mut points, mut ratios) = (Vec::new(), Vec::new());
    let (mut most, mut segments) = (0.0_f64, 0.0_f64);
    for p in (2..=bench.either([7, 12])).take_while(|_| !bench.stopped()) {
        let (a, b) = pairs(p);
        let (Some(x), Some(y)) = (read(&a), read(&b)) else { continue };
        let (Ok(sum), Ok(Some(kinetic))) =
            (convolve::sum(&x, &y, Budget::NONE), Kinetic::new(&x, &y, Holes::All, Ties::FIRST_A))
        else {
            continue;
        };
        let pairs = 2.0 * (x.vertices() * y.vertices()) as f64;
        let count = (kinetic.forward().len() + kinetic.backward().len()) as f64;
        let (p, holes) = (f64::from(p), sum.holes() as f64);
        points.push([p, holes]);
        ratios.push(holes / ((p * p - 1.0) * (p * p - 1.0)));
        most = most.max(sum.vertices() as f64 / (pairs * (pairs - 1.0)));
        segments = segments.max(count / pairs);
    }
    let exponent = Trend::of(points.iter().copied()).map_or([0.0; 2], |trend| trend.exponent);
    let note = format!(
        "exponent in p {:.3} to {:.3}; at most {segments:.3} of the 2mn sums are sum segments; vertices at most {most:.1e} of \
         twice the pairs of these",
        exponent[0], exponent[1]
    );
    let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
    let holds = least >= 1.0 && most <= 1.0 && segments <= 1.0;
    let verdict = if holds { Verdict::Confirmed } else { Verdict::Refuted };
    let plot = Plot::log_log("teeth each way", "holes", vec![Series::new("", points).joined()]);
    Finding::new(verdict, [least; 2], ratios.len()).against(1.0).saying(note).drawn(plot)
}

/// Counts vertices for pairs of two sizes. Confirmed if they are linear in each size, with a product term.
fn bilinear(bench: &Bench, pairs: fn(u32, u32) -> (Region, Region)) -> Finding {
    let sizes: Vec<u32> = (1..=bench.either([5, 12])).map(|k| 8 * k).collect();
    let mut counts = Vec::new();
    for &n in &sizes {
        let count = |&k: &u32| {
            let (a, b) = pairs(n, k);
            let sum = convolve::sum(&read(&a)?, &read(&b)?, Budget::NONE).ok()?;
            Some(sum.vertices() as f64)
        };
        let row: Option<Vec<f64>> = sizes.iter().map(count).collect();
        let Some(row) = row.filter(|_| !bench.stopped()) else { break };
        counts.push(row);
    }
    let rows = counts.len();
    if rows < 3 {
        return Finding::new(Verdict::Undecided, [f64::NAN; 2], 0).saying("too few sizes");
    }
    let at = |i: usize, j: usize| counts[i][j];
    let mut bend = 0.0_f64;
    for i in 0..rows {
        for j in 0..rows - 2 {
            bend = bend.max((at(i, j) - 2.0 * at(i, j + 1) + at(i, j + 2)).abs());
            bend = bend.max((at(j, i) - 2.0 * at(j + 1, i) + at(j + 2, i)).abs());
        }
    }
    let product = (at(0, 0) + at(1, 1) - at(0, 1) - at(1, 0)) / 64.0;
    let note = format!("{product} vertices for each tooth and corner");
    let holds = bend == 0.0 && product > 0.0;
    let verdict = if holds { Verdict::Confirmed } else { Verdict::Refuted };
    let series = sizes.iter().zip(&counts).map(|(n, row)| {
        let points = sizes.iter().zip(row).map(|(k, count)| [f64::from(*k), *count]);
        Series::new(&format!("{n} teeth"), points).joined()
    });
    let plot = Plot::linear("corners of the convex polygon", "vertices of the sum", series.collect());
    Finding::new(verdict, [bend; 2], rows * rows).against(0.0).saying(note).drawn(plot)
}
