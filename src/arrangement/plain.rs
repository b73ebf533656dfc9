//! The crossing module in plain doubles: closed forms as they come out, without point tests (MS 8.3). Returns orders and
//! crossings that need not go together.

use super::cross::{CrossingModule, Crossings, boxes_apart};
use super::curve::Curve;
use super::moment::Moment;
use super::pair::Pair;
use glam::DVec2;

/// The module without robustness: no tolerance, no tests of signs, no bisection, no twofold abscissas.
#[derive(Clone, Copy, Debug)]
pub struct PlainModule;

impl CrossingModule for PlainModule {
    fn cross(&self, f: &Curve, g: &Curve) -> Crossings {
        if let Some(below) = boxes_apart(f, g) {
            return Crossings::none(below);
        }
        let pair = Pair { f, g, tolerance: self.tolerance() };
        let (joined, meeting) = pair.shared();
        if pair.cannot_cross(joined, meeting) {
            return Crossings::none(pair.order_at_shared(joined));
        }
        let below = if joined { pair.order_at_shared(joined) } else { pair.gap_at_start() < 0.0 };
        let (places, count) = pair.candidates(joined, meeting);
        Crossings::at(below, &places.map(Moment::from)[..count])
    }

    fn above(&self, p: DVec2, curve: &Curve) -> f64 {
        curve.above(p)
    }

    fn tolerance(&self) -> f64 {
        0.0
    }
}
