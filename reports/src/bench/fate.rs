//! What became of an engine on a case: the column `status` of `timing.csv`.

use crate::row::Status;
use serde::{Deserialize, Serialize};

/// The fate of an engine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Fate {
    /// It answered and was timed.
    #[default]
    Ok,
    /// It panicked, aborted or ran out of memory.
    Crashed,
    /// It did not answer in its time.
    Timeout,
    /// It answered something that is no region, or refused the case.
    Invalid,
    /// It was not asked, because it took too long on a smaller case of the family.
    #[serde(rename = "too slow")]
    TooSlow,
    /// Its arrangement here or on a smaller case of the family is larger than was asked for.
    #[serde(rename = "too large")]
    TooLarge,
}

impl Fate {
    /// All fates, good first.
    pub const ALL: [Self; 6] = [Self::Ok, Self::Crashed, Self::Timeout, Self::Invalid, Self::TooSlow, Self::TooLarge];

    /// The word in the table.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Crashed => "crashed",
            Self::Timeout => "timeout",
            Self::Invalid => "invalid",
            Self::TooSlow => "too slow",
            Self::TooLarge => "too large",
        }
    }
}

impl From<Status> for Fate {
    fn from(status: Status) -> Self {
        match status {
            Status::Crashed => Self::Crashed,
            Status::Timeout => Self::Timeout,
            Status::Invalid => Self::Invalid,
            // The answer is there; what the reference says about it is another column.
            Status::Ok | Status::Undecided | Status::Sampled => Self::Ok,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_those_of_the_table() {
        for fate in Fate::ALL {
            assert_eq!(serde_json::to_value(fate).unwrap(), fate.word());
        }
    }
}
