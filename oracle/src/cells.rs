//! Sets of cells of a square lattice, as rows of bits.

use crate::lattice::Bounds;

/// A set of points or squares of a lattice: rows of bits.
#[derive(Clone, Debug)]
pub struct Cells {
    /// The numbers of the first column and row.
    corner: [i64; 2],
    columns: usize,
    rows: Vec<Vec<u64>>,
}

impl Cells {
    /// The empty set with room for the cells within the bounds.
    #[must_use]
    pub fn new([low, high]: Bounds) -> Self {
        let [columns, rows] = [0, 1].map(|k| (high[k] - low[k] + 1) as usize);
        Self { corner: low, columns, rows: vec![vec![0; columns.div_ceil(64)]; rows] }
    }

    /// Adds a run of cells, `first` to `last` included, of a row; what there is no room for is left out.
    pub fn insert(&mut self, row: i64, first: i64, last: i64) {
        if let Some((row, from, to)) = self.position(row, first, last) {
            words(from, to).for_each(|(word, mask)| self.rows[row][word] |= mask);
        }
    }

    /// Takes a run of cells out of the set.
    pub fn remove(&mut self, row: i64, first: i64, last: i64) {
        if let Some((row, from, to)) = self.position(row, first, last) {
            words(from, to).for_each(|(word, mask)| self.rows[row][word] &= !mask);
        }
    }

    /// Takes the cells of another set out of this one.
    pub fn remove_all(&mut self, other: &Self) {
        other.runs().into_iter().for_each(|(row, first, last)| self.remove(row, first, last));
    }

    /// Whether all cells of a run are in the set.
    #[must_use]
    pub fn contains(&self, row: i64, first: i64, last: i64) -> bool {
        let whole = |(row, from, to): (usize, usize, usize)| {
            (to - from) as i64 == last - first
                && words(from, to).all(|(word, mask)| self.rows[row][word] & mask == mask)
        };
        self.position(row, first, last).is_some_and(whole)
    }

    /// The row and the first and last column of the part of a run there is room for.
    fn position(&self, row: i64, first: i64, last: i64) -> Option<(usize, usize, usize)> {
        let row = usize::try_from(row - self.corner[1]).ok().filter(|&row| row < self.rows.len())?;
        let from = usize::try_from((first - self.corner[0]).max(0)).ok()?;
        let to = usize::try_from((last - self.corner[0]).min(self.columns as i64 - 1)).ok()?;
        (from <= to).then_some((row, from, to))
    }

    /// The longest runs: row, first and last cell of each.
    #[must_use]
    pub fn runs(&self) -> Vec<(i64, i64, i64)> {
        let mut runs: Vec<(i64, i64, i64)> = Vec::new();
        for (row, bits) in (self.corner[1]..).zip(&self.rows) {
            for column in (0..self.columns).filter(|column| bits[column / 64] >> (column % 64) & 1 == 1) {
                let column = column as i64 + self.corner[0];
                match runs.last_mut() {
                    Some((same, _, last)) if *same == row && *last + 1 == column => *last = column,
                    _ => runs.push((row, column, column)),
                }
            }
        }
        runs
    }
}

/// The words of a run of bits, `from` to `to` included, and their bits that belong to it.
fn words(from: usize, to: usize) -> impl Iterator<Item = (usize, u64)> {
    (from / 64..=to / 64).map(move |word| {
        let low = if word == from / 64 { !0 << (from % 64) } else { !0 };
        let high = if word == to / 64 { !0 >> (63 - to % 64) } else { !0 };
        (word, low & high)
    })
}
