//! How finely a number is known: the ladder from doubles to 4096 bits (memo I4).

/// A number of significant bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Precision(u32);

impl Precision {
    /// Intervals of doubles.
    pub const DOUBLE: Self = Self(53);
    /// The finest precision that is tried.
    pub const FINEST: Self = Self(4096);
    /// All precisions from coarse to fine.
    pub const LADDER: [Self; 7] = [Self(53), Self(128), Self(256), Self(512), Self(1024), Self(2048), Self(4096)];

    /// The number of bits.
    #[must_use]
    pub fn bits(self) -> u32 {
        self.0
    }

    /// The place on the ladder.
    #[must_use]
    pub fn rung(self) -> usize {
        Self::LADDER.iter().position(|&p| p == self).expect("every precision is one of the ladder")
    }

    /// The steps of the ladder up to and including this one.
    pub fn up_to(self) -> impl Iterator<Item = Self> {
        Self::LADDER.into_iter().take_while(move |&p| p <= self)
    }

    /// The first answer on the way up to this precision; `None` if even this precision gives none.
    pub fn decide<T>(self, question: impl FnMut(Self) -> Option<T>) -> Option<T> {
        self.up_to().find_map(question)
    }
}
