//! A stored loop at a precision: the exact normals at its marks, and the exact points that the stored numbers mean.
//!
//! A circle segment with tail t, head h and normal angles a, b consists of the points t + q (n - n_a), n the unit
//! normals from a to b and q = (h - t) / (n_b - n_a) as complex numbers (memo A5). A true circle segment has a real
//! q, its signed radius; the imaginary part is what is wrong with the stored numbers.

use std::ops::Range;

use super::path::Round;
use super::stored::{Angle, StoredPiece};
use super::up::Up;
use crate::certified::precision::Precision;
use crate::certified::vector::Vector;

/// A place on a loop, by the index of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// The tail of the piece.
    Tail(usize),
    /// Inside the piece, where it is parallel to the direction.
    Turn(usize),
    /// The head of the piece.
    Head(usize),
}

/// A loop, a direction and a precision. All vectors are in the frame of the direction.
#[derive(Clone, Copy)]
pub struct Track<'a> {
    /// The loop.
    pub pieces: &'a [StoredPiece],
    /// The direction.
    pub up: Up,
    /// The precision, not [`Precision::DOUBLE`].
    pub precision: Precision,
}

impl Mark {
    /// The piece it lies on.
    #[must_use]
    pub fn piece(self) -> usize {
        let (Self::Tail(piece) | Self::Turn(piece) | Self::Head(piece)) = self;
        piece
    }
}

impl Track<'_> {
    /// The normal at a mark, of the direction's length.
    #[must_use]
    pub fn normal(&self, mark: Mark) -> Vector {
        match mark {
            Mark::Tail(i) => self.at(self.pieces[i].start),
            Mark::Head(i) => self.at(self.pieces[i].end),
            Mark::Turn(i) => {
                let sum = &self.at(self.pieces[i].start) + &self.at(self.pieces[i].end);
                let length = self.up.square(self.precision).sqrt();
                let x = if sum.x.is_positive() { length } else { -&length };
                Vector { x, y: Vector::new(0.0, 0.0, self.precision).y }
            }
        }
    }

    /// The normal at an angle.
    #[must_use]
    pub fn at(&self, angle: Angle) -> Vector {
        self.up.normal(angle, self.precision)
    }

    /// A stored point.
    #[must_use]
    pub fn point(&self, p: (f64, f64)) -> Vector {
        self.up.to_frame(&Vector::new(p.0, p.1, self.precision))
    }

    /// Where the engine has the mark: a stored point, or the exact point of the stored piece.
    #[must_use]
    pub fn stored(&self, mark: Mark) -> Vector {
        match mark {
            Mark::Tail(i) => self.point(self.pieces[i].tail),
            Mark::Head(i) => self.point(self.pieces[i].head),
            Mark::Turn(i) => self.on(&(i..i + 1), mark),
        }
    }

    /// The place of a mark at the end of a span on the circle segment of several pieces, by its two ends alone.
    #[must_use]
    pub fn on(&self, pieces: &Range<usize>, mark: Mark) -> Vector {
        if mark == Mark::Tail(pieces.start) || mark == Mark::Head(pieces.end - 1) {
            return self.stored(mark);
        }
        let (tail, start, ratio) = self.similarity(pieces);
        &tail + &multiply(&ratio, &(&self.normal(mark) - &start))
    }

    /// The circle of the circle segment of several pieces, by its two ends alone.
    #[must_use]
    pub fn round(&self, pieces: &Range<usize>) -> Round {
        let (tail, start, ratio) = self.similarity(pieces);
        let size = ratio.length();
        let radius = if self.pieces[pieces.start].radius > 0.0 { size } else { -&size };
        Round { centre: &tail - &multiply(&ratio, &start), radius }
    }

    /// The tail t, the normal n_a there and the number q of the module's first lines.
    fn similarity(&self, pieces: &Range<usize>) -> (Vector, Vector, Vector) {
        let (first, last) = (Mark::Tail(pieces.start), Mark::Head(pieces.end - 1));
        let [tail, head] = [first, last].map(|end| self.stored(end));
        let [start, end] = [first, last].map(|end| self.normal(end));
        let ratio = divide(&(&head - &tail), &(&end - &start));
        (tail, start, ratio)
    }
}

/// The product of complex numbers.
fn multiply(a: &Vector, b: &Vector) -> Vector {
    Vector { x: &a.x * &b.x - &a.y * &b.y, y: &a.x * &b.y + &a.y * &b.x }
}

/// The quotient of complex numbers.
fn divide(a: &Vector, b: &Vector) -> Vector {
    let square = b.square();
    let conjugate = Vector { x: b.x.clone(), y: -&b.y };
    let product = multiply(a, &conjugate);
    Vector { x: &product.x / &square, y: &product.y / &square }
}
