//! The grid: equal cells over a box, between lines on which no end of a piece lies.

use crate::piece::Pieces;
use glam::DVec2;

/// Cells for each piece. More prove more and take longer to walk through; between 6 and 12 that is about even.
const CELLS_A_PIECE: usize = 8;

/// Most cells along a side: what is counted in them stays in the cache of a processor, and twice as many take twice as long.
const MOST: usize = 1024;

/// A cell, by column and row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The column, from the left.
    pub column: usize,
    /// The row, from below.
    pub row: usize,
}

/// Cells over a box.
#[derive(Clone, Debug)]
pub struct Grid {
    /// The abscissas of the lines between the columns, the two outer ones included.
    pub xs: Vec<f64>,
    /// The ordinates of the lines between the rows.
    pub ys: Vec<f64>,
}

impl Grid {
    /// A grid over all ends of pieces, if these span a box.
    #[must_use]
    pub fn over(pieces: &Pieces) -> Option<Self> {
        let ends = || pieces.pieces.iter().flat_map(|p| [p.tail, p.head]).map(|v| pieces.points[v as usize]);
        let first = ends().next()?;
        let (low, high) = ends().fold((first, first), |(low, high), p| (low.min(p), high.max(p)));
        let size = high - low;
        if !(size.is_finite() && size.min_element() > 0.0) {
            return None;
        }
        let side = (size.x * size.y / (CELLS_A_PIECE * pieces.pieces.len()) as f64).sqrt();
        let lines = |low: f64, size: f64, of_point: &dyn Fn(DVec2) -> f64| {
            let count = ((size / side) as usize).clamp(1, MOST);
            let step = size / count as f64;
            // The outer lines are well outside.
            let lines: Vec<f64> = (0..=count + 1).map(|i| low + (i as f64 - 0.53) * step).collect();
            let mut lines = Self::free_of(lines, ends().map(of_point));
            lines.dedup();
            (lines.len() > 2).then_some(lines)
        };
        Some(Self { xs: lines(low.x, size.x, &|p| p.x)?, ys: lines(low.y, size.y, &|p| p.y)? })
    }

    /// Lines moved off all these coordinates.
    fn free_of(mut lines: Vec<f64>, taken: impl Iterator<Item = f64>) -> Vec<f64> {
        let mut near: Vec<f64> = taken.filter(|x| lines.binary_search_by(|line| line.total_cmp(x)).is_ok()).collect();
        near.sort_unstable_by(f64::total_cmp);
        for line in &mut lines {
            while near.binary_search_by(|x| x.total_cmp(line)).is_ok() {
                *line = line.next_up();
            }
        }
        lines
    }

    /// How many columns there are.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.xs.len() - 1
    }

    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.ys.len() - 1
    }

    /// The number of a cell.
    #[must_use]
    pub fn index(&self, cell: Cell) -> usize {
        cell.column * self.rows() + cell.row
    }

    /// The cell that a point is in.
    #[must_use]
    pub fn cell(&self, p: DVec2) -> Cell {
        Cell { column: between(&self.xs, p.x), row: between(&self.ys, p.y) }
    }

    /// The row that an ordinate is in.
    #[must_use]
    pub fn row(&self, y: f64) -> usize {
        between(&self.ys, y)
    }
}

/// The interval between lines that a number is in.
fn between(lines: &[f64], x: f64) -> usize {
    let last = lines.len() - 2;
    let guess = (x - lines[0]) / (lines[1] - lines[0]);
    let mut i = (guess.max(0.0) as usize).min(last);
    while i > 0 && x < lines[i] {
        i -= 1;
    }
    while i < last && x >= lines[i + 1] {
        i += 1;
    }
    i
}
