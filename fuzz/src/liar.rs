//! A crossing module that lies: the honest one with random noise on every answer, fixed for a pair.

use arcsum::arrangement::cross::{CrossingModule, Crossings, FloatModule};
use arcsum::arrangement::curve::Curve;
use arcsum::arrangement::moment::Moment;
use glam::DVec2;

/// Noise of size up to `size` on distances and crossings, and the order of close pairs drawn by lot.
#[derive(Clone, Copy, Debug)]
pub struct Liar {
    /// The honest module underneath.
    pub honest: FloatModule,
    /// Size of the lies, in the units of the frame.
    pub size: f64,
    /// Seed of the noise.
    pub seed: u64,
}

impl Liar {
    /// Noise in [-1, 1] that depends on the seed and these numbers only.
    fn noise(&self, keys: &[u64]) -> f64 {
        let mut h = self.seed;
        for k in keys {
            h = (h ^ k).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            h ^= h >> 29;
        }
        h = h.wrapping_mul(0xbf58_476d_1ce4_e5b9);
        ((h >> 11) as f64) * 2.0_f64.powi(-52) - 1.0
    }
}

fn key(c: &Curve) -> u64 {
    c.start.x.to_bits() ^ c.right.y.to_bits().rotate_left(17) ^ (u64::from(c.piece) << 32) ^ u64::from(c.first)
}

impl CrossingModule for Liar {
    fn cross(&self, f: &Curve, g: &Curve) -> Crossings {
        let truth = self.honest.cross(f, g);
        if f.first == g.first || f.last == g.last {
            return truth;
        }
        let noise = |i| self.noise(&[key(f), key(g), i]);
        let moved: Vec<Moment> = (truth.points().iter().enumerate())
            .map(|(i, p)| Moment::from(p.at + self.size * DVec2::new(noise(2 * i as u64), noise(2 * i as u64 + 1))))
            .collect();
        let close = f.above(g.start).abs().min(g.above(f.start).abs()) < self.size;
        let below = if close { noise(7) > 0.0 } else { truth.below };
        Crossings::at(below, &moved)
    }

    fn above(&self, p: DVec2, curve: &Curve) -> f64 {
        self.honest.above(p, curve) + self.size * self.noise(&[p.x.to_bits(), p.y.to_bits(), key(curve)])
    }

    fn tolerance(&self) -> f64 {
        self.honest.tolerance()
    }
}
