//! What a run leaves of a claim: `claims/ID.json`, and a row of `claims.csv`.

use super::bench::{Bench, Effort};
use super::control::Control;
use super::finding::{Finding, Verdict};
use super::picture::picture;
use super::{Claim, Test};
use crate::row::Record as Drawn;
use serde::{Deserialize, Serialize};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// A claim with what was found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Number and reading.
    pub id: String,
    /// Where the paper says it.
    pub place: String,
    /// What it says.
    pub says: String,
    /// What is wrong with the print.
    pub erratum: String,
    /// What was measured.
    pub quantity: String,
    /// Its unit.
    pub unit: String,
    /// The effort that was made.
    pub effort: Effort,
    /// The seed.
    pub seed: u64,
    /// The version of the program.
    pub version: String,
    /// What the experiment found.
    pub finding: Finding,
    /// What is planted in the control.
    pub plants: String,
    /// What the control found; none if it is another claim, or none is needed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub control: Option<Finding>,
    /// What a picture of the worst input needs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub picture: Option<Drawn>,
}

/// A row of `claims.csv`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ClaimRow {
    /// Number and reading.
    pub id: String,
    /// The verdict.
    pub verdict: String,
    /// What was measured.
    pub quantity: String,
    /// The number, its lower bound.
    pub measured: String,
    /// Its upper bound.
    pub measured_hi: String,
    /// What it was compared with.
    pub bound: String,
    /// The unit of these.
    pub unit: String,
    /// Inputs.
    pub cases: usize,
    /// Of these, how many decide nothing.
    pub undecided: usize,
    /// The file of the worst input.
    pub witness: String,
    /// What was planted in the control.
    pub control: String,
    /// The verdict of the control.
    pub control_verdict: String,
    /// What was measured in the control.
    pub control_measured: String,
    /// Where the paper says it.
    pub place: String,
    /// What it says.
    pub says: String,
    /// Other numbers.
    pub note: String,
}

impl Record {
    /// Makes the experiment on a claim and its control.
    #[must_use]
    pub fn of(claim: &Claim, bench: &Bench) -> Self {
        let (finding, control, plants) = match &claim.test {
            Test::Waits(why) => (Finding::new(Verdict::NotTested, [f64::NAN; 2], 0).saying(*why), None, String::new()),
            Test::Sup(sup) => {
                let finding = guarded(|| sup.run(claim.id, bench));
                let control = sup.control.is_own().then(|| guarded(|| sup.control(claim.id, bench)));
                (finding, control, sup.control.plants())
            }
            Test::Whole(whole) => {
                let control = match whole.control {
                    Control::Run { run, .. } => Some(guarded(|| run(bench))),
                    _ => None,
                };
                (guarded(|| (whole.run)(bench)), control, whole.control.plants())
            }
        };
        let [quantity, unit] = claim.quantity().map(str::to_owned);
        let mut record = Self {
            id: claim.id.into(),
            place: claim.place.into(),
            says: claim.says.into(),
            erratum: claim.erratum.into(),
            quantity,
            unit,
            effort: bench.effort,
            seed: bench.seed,
            version: env!("CARGO_PKG_VERSION").into(),
            finding,
            plants,
            control,
            picture: None,
        };
        record.picture = record.finding.worst.as_ref().and_then(picture);
        record.doubt();
        record
    }

    /// A claim whose control fails to fail is not confirmed.
    fn doubt(&mut self) {
        let failed = self.control.as_ref().is_some_and(|control| control.verdict != Verdict::Refuted);
        if failed && self.finding.verdict == Verdict::Confirmed {
            self.finding.verdict = Verdict::Undecided;
            self.finding.note = format!("the control was not refuted; {}", self.finding.note);
        }
    }

    /// The name of its files.
    #[must_use]
    pub fn stem(&self) -> String {
        self.id.replace(' ', "_")
    }

    /// The row of the table.
    #[must_use]
    pub fn row(&self) -> ClaimRow {
        let finding = &self.finding;
        let witness = finding.worst.as_ref().map(|_| format!("witnesses/{}.json", self.stem()));
        ClaimRow {
            id: self.id.clone(),
            verdict: finding.verdict.word().into(),
            quantity: self.quantity.clone(),
            measured: written(finding.lo),
            measured_hi: written(finding.hi),
            bound: finding.bound.map_or_else(String::new, written),
            unit: self.unit.clone(),
            cases: finding.cases,
            undecided: finding.undecided,
            witness: witness.unwrap_or_default(),
            control: self.plants.clone(),
            control_verdict: self.control.as_ref().map_or("", |control| control.verdict.word()).into(),
            control_measured: self.control.as_ref().map_or_else(String::new, |control| written(control.lo)),
            place: self.place.clone(),
            says: self.says.clone(),
            note: finding.note.clone(),
        }
    }
}

/// A number with four digits, nothing if there is none.
#[must_use]
pub fn written(value: f64) -> String {
    if value.is_nan() {
        String::new()
    } else if value == value.trunc() && value.abs() < 1e6 {
        format!("{value}")
    } else if (1e-3..1e6).contains(&value.abs()) {
        format!("{value:.4}")
    } else {
        format!("{value:.3e}")
    }
}

/// A panic in an experiment ends the experiment, not the run.
fn guarded(run: impl FnOnce() -> Finding) -> Finding {
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no message");
        Finding::new(Verdict::Undecided, [f64::NAN; 2], 0).saying(format!("the experiment crashed: {text}"))
    })
}

#[cfg(test)]
mod tests {
    use super::super::Whole;
    use super::*;
    use std::sync::atomic::AtomicBool;

    fn record(run: fn(&Bench) -> Finding, control: Control) -> Record {
        let whole = Whole { quantity: "q", unit: "1", run, control };
        let claim = Claim { id: "M1", place: "MS 1", says: "s", erratum: "", test: Test::Whole(whole) };
        Record::of(&claim, &Bench { effort: Effort::Quick, seed: 1, stop: &AtomicBool::new(false) })
    }

    fn right(_: &Bench) -> Finding {
        Finding::new(Verdict::Confirmed, [1.0; 2], 1)
    }

    fn wrong(_: &Bench) -> Finding {
        Finding::new(Verdict::Refuted, [2.0; 2], 1)
    }

    #[test]
    fn nothing_is_confirmed_by_a_check_that_cannot_fail() {
        assert_eq!(record(right, Control::Run { plants: "p", run: wrong }).finding.verdict, Verdict::Confirmed);
        let doubted = record(right, Control::Run { plants: "p", run: right });
        assert_eq!(doubted.finding.verdict, Verdict::Undecided);
        assert!(doubted.row().note.contains("control"));
        assert_eq!(record(wrong, Control::Run { plants: "p", run: right }).finding.verdict, Verdict::Refuted);
    }

    #[test]
    fn a_panic_is_no_verdict() {
        let crashed = record(|_| panic!("{}", "no luck"), Control::Itself);
        assert_eq!(crashed.finding.verdict, Verdict::Undecided);
        assert!(crashed.finding.note.contains("no luck"));
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.0, 12.0, 0.25, 1e-9, f64::NAN].map(written), ["0", "12", "0.2500", "1.000e-9", ""]);
    }
}
