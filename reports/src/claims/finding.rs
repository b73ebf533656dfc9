//! What an experiment found.

use super::input::Input;
use super::plot::Plot;
use crate::row::number;
use serde::{Deserialize, Serialize};

/// What an experiment says about a claim (section 3 of the design).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// It held on everything that was measured, and the measurement can fail.
    Confirmed,
    /// There is a witness against it.
    Refuted,
    /// Neither was shown.
    Undecided,
    /// No experiment was made.
    #[serde(rename = "not tested")]
    NotTested,
}

impl Verdict {
    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Confirmed => "confirmed",
            Self::Refuted => "refuted",
            Self::Undecided => "undecided",
            Self::NotTested => "not tested",
        }
    }
}

/// A quantity on one input, a certified bracket. An upper bound of infinity says that nothing was decided.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The lower bound.
    pub lo: f64,
    /// The upper bound.
    pub hi: f64,
    /// The size of the input as the claim counts it, for claims about growth; else 0.
    pub size: f64,
    /// The point where it happens, in input units, if there is one.
    pub spot: Option<[f64; 2]>,
}

impl Measured {
    /// A number known exactly, or to far more digits than matter.
    #[must_use]
    pub fn exactly(value: f64) -> Self {
        Self::between(value, value)
    }

    /// A bracket.
    #[must_use]
    pub fn between(lo: f64, hi: f64) -> Self {
        Self { lo, hi, size: 0.0, spot: None }
    }

    /// A count.
    #[must_use]
    pub fn count(count: usize) -> Self {
        Self::exactly(count as f64)
    }

    /// With this size.
    #[must_use]
    pub fn of_size(self, size: usize) -> Self {
        Self { size: size as f64, ..self }
    }

    /// Where it happens.
    #[must_use]
    pub fn at(self, spot: [f64; 2]) -> Self {
        Self { spot: Some(spot), ..self }
    }
}

/// The input that a verdict rests on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Worst {
    /// The input.
    pub input: Input,
    /// Lower bound of the quantity there.
    #[serde(with = "exact")]
    pub lo: f64,
    /// Upper bound.
    #[serde(with = "exact")]
    pub hi: f64,
    /// The point where it happens, in input units.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spot: Option<[f64; 2]>,
}

impl Worst {
    /// An input with what was measured on it.
    #[must_use]
    pub fn new(input: Input, measured: &Measured) -> Self {
        Self { input, lo: measured.lo, hi: measured.hi, spot: measured.spot }
    }
}

/// What an experiment found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// The verdict.
    pub verdict: Verdict,
    /// Lower bound of the measured number.
    #[serde(with = "exact")]
    pub lo: f64,
    /// Upper bound.
    #[serde(with = "exact")]
    pub hi: f64,
    /// What it is compared with; none if the constant is only reported.
    #[serde(default, with = "number")]
    pub bound: Option<f64>,
    /// Inputs that were measured.
    pub cases: usize,
    /// Of these, how many decide nothing.
    pub undecided: usize,
    /// Other numbers, in a sentence.
    pub note: String,
    /// The worst input.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub worst: Option<Worst>,
    /// What to draw.
    #[serde(default)]
    pub plot: Plot,
}

impl Finding {
    /// A verdict on a number.
    #[must_use]
    pub fn new(verdict: Verdict, [lo, hi]: [f64; 2], cases: usize) -> Self {
        let (note, plot) = (String::new(), Plot::default());
        Self { verdict, lo, hi, bound: None, cases, undecided: 0, note, worst: None, plot }
    }

    /// With a sentence.
    #[must_use]
    pub fn saying(self, note: impl Into<String>) -> Self {
        Self { note: note.into(), ..self }
    }

    /// With a bound.
    #[must_use]
    pub fn against(self, bound: f64) -> Self {
        Self { bound: Some(bound), ..self }
    }

    /// With a plot.
    #[must_use]
    pub fn drawn(self, plot: Plot) -> Self {
        Self { plot, ..self }
    }

    /// With the input that it rests on.
    #[must_use]
    pub fn witnessed(self, worst: Option<Worst>) -> Self {
        Self { worst, ..self }
    }
}

/// Numbers as JSON, infinities and the undefined as words.
mod exact {
    use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

    pub fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        if value.is_finite() { value.serialize(serializer) } else { value.to_string().serialize(serializer) }
    }

    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Either {
        Number(f64),
        Word(String),
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        match Either::deserialize(deserializer)? {
            Either::Number(number) => Ok(number),
            Either::Word(word) => word.parse().map_err(|_| D::Error::custom(format!("no number: {word}"))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn findings_read_back() {
        let worst = Worst::new(Input::numbers("f", [0.1, 5e-324]), &Measured::between(1.5, f64::INFINITY));
        let finding = Finding::new(Verdict::NotTested, [1.5, f64::INFINITY], 3).witnessed(Some(worst)).against(4.0);
        let text = serde_json::to_string(&finding).unwrap();
        assert_eq!(serde_json::from_str::<Finding>(&text).unwrap(), finding);
        assert!(text.contains("\"not tested\"") && text.contains("\"inf\""));
    }
}
