//! The sum of three doubles, rounded once (memo A6): what MS 4.1 asks of every end point `t + d + q`.
//!
//! MS add the two errors of two TwoSums, which is not the correctly rounded sum (memo fact 9). Rounding the inner sum
//! of the errors to odd is (Boldo and Melquiond, *Emulation of FMA and correctly rounded sums*, 2008).

use crate::twofold::two_sum;
use glam::DVec2;

/// How three terms are added.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// Rounded once, to nearest, ties to even.
    #[default]
    Correct,
    /// `(t + d) + q`, rounded twice: the papers' baseline.
    Plain,
}

impl Rounding {
    /// `t + d + q` of numbers. [`Rounding::Correct`] needs magnitudes below 2^1022; subnormal numbers are fine.
    #[must_use]
    pub fn sum(self, t: f64, d: f64, q: f64) -> f64 {
        match self {
            Self::Correct => round_once(t, d, q),
            Self::Plain => (t + d) + q,
        }
    }

    /// `t + d + q` of vectors, by coordinates.
    #[must_use]
    pub fn sum_points(self, t: DVec2, d: DVec2, q: DVec2) -> DVec2 {
        DVec2::new(self.sum(t.x, d.x, q.x), self.sum(t.y, d.y, q.y))
    }
}

fn round_once(t: f64, d: f64, q: f64) -> f64 {
    let (inner, inner_error) = two_sum(d, q);
    let (outer, outer_error) = two_sum(t, inner);
    outer + odd_sum(outer_error, inner_error)
}

/// `x + y` rounded to odd: exact, or the neighbour with an odd last bit. A later rounding to nearest then cannot
/// mistake an inexact sum for a tie.
fn odd_sum(x: f64, y: f64) -> f64 {
    let (s, error) = two_sum(x, y);
    if error == 0.0 || s.to_bits() & 1 == 1 {
        s
    } else if error > 0.0 {
        s.next_up()
    } else {
        s.next_down()
    }
}
