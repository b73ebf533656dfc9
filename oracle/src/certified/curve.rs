//! A boundary piece that is computed when it is asked for, at the precision that is asked for.

use std::fmt;
use std::sync::OnceLock;

use super::piece::Piece;
use super::precision::Precision;

/// How a piece follows from the numbers of the case.
type Recipe = Box<dyn Fn(Precision) -> Piece + Send + Sync>;

/// A piece at every precision of the ladder.
pub struct Curve {
    recipe: Recipe,
    known: [OnceLock<Piece>; Precision::LADDER.len()],
}

impl Curve {
    /// The piece that this recipe gives. At every precision it must be the same piece of the plane.
    pub fn new(recipe: impl Fn(Precision) -> Piece + Send + Sync + 'static) -> Self {
        Self { recipe: Box::new(recipe), known: Default::default() }
    }

    /// The piece known to this precision.
    #[must_use]
    pub fn at(&self, precision: Precision) -> &Piece {
        self.known[precision.rung()].get_or_init(|| (self.recipe)(precision))
    }

    /// The piece in intervals of doubles.
    #[must_use]
    pub fn rough(&self) -> &Piece {
        self.at(Precision::DOUBLE)
    }
}

impl fmt::Debug for Curve {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.rough().fmt(f)
    }
}
