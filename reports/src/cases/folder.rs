//! The cases of files and folders.
//!
//! A folder is a family: the pairs that `pairs.csv` in it or in its parent names, then each region with its own partners.
//! Where none is named each region also meets the next one. Folders in a folder are families of their own. Files named on their own are treated
//! like a folder without `pairs.csv`.

use super::Case;
use super::files::{BadFile, is_region_file, read, stem};
use super::pairs::{listing, pairs};
use super::partner::partners;
use arcsum::region::Region;
use std::path::{Path, PathBuf};

/// The cases found, and the files that could not be used.
#[derive(Debug, Default)]
pub struct Found {
    /// The cases, in the order of the pairs and of the sorted file names.
    pub cases: Vec<Case>,
    /// A sentence for each unusable file.
    pub bad: Vec<BadFile>,
}

impl Found {
    /// Appends what another source gave, each bad file once.
    pub fn extend(&mut self, other: Self) {
        self.cases.extend(other.cases);
        for bad in other.bad {
            self.reject(bad);
        }
    }

    fn reject(&mut self, bad: BadFile) {
        if !self.bad.contains(&bad) {
            self.bad.push(bad);
        }
    }
}

/// The cases of a folder and the folders in it; none when no region files are there.
///
/// # Errors
/// When a folder or its `pairs.csv` cannot be read.
pub fn folder(path: &Path) -> Result<Found, BadFile> {
    let (files, folders) = entries(path)?;
    let mut found = Found::default();
    if !files.is_empty() {
        let family = family_name(path);
        let listed = match listing(path) {
            Some(csv) => pairs(&csv, path, &family)?,
            None => Vec::new(),
        };
        let paired = !listed.is_empty();
        for case in listed {
            match case {
                Ok(case) => found.cases.push(case),
                Err(bad) => found.reject(bad),
            }
        }
        found.extend(singles(&files, &family, !paired));
    }
    for inner in &folders {
        found.extend(folder(inner)?);
    }
    Ok(found)
}

/// The cases of files named one by one: each region with its partners and with the next region.
#[must_use]
pub fn files(paths: &[PathBuf]) -> Found {
    singles(paths, "files", true)
}

fn singles(paths: &[PathBuf], family: &str, with_next: bool) -> Found {
    let mut found = Found::default();
    let mut before: Option<(String, Region)> = None;
    for path in paths {
        let region = match read(path) {
            Ok(region) => region,
            Err(bad) => {
                found.reject(bad);
                continue;
            }
        };
        let name = format!("{family}/{}", stem(path));
        for (label, partner) in partners(&region) {
            found.cases.push(case(format!("{name}_{label}"), family, &region, partner));
        }
        if let Some((first, other)) = before.take().filter(|_| with_next) {
            found.cases.push(case(format!("{first}+{}", stem(path)), family, &other, region.clone()));
        }
        before = Some((name, region));
    }
    found
}

fn case(name: String, family: &str, a: &Region, b: Region) -> Case {
    Case { name, family: family.to_owned(), a: a.clone(), b, seed: None, golden: None }
}

/// The region files and the folders in a folder, sorted by name.
fn entries(path: &Path) -> Result<(Vec<PathBuf>, Vec<PathBuf>), BadFile> {
    let broken = |e: std::io::Error| BadFile(format!("{}: {e}", path.display()));
    let mut all: Vec<PathBuf> = std::fs::read_dir(path)
        .map_err(broken)?
        .map(|e| e.map(|e| e.path()))
        .collect::<Result<_, _>>()
        .map_err(broken)?;
    all.sort();
    let (folders, files): (Vec<_>, Vec<_>) = all.into_iter().partition(|p| p.is_dir());
    Ok((files.into_iter().filter(|p| is_region_file(p)).collect(), folders))
}

fn family_name(path: &Path) -> String {
    let full = path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
    full.file_name().map_or_else(|| "files".into(), |n| n.to_string_lossy().into_owned())
}
