//! Angles of normals as an axis and an offset from it (memo A2).

/// The angle of a rightward normal: the nearest axis and the signed offset from it.
///
/// `k` counts axes +x, +y, -x, -y as 0 to 3; the half of axis 0 below it is stored as 4, so the derived lexicographic
/// order is the order of angles on [0, 360) degrees. Canonical: `off` in (-pi/4, pi/4], never -0.0, and (4, 0) is (0, 0).
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Ang {
    k: u8,
    off: f64,
}

impl Ang {
    /// Axis, 0 to 4.
    #[must_use]
    pub fn axis(self) -> u8 {
        self.k
    }

    /// Offset from the axis in radians.
    #[must_use]
    pub fn offset(self) -> f64 {
        self.off
    }
}
