//! Negative controls: variants of an experiment that must come out refuted.

use super::bench::Bench;
use super::finding::{Finding, Measured};
use super::input::Input;
use crate::cases::rng::Rng;

/// What must come out refuted, so that `confirmed` means something.
#[derive(Clone, Copy)]
pub enum Control {
    /// The same inputs, measured with something planted.
    Measure {
        /// What is planted.
        plants: &'static str,
        /// Measures with it.
        measure: fn(&Input) -> Option<Measured>,
    },
    /// Other inputs, which break an assumption of the claim.
    Inputs {
        /// What is different about them.
        plants: &'static str,
        /// Draws one, given its number.
        draw: fn(&mut Rng, usize) -> Input,
    },
    /// Another measurement.
    Run {
        /// What is planted.
        plants: &'static str,
        /// Measures with it.
        run: fn(&Bench) -> Finding,
    },
    /// The same experiment about another claim, which is false.
    Claim(&'static str),
    /// The claim itself is refuted by the experiment, by this reading of it.
    Itself,
}

impl Control {
    /// Whether it is an experiment of its own.
    #[must_use]
    pub fn is_own(&self) -> bool {
        !matches!(self, Self::Claim(_) | Self::Itself)
    }

    /// What is planted, in words.
    #[must_use]
    pub fn plants(&self) -> String {
        match self {
            Self::Measure { plants, .. } | Self::Inputs { plants, .. } | Self::Run { plants, .. } => (*plants).into(),
            Self::Claim(id) => format!("the experiment on {id}"),
            Self::Itself => String::new(),
        }
    }
}
