//! Witness files of claims.

use super::finding::Worst;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The worst input of a claim as a file that can be measured again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ClaimWitness {
    /// The claim.
    pub claim: String,
    /// The version of the program that wrote this.
    pub version: String,
    /// The input with what was measured.
    #[serde(flatten)]
    pub worst: Worst,
}

impl ClaimWitness {
    /// The witness in a file; none if it holds something else, such as a witness about an engine.
    #[must_use]
    pub fn read(file: &Path) -> Option<Self> {
        serde_json::from_str(&std::fs::read_to_string(file).ok()?).ok()
    }
}
