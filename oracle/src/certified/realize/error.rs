//! Why a stored boundary has no realization.

use thiserror::Error;

/// What keeps a realization from being built. Loops and pieces are counted from 0, pieces within their loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum RealizeError {
    /// A piece does not start where the one before it ends.
    #[error("loop {ring}, piece {piece}: does not start where the piece before it ends")]
    Open {
        /// The loop.
        ring: usize,
        /// The piece.
        piece: usize,
    },
    /// A coordinate or angle is not finite, or an angle is off by more than the engine's format allows.
    #[error("loop {ring}, piece {piece}: a number is not usable")]
    BadNumber {
        /// The loop.
        ring: usize,
        /// The piece.
        piece: usize,
    },
    /// The ends of a piece run against its stored angles, so that it would get a length or radius that is not positive.
    #[error("loop {ring}, piece {piece}: the end points contradict the stored angles")]
    Backward {
        /// The loop.
        ring: usize,
        /// The first piece of the part that is affected.
        piece: usize,
    },
    /// A loop does not turn back, as closed curves do.
    #[error("loop {ring} has no turning point")]
    Turnless {
        /// The loop.
        ring: usize,
    },
    /// The chains have no order from below to above: the stored boundary crosses itself by more than rounding.
    #[error("the chains of the boundary cannot be ordered from below to above")]
    Tangled,
}
