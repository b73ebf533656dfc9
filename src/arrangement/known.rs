//! What is known about the order of two curves beside their geometry (MS 7.1).

/// Knowledge at an abscissa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// Whether the first curve is below the second; none if that is for the crossing module to say.
    pub below: Option<bool>,
    /// The answer may change at this abscissa, infinite if it does not.
    pub until: f64,
    /// What the answer is wherever there is one, here or further on; none if it may be both.
    pub only: Option<bool>,
}

impl Known {
    /// No knowledge.
    pub const NOTHING: Self = Self { below: None, until: f64::INFINITY, only: None };

    /// All that is known from two sources.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        let only = match (self.only, other.only) {
            _ if self == Self::NOTHING => other.only,
            _ if other == Self::NOTHING => self.only,
            (f, g) => f.filter(|_| f == g),
        };
        Self { below: self.below.or(other.below), until: self.until.min(other.until), only }
    }
}
