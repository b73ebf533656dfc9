//! The proof: winding numbers at one point of each cell, and the cells in which it cannot fall to 0.

use super::grid::{Cell, Grid};
use super::walk::walk;
use crate::piece::Pieces;
use glam::DVec2;

/// Winding numbers, and what they prove.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The winding number in the middle of the left side of each cell.
    windings: Vec<i32>,
    holds: Vec<bool>,
    /// How many pieces pass each cell.
    visits: Vec<u32>,
    rows: usize,
    /// The winding number far away.
    pub base: i32,
}

impl Proof {
    /// Counts pieces in cells and winding numbers between them.
    #[must_use]
    pub fn new(grid: &Grid, pieces: &Pieces) -> Self {
        let rows = grid.rows();
        let cells = grid.columns() * rows;
        let (mut falls, mut visits) = (vec![0_i32; cells], vec![0_u32; cells]);
        let (mut changes, mut steps) = (vec![0_i32; cells], Vec::new());
        for piece in &pieces.pieces {
            let Some((mut cell, rightward)) = walk(grid, pieces, piece, &mut steps) else { continue };
            let weight = if rightward { piece.weight } else { -piece.weight };
            let (is_higher_above, fall) = (weight > 0, weight.abs());
            let mut entry = None;
            for step in &steps {
                // A piece that begins in a cell may be passed on both sides.
                let may_fall = entry.is_none_or(|entry| is_on_left(grid, cell, entry) == is_higher_above);
                falls[grid.index(cell)] += if may_fall { fall } else { 0 };
                visits[grid.index(cell)] += 1;
                if step.to.column != cell.column && step.at.y < middle(grid, step.to.row) {
                    changes[grid.index(step.to)] += weight;
                } else if step.to.column != cell.column && step.to.row + 1 < rows {
                    changes[grid.index(step.to) + 1] += weight;
                }
                entry = Some((cell, step.at));
                cell = step.to;
            }
            falls[grid.index(cell)] += fall;
            visits[grid.index(cell)] += 1;
        }
        let windings = changes.chunks(rows).flat_map(|column| {
            column.iter().scan(pieces.base[0], |winding, change| {
                *winding += change;
                Some(*winding)
            })
        });
        let windings: Vec<i32> = windings.collect();
        let holds = windings.iter().zip(&falls).map(|(winding, falls)| winding > falls).collect();
        Self { windings, holds, visits, rows, base: pieces.base[0] }
    }

    /// Whether the winding number is positive in the whole cell.
    #[must_use]
    pub fn holds(&self, cell: Cell) -> bool {
        self.holds[cell.column * self.rows + cell.row]
    }

    /// Whether culling takes away more crossings than its rims bring, by a guess: of the pairs in a cell half cross, and of the
    /// pieces beside what is proved all go on into it.
    #[must_use]
    pub fn is_worth_it(&self) -> bool {
        let (mut saved, mut cost) = (0_u64, 0_u64);
        for (index, visits) in self.visits.iter().enumerate() {
            let visits = u64::from(*visits);
            let near = [index.wrapping_sub(1), index + 1, index.wrapping_sub(self.rows), index + self.rows];
            if self.holds[index] {
                saved += visits * visits.saturating_sub(1) / 4;
            } else if near.into_iter().any(|other| self.holds.get(other) == Some(&true)) {
                cost += visits + 2;
            }
        }
        saved > cost
    }

    /// The winding number in the middle of the left side of a cell.
    #[must_use]
    pub fn winding(&self, cell: Cell) -> i32 {
        self.windings[cell.column * self.rows + cell.row]
    }
}

/// Whether the middle of the left side of a cell is on the left of what comes in from another cell at a point and goes out
/// again.
fn is_on_left(grid: &Grid, cell: Cell, (from, at): (Cell, DVec2)) -> bool {
    if from.column == cell.column { from.row < cell.row } else { at.y < middle(grid, cell.row) }
}

/// The ordinate in the middle of a row.
#[must_use]
pub fn middle(grid: &Grid, row: usize) -> f64 {
    0.5 * (grid.ys[row] + grid.ys[row + 1])
}
