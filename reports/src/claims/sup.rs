//! Experiments on single inputs: a quantity that must stay below a bound on all of them, that must exceed one on some, or
//! that must not grow with the size of the input.

use super::bench::Bench;
use super::control::Control;
use super::finding::{Finding, Measured, Verdict, Worst};
use super::input::Input;
use super::kept;
use super::plot::{Plot, Series};
use super::trend::Trend;
use crate::cases::rng::Rng;

/// An experiment on single inputs.
#[derive(Clone)]
pub struct Sup {
    /// What is measured.
    pub quantity: &'static str,
    /// Its unit, 1 for a pure number.
    pub unit: &'static str,
    /// How the verdict follows.
    pub rule: Rule,
    /// Inputs at quick and at full effort, besides those that are kept.
    pub draws: [usize; 2],
    /// Draws an input, given its number.
    pub draw: fn(&mut Rng, usize) -> Input,
    /// Measures the quantity; none if the claim says nothing about such an input.
    pub measure: fn(&Input) -> Option<Measured>,
    /// The worst inputs known, the text of their file.
    pub kept: &'static str,
    /// What must come out refuted.
    pub control: Control,
}

/// How a verdict follows from the quantity on all inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// Confirmed if it is at most this on all, refuted if it is more on one.
    AtMost(f64),
    /// Confirmed if it is more than this on one, refuted if it is at most this on all: a claim that something exists.
    Exceeds(f64),
    /// Confirmed if it certainly does not grow with the size of the input, refuted if it certainly does, where certain is
    /// what 95% intervals of the exponent say.
    Flat,
}

/// The experiment over all inputs so far.
struct Tally {
    rule: Rule,
    values: Vec<Measured>,
    worst: Option<(Input, Measured)>,
}

impl Sup {
    /// Measures the kept inputs and the drawn ones.
    #[must_use]
    pub fn run(&self, id: &str, bench: &Bench) -> Finding {
        self.measured(id, bench, self.kept, self.draw, self.measure)
    }

    /// The control; the experiment itself if it has none of its own.
    #[must_use]
    pub fn control(&self, id: &str, bench: &Bench) -> Finding {
        match self.control {
            Control::Measure { measure, .. } => self.measured(id, bench, self.kept, self.draw, measure),
            // Kept inputs are none of these.
            Control::Inputs { draw, .. } => self.measured(id, bench, "", draw, self.measure),
            Control::Run { run, .. } => run(bench),
            Control::Claim(_) | Control::Itself => self.run(id, bench),
        }
    }

    fn measured(
        &self,
        id: &str,
        bench: &Bench,
        kept: &str,
        draw: fn(&mut Rng, usize) -> Input,
        measure: fn(&Input) -> Option<Measured>,
    ) -> Finding {
        let mut tally = Tally { rule: self.rule, values: Vec::new(), worst: None };
        for kept in kept::read(kept) {
            tally.enter(kept.input, measure);
        }
        for number in 0..bench.either(self.draws) {
            if bench.stopped() {
                break;
            }
            // A stream of its own for every input: it stays the same whatever is drawn before it.
            tally.enter(draw(&mut bench.rng(&format!("{id} {number}")), number), measure);
        }
        tally.finish(self.quantity)
    }
}

impl Tally {
    fn enter(&mut self, input: Input, measure: fn(&Input) -> Option<Measured>) {
        let Some(measured) = measure(&input) else { return };
        if self.worst.as_ref().is_none_or(|(_, worst)| (measured.lo, measured.hi) > (worst.lo, worst.hi)) {
            self.worst = Some((input, measured.clone()));
        }
        self.values.push(measured);
    }

    fn finish(self, quantity: &str) -> Finding {
        let greatest = |of: fn(&Measured) -> f64| self.values.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
        let (lo, hi) = (greatest(|m| m.lo), greatest(|m| m.hi));
        let plot = self.plot(quantity);
        let worst = self.worst.as_ref().map(|(input, measured)| Worst::new(input.clone(), measured));
        let cases = self.values.len();
        let mut finding = match self.rule {
            _ if cases == 0 => Finding::new(Verdict::Undecided, [f64::NAN; 2], 0).saying("no input was measured"),
            Rule::AtMost(bound) => Finding::new(at_most(bound, [lo, hi]), [lo, hi], cases).against(bound),
            Rule::Exceeds(bound) => Finding::new(exceeds(bound, [lo, hi]), [lo, hi], cases).against(bound),
            Rule::Flat => self.flat([lo, hi]),
        };
        finding.undecided = self.values.iter().filter(|m| self.is_undecided(m)).count();
        finding.witnessed(worst).drawn(plot)
    }

    fn is_undecided(&self, measured: &Measured) -> bool {
        match self.rule {
            Rule::AtMost(bound) | Rule::Exceeds(bound) => measured.lo <= bound && measured.hi > bound,
            Rule::Flat => !measured.hi.is_finite(),
        }
    }

    /// The exponent of growth, from the greatest value at each size.
    fn flat(&self, [lo, hi]: [f64; 2]) -> Finding {
        let decided = self.values.iter().filter(|m| m.hi.is_finite());
        let Some(trend) = Trend::of_greatest(decided.map(|m| [m.size, m.hi])) else {
            return Finding::new(Verdict::Undecided, [f64::NAN; 2], self.values.len()).saying("too few sizes");
        };
        let note = format!("greatest constant in [{lo:.3e}, {hi:.3e}]");
        Finding::new(trend.no_growth(), trend.exponent, self.values.len()).against(0.0).saying(note)
    }

    fn plot(&self, quantity: &str) -> Plot {
        let decided = self.values.iter().filter(|m| m.hi.is_finite());
        if self.values.iter().any(|m| m.size > 0.0) {
            let points = decided.filter(|m| m.hi > 0.0).map(|m| [m.size, m.hi]);
            Plot::log_log("size of the input", quantity, vec![Series::new("", points)])
        } else {
            Plot::histogram(quantity, decided.map(|m| m.hi))
        }
    }
}

fn at_most(bound: f64, [lo, hi]: [f64; 2]) -> Verdict {
    if lo > bound {
        Verdict::Refuted
    } else if hi <= bound {
        Verdict::Confirmed
    } else {
        Verdict::Undecided
    }
}

fn exceeds(bound: f64, measured: [f64; 2]) -> Verdict {
    match at_most(bound, measured) {
        Verdict::Refuted => Verdict::Confirmed,
        Verdict::Confirmed => Verdict::Refuted,
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::Effort;
    use super::*;
    use std::sync::atomic::AtomicBool;

    fn found(rule: Rule, measure: fn(&Input) -> Option<Measured>) -> Finding {
        let control = Control::Itself;
        let draw = |_: &mut Rng, number: usize| Input::numbers("n", [number as f64]);
        let sup = Sup { quantity: "q", unit: "1", rule, draws: [20, 40], draw, measure, kept: "", control };
        sup.run("X", &Bench { effort: Effort::Quick, seed: 1, stop: &AtomicBool::new(false) })
    }

    #[test]
    fn verdicts_follow_from_brackets() {
        let exact: fn(&Input) -> Option<Measured> = |input| Some(Measured::exactly(input.as_numbers("n")?[0]));
        let loose: fn(&Input) -> Option<Measured> = |input| Some(Measured::between(0.0, input.as_numbers("n")?[0]));
        assert_eq!(found(Rule::AtMost(19.0), exact).verdict, Verdict::Confirmed);
        let refuted = found(Rule::AtMost(18.0), exact);
        assert_eq!((refuted.verdict, refuted.lo, refuted.cases), (Verdict::Refuted, 19.0, 20));
        assert_eq!(refuted.worst.unwrap().input, Input::numbers("n", [19.0]));
        let open = found(Rule::AtMost(17.0), loose);
        assert_eq!((open.verdict, open.undecided), (Verdict::Undecided, 2));
        assert_eq!(found(Rule::Exceeds(18.0), exact).verdict, Verdict::Confirmed);
        assert_eq!(found(Rule::Exceeds(19.0), exact).verdict, Verdict::Refuted);
        assert_eq!(found(Rule::AtMost(1.0), |_| None).verdict, Verdict::Undecided);
    }

    #[test]
    fn growth_is_seen() {
        fn power(input: &Input, exponent: f64) -> Option<Measured> {
            let n = input.as_numbers("n")?[0] + 1.0;
            let ripple = 1.0 + 0.01 * libm::sin(7.0 * n);
            Some(Measured { size: n, ..Measured::exactly(ripple * libm::pow(n, exponent)) })
        }
        let growing = found(Rule::Flat, |input| power(input, 0.5));
        assert_eq!(growing.verdict, Verdict::Refuted);
        assert!(growing.lo < 0.5 && 0.5 < growing.hi, "{growing:?}");
        assert_eq!(found(Rule::Flat, |input| power(input, -0.5)).verdict, Verdict::Confirmed);
        assert_eq!(found(Rule::Flat, |input| power(input, 0.0)).verdict, Verdict::Undecided);
    }
}
