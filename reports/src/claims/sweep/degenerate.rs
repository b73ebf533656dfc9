//! M50: the time of the arrangement on degenerate input, against twins whose vertices are moved by a millionth (MS 1).
//!
//! What is arranged is the kinetic convolution of a pair. Twins run in turn; the middle of the ratios of a pair counts, and
//! the work of both, which does not vary, is told beside it.

use super::super::bench::Bench;
use super::super::control::Control;
use super::super::draw::input;
use super::super::finding::{Finding, Measured, Verdict, Worst};
use super::super::plot::{Plot, Series};
use super::super::{Claim, Test, Whole};
use super::audit::Told;
use super::clock::timed;
use super::liar::Liar;
use super::perturbed::convolutions;
use super::tangle::extent;
use crate::bench::middle::Sorted;
use crate::cases::orthogonal::{Corners, Style, cells};
use crate::cases::rng::Rng;
use crate::cases::shape::{polygon, regular};
use crate::cases::{combs, fork, gear};
use arcsum::arrangement::arrange_with;
use arcsum::piece::Pieces;
use arcsum::region::Region;

/// The memo's bounds of "unchanged".
const UNCHANGED: [f64; 2] = [0.8, 1.25];

/// By how much the vertices of twins are moved, in parts of the coordinates and of 1.
const MOVED: f64 = 1e-6;

pub(super) fn claims() -> [Claim; 2] {
    let claim = |id, says, erratum, whole| Claim { id, place: "MS 1", says, erratum, test: Test::Whole(whole) };
    let slower = Control::Run {
        plants: "degenerate pairs have all pairs of curves looked at",
        run: |bench| run(bench, [0.0, UNCHANGED[1]], true),
    };
    let unchanged = Whole {
        quantity: "time on degenerate input by time on its twin, least and greatest",
        unit: "1",
        run: |bench| run(bench, UNCHANGED, false),
        control: Control::Run {
            plants: "degenerate pairs have all pairs of curves looked at",
            run: |bench| run(bench, UNCHANGED, true),
        },
    };
    let no_slower = Whole { run: |bench| run(bench, [0.0, UNCHANGED[1]], false), control: slower, ..unchanged.clone() };
    [
        claim(
            "M50 printed",
            "The running time on degenerate input is unchanged, here: 0.8 to 1.25 times that on input in general position.",
            "Coincidences are merged by the sweep of the memo, which saves vertices: it is not unchanged but less.",
            unchanged,
        ),
        claim(
            "M50 corrected",
            "The running time on degenerate input is no larger, here: at most 1.25 times.",
            "",
            no_slower,
        ),
    ]
}

/// Degenerate pairs under their names.
pub(super) fn pairs(rng: &mut Rng, size: u32) -> Vec<(&'static str, Region, Region)> {
    let style = Style { side: 8, cells: 6 * size as usize, holes: false, collinear: true, corners: Corners::Sharp };
    let (grid, rounded) = (cells(style, rng), cells(Style { corners: Corners::Rounded, ..style }, rng));
    let even = polygon(&regular(24 * size, 1.0, 0.0));
    let wheel = gear::gear(24 * size, rng);
    let ((f, g), (c, d)) = (fork::fork(size + 1), combs::combs(4 * size));
    vec![
        ("cells and their negative", grid.clone(), grid.negated()),
        ("rounded cells and their copy", rounded.clone(), rounded),
        ("regular polygon and its copy", even.clone(), even),
        ("gear and its copy", wheel.clone(), wheel),
        ("fork", f, g),
        ("combs", c, d),
    ]
}

/// The region in general position.
fn twin(region: &Region, rng: &mut Rng) -> Region {
    let mut twin = region.clone();
    for node in twin.loops.iter_mut().flatten() {
        node.x += MOVED * rng.between(-1.0, 1.0) * node.x.abs().max(1.0);
        node.y += MOVED * rng.between(-1.0, 1.0) * node.y.abs().max(1.0);
    }
    twin
}

/// Seconds and work of an arrangement.
fn arranged(pieces: &Pieces, all_pairs: bool) -> [f64; 2] {
    let module = Liar::honest(extent(pieces));
    let (seconds, map) = timed(|| {
        if all_pairs {
            std::hint::black_box(Told::new(pieces, &module).crossings());
        }
        arrange_with(pieces, &module)
    });
    [seconds, (module.asked() + map.audit.queued + map.audit.vertices) as f64]
}

/// The middle ratio of times, and the ratio of work, of a degenerate pair to its twin.
fn ratios(both: &[Pieces; 2], rounds: usize, all_pairs: bool) -> [f64; 2] {
    let round = |_| {
        let [[t, work], [twin_t, twin_work]] = [arranged(&both[0], all_pairs), arranged(&both[1], false)];
        [t / twin_t, work / twin_work]
    };
    let rounds: Vec<[f64; 2]> = (0..rounds).map(round).collect();
    let middle = Sorted::new(rounds.iter().map(|round| round[0])).expect("a round at least").median();
    [middle, rounds[0][1]]
}

fn run(bench: &Bench, [least, most]: [f64; 2], all_pairs: bool) -> Finding {
    let few = (2, 9);
    // All pairs of many curves would be more than any machine can hold.
    let (size, rounds) = if all_pairs { few } else { bench.either([few, (8, 51)]) };
    let mut rng = bench.rng("M50");
    let (mut note, mut bars, mut found, mut worst) = (Vec::new(), Vec::new(), [f64::INFINITY, 0.0_f64], None);
    for (name, a, b) in pairs(&mut rng, size) {
        let twins = [twin(&a, &mut rng), twin(&b, &mut rng)];
        let both = [convolutions(&a, &b), convolutions(&twins[0], &twins[1])].map(|mut all| all.swap_remove(0));
        let [time, work] = ratios(&both, rounds, all_pairs);
        note.push(format!("{name}: time {time:.2}, work {work:.2}"));
        bars.push([work, time]);
        if time > found[1] {
            worst = Some(Worst::new(input(name, a, b), &Measured::exactly(time)));
        }
        found = [found[0].min(time), found[1].max(time)];
    }
    let holds = least <= found[0] && found[1] <= most;
    Finding::new(if holds { Verdict::Confirmed } else { Verdict::Refuted }, found, bars.len())
        .against(most)
        .saying(note.join("; "))
        .witnessed(worst)
        .drawn(Plot::linear("ratio of work", "ratio of time", vec![Series::new("pairs", bars)]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use arcsum::validate::validate;

    #[test]
    fn pairs_and_twins_are_valid() {
        let mut rng = Rng::new(1, "M50");
        for (name, a, b) in pairs(&mut rng, 1) {
            for region in [&a, &b, &twin(&a, &mut rng), &twin(&b, &mut rng)] {
                validate(region).unwrap_or_else(|e| panic!("{name}: {e}"));
            }
        }
    }
}
