//! The walk of a piece through the grid, from cell to cell.

use super::grid::{Cell, Grid};
use crate::arrangement::curve::Curve;
use crate::piece::{Piece, Pieces};
use glam::DVec2;

/// A step over a line of the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The cell that it leads to, next to the one before.
    pub to: Cell,
    /// Where: on the line, between the lines that cross it.
    pub at: DVec2,
}

/// The steps of a piece from left to right, of a vertical upwards, the cell where they begin, and whether the piece runs that
/// way; none if it has no length.
pub fn walk(grid: &Grid, pieces: &Pieces, piece: &Piece, steps: &mut Vec<Step>) -> Option<(Cell, bool)> {
    steps.clear();
    let point = |v: u32| pieces.points[v as usize];
    let (tail, head) = (point(piece.tail), point(piece.head));
    if tail == head {
        return None;
    }
    let rightward = (tail.x, tail.y) < (head.x, head.y);
    let (left, right) = if rightward { (tail, head) } else { (head, tail) };
    let (first, last) = (grid.cell(left), grid.cell(right));
    if first == last {
        return Some((first, rightward));
    }
    let curve = Curve::new(0, piece, (0, tail), (1, head), piece.whole.map(point))?;
    let mut walker = Walker { grid, curve: &curve, at: left, cell: first, steps };
    while walker.cell.column < last.column {
        let x = grid.xs[walker.cell.column + 1];
        let y = curve.y_at(x);
        let row = grid.row(y).clamp(first.row.min(last.row), first.row.max(last.row));
        walker.climb(row, x);
        walker.cross(DVec2::new(x, y));
    }
    walker.climb(last.row, right.x);
    Some((first, rightward))
}

struct Walker<'a> {
    grid: &'a Grid,
    curve: &'a Curve,
    at: DVec2,
    cell: Cell,
    steps: &'a mut Vec<Step>,
}

impl Walker<'_> {
    /// Steps to a row, no further to the right than `most`.
    fn climb(&mut self, row: usize, most: f64) {
        while self.cell.row != row {
            let up = self.cell.row < row;
            let to = Cell { row: if up { self.cell.row + 1 } else { self.cell.row - 1 }, ..self.cell };
            let y = self.grid.ys[if up { to.row } else { self.cell.row }];
            let x = if self.curve.is_vertical() { self.at.x } else { self.curve.x_at(y) };
            self.step(to, DVec2::new(x.max(self.at.x).min(most), y));
        }
    }

    /// Steps to the next column.
    fn cross(&mut self, at: DVec2) {
        let [low, high] = [0, 1].map(|next| self.grid.ys[self.cell.row + next]);
        let to = Cell { column: self.cell.column + 1, ..self.cell };
        self.step(to, DVec2::new(at.x, at.y.clamp(low, high)));
    }

    fn step(&mut self, to: Cell, at: DVec2) {
        (self.at, self.cell) = (at, to);
        self.steps.push(Step { to, at });
    }
}
