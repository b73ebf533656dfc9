//! Carrying out the experiments: a claim a thread, each finding on disk as soon as it is known.
//!
//! Every experiment draws its own random numbers, so the findings are the same for any number of threads.

use super::Claim;
use super::bench::{Bench, Effort};
use super::record::Record;
use super::witness::ClaimWitness;
use crate::run::folder::{Folder, FolderError, write_json};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc;

/// How claims are tested.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// How much effort is made.
    pub effort: Effort,
    /// The seed.
    pub seed: u64,
    /// Experiments at a time.
    pub threads: usize,
    /// Whether findings that the folder holds, of the same effort, seed and version, are taken for done.
    pub resume: bool,
}

/// Tests the claims and writes their files; hands each record to `each` as it comes. The records are in the order of the
/// claims; there are fewer if the run was stopped.
///
/// # Errors
/// When a file cannot be written.
pub fn run(
    claims: &[Claim],
    settings: &Settings,
    folder: &Folder,
    stop: &AtomicBool,
    mut each: impl FnMut(&Record),
) -> Result<Vec<Record>, FolderError> {
    let bench = Bench { effort: settings.effort, seed: settings.seed, stop };
    let mut records: Vec<Option<Record>> = claims.iter().map(|claim| done(claim, settings, folder)).collect();
    let open: Vec<usize> = (0..claims.len()).filter(|&i| records[i].is_none()).collect();
    let next = AtomicUsize::new(0);
    let (sender, found) = mpsc::channel();
    std::thread::scope(|scope| {
        for _ in 0..settings.threads.clamp(1, open.len().max(1)) {
            let (next, open, sender) = (&next, &open, sender.clone());
            scope.spawn(move || {
                while let Some(&index) = open.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let record = Record::of(&claims[index], &bench);
                    // What was cut short is no finding.
                    if bench.stopped() || sender.send((index, record)).is_err() {
                        return;
                    }
                }
            });
        }
        drop(sender);
        for (index, record) in found {
            each(&record);
            folder.write_claim(&record)?;
            records[index] = Some(record);
            folder.write_table("claims.csv", records.iter().flatten().map(Record::row))?;
        }
        Ok(())
    })?;
    folder.write_table("claims.csv", records.iter().flatten().map(Record::row))?;
    Ok(records.into_iter().flatten().collect())
}

/// The record of an earlier run, if it is of the same kind.
fn done(claim: &Claim, settings: &Settings, folder: &Folder) -> Option<Record> {
    let text = std::fs::read_to_string(folder.claim(&claim.stem())).ok().filter(|_| settings.resume)?;
    let record: Record = serde_json::from_str(&text).ok()?;
    let same = (record.effort, record.seed) == (settings.effort, settings.seed);
    (same && record.version == env!("CARGO_PKG_VERSION")).then_some(record)
}

impl Folder {
    /// The file of a claim's record.
    #[must_use]
    pub fn claim(&self, stem: &str) -> std::path::PathBuf {
        self.inner("claims").join(format!("{stem}.json"))
    }

    /// Writes a claim's record, and its worst input as a witness.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn write_claim(&self, record: &Record) -> Result<(), FolderError> {
        if let Some(worst) = &record.finding.worst {
            let witness =
                ClaimWitness { claim: record.id.clone(), version: record.version.clone(), worst: worst.clone() };
            write_json(&self.inner("witnesses").join(format!("{}.json", record.stem())), &witness)?;
        }
        write_json(&self.claim(&record.stem()), record)
    }
}
