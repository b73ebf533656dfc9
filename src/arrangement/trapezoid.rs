//! The vertical decomposition: every maximal interval of a gap between events is a trapezoid (memo C3).

/// A part of a face between two curves with no event on either between its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trapezoid {
    /// The face.
    pub face: u32,
    /// Left end.
    pub from: f64,
    /// Right end, greater than `from`.
    pub to: f64,
    /// The curve below.
    pub bottom: u32,
    /// The curve above.
    pub top: u32,
}
