//! Distances of planted errors in closed form, in floats of 512 bits.

use rug::Float;

const BITS: u32 = 512;

/// Far more than the rounding of a few operations on numbers near 1.
const ROUNDING: i32 = -480;

/// A double as a float of many bits.
pub fn float(x: f64) -> Float {
    Float::with_val(BITS, x)
}

/// The square root.
pub fn root(x: Float) -> Float {
    x.sqrt()
}

/// The length of a vector.
pub fn length((x, y): (Float, Float)) -> Float {
    (x.square() + y.square()).sqrt()
}

/// The difference of two points of doubles.
pub fn step(from: (f64, f64), to: (f64, f64)) -> (Float, Float) {
    (float(to.0) - from.0, float(to.1) - from.1)
}

/// The distance of two points of doubles.
pub fn distance(from: (f64, f64), to: (f64, f64)) -> Float {
    length(step(from, to))
}

/// Whether a double is at most a number.
pub fn at_most(x: f64, truth: &Float) -> bool {
    x <= Float::with_val(BITS, truth + Float::with_val(BITS, Float::i_exp(1, ROUNDING)))
}

/// Whether a double is at least a number.
pub fn at_least(x: f64, truth: &Float) -> bool {
    x >= Float::with_val(BITS, truth - Float::with_val(BITS, Float::i_exp(1, ROUNDING)))
}

/// Centre and radius of the disc over a diameter from (left, y) to (right, y).
fn round((left, right, y): (f64, f64, f64)) -> ((Float, Float), Float) {
    (((float(left) + right) / 2, float(y)), (float(right) - left) / 2)
}

/// How far a surplus and a lack reach, 0 without any.
pub type Reaches = [Float; 2];

/// A surplus that reaches so far, or a lack.
pub fn one(reach: Float, grows: bool) -> Reaches {
    if grows { [reach, float(0.0)] } else { [float(0.0), reach] }
}

/// A surplus that reaches so far.
pub fn surplus(reach: Float) -> Reaches {
    one(reach, true)
}

/// A lack that reaches so far.
pub fn lack(reach: Float) -> Reaches {
    one(reach, false)
}

/// A round hole in the place of another one that it overlaps, moved by less than the radii.
pub fn discs(before: (f64, f64, f64), after: (f64, f64, f64)) -> Reaches {
    let ((a, r), (b, s)) = (round(before), round(after));
    let apart = length((a.0 - b.0, a.1 - b.1));
    let more = r - s;
    let lack = Float::with_val(BITS, &apart - &more);
    [apart + more, lack].map(|reach| reach.max(&float(0.0)))
}

/// How far a disc reaches out of the circle of an arc with this bulge.
pub fn beyond(disc: (f64, f64, f64), [from, to]: [(f64, f64); 2], bulge: f64) -> Float {
    let (centre, radius) = round(disc);
    let chord = step(from, to);
    let factor = (1 - float(bulge).square()) / (float(bulge) * 4);
    let x = (float(from.0) + to.0) / 2 - Float::with_val(BITS, &chord.1 * &factor);
    let y = (float(from.1) + to.1) / 2 + chord.0 * factor;
    let arm = length((float(from.0) - &x, float(from.1) - &y));
    length((centre.0 - x, centre.1 - y)) + radius - arm
}

/// The distance of a region with errors from the one without.
#[derive(Clone, Debug)]
pub struct Truth {
    sides: Reaches,
}

impl Truth {
    /// No error at all.
    pub fn none() -> Self {
        Self { sides: [float(0.0), float(0.0)] }
    }

    /// The errors of this one and an error far from them.
    #[must_use]
    pub fn and(self, reaches: Reaches) -> Self {
        let [surplus, lack] = self.sides;
        Self { sides: [surplus.max(&reaches[0]), lack.max(&reaches[1])] }
    }

    /// The greater reach.
    pub fn distance(&self) -> &Float {
        let [surplus, lack] = &self.sides;
        if surplus >= lack { surplus } else { lack }
    }

    /// Whether the surplus reaches certainly farther, or certainly the lack does; `None` if both are about as great.
    pub fn direction(&self) -> Option<bool> {
        let [surplus, lack] = &self.sides;
        let more = |x: &Float, y: &Float| *x > Float::with_val(BITS, y * 1.1) && *x > 2f64.powi(-55);
        if more(surplus, lack) { Some(true) } else { more(lack, surplus).then_some(false) }
    }
}
