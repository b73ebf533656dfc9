//! Random numbers that are hard on floating point: any magnitude, neighbours of given numbers, directions near the axes.

use super::rng::Rng;

impl Rng {
    /// 10 to a uniform power between lo and hi.
    pub fn decade(&mut self, lo: f64, hi: f64) -> f64 {
        libm::pow(10.0, self.between(lo, hi))
    }

    /// 1 or -1.
    pub fn sign(&mut self) -> f64 {
        if self.below(2) == 0 { 1.0 } else { -1.0 }
    }

    /// One of the items, of which there is at least one.
    pub fn pick<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        &items[self.below(items.len())]
    }

    /// A direction of length about 1: anywhere, near a diagonal, or near an axis down to subnormal numbers.
    pub fn direction(&mut self) -> [f64; 2] {
        let (major, sign) = (self.between(0.5, 1.0), self.sign());
        let minor = match self.below(4) {
            0 => self.unit(),
            1 => major * (1.0 - self.decade(-17.0, -1.0)),
            2 => major * self.decade(-17.0, 0.0),
            _ => major * self.decade(-320.0, -8.0),
        };
        let mut direction = [sign * major, minor * self.sign()];
        direction.rotate_left(self.below(2));
        direction
    }

    /// A tail and a head in the unit box about the origin, a chord of any length from 1e-12 up between them.
    pub fn chord(&mut self) -> [f64; 4] {
        let length = if self.below(2) == 0 { 1.0 } else { self.decade(-12.0, 0.0) };
        let way = self.direction().map(|x| x * length);
        // Half the time about the origin or on an axis, so that chords keep digits below the last place of 1.
        let mut place = |way: f64| {
            let place = self.between(-0.5, 0.5) * self.pick(&[1.0, 1.0, 0.0, 1e-9]);
            if (place + way).abs() > 0.5 { -way / 2.0 } else { place }
        };
        let tail = way.map(&mut place);
        [tail[0], tail[1], tail[0] + way[0], tail[1] + way[1]]
    }

    /// The number moved by up to `n` doubles either way.
    pub fn jitter(&mut self, x: f64, n: usize) -> f64 {
        let steps = self.below(2 * n + 1) as i64 - n as i64;
        let magnitude = (x.abs().to_bits() as i64 + steps).max(0);
        f64::from_bits(magnitude as u64).copysign(x)
    }
}
