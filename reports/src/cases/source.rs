//! What the words on the command line mean: a file, a folder, a family, or a family at one size (`fork_5`).

use super::Case;
use super::family::{FAMILIES, Family};
use super::files::BadFile;
use super::folder::{Found, files, folder};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Collects the cases the words name, in their order; without words, all built-in families at their quick sizes.
///
/// # Errors
/// When a word is neither a file, a folder nor a family, or a folder has no regions.
pub fn collect(words: &[String], seed: u64) -> Result<Found, BadFile> {
    let mut found = Found::default();
    if words.is_empty() {
        found.cases = FAMILIES.iter().flat_map(|f| f.cases(seed)).collect();
    }
    let is_file = |w: &&String| Path::new(w.as_str()).is_file();
    let single: Vec<PathBuf> = words.iter().filter(is_file).map(PathBuf::from).collect();
    found.extend(files(&single));
    for word in words.iter().filter(|w| !is_file(w)) {
        if Path::new(word).is_dir() {
            let inside = folder(Path::new(word))?;
            if inside.cases.is_empty() && inside.bad.is_empty() {
                return Err(BadFile(format!("{word}: no region files in this folder")));
            }
            found.extend(inside);
        } else {
            found.cases.extend(family(word, seed)?);
        }
    }
    number_repeats(&mut found.cases);
    Ok(found)
}

fn family(word: &str, seed: u64) -> Result<Vec<Case>, BadFile> {
    if let Some(family) = Family::named(word) {
        return Ok(family.cases(seed));
    }
    let sized = word.rsplit_once('_').and_then(|(name, size)| Some((Family::named(name)?, size.parse().ok()?)));
    match sized.map(|(family, size)| family.cases_of_size(size, seed)) {
        Some(cases) if !cases.is_empty() => Ok(cases),
        _ => Err(BadFile(format!("{word}: neither a file, a folder nor a built-in family"))),
    }
}

/// A name met before gets a number, so that names stay unique within a run.
pub fn number_repeats(cases: &mut [Case]) {
    let mut seen: BTreeMap<String, u32> = BTreeMap::new();
    for case in cases {
        let count = seen.entry(case.name.clone()).or_insert(0);
        *count += 1;
        if *count > 1 {
            case.name = format!("{}#{count}", case.name);
        }
    }
}
