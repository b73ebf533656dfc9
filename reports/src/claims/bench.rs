//! What an experiment is given: how much effort to make, and where its random numbers come from.

use crate::cases::rng::Rng;
use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicBool, Ordering};

/// How much effort is made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Effort {
    /// All claims in minutes.
    #[default]
    Quick,
    /// All claims in hours.
    Full,
}

/// The place where an experiment runs.
#[derive(Clone, Copy, Debug)]
pub struct Bench<'a> {
    /// How much effort is made.
    pub effort: Effort,
    /// The seed of all random numbers.
    pub seed: u64,
    /// Set when the run is to end; an experiment then ends early with whatever it has, and its finding is thrown away.
    pub stop: &'a AtomicBool,
}

impl Bench<'_> {
    /// The stream of random numbers of this name.
    #[must_use]
    pub fn rng(&self, name: &str) -> Rng {
        Rng::new(self.seed, name)
    }

    /// The first number at quick effort, the second at full.
    #[must_use]
    pub fn either<T>(&self, [quick, full]: [T; 2]) -> T {
        match self.effort {
            Effort::Quick => quick,
            Effort::Full => full,
        }
    }

    /// Whether the run is to end.
    #[must_use]
    pub fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
