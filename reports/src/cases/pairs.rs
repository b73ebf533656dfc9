//! `pairs.csv`: which files of a folder are to be summed with which, and what others say the sum is.
//!
//! Columns `family, case, A, B` and optionally `golden`; further columns are ignored. Paths are relative to the folder of
//! `pairs.csv`; several files separated by `;` make one region of all their loops. A pair with a golden is one of the
//! no-fit polygon: its second operand is -B.

use super::files::{BadFile, read};
use super::{Case, Golden};
use arcsum::region::Region;
use arcsum::validate;
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// A line of `pairs.csv`.
#[derive(Clone, Debug, Deserialize)]
struct Line {
    case: String,
    #[serde(rename = "A")]
    a: String,
    #[serde(rename = "B")]
    b: String,
    #[serde(default)]
    golden: Option<String>,
}

/// The file `pairs.csv` that speaks about `folder`: in it, or in its parent.
#[must_use]
pub fn listing(folder: &Path) -> Option<PathBuf> {
    let parent = folder.canonicalize().ok()?.parent().map(Path::to_path_buf);
    [Some(folder.to_path_buf()), parent].into_iter().flatten().map(|f| f.join("pairs.csv")).find(|p| p.is_file())
}

/// The pairs of `listing` whose first file lies in `folder`, those with unusable files as sentences.
///
/// # Errors
/// When the listing itself cannot be read.
pub fn pairs(listing: &Path, folder: &Path, family: &str) -> Result<Vec<Result<Case, BadFile>>, BadFile> {
    let broken = |e: csv::Error| BadFile(format!("{}: {e}", listing.display()));
    let base = listing.parent().unwrap_or(Path::new("."));
    let mut cases = Vec::new();
    for line in csv::Reader::from_path(listing).map_err(broken)?.into_deserialize() {
        let line: Line = line.map_err(broken)?;
        let first = base.join(line.a.split(';').next().unwrap_or_default());
        let same_folder = first.parent().is_some_and(|p| p.canonicalize().ok() == folder.canonicalize().ok());
        if same_folder {
            cases.push(pair(&line, base, family));
        }
    }
    Ok(cases)
}

fn pair(line: &Line, base: &Path, family: &str) -> Result<Case, BadFile> {
    let a = joined(&line.a, base)?;
    let b = joined(&line.b, base)?;
    let name = format!("{family}/{}", line.case);
    let golden = match line.golden.as_deref() {
        None | Some("") => return Ok(Case { name, family: family.to_owned(), a, b, seed: None, golden: None }),
        // Inner loops are printed like outer ones; together the loops are no valid region.
        Some(golden) => together(golden, base)?,
    };
    // The reference point of libnfporb is the first vertex of the moving part.
    let shift = b.loops.first().and_then(|l| l.first()).map_or([0.0, 0.0], |n| [n.x, n.y]);
    let golden = Some(Golden { region: golden, shift });
    Ok(Case { name, family: family.to_owned(), a, b: b.negated(), seed: None, golden })
}

/// The region of all files; each is valid, and so they must be together.
fn joined(files: &str, base: &Path) -> Result<Region, BadFile> {
    let region = together(files, base)?;
    validate::validate(&region).map_err(|e| BadFile(format!("{}: {e}", base.join(files).display())))?;
    Ok(region)
}

fn together(files: &str, base: &Path) -> Result<Region, BadFile> {
    let mut regions = files.split(';').map(|file| read(&base.join(file)));
    let mut region = regions.next().unwrap_or_else(|| Err(BadFile("a pair names no file".into())))?;
    for more in regions {
        region.loops.extend(more?.loops);
    }
    Ok(region)
}
