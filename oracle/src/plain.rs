//! Regions as plain numbers: the only form in which a case reaches the oracle. Every double is taken literally as the
//! rational number it is.

/// How the boundary runs from one vertex to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bend {
    /// A straight line.
    Line,
    /// A minor circle segment of this signed radius, positive when the centre is on the left.
    Radius(f64),
    /// A circle segment of this bulge, tan(sweep/4), positive counter-clockwise.
    Bulge(f64),
}

/// A vertex and the bend that leaves it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Abscissa, in input units.
    pub x: f64,
    /// Ordinate.
    pub y: f64,
    /// The way to the next vertex.
    pub bend: Bend,
}

/// A region: loops with the interior on the left, closed implicitly.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlainRegion {
    /// The loops.
    pub loops: Vec<Vec<Corner>>,
    /// Whether everything far away belongs to the region.
    pub unbounded: bool,
}

impl PlainRegion {
    /// Whether every bend is a line.
    #[must_use]
    pub fn is_polygonal(&self) -> bool {
        self.loops.iter().flatten().all(|c| c.bend == Bend::Line)
    }
}
