//! Counters of a run of the sweep (memo C4).

/// What the sweep did. All counts are exact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Audit {
    /// Curves at the start, zero-length pieces not counted.
    pub curves: usize,
    /// Vertices of the map, crossings included.
    pub vertices: usize,
    /// Crossings swapped when their event came.
    pub crossings: usize,
    /// Neighbours found in the wrong order and swapped at once.
    pub late: usize,
    /// Swaps that brought the curves ending at a vertex together.
    pub gather: usize,
    /// Swaps refused because the order is known to be right. A pair counts once, however often it is asked about, until it
    /// is swapped after all.
    pub cancelled: usize,
    /// Gather swaps against an order that is known.
    pub order_conflict: usize,
    /// Curves taken out beyond strangers; 0 unless gathering is left out.
    pub apart: usize,
    /// Lines cut at a vertex that lies on them exactly.
    pub cut: usize,
    /// Coinciding curves merged into one of net weight.
    pub merged: usize,
    /// Crossing events queued.
    pub queued: usize,
    /// Of these, how many had been overtaken when their turn came.
    pub stale: usize,
    /// Most curves active at once.
    pub longest_status: usize,
}
