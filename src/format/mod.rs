//! Regions as files (design of the file formats): one region a file, the format told by the file's extension.
//!
//! Reading checks the grammar, [`crate::validate`] the shape; [`load`] does both. Every error is one sentence that names
//! the file, the place and the reason.

pub mod json;

use crate::region::Region;
use crate::validate::{Invalid, MAX_VERTICES, validate};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The greatest length of a region file in bytes: [`MAX_VERTICES`] vertices at 256 bytes each.
pub const MAX_BYTES: u64 = MAX_VERTICES as u64 * 256;

/// Why a text is not a region.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum FormatError {
    /// The text breaks the grammar of its format, or ends early.
    #[error("line {line}, column {column}: {reason}")]
    Syntax {
        /// Line, from 1.
        line: usize,
        /// Column in bytes, from 1; 0 before the first byte of a line.
        column: usize,
        /// What was found or expected.
        reason: String,
    },
    /// The text keeps the grammar but says something else than a region: a missing, repeated or wrong field.
    #[error("line {line}, column {column}: {reason}")]
    Content {
        /// Line, from 1.
        line: usize,
        /// Column in bytes.
        column: usize,
        /// What was found or expected.
        reason: String,
    },
    /// A number is beyond the range of doubles.
    #[error("line {line}, column {column}: the number is not finite")]
    NotFinite {
        /// Line, from 1.
        line: usize,
        /// Column in bytes.
        column: usize,
    },
    /// There are more than [`MAX_VERTICES`] vertices.
    #[error("the region is too large: {vertices} vertices, at most {MAX_VERTICES} are allowed")]
    TooLarge {
        /// The number of vertices.
        vertices: usize,
    },
}

/// Why a file gives no region.
#[derive(Debug, Error)]
#[error("{}: {cause}", path.display())]
pub struct FileError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong with it.
    #[source]
    pub cause: Cause,
}

/// What is wrong with a file.
#[derive(Debug, Error)]
pub enum Cause {
    /// It cannot be read.
    #[error("cannot be read: {0}")]
    Io(#[from] std::io::Error),
    /// Its extension names no format of regions.
    #[error("the extension is not that of a region file (json)")]
    UnknownFormat,
    /// It is longer than [`MAX_BYTES`].
    #[error("the file is too large: at most {MAX_BYTES} bytes are allowed")]
    TooLarge,
    /// It is not UTF-8.
    #[error("byte {0} is not part of a UTF-8 text")]
    NotText(usize),
    /// Its text is not a region.
    #[error("{0}")]
    Format(#[from] FormatError),
    /// Its region is not valid.
    #[error("{0}")]
    Invalid(#[from] Invalid),
}

/// Reads a region from a file. The region may still be invalid; [`load`] excludes that.
pub fn read_file(path: &Path) -> Result<Region, FileError> {
    parse(path).map_err(|cause| FileError { path: path.to_owned(), cause })
}

/// Reads a region from a file and validates it.
pub fn load(path: &Path) -> Result<Region, FileError> {
    let valid = |region: Region| validate(&region).map(|()| region).map_err(Cause::from);
    parse(path).and_then(valid).map_err(|cause| FileError { path: path.to_owned(), cause })
}

fn parse(path: &Path) -> Result<Region, Cause> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    if !extension.eq_ignore_ascii_case("json") {
        return Err(Cause::UnknownFormat);
    }
    Ok(json::read(&read_text(path)?)?)
}

fn read_text(path: &Path) -> Result<String, Cause> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(Cause::TooLarge);
    }
    String::from_utf8(bytes).map_err(|e| Cause::NotText(e.utf8_error().valid_up_to()))
}
