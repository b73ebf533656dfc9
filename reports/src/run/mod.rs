//! A run: every engine on every case, in worker processes, each result on disk as soon as it is known.

pub mod folder;
pub mod journal;
pub mod plan;
pub mod pool;
pub mod progress;
pub mod record;
pub mod witness;

use crate::row::{Record, Row, Status};
use folder::Folder;
use journal::{Entry, Journal};
use plan::Plan;
use pool::{Pool, PoolError};
use progress::Progress;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

/// How often `results.csv` is brought up to date while a run goes on. The journal never lags behind.
const REFRESH: Duration = Duration::from_secs(2);

/// How a run is carried out. None of this changes the results, time limits excepted.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The output folder.
    pub out: PathBuf,
    /// Worker processes at a time.
    pub threads: usize,
    /// Time for the engine, and again for the reference, on a case.
    pub limit: Duration,
    /// Whether to go on with an interrupted run in the same folder.
    pub resume: bool,
    /// The program whose command `worker` serves.
    pub program: PathBuf,
}

/// What ended a run early.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// Writing or reading a file of the output folder.
    #[error(transparent)]
    Folder(#[from] folder::FolderError),
    /// The journal is of another run.
    #[error(transparent)]
    Journal(#[from] journal::JournalError),
    /// The workers.
    #[error(transparent)]
    Pool(#[from] PoolError),
}

/// The outcome of a run.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// The rows, in the order of the plan; without those an interrupt left undone.
    pub rows: Vec<Row>,
    /// Whether the run was stopped before its end.
    pub interrupted: bool,
}

/// Carries out the plan.
///
/// # Errors
/// When the folder cannot be used, holds another run to be resumed, or no worker starts.
pub fn run(plan: &Plan, settings: &Settings, stop: &AtomicBool) -> Result<Summary, RunError> {
    let folder = if settings.resume { Folder::open(&settings.out)? } else { Folder::fresh(&settings.out)? };
    let (mut journal, done) = Journal::open(&folder.journal(), &plan.fingerprint(), settings.resume)?;
    let mut entries: Vec<Option<Entry>> = vec![None; plan.jobs.len()];
    for entry in done {
        if let Some(place) = entry.number.checked_sub(1).and_then(|i| entries.get_mut(i)) {
            *place = Some(entry);
        }
    }
    let open: Vec<usize> = (0..entries.len()).filter(|&i| entries[i].is_none()).collect();
    let progress = Progress::new(entries.len(), entries.len() - open.len());
    let mut refreshed = Instant::now();
    let pool = Pool { program: &settings.program, threads: settings.threads, limit: settings.limit };
    let ended = pool.measure(plan, &open, stop, |job, mut outcome| -> Result<(), RunError> {
        let golden = outcome.judgement.as_mut().and_then(|j| j.golden.take());
        let record = record::assemble(plan, job, outcome);
        folder.write_record(job + 1, &record)?;
        let entry = Entry { number: job + 1, row: record.row, golden };
        journal.append(&entry)?;
        progress.done(&entry.row);
        entries[job] = Some(entry);
        if refreshed.elapsed() >= REFRESH {
            write_tables(&folder, &entries)?;
            refreshed = Instant::now();
        }
        Ok(())
    });
    write_tables(&folder, &entries)?;
    let interrupted = match ended {
        Err(RunError::Pool(PoolError::Stopped)) => true,
        other => other.map(|()| false)?,
    };
    let rows: Vec<Row> = entries.into_iter().flatten().map(|e| e.row).collect();
    progress.finish(&rows);
    if !interrupted {
        witness::keep(plan, &folder, &rows)?;
    }
    Ok(Summary { rows, interrupted })
}

/// Writes `results.csv`, and `goldens.csv` if there are any.
fn write_tables(folder: &Folder, entries: &[Option<Entry>]) -> Result<(), RunError> {
    let known = || entries.iter().flatten();
    folder.write_table("results.csv", known().map(|e| &e.row))?;
    if known().any(|e| e.golden.is_some()) {
        folder.write_table("goldens.csv", known().filter_map(|e| e.golden.as_ref()))?;
    }
    Ok(())
}

impl Summary {
    /// The rows of this status.
    #[must_use]
    pub fn count(&self, status: Status) -> usize {
        self.rows.iter().filter(|r| r.status == status).count()
    }
}

/// Measures one case alone, without a folder.
///
/// # Errors
/// When no worker starts.
pub fn measure_one(plan: &Plan, settings: &Settings, stop: &AtomicBool) -> Result<Option<Record>, RunError> {
    let pool = Pool { program: &settings.program, threads: 1, limit: settings.limit };
    let mut measured = None;
    pool.measure(plan, &[0], stop, |job, outcome| -> Result<(), RunError> {
        measured = Some(record::assemble(plan, job, outcome));
        Ok(())
    })?;
    Ok(measured)
}
