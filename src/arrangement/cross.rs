//! The crossing module: in which order two curves run, and where they cross (memo C1).
//!
//! The module is accurate but need not be consistent: three curves may come out in cyclic order. Its contract, tested
//! against MPFR, is that wherever it says f is below g, no point of f is above g by more than a few eps. The sweep relies
//! on nothing but this: the answer for a pair is a fixed function of the pair.

use super::curve::Curve;
use super::known::Known;
use super::moment::Moment;
use super::pair::Pair;
use glam::DVec2;

/// Half a unit in the last place of 1: the papers' epsilon.
pub const EPS: f64 = f64::EPSILON / 2.0;

/// How two curves f and g run over their common part of the sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossings {
    /// Whether f is below g where the common part begins.
    pub below: bool,
    /// The crossings, sorted; each changes the order.
    at: [Moment; 2],
    count: u8,
}

impl Crossings {
    /// No crossing.
    #[must_use]
    pub fn none(below: bool) -> Self {
        Self { below, at: [Moment::from(DVec2::ZERO); 2], count: 0 }
    }

    /// One or two crossings, in any order.
    #[must_use]
    pub fn at(below: bool, points: &[Moment]) -> Self {
        let mut all = Self::none(below);
        for &p in points.iter().take(2) {
            all.push(p);
        }
        all
    }

    /// Adds a crossing, of at most two.
    pub(super) fn push(&mut self, crossing: Moment) {
        self.at[usize::from(self.count)] = crossing;
        self.count += 1;
        if self.count == 2 && self.at[0].compare(&self.at[1]).is_gt() {
            self.at.swap(0, 1);
        }
    }

    /// The crossings in sweep order.
    #[must_use]
    pub fn points(&self) -> &[Moment] {
        &self.at[..usize::from(self.count)]
    }

    /// The answer with the roles of f and g exchanged.
    #[must_use]
    pub fn exchanged(self) -> Self {
        Self { below: !self.below, ..self }
    }
}

/// What the sweep asks about curves. Answers must depend on the arguments alone.
pub trait CrossingModule {
    /// Order and crossings of two curves whose parts overlap in the sweep. `f` is the one with the smaller index.
    fn cross(&self, f: &Curve, g: &Curve) -> Crossings;

    /// How far `p` lies above the curve, vertically; 0 on the line of a vertical.
    fn above(&self, p: DVec2, curve: &Curve) -> f64;

    /// Vertical distances up to this count as zero.
    fn tolerance(&self) -> f64;

    /// What is known about the order of two curves at an abscissa, against which crossings do not count.
    fn known(&self, _f: &Curve, _g: &Curve, _x: f64) -> Known {
        Known::NOTHING
    }

    /// Whether [`CrossingModule::known`] and [`CrossingModule::placed`], wherever they are asked, say nothing about two curves but
    /// that the first is below the second, or else above.
    fn agrees(&self, _below: bool, _f: &Curve, _g: &Curve) -> bool {
        true
    }

    /// What is known where one of the curves begins.
    fn placed(&self, _f: &Curve, _g: &Curve, _x: f64) -> Option<bool> {
        None
    }

    /// Adds the pieces at an abscissa about whose order with this one something may be known.
    fn related(&self, _piece: u32, _x: f64, _found: &mut Vec<u32>) {}
}

/// The honest module: closed forms in doubles, made consistent with point tests at the ends and between crossings.
#[derive(Clone, Copy, Debug)]
pub struct FloatModule {
    tolerance: f64,
}

impl FloatModule {
    /// A module for curves in a box with sides up to `extent`.
    #[must_use]
    pub fn new(extent: f64) -> Self {
        Self { tolerance: 4.0 * EPS * extent }
    }
}

impl CrossingModule for FloatModule {
    fn cross(&self, f: &Curve, g: &Curve) -> Crossings {
        match boxes_apart(f, g) {
            Some(below) => Crossings::none(below),
            None => Pair { f, g, tolerance: self.tolerance }.crossings(),
        }
    }

    fn above(&self, p: DVec2, curve: &Curve) -> f64 {
        curve.above(p)
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }
}

/// Whether f is below g, if that shows in their ordinates and they share no end.
pub(super) fn boxes_apart(f: &Curve, g: &Curve) -> Option<bool> {
    if f.first == g.first || f.last == g.last {
        return None;
    }
    let ((f_low, f_high), (g_low, g_high)) = (f.y_range(), g.y_range());
    (f_high < g_low || g_high < f_low).then_some(f_high < g_low)
}
