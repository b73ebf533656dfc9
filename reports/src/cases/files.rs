//! Regions from files: read, checked, and turned away in one sentence when they are no regions.

use arcsum::format;
use arcsum::region::Region;
use std::path::Path;

/// A file that holds no region to be measured; the message names the file, the place and the reason.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct BadFile(pub String);

/// The extensions of region files.
const EXTENSIONS: [&str; 4] = ["json", "wkt", "dxf", "svg"];

/// Reads and checks the region in a file.
///
/// # Errors
/// One sentence when the file cannot be read, is malformed, or its region is invalid.
pub fn read(path: &Path) -> Result<Region, BadFile> {
    format::load(path).map_err(|e| BadFile(e.to_string()))
}

/// Whether the name of the file is that of a region file.
#[must_use]
pub fn is_region_file(path: &Path) -> bool {
    let extension = path.extension().and_then(|e| e.to_str()).map(str::to_ascii_lowercase);
    path.is_file() && extension.is_some_and(|e| EXTENSIONS.contains(&e.as_str()))
}

/// The name of the file without folder and extension.
#[must_use]
pub fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned())
}
