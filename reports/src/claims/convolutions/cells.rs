//! M18: the sum by a convex convolution, whose cells are decided one by one (MS 5).

use super::super::bench::Bench;
use super::super::control::Control;
use super::super::draw::input;
use super::super::finding::{Finding, Measured, Verdict};
use super::super::input::Input;
use super::super::plot::{Plot, Series};
use super::super::sup::{Rule, Sup};
use super::super::sweep::audit::steps;
use super::super::sweep::liar::Liar;
use super::super::sweep::tangle::extent;
use super::super::{Claim, Test, Whole};
use crate::bridge::{plain, unit};
use crate::cases::fig8::fig8;
use crate::cases::place::turned;
use crate::cases::radial::{noise, noisy};
use crate::cases::rng::Rng;
use crate::cases::shape::polygon;
use crate::kept;
use arcsum::arrangement::arrange_with;
use arcsum::frame::Frame;
use arcsum::piece::{Piece, Pieces, Source};
use arcsum::region::Region;
use arcsum::smooth::{Kind, Smooth};
use arcsum::sum::{Convolution, Options, sum};
use arcsum::validate::validate;
use arcsum_oracle::measure::hausdorff;
use arcsum_oracle::polygon as oracle;
use glam::DVec2;

/// An error that no number of roundings makes: a hundredth of the unit box.
const UNBOUNDED: f64 = 0.01;

pub(super) fn claims() -> [Claim; 2] {
    let error = Sup {
        quantity: "distance of the sum by the convex convolution from the exact one, infinite where all of it is lost",
        unit: "unit box",
        rule: Rule::Exceeds(UNBOUNDED),
        draws: [300, 30_000],
        draw,
        measure: |input| measure(input, Convolution::Convex),
        kept: kept!("M18_error"),
        control: Control::Measure {
            plants: "the monotonic convolution in place of the convex one",
            measure: |input| measure(input, Convolution::Monotonic),
        },
    };
    let time = Whole {
        quantity: "questions and events of a sweep over both boundaries by n (6 ln n + 8)",
        unit: "1",
        run: |bench| run(bench, false),
        control: Control::Run { plants: "all pairs of segments looked at", run: |bench| run(bench, true) },
    };
    let claim = |id, says, test| Claim { id, place: "MS 5", says, erratum: "", test };
    [
        claim("M18 error", "The convex convolution is prone to unbounded error in floating point.", Test::Sup(error)),
        claim(
            "M18 time",
            "Whether a cell of it is free can be decided in O(n log n) time, by whether A meets t - B.",
            Test::Whole(time),
        ),
    ]
}

fn measure(input: &Input, convolution: Convolution) -> Option<Measured> {
    let case = input.as_pair().filter(|case| case.is_polygonal())?;
    let exact = oracle::sum(&plain(&case.a), &plain(&case.b)).ok()?;
    let found = sum(&case.a, &case.b, &Options { convolution, ..Options::default() }).ok()?;
    let bracket = hausdorff(&plain(&found.region), &exact, unit(&case.a, &case.b)).ok()?;
    let measured = Measured::between(bracket.lo, bracket.hi);
    let (x, y) = bracket.witness;
    Some(if x.is_finite() && y.is_finite() { measured.at([x, y]) } else { measured })
}

/// Polygons with corners on a small grid, both turned by one angle: their coincidences are rounded.
fn draw(rng: &mut Rng, _: usize) -> Input {
    let angle = rng.angle();
    let [a, b] = [0, 1].map(|_| turned(&on_grid(rng), angle));
    input("turned grid", a, b)
}

fn on_grid(rng: &mut Rng) -> Region {
    loop {
        let size = 1.0 + rng.below(3) as f64;
        let mut points: Vec<[f64; 2]> =
            noise(3 + rng.below(5) as u32, rng).iter().map(|p| p.map(|c| (size * c).round())).collect();
        points.dedup();
        let region = polygon(&points);
        if points.len() > 2 && validate(&region).is_ok() {
            return region;
        }
    }
}

/// A pair of about so many segments, and a place at which A does not meet t - B.
type Family = (&'static str, fn(&mut Rng, u32) -> (Region, Region, DVec2));

const FAMILIES: [Family; 2] = [
    ("a part in a container", |_, n| {
        let (a, b) = fig8(n / 2);
        (a, b, DVec2::ZERO)
    }),
    ("one above the other", |rng, n| {
        let (a, b) = noisy(n / 2, rng);
        (a, b, DVec2::new(0.1, 4.0))
    }),
];

fn run(bench: &Bench, all_pairs: bool) -> Finding {
    let doublings = bench.either([6, 9]);
    let (mut greatest, mut series, mut cases) = (0.0_f64, Vec::new(), 0);
    for (name, family) in FAMILIES {
        let ratio = |doubling: u32| {
            let (a, b, t) = family(&mut bench.rng(&format!("M18 {name} {doubling}")), 32 << doubling);
            let (n, work) = work(&a, &b, t)?;
            Some([n, if all_pairs { n * n } else { work } / (n * steps(n))])
        };
        let points: Vec<[f64; 2]> = (0..doublings).filter_map(ratio).collect();
        cases += points.len();
        greatest = points.iter().map(|point| point[1]).fold(greatest, f64::max);
        series.push(Series::new(name, points).joined());
    }
    let verdict = match greatest {
        0.0 => Verdict::Undecided,
        ratio if ratio <= 1.0 => Verdict::Confirmed,
        _ => Verdict::Refuted,
    };
    Finding::new(verdict, [greatest; 2], cases).against(1.0).drawn(Plot::log_log(
        "segments",
        "work by n (6 ln n + 8)",
        series,
    ))
}

/// The segments of a pair, and the questions and events of a sweep over the boundaries of A and t - B.
fn work(a: &Region, b: &Region, t: DVec2) -> Option<(f64, f64)> {
    let frames = Frame::pair(a, b);
    let mut pieces = Pieces::default();
    for (region, frame, place) in [(a, &frames.0, None), (b, &frames.1, Some(t))] {
        let smooth = Smooth::new(region, frame).ok()?;
        let first = pieces.points.len() as u32;
        pieces.points.extend(smooth.points.iter().map(|p| place.map_or(*p, |t| t - *p)));
        for seg in smooth.loops.iter().flat_map(|of_loop| &of_loop.segs).filter(|seg| seg.kind == Kind::Line) {
            let line = Piece::between(&pieces.points, first + seg.tail, first + seg.head, Source::default());
            pieces.pieces.push(line);
        }
    }
    let module = Liar::honest(extent(&pieces));
    let map = arrange_with(&pieces, &module);
    let work = module.asked() + map.audit.queued;
    (map.audit.crossings == 0).then_some((pieces.pieces.len() as f64, work as f64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_places_are_free() {
        for (name, family) in FAMILIES {
            let (a, b, t) = family(&mut Rng::new(1, name), 64);
            let (segments, work) = work(&a, &b, t).unwrap_or_else(|| panic!("{name}"));
            assert!(segments == 64.0 && work > segments);
            let frames = Frame::pair(&a, &b);
            let [a, b] = [(&a, &frames.0), (&b, &frames.1)].map(|(r, f)| Smooth::new(r, f).unwrap());
            assert!(!arcsum::overlap::Overlap::new(&a, &b).at(t), "{name}");
        }
    }
}
