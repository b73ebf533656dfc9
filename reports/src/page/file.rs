//! Files as pages read them: CSV as text or row by row, and JSON. The first fault ends in one sentence that names its line.

use super::PageError;
use csv::StringRecord;
use serde::de::DeserializeOwned;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// A CSV file as text.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The names of the columns.
    pub headers: StringRecord,
    /// The rows, each as long as `headers`.
    pub rows: Vec<StringRecord>,
}

/// The file's bytes, or `None` when there is no such file.
pub fn read(file: &Path) -> Result<Option<Vec<u8>>, PageError> {
    match fs::read(file) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(source) => Err(PageError::Io { file: file.to_owned(), source }),
    }
}

/// What a JSON file holds, or `None` when there is no such file.
pub fn json<T: DeserializeOwned>(file: &Path) -> Result<Option<T>, PageError> {
    let Some(bytes) = read(file)? else { return Ok(None) };
    serde_json::from_slice(&bytes).map(Some).map_err(|error| {
        let reason = error.to_string();
        let reason = reason.split(" at line ").next().unwrap_or_default().to_owned();
        PageError::Broken { file: file.to_owned(), line: error.line() as u64, reason }
    })
}

/// The bytes of a CSV file as text.
pub fn sheet(file: &Path, bytes: &[u8]) -> Result<Sheet, PageError> {
    let mut reader = csv::Reader::from_reader(bytes);
    let none = StringRecord::new();
    let headers = reader.headers().map_err(|error| broken_csv(file, &none, &error, &none))?.clone();
    let rows = reader.records().collect::<Result<_, _>>().map_err(|error| broken_csv(file, &none, &error, &headers))?;
    Ok(Sheet { headers, rows })
}

/// A fault of a CSV file in words, with the line of the row it is in.
pub fn broken_csv(file: &Path, row: &StringRecord, error: &csv::Error, headers: &StringRecord) -> PageError {
    let position = error.position().or(row.position());
    let reason = match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("the row has {len} fields, the header {expected_len}")
        }
        csv::ErrorKind::Utf8 { .. } => "the row is not UTF-8".to_owned(),
        csv::ErrorKind::Deserialize { err, .. } => {
            let column = err.field().and_then(|i| headers.get(usize::try_from(i).ok()?));
            column.map_or(err.kind().to_string(), |name| format!("column {name}: {}", err.kind()))
        }
        other => format!("{other:?}"),
    };
    PageError::Broken { file: file.to_owned(), line: position.map_or(1, csv::Position::line), reason }
}

/// The rows of a CSV file, as text and as what they say; `None` when there is no such file.
pub fn rows<T: DeserializeOwned>(file: &Path) -> Result<Option<(Sheet, Vec<T>)>, PageError> {
    let Some(bytes) = read(file)? else { return Ok(None) };
    let sheet = sheet(file, &bytes)?;
    let row = |cells: &StringRecord| {
        cells.deserialize(Some(&sheet.headers)).map_err(|error| broken_csv(file, cells, &error, &sheet.headers))
    };
    let rows = sheet.rows.iter().map(row).collect::<Result<_, _>>()?;
    Ok(Some((sheet, rows)))
}
