//! Rims: the boundary of what is proved blocked, with weights that close the curves that were cut there.
//!
//! A rim is run with the inside on its left. Along it the winding number outside changes where a piece comes in or goes out.

use super::DEEP;
use super::grid::{Cell, Grid};
use super::proof::{Proof, middle};
use crate::part::Parts;
use crate::piece::{Piece, Source};
use glam::DVec2;
use rustc_hash::FxHashMap as HashMap;

/// A side of a cell, run with the cell on its left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// Rightward.
    Bottom,
    /// Upward.
    Right,
    /// Leftward.
    Top,
    /// Downward.
    Left,
}

const SIDES: [Side; 4] = [Side::Bottom, Side::Right, Side::Top, Side::Left];

impl Side {
    /// The side of a cell that it shares with another.
    #[must_use]
    pub fn towards(cell: Cell, other: Cell) -> Self {
        match (other.column > cell.column, other.column < cell.column, other.row > cell.row) {
            (true, _, _) => Self::Right,
            (_, true, _) => Self::Left,
            (_, _, true) => Self::Top,
            _ => Self::Bottom,
        }
    }

    /// How far along the side a point is.
    fn along(self, p: DVec2) -> f64 {
        match self {
            Self::Bottom => p.x,
            Self::Right => p.y,
            Self::Top => -p.x,
            Self::Left => -p.y,
        }
    }

    /// The side that comes next around a cell, or with `steps` 3 the one before.
    fn turned(self, steps: usize) -> Self {
        SIDES[(self as usize + steps) % 4]
    }
}

/// Where a piece crosses a rim.
#[derive(Clone, Copy, Debug)]
struct Meeting {
    along: f64,
    vertex: u32,
    /// By how much the winding number outside changes there, along the rim.
    change: i32,
}

/// The rims of what is proved.
pub struct Rims<'a> {
    grid: &'a Grid,
    proof: &'a Proof,
    meetings: HashMap<(usize, Side), Vec<Meeting>>,
}

impl<'a> Rims<'a> {
    /// Rims that nothing crosses yet.
    pub fn new(grid: &'a Grid, proof: &'a Proof) -> Self {
        Self { grid, proof, meetings: HashMap::default() }
    }

    /// Notes that a piece crosses a side of a proved cell, where the winding number outside changes by so much along the rim.
    pub fn meet(&mut self, inner: Cell, side: Side, at: DVec2, vertex: u32, change: i32) {
        let meeting = Meeting { along: side.along(at), vertex, change };
        self.meetings.entry((self.grid.index(inner), side)).or_default().push(meeting);
    }

    /// Adds all rims. `None` if the winding numbers do not come out even, which would be a mistake of the walks.
    pub fn close(&mut self, left: &mut Parts) -> Option<()> {
        self.meetings.values_mut().for_each(|met| met.sort_by(|p, q| p.along.total_cmp(&q.along)));
        let mut done = vec![false; 4 * self.grid.columns() * self.grid.rows()];
        for column in 0..self.grid.columns() {
            for row in 0..self.grid.rows() {
                for side in [Side::Right, Side::Left] {
                    let start = (Cell { column, row }, side);
                    if self.is_rim(start) && !done[self.number(start)] {
                        self.run(start, left, &mut done)?;
                    }
                }
            }
        }
        Some(())
    }

    fn number(&self, (cell, side): (Cell, Side)) -> usize {
        4 * self.grid.index(cell) + side as usize
    }

    fn is_rim(&self, (cell, side): (Cell, Side)) -> bool {
        self.proof.holds(cell) && self.neighbour(cell, side).is_none_or(|other| !self.proof.holds(other))
    }

    /// The cell beyond a side, if there is one.
    fn neighbour(&self, Cell { column, row }: Cell, side: Side) -> Option<Cell> {
        let (column, row) = match side {
            Side::Bottom => (Some(column), row.checked_sub(1)),
            Side::Right => (Some(column + 1).filter(|c| *c < self.grid.columns()), Some(row)),
            Side::Top => (Some(column), Some(row + 1).filter(|r| *r < self.grid.rows())),
            Side::Left => (column.checked_sub(1), Some(row)),
        };
        Some(Cell { column: column?, row: row? })
    }

    /// The side of a rim after this one. Where two cells touch at a corner only, their rims stay apart.
    fn next(&self, (cell, side): (Cell, Side)) -> (Cell, Side) {
        let blocked = |cell: Option<Cell>| cell.filter(|cell| self.proof.holds(*cell));
        let ahead = side.turned(1);
        let Some(left) = blocked(self.neighbour(cell, ahead)) else { return (cell, ahead) };
        match blocked(self.neighbour(left, side)) {
            None => (left, side),
            Some(right) => (right, side.turned(3)),
        }
    }

    fn met(&self, (cell, side): (Cell, Side)) -> &[Meeting] {
        self.meetings.get(&(self.grid.index(cell), side)).map_or(&[], Vec::as_slice)
    }

    /// The corner where a side begins.
    fn corner(&self, (Cell { column, row }, side): (Cell, Side)) -> DVec2 {
        let (right, up) = match side {
            Side::Bottom => (0, 0),
            Side::Right => (1, 0),
            Side::Top => (1, 1),
            Side::Left => (0, 1),
        };
        DVec2::new(self.grid.xs[column + right], self.grid.ys[row + up])
    }

    /// The winding number outside at the beginning of an upright side.
    fn outside(&self, start: (Cell, Side)) -> i32 {
        let (Cell { column, row }, side) = start;
        let cell = if side == Side::Right { Cell { column: column + 1, row } } else { start.0 };
        // Beyond the last column there is nothing but the base.
        let winding = if cell.column < self.grid.columns() { self.proof.winding(cell) } else { self.proof.base };
        let middle = side.along(DVec2::new(0.0, middle(self.grid, row)));
        // On a line that is run downwards a piece right in the middle comes before it.
        let before = |met: &&Meeting| if side == Side::Right { met.along < middle } else { met.along <= middle };
        winding - self.met(start).iter().filter(before).map(|met| met.change).sum::<i32>()
    }

    /// Adds the rim that this side, which is upright, belongs to.
    fn run(&self, start: (Cell, Side), left: &mut Parts, done: &mut [bool]) -> Option<()> {
        let first = add_point(left, self.corner(start));
        let (mut at, mut from, beginning) = (start, first, self.outside(start));
        let mut outside = beginning;
        loop {
            done[self.number(at)] = true;
            for met in self.met(at) {
                add_piece(left, [from, met.vertex], DEEP - outside);
                outside += met.change;
                from = met.vertex;
            }
            let next = self.next(at);
            if next == start {
                break;
            }
            if next.1 != at.1 {
                let corner = add_point(left, self.corner(next));
                add_piece(left, [from, corner], DEEP - outside);
                from = corner;
            }
            at = next;
        }
        add_piece(left, [from, first], DEEP - outside);
        (outside == beginning).then_some(())
    }
}

fn add_point(left: &mut Parts, point: DVec2) -> u32 {
    left.pieces.points.push(point);
    (left.pieces.points.len() - 1) as u32
}

fn add_piece(left: &mut Parts, [tail, head]: [u32; 2], weight: i32) {
    let source = Source { first: u32::MAX, second: head };
    let piece = Piece::between(&left.pieces.points, tail, head, source);
    left.pieces.pieces.push(Piece { weight, ..piece });
}
