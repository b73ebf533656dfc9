//! M2: how many fewer arcs than lines a curve takes (MS 1).

use super::super::bench::Bench;
use super::super::control::Control;
use super::super::finding::{Finding, Verdict};
use super::super::plot::{Plot, Series};
use super::super::trend::Trend;
use super::super::{Claim, Test, Whole};
use super::curves::{CURVES, Curve};
use super::fit::{arcs, chords, least_arcs};
use libm::pow;

/// The factor that MS claim at least.
const FACTOR: f64 = 100.0;

pub(super) fn claims() -> [Claim; 1] {
    let whole = Whole {
        quantity: "greatest ratio of lines to arcs at tolerances of 1e-4 to 1e-6: arcs as fitted, and no fewer than any fit has",
        unit: "1",
        run: |bench| measured(bench, &CURVES),
        control: Control::Itself,
    };
    [Claim {
        id: "M2",
        place: "MS 1",
        says: "Curves take quadratically fewer circle segments than lines, so at 4 to 6 digits arcs make models 100 to 1000 \
               times smaller.",
        erratum: "Arcs of a fit have an error of the third order in their length, lines of the second: the number of arcs is that of \
                  lines to the power of 2/3. Only curves that are nearly circles gain more.",
        test: Test::Whole(whole),
    }]
}

/// Numbers of lines, arcs, and of arcs that no fit has fewer than, at a tolerance.
type Counts = (f64, [f64; 3]);

fn counts(curve: &Curve, bench: &Bench) -> Vec<Counts> {
    let steps = bench.either([2, 8]);
    let tolerances = (0..=3 * steps).map(|i| pow(10.0, -3.0 - f64::from(i) / f64::from(steps)));
    let count = |tolerance: f64| {
        let counts = [chords(curve, tolerance), arcs(curve, tolerance), least_arcs(curve, tolerance)];
        (tolerance, counts.map(|count| count as f64))
    };
    tolerances.take_while(|_| !bench.stopped()).map(count).collect()
}

/// Refuted if on some of these curves no fit by arcs is as small as claimed; confirmed if all fits are.
fn measured(bench: &Bench, curves: &[Curve]) -> Finding {
    let (mut series, mut notes, mut cases) = (Vec::new(), Vec::new(), 0);
    let (mut fitted, mut possible) = (f64::INFINITY, f64::INFINITY);
    let mut greatest = [0.0_f64; 2];
    for curve in curves {
        let counts = counts(curve, bench);
        cases += counts.len();
        let fine = counts.iter().filter(|(tolerance, _)| *tolerance < 1.5e-4);
        let ratio = |which: usize| fine.clone().map(|(_, c)| c[0] / c[which]).fold(0.0, f64::max);
        let ratios = [ratio(1), ratio(2)];
        (fitted, possible) = (fitted.min(ratios[0]), possible.min(ratios[1]));
        greatest = [greatest[0].max(ratios[0]), greatest[1].max(ratios[1])];
        let of = |which: usize| counts.iter().map(move |(tolerance, c)| [1.0 / tolerance, c[which]]);
        let exponent = |which: usize| Trend::of(of(which)).map_or([f64::NAN; 2], |trend| trend.exponent);
        let [lines, arcs, least] = [0, 1, 2].map(exponent);
        notes.push(format!(
            "{}: exponents of the tolerance: lines {:.3} to {:.3}, arcs {:.3} to {:.3}, least arcs {:.3} to {:.3}; factor \
             {:.1} to {:.1}",
            curve.name, lines[0], lines[1], arcs[0], arcs[1], least[0], least[1], ratios[0], ratios[1]
        ));
        for (which, what) in [(0, "lines"), (1, "arcs"), (2, "least arcs")] {
            series.push(Series::new(&format!("{}, {what}", curve.name), of(which)).joined());
        }
    }
    let verdict = if possible < FACTOR {
        Verdict::Refuted
    } else if fitted >= FACTOR {
        Verdict::Confirmed
    } else {
        Verdict::Undecided
    };
    let plot = Plot::log_log("one over the tolerance", "segments", series);
    Finding::new(verdict, greatest, cases).against(FACTOR).saying(notes.join(". ")).drawn(plot)
}

#[cfg(test)]
mod tests {
    use super::super::super::bench::Effort;
    use super::super::curves::CIRCLE;
    use super::*;
    use std::sync::atomic::AtomicBool;

    #[test]
    fn a_circle_is_as_claimed_and_an_ellipse_is_not() {
        let bench = Bench { effort: Effort::Quick, seed: 1, stop: &AtomicBool::new(false) };
        assert_eq!(measured(&bench, &[CIRCLE]).verdict, Verdict::Confirmed);
        assert_eq!(measured(&bench, &CURVES[..1]).verdict, Verdict::Refuted);
    }
}
