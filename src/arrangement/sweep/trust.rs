//! What is known about the order of curves, as far as geometry bears it out (MS 7.1; memo E6).
//!
//! Knowledge decides where rounding has brought curves out of order, by a few roundings. It speaks of ordinates at one
//! abscissa, and a line may rise by much within one rounding of x, so that its vertical error is large although it is in its
//! place. Where knowledge would put a curve on the wrong side by more than [`TRUST`], it is not used.

use super::Sweep;
use crate::arrangement::cross::CrossingModule;
use crate::arrangement::curve::Curve;
use crate::arrangement::known::Known;
use glam::DVec2;

/// How far beyond another curve one may be and still be put before it: 256 eps per unit of size, many times what rounding
/// does to curves of the unit box, and less than what is measured as an error.
const TRUST: f64 = 256.0 / 4.0;

impl<M: CrossingModule> Sweep<'_, M> {
    /// Whether all that may be known about two curves is that the first is below the second, or else above.
    pub(super) fn agrees(&self, below: bool, f: u32, g: u32) -> bool {
        self.all_agree(below, f, g)
    }

    /// What is known about the order of two active curves just after the current event, whether geometry bears it out or not.
    /// Where one of them is about to end it is what is known up to there.
    pub(super) fn known(&self, f: u32, g: u32) -> Known {
        let known = self.all_known(f, g, self.abscissa(f, g));
        Known { until: if known.until > self.now.x { known.until } else { f64::INFINITY }, ..known }
    }

    /// Whether one curve is below another as far as is known, if geometry says something else but bears it out.
    pub(super) fn overruled(&self, known: Known, geometric: bool, f: u32, g: u32) -> Option<bool> {
        known.below.filter(|below| *below != geometric && self.is_borne_out(*below, f, g))
    }

    /// The current abscissa, or the one before if one of two curves ends here and both came from there.
    fn abscissa(&self, f: u32, g: u32) -> f64 {
        let [f, g] = [f, g].map(|curve| &self.curves[curve as usize]);
        let x = self.now.x;
        let ends = f.end.x.min(g.end.x) <= x && f.start.x.max(g.start.x) < x;
        if ends { x.next_down() } else { x }
    }

    /// What is known about where to put a curve that begins, relative to another.
    pub(super) fn placed(&self, f: u32, g: u32) -> Option<bool> {
        let below = self.any_placed(f, g)?;
        self.is_borne_out(below, f, g).then_some(below)
    }

    /// Whether a curve that begins is known to be above, or else below, another.
    pub(super) fn is_placed(&self, above: bool, f: u32, g: u32) -> bool {
        if self.agrees(!above, f, g) {
            return false;
        }
        self.any_placed(f, g) == Some(above) && self.is_borne_out(above, f, g)
    }

    /// Whether one curve is below another, or not above it by more than roundings, from here to where the first of them ends.
    pub(super) fn is_borne_out(&self, below: bool, f: u32, g: u32) -> bool {
        let (lower, upper) = if below { (f, g) } else { (g, f) };
        let (lower, upper) = (&self.curves[lower as usize], &self.curves[upper as usize]);
        self.excess(lower, upper) <= TRUST * self.module.tolerance()
    }

    /// How far the first curve is above the second from here on, by distance.
    fn excess(&self, lower: &Curve, upper: &Curve) -> f64 {
        if lower.is_vertical() {
            return upper.side(lower.end);
        }
        if upper.is_vertical() {
            return -lower.side(upper.start);
        }
        let (from, to) = (self.now.x, lower.end.x.min(upper.end.x));
        let at = |x: f64| {
            let on = |curve: &Curve| DVec2::new(x, curve.y_at(x.clamp(curve.left.x, curve.right.x)));
            upper.side(on(lower)).max(-lower.side(on(upper)))
        };
        at(from).max(at(0.5 * (from + to))).max(at(to))
    }
}
