//! Inputs of experiments: numbers for a formula, or a pair of regions.

use crate::cases::Case;
use serde::{Deserialize, Serialize};

/// What a quantity is measured on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Input {
    /// Numbers for a formula.
    Numbers(Numbers),
    /// A pair of regions.
    Pair(Box<Case>),
}

/// Numbers for a formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Numbers {
    /// The formula, or what the numbers are.
    pub of: String,
    /// The numbers.
    pub values: Vec<f64>,
}

impl Input {
    /// Numbers for this formula.
    #[must_use]
    pub fn numbers(of: &str, values: impl Into<Vec<f64>>) -> Self {
        Self::Numbers(Numbers { of: of.into(), values: values.into() })
    }

    /// A pair of regions.
    #[must_use]
    pub fn pair(case: Case) -> Self {
        Self::Pair(Box::new(case))
    }

    /// The pair, if it is one.
    #[must_use]
    pub fn as_pair(&self) -> Option<&Case> {
        match self {
            Self::Pair(case) => Some(case),
            Self::Numbers(_) => None,
        }
    }

    /// The numbers, if they are for this formula.
    #[must_use]
    pub fn as_numbers(&self, formula: &str) -> Option<&[f64]> {
        match self {
            Self::Numbers(numbers) if numbers.of == formula => Some(&numbers.values),
            _ => None,
        }
    }

    /// How large it is: numbers, or segments of both operands.
    #[must_use]
    pub fn size(&self) -> usize {
        match self {
            Self::Numbers(numbers) => numbers.values.len(),
            Self::Pair(case) => case.segments(),
        }
    }
}
