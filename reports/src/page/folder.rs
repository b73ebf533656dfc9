//! An output folder as the page reads it: `results.csv` row by row, the other tables as text, and the records.
//!
//! Only `results.csv` must be there. What is there must be sound: the first fault ends in one sentence.

use super::PageError;
use super::file::{Sheet, broken_csv, json, read, sheet};
use crate::row::{Record, Row};
use csv::StringRecord;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// A row of `results.csv`.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its number, from 1: the number of its record and picture too.
    pub number: usize,
    /// What it says.
    pub row: Row,
    /// How the file says it, field by field.
    pub cells: StringRecord,
}

/// What an output folder holds, the records excepted: those are read one at a time.
#[derive(Debug)]
pub struct Folder {
    dir: PathBuf,
    /// The columns of `results.csv`.
    pub headers: StringRecord,
    /// Its rows, in their order.
    pub entries: Vec<Entry>,
    /// `environment.json`: any JSON object.
    pub environment: Option<BTreeMap<String, serde_json::Value>>,
}

impl Entry {
    /// The number as files have it: four digits or more.
    pub fn file_stem(&self) -> String {
        format!("{:04}", self.number)
    }
}

impl Folder {
    /// Reads `results.csv` and `environment.json`.
    ///
    /// # Errors
    ///
    /// If `results.csv` is missing, or either file cannot be read or does not have its format.
    pub fn read(dir: &Path) -> Result<Self, PageError> {
        let file = dir.join("results.csv");
        let bytes = fs::read(&file).map_err(|source| PageError::Io { file: file.clone(), source })?;
        let sheet = sheet(&file, &bytes)?;
        let mut entries = Vec::with_capacity(sheet.rows.len());
        for (index, cells) in sheet.rows.into_iter().enumerate() {
            let row = cells
                .deserialize(Some(&sheet.headers))
                .map_err(|error| broken_csv(&file, &cells, &error, &sheet.headers))?;
            entries.push(Entry { number: index + 1, row, cells });
        }
        let environment = json(&dir.join("environment.json"))?;
        Ok(Self { dir: dir.to_owned(), headers: sheet.headers, entries, environment })
    }

    /// A table of the folder, or `None` when there is no such file.
    ///
    /// # Errors
    ///
    /// If the file cannot be read or is not CSV.
    pub fn sheet(&self, name: &str) -> Result<Option<Sheet>, PageError> {
        let file = self.dir.join(name);
        read(&file)?.map(|bytes| sheet(&file, &bytes)).transpose()
    }

    /// Whether a file of this name is in the folder.
    pub fn has(&self, name: &str) -> bool {
        self.dir.join(name).is_file()
    }

    /// The record of an entry, or `None` when it has none.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, is not a record, or is that of another case or engine.
    pub fn record(&self, entry: &Entry) -> Result<Option<Record>, PageError> {
        let file = self.dir.join("cases").join(entry.file_stem() + ".json");
        let Some(record) = json::<Record>(&file)? else { return Ok(None) };
        if (&record.row.case, &record.row.engine) != (&entry.row.case, &entry.row.engine) {
            let reason = format!("the record is that of case {:?}, engine {:?}", record.row.case, record.row.engine);
            return Err(PageError::Broken { file, line: 1, reason });
        }
        Ok(Some(record))
    }

    /// The witness of an entry relative to the folder, if there is one.
    pub fn witness(&self, entry: &Entry) -> Option<String> {
        let name = format!("witnesses/{}.json", entry.file_stem());
        self.dir.join(&name).is_file().then_some(name)
    }
}
