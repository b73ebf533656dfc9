//! What engines of others get wrong, each kept as a small witness that is measured again: whoever updates an engine is told
//! that it got better. An engine whose feature is off is skipped, and the test says so.
//!
//! By their names, what is wrong:
//!
//! - `false_hole`: Clipper2's own sum is that of the two boundaries, so that it has a hole where one operand fits inside the
//!   other.
//! - `empty_fork`: polyclip's own sum of a fork whose sum has 9,801 holes is `Ok` and empty, or in debug builds
//!   a panic.
//! - `coarse_arcs`, `slivers`: iCurve's union loses crossings of arcs: it is wrong by thousands of its roundings, or has slivers
//!   beside the sum.

use arcsum_reports::engine::peer::Peer;
use arcsum_reports::engine::{Engine, EngineError};
use arcsum_reports::judge::judge;
use arcsum_reports::row::{Row, Status};
use arcsum_reports::run::plan::Plan;
use arcsum_reports::run::record::assemble;
use arcsum_reports::run::witness::Witness;
use arcsum_reports::worker::Outcome;
use std::fs;
use std::path::Path;

fn witnesses() -> Vec<(String, Witness)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("witnesses/peers");
    let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path());
    let mut files: Vec<_> = files.collect();
    files.sort();
    assert!(!files.is_empty());
    let name = |file: &Path| file.file_stem().expect("a name").to_string_lossy().into_owned();
    files.iter().map(|file| (name(file), Witness::read(file).expect("a witness"))).collect()
}

/// What an engine does with the case of a witness now.
fn measured(witness: &Witness, engine: &mut dyn Engine) -> Row {
    let Witness { case, engine: name, .. } = witness;
    let outcome = match engine.sum(&case.a, &case.b) {
        Ok(answer) => Outcome { judgement: Some(judge(case, name, &answer)), answer: Some(answer), failure: None },
        Err(error) => Outcome { failure: Some(failure(error)), ..Outcome::default() },
    };
    let plan = Plan::new(vec![case.clone()], std::slice::from_ref(name)).expect("an engine");
    assemble(&plan, 0, outcome).row
}

fn failure(error: EngineError) -> (Status, String) {
    match error {
        EngineError::Invalid(note) => (Status::Invalid, note),
        EngineError::Crashed(note) => (Status::Crashed, note),
    }
}

/// Whether a row shows a mistake: no region, a wrong one, or holes and islands that are none.
fn mistaken(row: &Row) -> bool {
    let checks = row.failed_checks.as_deref().unwrap_or("none");
    row.status != Status::Ok || checks.split(' ').any(|check| check == "loops") || row.mu_lo > Some(1e-7)
}

#[test]
fn mistakes_of_others_are_still_made() {
    let mut better = Vec::new();
    for (name, witness) in witnesses() {
        assert!(mistaken(&witness.measured), "{name} shows no mistake");
        let Some(mut peer) = Peer::named(&witness.engine) else {
            eprintln!("skipped {name}: {} is not built in", witness.engine);
            continue;
        };
        let now = measured(&witness, &mut peer);
        // What is an empty answer in release is a failed assertion of theirs in a debug build.
        let still_none = witness.measured.status != Status::Ok && now.status != Status::Ok;
        let changes = if still_none { Vec::new() } else { witness.changes(&now) };
        if !changes.is_empty() {
            better.push(format!("{name}, of {}: {}", witness.engine, changes.join("; ")));
        }
    }
    assert!(better.is_empty(), "these witnesses hold no longer, so take them out: {better:#?}");
}

/// The engine of this project makes none of these mistakes.
#[test]
fn ours_are_right_there() {
    for (name, witness) in witnesses() {
        if witness.case.segments() > MOST {
            continue;
        }
        let mut engine = arcsum_reports::engine::own::Own::named("monotonic").expect("ours");
        let answer = engine.sum(&witness.case.a, &witness.case.b).expect("valid");
        let judgement = judge(&witness.case, "monotonic", &answer);
        assert!(judgement.mu_hi < Some(1e-14), "{name}: {judgement:?}");
        assert!(!judgement.failed_checks.contains(&"loops".to_owned()), "{name}: {judgement:?}");
    }
}

/// More segments than this cost the references minutes.
const MOST: usize = 40;

/// A right answer to the case of a witness is told apart from the mistake.
#[test]
fn a_witness_of_a_better_engine_does_not_hold() {
    let (_, witness) = witnesses().into_iter().find(|(name, _)| name == "false_hole").expect("a witness");
    let mut right = arcsum_reports::engine::own::Own::named("kinetic").expect("ours");
    let row = measured(&Witness { engine: "kinetic".into(), ..witness.clone() }, &mut right);
    assert!(!mistaken(&row) && !witness.changes(&row).is_empty(), "{row:?}");
}
