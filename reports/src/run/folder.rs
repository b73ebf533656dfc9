//! The output folder of a run: `results.csv`, `journal.jsonl`, `cases/NNNN.json`, `witnesses/NNNN.json`, numbered by the
//! rows from 1; `claims.csv`, `claims/ID.json` and `witnesses/ID.json` by claim.

use crate::row::Record;
use serde::Serialize;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// A file of the folder that cannot be written or removed.
#[derive(Debug, thiserror::Error)]
#[error("{file}: {reason}")]
pub struct FolderError {
    /// The file or folder.
    pub file: PathBuf,
    /// What the system says.
    pub reason: String,
}

impl FolderError {
    /// The error about this file.
    #[must_use]
    pub fn new(file: &Path, reason: &impl ToString) -> Self {
        Self { file: file.to_path_buf(), reason: reason.to_string() }
    }
}

/// An output folder.
#[derive(Clone, Debug)]
pub struct Folder {
    path: PathBuf,
}

/// What a run leaves in its folder.
const FILES: [&str; 12] = [
    "results.csv",
    "claims.csv",
    "journal.jsonl",
    "environment.json",
    "goldens.csv",
    "timing.csv",
    "comparison.csv",
    "goals.csv",
    "iterated.csv",
    "index.html",
    "bench.html",
    "claims.html",
];
const FOLDERS: [&str; 4] = ["cases", "claims", "witnesses", "pictures"];

impl Folder {
    /// The folder, made if need be, with whatever is in it.
    ///
    /// # Errors
    /// When it cannot be made.
    pub fn open(path: &Path) -> Result<Self, FolderError> {
        for inner in ["cases", "claims", "witnesses"] {
            let inner = path.join(inner);
            std::fs::create_dir_all(&inner).map_err(|e| FolderError::new(&inner, &e))?;
        }
        Ok(Self { path: path.to_path_buf() })
    }

    /// The folder without what an earlier run left in it. Other files stay.
    ///
    /// # Errors
    /// When it cannot be made, or something cannot be removed.
    pub fn fresh(path: &Path) -> Result<Self, FolderError> {
        let files = FILES.iter().map(|f| (path.join(f), std::fs::remove_file(path.join(f))));
        let folders = FOLDERS.iter().map(|f| (path.join(f), std::fs::remove_dir_all(path.join(f))));
        for (file, removed) in files.chain(folders) {
            match removed {
                Err(e) if e.kind() != ErrorKind::NotFound => return Err(FolderError::new(&file, &e)),
                _ => {}
            }
        }
        Self::open(path)
    }

    /// A folder inside.
    #[must_use]
    pub fn inner(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// The journal.
    #[must_use]
    pub fn journal(&self) -> PathBuf {
        self.path.join("journal.jsonl")
    }

    /// Writes a table, at once as a whole.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn write_table<T: Serialize>(&self, name: &str, rows: impl Iterator<Item = T>) -> Result<(), FolderError> {
        let file = self.path.join(name);
        let wrong = |e: &dyn std::fmt::Display| FolderError::new(&file, &e.to_string());
        let mut writer = csv::Writer::from_writer(Vec::new());
        for row in rows {
            writer.serialize(row).map_err(|e| wrong(&e))?;
        }
        let bytes = writer.into_inner().map_err(|e| wrong(&e))?;
        write_whole(&file, &bytes)
    }

    /// Writes the record of a row.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn write_record(&self, number: usize, record: &Record) -> Result<(), FolderError> {
        write_json(&self.path.join("cases").join(format!("{number:04}.json")), record)
    }

    /// The file of the witness of a row.
    #[must_use]
    pub fn witness(&self, number: usize) -> PathBuf {
        self.path.join("witnesses").join(format!("{number:04}.json"))
    }
}

/// Writes a value as JSON, at once as a whole.
///
/// # Errors
/// When it cannot be written.
pub fn write_json(file: &Path, value: &impl Serialize) -> Result<(), FolderError> {
    let mut bytes = serde_json::to_vec(value).map_err(|e| FolderError::new(file, &e))?;
    bytes.push(b'\n');
    write_whole(file, &bytes)
}

/// Writes a file; whoever reads it meanwhile sees the old or the new one, never a part.
///
/// # Errors
/// When it cannot be written.
pub fn write_whole(file: &Path, bytes: &[u8]) -> Result<(), FolderError> {
    let draft = file.with_extension("part");
    let written = std::fs::write(&draft, bytes).and_then(|()| std::fs::rename(&draft, file));
    written.map_err(|e| FolderError::new(file, &e))
}
