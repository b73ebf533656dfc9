//! The claims' worst inputs, measured again: the constant may fall, and a rise fails. What refutes a claim goes on refuting it, or
//! the claim has got better, and its file must be brought up to date.

use arcsum_reports::claims::bench::{Bench, Effort};
use arcsum_reports::claims::control::Control;
use arcsum_reports::claims::finding::{Verdict, Worst};
use arcsum_reports::claims::kept;
use arcsum_reports::claims::record::Record;
use arcsum_reports::claims::registry::claims;
use arcsum_reports::claims::sup::{Rule, Sup};
use arcsum_reports::claims::{Claim, Test};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// A kept number may move by this part of itself: it is written with all digits, but references may get tighter.
const SLACK: f64 = 1e-9;

fn sups() -> impl Iterator<Item = (Claim, Sup)> {
    claims().into_iter().filter_map(|claim| match &claim.test {
        Test::Sup(sup) => Some((claim.clone(), sup.clone())),
        Test::Whole(_) | Test::Waits(_) => None,
    })
}

/// Why a kept input is no longer what it was.
fn risen(sup: &Sup, kept: &Worst) -> Option<String> {
    let Some(now) = (sup.measure)(&kept.input) else { return Some("is no input of the claim".into()) };
    (now.lo > kept.hi + SLACK * kept.hi.abs()).then(|| format!("rose from {} to {}", kept.hi, now.lo))
}

#[test]
fn worst_inputs_are_no_worse_than_they_were() {
    let mut wrong = Vec::new();
    for (claim, sup) in sups() {
        for kept in kept::read(sup.kept) {
            wrong.extend(risen(&sup, &kept).map(|why| format!("{}: {} {why}", claim.id, sup.quantity)));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A kept input whose number is lowered by hand is told.
#[test]
fn a_rise_is_told() {
    let kept = sups().flat_map(|(_, sup)| kept::read(sup.kept).into_iter().map(move |kept| (sup.clone(), kept)));
    let mut seen = 0;
    for (sup, mut kept) in kept.filter(|(_, kept)| kept.lo > 0.0 && kept.input.size() < 40).take(5) {
        (kept.lo, kept.hi) = (0.5 * kept.lo, 0.5 * kept.lo);
        assert!(risen(&sup, &kept).is_some());
        seen += 1;
    }
    assert!(seen > 2, "{seen} inputs are kept");
}

/// The committed verdicts: all claims, none without a verdict but those that wait, every control refuted.
#[test]
fn published_verdicts_are_complete() {
    for claim in claims() {
        let verdict = published(claim.id);
        assert_ne!(verdict, "not published", "{}", claim.id);
        assert_eq!(verdict == Verdict::NotTested.word(), matches!(claim.test, Test::Waits(_)), "{}", claim.id);
    }
}

/// A claim that is confirmed and has no control of its own shares the experiment with one that is refuted.
#[test]
fn shared_controls_are_refuted() {
    let mut shared = 0;
    for claim in claims() {
        let control = match &claim.test {
            Test::Sup(sup) => sup.control,
            Test::Whole(whole) => whole.control,
            Test::Waits(_) => continue,
        };
        match control {
            Control::Claim(id) => {
                assert_eq!(published(id), "refuted", "{}", claim.id);
                shared += 1;
            }
            Control::Itself => assert_eq!(published(claim.id), "refuted", "{}", claim.id),
            _ => {}
        }
    }
    assert!(shared > 5);
}

/// The committed verdict on a claim.
fn published(id: &str) -> String {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../reports/published/claims/claims.csv");
    let text = std::fs::read_to_string(file).expect("the published table");
    let line = text.lines().find(|line| line.starts_with(&format!("{id},")));
    line.and_then(|line| line.split(',').nth(1)).unwrap_or("not published").to_owned()
}

/// A file of worst inputs that nothing reads would be measured by nobody.
#[test]
fn every_file_of_worst_inputs_belongs_to_a_claim_or_a_formula() {
    let folder = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/worst")).expect("the folder");
    let known: Vec<String> = claims().iter().map(Claim::stem).collect();
    for file in
        folder.map(|entry| entry.expect("a file").path()).filter(|file| file.extension().is_some_and(|e| e == "json"))
    {
        let stem = file.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        assert!(known.iter().any(|id| id == stem), "{stem}");
    }
}

/// Kept inputs of refuted claims whose rule is a bound exceed it.
#[test]
fn kept_inputs_of_refuted_claims_refute() {
    for (claim, sup) in sups().filter(|(claim, _)| claim.id.ends_with("printed")) {
        let (Rule::AtMost(bound), [first, ..]) = (sup.rule, &kept::read(sup.kept)[..]) else { continue };
        let now = (sup.measure)(&first.input).expect("an input of the claim");
        assert!(now.lo > bound, "{}: {} is not above {bound}", claim.id, now.lo);
    }
}

/// Claims about times: their verdicts depend on the machine.
const TIMED: [&str; 4] = ["M49", "M50 printed", "M50 corrected", "A4 time"];

/// All experiments at quick effort come to the committed verdicts, and all controls are refuted.
#[test]
fn verdicts_are_as_published() {
    let bench = Bench { effort: Effort::Quick, seed: 1, stop: &AtomicBool::new(false) };
    let (claims, next, wrong) = (claims(), AtomicUsize::new(0), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(claim) = claims.get(next.fetch_add(1, Ordering::Relaxed)) {
                    if TIMED.contains(&claim.id) {
                        continue;
                    }
                    let record = Record::of(claim, &bench);
                    let (now, then) = (record.finding.verdict.word(), published(claim.id));
                    let passed = record.control.is_some_and(|control| control.verdict != Verdict::Refuted);
                    if now != then || passed {
                        let text = format!("{}: {now}, was {then}; control passed: {passed}", claim.id);
                        wrong.lock().expect("no panic").push(text);
                    }
                }
            });
        }
    });
    let wrong = wrong.into_inner().expect("no panic");
    assert!(wrong.is_empty(), "{wrong:#?}");
}
