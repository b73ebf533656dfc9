//! The boundary of a region as an engine stores it, in plain numbers: float points and the normal angles it has given
//! to them (memo A1, A2).

/// The angle of a rightward normal: quarter turns from the direction of x plus radians, taken literally.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle {
    /// Quarter turns, counter-clockwise.
    pub quarter: u8,
    /// Radians, within pi/4 up to rounding.
    pub offset: f64,
}

/// A line, or a circle segment with no axis normal strictly inside, as the engine stores it.
#[derive(Clone, Debug, PartialEq)]
pub struct StoredPiece {
    /// Where it starts, in the unit box.
    pub tail: (f64, f64),
    /// Where it ends: the tail of the piece that follows.
    pub head: (f64, f64),
    /// The normal angle at the tail.
    pub start: Angle,
    /// The normal angle at the head; that at the tail for a line.
    pub end: Angle,
    /// The signed radius, 0 for a line. Only the sign counts: positive when the centre is on the left.
    pub radius: f64,
    /// Index of the corner in its loop that the whole segment leaves, before it was cut at axis normals.
    pub edge: usize,
    /// The places inside at which the convolution ends sum segments (MS 4.2, step 1).
    pub stops: Vec<Stop>,
}

/// A place inside a circle segment where a sum segment ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Its normal angle.
    pub angle: Angle,
    /// The end of the piece that the engine measures the place from.
    pub end: (f64, f64),
    /// The way from there as the engine has it, not yet added (memo A5).
    pub way: (f64, f64),
}

/// A region as the engine stores it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StoredRegion {
    /// The loops with the interior on the left. Turns between pieces are not listed.
    pub loops: Vec<Vec<StoredPiece>>,
    /// Whether everything far away belongs to the region.
    pub unbounded: bool,
    /// What has to be added to all points to have them in input units over the side of the unit box.
    pub shift: (f64, f64),
}

impl StoredPiece {
    /// Whether it is a straight line: equal angles make a line whatever the radius.
    #[must_use]
    pub fn is_line(&self) -> bool {
        self.radius == 0.0 || self.start == self.end
    }

    /// About how many radians it turns by, not negative.
    #[must_use]
    pub fn sweep(&self) -> f64 {
        if self.is_line() {
            return 0.0;
        }
        let turn = self.end.radians() - self.start.radians();
        (if self.radius > 0.0 { turn } else { -turn }).rem_euclid(std::f64::consts::TAU)
    }
}

impl Angle {
    /// About its value in radians.
    #[must_use]
    pub fn radians(self) -> f64 {
        f64::from(self.quarter) * std::f64::consts::FRAC_PI_2 + self.offset
    }
}
