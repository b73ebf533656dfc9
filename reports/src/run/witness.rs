//! Witnesses: a case that shows something, with what was measured, so that anybody can measure it again.
//!
//! A run keeps one for every row that failed (not ok, or a failed check) and for the worst row of each family and engine.

use super::folder::{Folder, FolderError, write_json};
use super::plan::Plan;
use crate::cases::Case;
use crate::row::{Row, Status};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// A witness file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Witness {
    /// What it shows, for people.
    pub claim: String,
    /// The engine.
    pub engine: String,
    /// Its options, as the engine names them; all engines run with their defaults so far.
    pub options: String,
    /// The seed of the run, for built-in cases.
    pub seed: Option<u64>,
    /// The version of the program that wrote this.
    pub version: String,
    /// The case, as exact doubles.
    pub case: Case,
    /// What was measured.
    pub measured: Row,
}

impl Witness {
    /// Reads a witness file.
    ///
    /// # Errors
    /// One sentence naming the file, and the place where it is no witness.
    pub fn read(file: &Path) -> Result<Self, FolderError> {
        let text = std::fs::read_to_string(file).map_err(|e| FolderError::new(file, &e))?;
        serde_json::from_str(&text).map_err(|e| FolderError::new(file, &format!("no witness: {e}")))
    }

    /// What differs in a new measurement; nothing when the witness still holds.
    ///
    /// It holds when the status and the failed checks are the same and the brackets of mu have a number in common.
    #[must_use]
    pub fn changes(&self, now: &Row) -> Vec<String> {
        let then = &self.measured;
        let mut changes = Vec::new();
        if now.status != then.status {
            changes.push(format!("status {:?}, was {:?}", now.status, then.status));
        }
        if now.failed_checks != then.failed_checks {
            changes.push(format!("failed checks {:?}, were {:?}", now.failed_checks, then.failed_checks));
        }
        let bracket = |r: &Row| (r.mu_lo.unwrap_or(0.0), r.mu_hi.unwrap_or(f64::INFINITY));
        let ((lo, hi), (old_lo, old_hi)) = (bracket(now), bracket(then));
        if lo > old_hi || hi < old_lo {
            changes.push(format!("mu in [{lo:e}, {hi:e}], was in [{old_lo:e}, {old_hi:e}]"));
        }
        changes
    }
}

/// Writes the witnesses of a finished run.
pub(super) fn keep(plan: &Plan, folder: &Folder, rows: &[Row]) -> Result<(), FolderError> {
    let worst = worst(rows);
    for (index, row) in rows.iter().enumerate() {
        let key = (row.family.as_str(), row.engine.as_str());
        let claim = if failed(row) {
            failure(row)
        } else if worst.get(&key) == Some(&index) {
            format!("the least accurate result of {} in the family {}", row.engine, row.family)
        } else {
            continue;
        };
        let witness = Witness {
            claim,
            engine: row.engine.clone(),
            options: "default".into(),
            seed: row.seed,
            version: env!("CARGO_PKG_VERSION").into(),
            case: plan.cases[plan.jobs[index].case].clone(),
            measured: row.clone(),
        };
        write_json(&folder.witness(index + 1), &witness)?;
    }
    Ok(())
}

/// Whether a row shows something wrong: not ok, or a failed check. A reference that gave up shows nothing.
fn failed(row: &Row) -> bool {
    let checked = row.failed_checks.as_deref().is_none_or(|c| c == "none");
    !checked || !matches!(row.status, Status::Ok | Status::Undecided | Status::Sampled)
}

fn failure(row: &Row) -> String {
    match row.failed_checks.as_deref() {
        Some(checks) if checks != "none" => format!("{} fails the checks: {checks}", row.engine),
        _ => format!("{}: {}", row.engine, row.note),
    }
}

/// The index of the row with the largest lower bound of mu, for each family and engine.
fn worst(rows: &[Row]) -> BTreeMap<(&str, &str), usize> {
    let mut worst: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    for (index, row) in rows.iter().enumerate() {
        let Some(mu) = row.mu_lo else { continue };
        let kept = worst.entry((&row.family, &row.engine)).or_insert(index);
        if rows[*kept].mu_lo.is_none_or(|best| mu > best) {
            *kept = index;
        }
    }
    worst
}
