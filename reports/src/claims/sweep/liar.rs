//! Crossing modules that lie, but never by more than they may: where they say that f is below g, no point of f is above g by
//! more than the size of the lie (memo C1, C4). What MS reference 5 asks of a module is no more than that.

use arcsum::arrangement::cross::{CrossingModule, Crossings, FloatModule};
use arcsum::arrangement::curve::{Curve, compare};
use arcsum::arrangement::moment::Moment;
use glam::DVec2;
use std::cell::Cell;

/// How a module lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::claims) enum Lie {
    /// Not at all.
    None,
    /// Crossings are moved along the curves, and the order of curves that nowhere are far apart is drawn by lot.
    Shifts,
    /// Of curves next to each other in the list the first is below the second, if they are near enough (memo C4).
    Stairs,
}

impl Lie {
    const ALL: [Self; 3] = [Self::None, Self::Shifts, Self::Stairs];

    /// The lie of this number.
    pub(in crate::claims) fn numbered(number: f64) -> Option<Self> {
        Self::ALL.into_iter().find(|lie| lie.number() == number)
    }

    /// Its number.
    pub(in crate::claims) fn number(self) -> f64 {
        f64::from(self as u8)
    }
}

/// A module that lies, and counts what it is asked.
#[derive(Clone, Debug)]
pub(in crate::claims) struct Liar {
    honest: FloatModule,
    lie: Lie,
    size: f64,
    seed: u64,
    asked: Cell<usize>,
}

impl Liar {
    /// A module for curves in a box with sides up to `extent`, whose lies are up to `size` long.
    pub(in crate::claims) fn new(lie: Lie, extent: f64, size: f64, seed: u64) -> Self {
        Self { honest: FloatModule::new(extent), lie, size, seed, asked: Cell::new(0) }
    }

    /// The honest one.
    pub(in crate::claims) fn honest(extent: f64) -> Self {
        Self::new(Lie::None, extent, 0.0, 0)
    }

    /// How often it has been asked: the comparisons of the sweep.
    pub(in crate::claims) fn asked(&self) -> usize {
        self.asked.get()
    }

    fn count(&self) {
        self.asked.set(self.asked.get() + 1);
    }

    /// A number in [-1, 1] that depends on two curves and the seed alone.
    fn lot(&self, f: &Curve, g: &Curve, which: u64) -> f64 {
        let mut h = self.seed;
        for key in [u64::from(f.piece), u64::from(g.piece), which] {
            h = (h ^ key).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            h ^= h >> 29;
        }
        h = h.wrapping_mul(0xbf58_476d_1ce4_e5b9);
        (h >> 11) as f64 * libm::scalbn(1.0, -52) - 1.0
    }

    fn shifted(&self, f: &Curve, g: &Curve, truth: Crossings) -> Crossings {
        let pair = Both::new(f, g);
        if pair.is_within(self.size) {
            return Crossings::none(self.lot(f, g, 0) < 0.0);
        }
        let mut moved = [Moment::from(DVec2::ZERO); 2];
        for (i, crossing) in truth.points().iter().enumerate() {
            moved[i] = pair.shifted(crossing, self.size, self.lot(f, g, 1 + i as u64));
        }
        let moved = &moved[..truth.points().len()];
        let in_order = moved.windows(2).all(|two| two[0].compare(&two[1]).is_lt());
        if in_order { Crossings::at(truth.below, moved) } else { truth }
    }
}

impl CrossingModule for Liar {
    fn cross(&self, f: &Curve, g: &Curve) -> Crossings {
        self.count();
        let truth = self.honest.cross(f, g);
        let may_lie = f.first != g.first && f.last != g.last && !f.is_vertical() && !g.is_vertical();
        match self.lie {
            Lie::Shifts if may_lie => self.shifted(f, g, truth),
            Lie::Stairs if may_lie && f.piece.abs_diff(g.piece) == 1 && Both::new(f, g).is_within(self.size) => {
                Crossings::none(f.piece < g.piece)
            }
            _ => truth,
        }
    }

    fn above(&self, p: DVec2, curve: &Curve) -> f64 {
        self.count();
        self.honest.above(p, curve)
    }

    fn tolerance(&self) -> f64 {
        self.honest.tolerance().max(self.size)
    }
}

/// Two curves over their common abscissas.
struct Both<'a> {
    f: &'a Curve,
    g: &'a Curve,
    from: f64,
    to: f64,
}

impl<'a> Both<'a> {
    fn new(f: &'a Curve, g: &'a Curve) -> Self {
        let start = if compare(f.start, g.start).is_ge() { f.start } else { g.start };
        let end = if compare(f.end, g.end).is_le() { f.end } else { g.end };
        Self { f, g, from: start.x, to: end.x }
    }

    fn gap(&self, x: f64) -> f64 {
        (self.f.y_at(x) - self.g.y_at(x)).abs()
    }

    /// Whether they are no further apart than this at five places.
    fn is_within(&self, size: f64) -> bool {
        (0..5).all(|i| self.gap(self.from + (self.to - self.from) * 0.25 * f64::from(i)) <= size)
    }

    /// A crossing moved by a part of the way along which the curves stay within `size` of each other.
    fn shifted(&self, crossing: &Moment, size: f64, part: f64) -> Moment {
        let x = crossing.at.x;
        let mut way = if part < 0.0 { self.from - x } else { self.to - x };
        let stays = |way: f64| (1..5).all(|i| self.gap(x + way * 0.25 * f64::from(i)) <= size);
        for _ in 0..60 {
            if stays(way) {
                let x = x + way * part.abs();
                return Moment::from(DVec2::new(x, self.f.y_at(x)));
            }
            way *= 0.5;
        }
        *crossing
    }
}

#[cfg(test)]
mod tests {
    use super::super::tangle::{Tangle, draw};
    use super::*;
    use crate::cases::rng::Rng;

    /// At many places of many pairs, where the module has f below g, f is not above g by more than the lie and a rounding.
    #[test]
    fn no_lie_is_longer_than_it_may_be() {
        for number in (0..400).filter(|number| (1..=5).contains(&(number % 8))) {
            let tangle = Tangle::of(&draw(&mut Rng::new(3, &format!("{number}")), number)).unwrap();
            let pieces = tangle.pieces();
            let module = tangle.module(&pieces);
            let map = arcsum::arrangement::arrange(&pieces);
            let curves: Vec<&Curve> = map.graph.curves.iter().take(map.audit.curves).collect();
            for (j, g) in curves.iter().enumerate() {
                for f in &curves[..j] {
                    let (pair, answer) = (Both::new(f, g), module.cross(f, g));
                    for i in 1..40 {
                        let x = pair.from + (pair.to - pair.from) * f64::from(i) / 40.0;
                        let passed = answer.points().iter().filter(|crossing| crossing.at.x <= x).count();
                        let wrong = f.y_at(x) - g.y_at(x);
                        let above = if answer.below ^ (passed == 1) { wrong } else { -wrong };
                        assert!(pair.from >= pair.to || above <= 2.0 * module.tolerance(), "{number}: {above}");
                    }
                }
            }
        }
    }
}
