//! Realizations: regions near the input whose exact normals are an engine's stored angles (MS 4.2; memo I5).
//!
//! The convolution of an engine is not that of its input, because its angles are rounded, but it is nearly that of the
//! realizations A* and B*. The error of a sum against A* ⊕ B* is then the arrangement's alone. The steps are those of
//! MS 4.2, with these differences:
//!
//! * The vertical is any direction ([`Up`]). With the y axis, as printed, a circle segment of sweep s next to a
//!   vertical tangent moves by about 1/s eps (measured: up to 0.6/s), since its stored angles are off by eps over its
//!   length once they agree with those of its neighbours, and Theorem 1 fails.
//! * Step 1 does not split. A span has all normals between its ends, so that it has the right angle where a sum segment
//!   ends, and near the engine's point ([`Moved::stops`]). Splitting would keep the engine's abscissas, which only the
//!   monotonic algorithm asks for, but they need not be in the order of the angles: two angles one unit in the last
//!   place apart can have equal or swapped points.
//! * Circle segments go on through the engine's cuts at axis normals where one side is short ([`chain`]).
//! * Step 3 keeps chains apart by 2^-80 where they would touch.
//!
//! A line parallel to the direction becomes a connection of step 4. It has the right angle up to its ends, which are
//! at one abscissa.

pub mod chain;
pub mod error;
pub mod lift;
pub mod moved;
pub mod order;
pub mod outline;
pub mod path;
pub mod place;
pub mod plan;
pub mod stored;
pub mod track;
pub mod up;
pub mod upright;

pub use error::RealizeError;
pub use moved::{ChainMove, Moved};
pub use stored::{Angle, Stop, StoredPiece, StoredRegion};
pub use up::Up;
pub use upright::vertical_distance;

use super::shape::Shape;
use plan::Plan;

/// A region with the stored angles and how far it is from the stored boundary.
#[derive(Clone, Debug)]
pub struct Realization {
    /// The region, in input units over the side of the unit box.
    pub shape: Shape,
    /// What was vertical.
    pub up: Up,
    /// Its distance from the stored boundary.
    pub moved: Moved,
    /// The moves of its chains.
    pub chains: Vec<ChainMove>,
}

/// The nearer one of the realizations of a stored boundary along [`Up::clear_of`] and [`Up::VERTICAL`]: the former
/// suits circle segments, the latter lines in many directions.
///
/// # Errors
/// [`RealizeError`], as its variants say, if there is neither.
pub fn realize(region: &StoredRegion) -> Result<Realization, RealizeError> {
    match (realize_along(region, Up::clear_of(region)), realize_along(region, Up::VERTICAL)) {
        (Ok(clear), Ok(vertical)) if vertical.moved.greatest() < clear.moved.greatest() => Ok(vertical),
        (Err(_), Ok(vertical)) => Ok(vertical),
        (clear, _) => clear,
    }
}

/// The realization with this direction for the vertical; [`Up::VERTICAL`] for the printed steps.
///
/// # Errors
/// [`RealizeError`], as its variants say.
pub fn realize_along(region: &StoredRegion, up: Up) -> Result<Realization, RealizeError> {
    let plan = Plan::new(region.clone(), up)?;
    let (moved, chains) = moved::moved(&plan);
    Ok(Realization { shape: outline::shape(&plan), up, moved, chains })
}
