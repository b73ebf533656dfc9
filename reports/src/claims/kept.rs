//! The worst inputs known, committed as files under `tests/worst/` and compiled in: every run measures them first.

use super::finding::Worst;

/// The worst inputs of a claim: the text of its file.
#[macro_export]
macro_rules! kept {
    ($stem:literal) => {
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/worst/", $stem, ".json"))
    };
}

/// What a file of worst inputs holds.
///
/// # Panics
/// If it holds something else; a test reads all of them.
#[must_use]
pub fn read(text: &str) -> Vec<Worst> {
    if text.is_empty() {
        return Vec::new();
    }
    serde_json::from_str(text).expect("a file of worst inputs")
}

/// The text of a file that holds these, an input a line.
///
/// # Errors
/// When a number cannot be written.
pub fn write(worst: &[Worst]) -> serde_json::Result<String> {
    let lines: serde_json::Result<Vec<String>> = worst.iter().map(serde_json::to_string).collect();
    Ok(format!("[\n{}\n]\n", lines?.join(",\n")))
}
