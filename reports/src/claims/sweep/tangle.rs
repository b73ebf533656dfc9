//! Sets of curves for the arrangement as numbers, with the module that is asked about them: what MS reference 5 takes in.
//!
//! The numbers are the lie, its size in eps of the box, the seed of the lies, and for each curve its ends and half sweep.

use super::super::input::Input;
use super::liar::{Liar, Lie};
use crate::cases::rng::Rng;
use arcsum::angle::Ang;
use arcsum::arrangement::cross::EPS;
use arcsum::arrangement::curve::compare;
use arcsum::piece::{Piece, Pieces, Source};
use glam::DVec2;
use libm::{pow, sin};

/// What the numbers are.
const FORMAT: &str = "lie, size, seed; x0, y0, x1, y1, half sweep of each curve";

/// Numbers before the curves.
const HEAD: usize = 3;

/// Numbers of curves in sets of growing size.
const SIZES: [usize; 7] = [8, 12, 16, 24, 32, 48, 96];

/// A set of curves and a lie about them.
#[derive(Clone, Debug)]
pub(super) struct Tangle {
    lie: Lie,
    /// Size of the lies, in eps of the box.
    size: f64,
    seed: f64,
    curves: Vec<[f64; 5]>,
}

impl Tangle {
    /// What an input holds; none if it is something else.
    pub(super) fn of(input: &Input) -> Option<Self> {
        let values = input.as_numbers(FORMAT)?;
        let head = values.get(..HEAD)?;
        let lie = Lie::numbered(head[0])?;
        let curves = values[HEAD..].chunks_exact(5).map(|c| c.try_into().expect("five numbers")).collect();
        Some(Self { lie, size: head[1].abs(), seed: head[2], curves })
    }

    /// The input that holds it.
    fn input(self) -> Input {
        let head = [self.lie.number(), self.size, self.seed];
        let values: Vec<f64> = head.into_iter().chain(self.curves.into_iter().flatten()).collect();
        Input::numbers(FORMAT, values)
    }

    /// The curves as pieces. What has no direction, or more than a quarter turn, is left out. Equal ends are one vertex.
    pub(super) fn pieces(&self) -> Pieces {
        let mut pieces = Pieces::default();
        for &[x0, y0, x1, y1, delta] in &self.curves {
            let (from, to) = (DVec2::new(x0, y0), DVec2::new(x1, y1));
            let Some(chord) = Ang::of_line(from, to).filter(|_| is_monotone(to - from, delta)) else { continue };
            let tail = pieces.points.len() as u32;
            pieces.points.extend([from, to]);
            let source = Source { first: pieces.pieces.len() as u32, second: 0 };
            let line = Piece::line(tail, tail + 1, chord, source);
            let r = if delta == 0.0 { 0.0 } else { 0.5 * (to - from).length() / sin(delta) };
            pieces.pieces.push(Piece { a: chord.plus(-delta), b: chord.plus(delta), delta, r, ..line });
        }
        pieces
    }

    /// Whether two ends of curves coincide.
    pub(super) fn shares_ends(&self) -> bool {
        let mut ends: Vec<DVec2> = self.pieces().points;
        let all = ends.len();
        ends.sort_by(|p, q| compare(*p, *q));
        ends.dedup();
        ends.len() < all
    }

    /// The module that is asked.
    pub(super) fn module(&self, pieces: &Pieces) -> Liar {
        let extent = extent(pieces);
        Liar::new(self.lie, extent, self.size * EPS * extent, self.seed.to_bits())
    }

    /// The same curves with lies so many times larger.
    pub(super) fn lying(self, times: f64) -> Self {
        Self { lie: Lie::Shifts, size: times * self.size.max(1.0), ..self }
    }
}

/// Whether the arc over a chord stays in one quarter turn.
fn is_monotone(chord: DVec2, delta: f64) -> bool {
    let (c, s) = (libm::cos(delta), sin(delta));
    let turned = |s: f64| [c * chord.x - s * chord.y, s * chord.x + c * chord.y];
    let [p, q] = [turned(s), turned(-s)];
    delta == 0.0 || delta.abs() < 0.8 && (0..2).all(|i| p[i] * q[i] > 0.0)
}

/// The larger side of the box of the vertices.
pub(in crate::claims) fn extent(pieces: &Pieces) -> f64 {
    let Some(&first) = pieces.points.first() else { return 0.0 };
    let (min, max) = pieces.points.iter().fold((first, first), |(min, max), p| (min.min(*p), max.max(*p)));
    (max - min).max_element()
}

/// A set of curves of any kind: in general position, in bundles, through one point, with tails inside of bundles, on a
/// small grid; with the honest module or one that lies.
pub(super) fn draw(rng: &mut Rng, number: usize) -> Input {
    let count = 4 + rng.below(16);
    of_kind(rng, number % 8, count)
}

/// Curves near each other in growing numbers, with a module that lies.
pub(super) fn draw_sized(rng: &mut Rng, number: usize) -> Input {
    of_kind(rng, 1 + number / SIZES.len() % 5, SIZES[number % SIZES.len()])
}

fn of_kind(rng: &mut Rng, kind: usize, count: usize) -> Input {
    let (seed, size) = (rng.below(1 << 40) as f64, 1.0 + rng.below(16) as f64);
    let (lie, curves) = match kind {
        0 => (Lie::None, (0..count).map(|_| any(rng)).collect()),
        1 => (Lie::Shifts, bundle(rng, count, 0.0)),
        2 => (Lie::Shifts, bundle(rng, count, 0.4)),
        3 => (Lie::Shifts, pencil(rng, count)),
        4 => (Lie::Stairs, stairs(count, size)),
        5 => (Lie::Shifts, tails(rng, count)),
        6 => (Lie::None, (0..count).map(|_| on_grid(rng)).collect()),
        _ => (Lie::None, tails(rng, count)),
    };
    let size = if lie == Lie::None { 1.0 } else { size };
    Tangle { lie, size, seed, curves }.input()
}

/// The same, but honest.
pub(super) fn draw_honest(rng: &mut Rng, number: usize) -> Input {
    let input = draw(rng, number);
    Tangle::of(&input).map_or(input, |tangle| Tangle { lie: Lie::None, size: 1.0, ..tangle }.input())
}

/// A line or an arc anywhere.
fn any(rng: &mut Rng) -> [f64; 5] {
    let mut number = || rng.between(-1.0, 1.0);
    let ends = [number(), number(), number(), number()];
    let half_sweep = if rng.below(2) == 0 { 0.0 } else { rng.between(-0.7, 0.7) };
    [ends[0], ends[1], ends[2], ends[3], half_sweep]
}

/// A width of a tenth of an eps to thousands of them.
fn width(rng: &mut Rng) -> f64 {
    EPS * pow(10.0, rng.between(-1.0, 4.0))
}

/// Curves that nearly are one.
fn bundle(rng: &mut Rng, count: usize, most: f64) -> Vec<[f64; 5]> {
    let (width, half_sweep, rise) = (width(rng), rng.between(-most, most), rng.between(0.5, 1.2));
    let mut noise = || width * rng.between(-1.0, 1.0);
    (0..count).map(|_| [noise(), noise(), 1.0 + noise(), rise + noise(), half_sweep]).collect()
}

/// Lines nearly through one point.
fn pencil(rng: &mut Rng, count: usize) -> Vec<[f64; 5]> {
    let (width, middle) = (width(rng), [rng.between(0.4, 0.6), rng.between(0.4, 0.6)]);
    let line = |_| {
        let (y, off) = (rng.unit(), width * rng.between(-1.0, 1.0));
        let slope = (middle[1] + off - y) / middle[0];
        [0.0, y, 1.0, y + slope, 0.0]
    };
    (0..count).map(line).collect()
}

/// Lines each of which lies a little below the one before: the lie has it above (memo C4).
fn stairs(count: usize, size: f64) -> Vec<[f64; 5]> {
    let line = |i: usize| {
        let drop = 0.99 * size * EPS * i as f64;
        [1e-3 * i as f64, 0.1 - drop, 1.0, 0.1 - drop, 0.0]
    };
    (0..count).map(line).collect()
}

/// A bundle with short curves that begin inside of it, which take up its direction or leave it.
fn tails(rng: &mut Rng, count: usize) -> Vec<[f64; 5]> {
    let long = bundle(rng, count.div_ceil(2), 0.0);
    let rise = long[0][3] - long[0][1];
    let mut curves = long;
    let width = width(rng);
    while curves.len() < count {
        let (x, length) = (rng.between(0.05, 0.9), rng.between(0.01, 0.1));
        let bent = if rng.below(2) == 0 { rng.between(-0.3, 0.3) } else { width * rng.between(-1.0, 1.0) };
        let y = rise * x + width * rng.between(-1.0, 1.0);
        curves.push([x, y, x + length, y + rise * length + bent, 0.0]);
    }
    curves
}

/// A line between two points of a small grid.
fn on_grid(rng: &mut Rng) -> [f64; 5] {
    let mut number = || rng.below(5) as f64;
    [number(), number(), number(), number(), 0.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangles_read_back_and_have_curves() {
        for number in 0..64 {
            let input = draw(&mut Rng::new(1, &format!("{number}")), number);
            let tangle = Tangle::of(&input).unwrap();
            assert!(!tangle.pieces().pieces.is_empty());
            assert_eq!(tangle.input(), input);
        }
        assert!(Tangle::of(&Input::numbers("t, d, q", [0.0; 8])).is_none());
    }
}
