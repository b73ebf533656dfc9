//! Culling: leaves out of a convolution what lies deep inside the sum, before it is arranged (ours).
//!
//! A grid is laid over the convolution. Where the winding number at one point of a cell exceeds the weights of the pieces in the
//! cell, it is positive in the whole cell, because a way from that point to another crosses each piece at most once for
//! the balance. Such a cell is blocked, whatever the arrangement in it looks like. Pieces are cut at the rims of what is
//! proved blocked, and what is inside is left out. A rim closes the curves again: its weight is what the winding number outside
//! lacks of [`DEEP`], so that it stays right outside and nonzero inside, rounding or not.
//!
//! No rim bounds the sum, since the winding number is positive on both its sides; so culling moves no boundary, and the
//! arrangement no longer finds the crossings that nobody asks for. Where a piece runs along a line of the grid up to rounding
//! it is taken to be on the side on which its walk through the grid is. The proof is about these walks, and the pieces differ
//! from them by roundings.

mod grid;
mod proof;
mod rim;
mod sample;
mod walk;

use crate::part::{Parts, part};
use crate::piece::{Piece, Pieces};
use grid::{Cell, Grid};
use proof::Proof;
use rim::{Rims, Side};
use sample::is_dense;
use walk::{Step, walk};

/// The winding number inside of what was culled: greater than any number of pieces that rounding may bring there.
const DEEP: i32 = 1 << 20;

/// With fewer pieces there is nothing to gain.
const FEW: usize = 256;

/// Culls a convolution, which must be one operand's and of closed curves: the parts of its pieces that are left, and rims.
/// `None` if there is nothing to gain.
#[must_use]
pub fn cull(pieces: &Pieces) -> Option<Parts> {
    if pieces.pieces.len() < FEW || !is_dense(pieces) {
        return None;
    }
    let grid = Grid::over(pieces)?;
    let proof = Proof::new(&grid, pieces);
    if !proof.is_worth_it() {
        return None;
    }
    let mut cutting = Cutting::new(&grid, &proof, pieces);
    for index in 0..pieces.pieces.len() {
        cutting.cut(index);
    }
    cutting.rims.close(&mut cutting.left)?;
    let Parts { pieces, origins } = &mut cutting.left;
    origins.resize(pieces.pieces.len(), None);
    Some(cutting.left)
}

/// Pieces being cut at the rims of what is proved.
struct Cutting<'a> {
    grid: &'a Grid,
    proof: &'a Proof,
    whole: &'a Pieces,
    left: Parts,
    rims: Rims<'a>,
    steps: Vec<Step>,
}

impl<'a> Cutting<'a> {
    fn new(grid: &'a Grid, proof: &'a Proof, whole: &'a Pieces) -> Self {
        let pieces = Pieces { points: whole.points.clone(), pieces: Vec::new(), base: whole.base };
        let left = Parts { pieces, origins: Vec::new() };
        Self { grid, proof, whole, left, rims: Rims::new(grid, proof), steps: Vec::new() }
    }

    /// Keeps the parts of a piece outside of what is proved.
    fn cut(&mut self, index: usize) {
        let piece = &self.whole.pieces[index];
        let mut steps = std::mem::take(&mut self.steps);
        if let Some((cell, rightward)) = walk(self.grid, self.whole, piece, &mut steps) {
            self.cut_along(index, cell, rightward, &steps);
        }
        self.steps = steps;
    }

    fn cut_along(&mut self, index: usize, mut cell: Cell, rightward: bool, steps: &[Step]) {
        let piece = self.whole.pieces[index];
        let (left, right) = if rightward { (piece.tail, piece.head) } else { (piece.head, piece.tail) };
        let mut from = (!self.proof.holds(cell)).then_some(left);
        for step in steps {
            let holds = self.proof.holds(step.to);
            if holds != self.proof.holds(cell) {
                let vertex = self.left.pieces.points.len() as u32;
                self.left.pieces.points.push(step.at);
                let (inner, outer) = if holds { (step.to, cell) } else { (cell, step.to) };
                // The winding number is higher on the left of the piece: of one that comes in, behind.
                let change = if holds == rightward { -piece.weight } else { piece.weight };
                self.rims.meet(inner, Side::towards(inner, outer), step.at, vertex, change);
                match from.take() {
                    Some(from) => self.keep(index, rightward, from, vertex),
                    None => from = Some(vertex),
                }
            }
            cell = step.to;
        }
        if let Some(from) = from {
            self.keep(index, rightward, from, right);
        }
    }

    fn keep(&mut self, index: usize, rightward: bool, left: u32, right: u32) {
        let piece: &Piece = &self.whole.pieces[index];
        let (tail, head) = if rightward { (left, right) } else { (right, left) };
        self.left.pieces.pieces.push(part(&self.left.pieces.points, piece, tail, head));
        self.left.origins.push(Some(index as u32));
    }
}
