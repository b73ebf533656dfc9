//! The journal of a run, `journal.jsonl`: a line for each row as soon as it is known, so that an interrupted run can go
//! on. The first line says which run it is; a last line cut short by a crash is dropped.

use crate::judge::golden::Verdict;
use crate::row::Row;
use serde::{Deserialize, Serialize};
use std::fs::{File, OpenOptions};
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Why a journal cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// It cannot be read or written.
    #[error("{file}: {source}")]
    Io {
        /// The journal.
        file: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// It belongs to a run of other cases, engines or seed.
    #[error("{0}: this folder holds a run of other cases, engines or seed; it cannot be resumed")]
    OtherRun(PathBuf),
    /// A line in its middle is not a row.
    #[error("{file}, line {line}: not a row of a run")]
    Broken {
        /// The journal.
        file: PathBuf,
        /// The line, from 1.
        line: usize,
    },
}

/// A row with its number, from 1, in the order of the plan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    /// The number.
    pub number: usize,
    /// The row.
    pub row: Row,
    /// The verdict on somebody else's claim, where the case has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub golden: Option<Verdict>,
}

/// The first line.
#[derive(Serialize, Deserialize)]
struct Header {
    run: String,
}

/// An open journal.
#[derive(Debug)]
pub struct Journal {
    file: File,
    path: PathBuf,
}

impl Journal {
    /// Opens the journal of the run `fingerprint`: empty, or with `resume` what is there, and the rows in it.
    ///
    /// # Errors
    /// When it cannot be read or written, belongs to another run, or is broken before its last line.
    pub fn open(path: &Path, fingerprint: &str, resume: bool) -> Result<(Self, Vec<Entry>), JournalError> {
        let io = |source| JournalError::Io { file: path.to_path_buf(), source };
        let text = match std::fs::read_to_string(path) {
            Ok(text) if resume => text,
            Err(e) if resume && e.kind() != std::io::ErrorKind::NotFound => return Err(io(e)),
            _ => String::new(),
        };
        let whole = text.rfind('\n').map_or("", |end| &text[..=end]);
        let entries = parse(path, whole, fingerprint)?;
        let mut file = OpenOptions::new().create(true).write(true).truncate(false).open(path).map_err(io)?;
        file.set_len(whole.len() as u64).map_err(io)?;
        file.seek(SeekFrom::End(0)).map_err(io)?;
        let mut journal = Self { file, path: path.to_path_buf() };
        if whole.is_empty() {
            journal.line(&Header { run: fingerprint.to_owned() })?;
        }
        Ok((journal, entries))
    }

    /// Writes a row down; it is with the system when this returns.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn append(&mut self, entry: &Entry) -> Result<(), JournalError> {
        self.line(entry)
    }

    fn line(&mut self, value: &impl Serialize) -> Result<(), JournalError> {
        let written = serde_json::to_string(value).map_err(std::io::Error::from);
        // One write a line: a killed run leaves at most one line cut short.
        let written = written.and_then(|text| self.file.write_all(format!("{text}\n").as_bytes()));
        written.map_err(|source| JournalError::Io { file: self.path.clone(), source })
    }
}

fn parse(path: &Path, text: &str, fingerprint: &str) -> Result<Vec<Entry>, JournalError> {
    let mut lines = text.lines().enumerate();
    let Some((_, first)) = lines.next() else { return Ok(Vec::new()) };
    if serde_json::from_str::<Header>(first).map(|h| h.run).ok().as_deref() != Some(fingerprint) {
        return Err(JournalError::OtherRun(path.to_path_buf()));
    }
    let entry = |(i, line): (usize, &str)| {
        serde_json::from_str(line).map_err(|_| JournalError::Broken { file: path.to_path_buf(), line: i + 1 })
    };
    lines.map(entry).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::row::tests::row;

    fn entry(number: usize) -> Entry {
        Entry { number, row: row(), golden: None }
    }

    #[test]
    fn a_cut_line_is_dropped_and_the_rest_goes_on() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal.jsonl");
        let (mut journal, none) = Journal::open(&path, "run", false).unwrap();
        assert!(none.is_empty());
        journal.append(&entry(1)).unwrap();
        journal.append(&entry(2)).unwrap();
        drop(journal);
        let text = std::fs::read_to_string(&path).unwrap();
        std::fs::write(&path, &text[..text.len() - 5]).unwrap();
        let (mut journal, kept) = Journal::open(&path, "run", true).unwrap();
        assert_eq!(kept, [entry(1)]);
        journal.append(&entry(3)).unwrap();
        let (_, kept) = Journal::open(&path, "run", true).unwrap();
        assert_eq!(kept, [entry(1), entry(3)]);
    }

    #[test]
    fn another_run_is_refused_and_a_fresh_one_starts_over() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal.jsonl");
        Journal::open(&path, "run", false).unwrap().0.append(&entry(1)).unwrap();
        assert!(matches!(Journal::open(&path, "other", true), Err(JournalError::OtherRun(_))));
        assert!(Journal::open(&path, "other", false).unwrap().1.is_empty());
    }
}
