//! What is known about the order of two curves beside their geometry (MS 7.1).

/// Knowledge at an abscissa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// Whether the first curve is below the second; none if that is for the crossing module to say.
    pub below: Option<bool>,
    /// The answer may change at this abscissa, infinite if it does not.
    pub until: f64,
}

impl Known {
    /// No knowledge.
    pub const NOTHING: Self = Self { below: None, until: f64::INFINITY };
}
