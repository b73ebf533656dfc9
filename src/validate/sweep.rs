//! The meetings of many lines in O(n log n), by a sweep with exact predicates (Shamos and Hoey, *Geometric intersection
//! problems*, 1976), extended to lines that touch.
//!
//! Points are met in order of x, then y, as if the plane were sheared a little; so no line is vertical. The status holds the
//! lines at the sweep point from bottom to top. Up to the first crossing that order is total, and the two lines that cross
//! first are neighbours before they do.

use super::boundary::Part;
use super::line::meet;
use super::{Contact, Invalid};
use crate::exact::orientation;
use glam::DVec2;
use std::cmp::Ordering::{self, Equal, Greater};

/// The number of lines at which a block of the status is halved.
const BLOCK: usize = 512;

/// Calls `visit` for all pairs of lines that share an end of either, and for a pair that crosses, until it fails.
/// `visit` must fail for a pair that crosses or overlaps.
pub fn sweep(parts: &[Part], mut visit: impl FnMut(usize, usize) -> Result<(), Invalid>) -> Result<(), Invalid> {
    let mut starts: Vec<usize> = (0..parts.len()).filter(|&i| parts[i].is_line()).collect();
    starts.sort_by(|&i, &j| order(ends(&parts[i]).0, ends(&parts[j]).0));
    let mut points: Vec<DVec2> = starts.iter().flat_map(|&i| [parts[i].tail, parts[i].head]).collect();
    points.sort_by(|&p, &q| order(p, q));
    points.dedup();
    let mut status = Status { parts, blocks: Vec::new() };
    let mut starts = starts.as_slice();
    for point in points {
        let count = starts.partition_point(|&i| ends(&parts[i]).0 == point);
        let (starting, rest) = starts.split_at(count);
        status.advance(point, starting, &mut visit)?;
        starts = rest;
    }
    Ok(())
}

fn order(p: DVec2, q: DVec2) -> Ordering {
    p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
}

/// The first and the last point of a line in the order of the sweep.
fn ends(part: &Part) -> (DVec2, DVec2) {
    if order(part.tail, part.head).is_le() { (part.tail, part.head) } else { (part.head, part.tail) }
}

/// The lines at the sweep point, from bottom to top, in blocks none of which is empty.
struct Status<'a> {
    parts: &'a [Part],
    blocks: Vec<Vec<usize>>,
}

/// Index of a block, and of a line in it.
type Position = (usize, usize);

impl Status<'_> {
    /// Moves the sweep to the next point: lines that end there leave the status, lines that start there enter it.
    fn advance(
        &mut self,
        point: DVec2,
        starting: &[usize],
        visit: &mut impl FnMut(usize, usize) -> Result<(), Invalid>,
    ) -> Result<(), Invalid> {
        let mut here = Vec::new();
        while let Some(line) = self.get(self.find(point)).filter(|&line| self.side(line, point) == Equal) {
            here.push(line);
            self.remove(self.find(point));
        }
        here.extend(starting);
        for (k, &i) in here.iter().enumerate() {
            here[k + 1..].iter().try_for_each(|&j| visit(i, j))?;
        }
        // None of them overlap, so their directions from the point are ordered strictly.
        here.retain(|&line| ends(&self.parts[line]).1 != point);
        let end = |line: usize| ends(&self.parts[line]).1;
        here.sort_by(|&i, &j| orientation(point, end(j), end(i)));
        let position = self.find(point);
        let (below, above) = (self.before(position), self.get(position));
        for &line in here.iter().rev() {
            self.insert(self.find(point), line);
        }
        let neighbours = match (here.first(), here.last()) {
            (Some(&first), Some(&last)) => [(below, Some(first)), (Some(last), above)],
            _ => [(below, above), (None, None)],
        };
        let pairs = neighbours.into_iter().filter_map(|(low, high)| low.zip(high));
        pairs.filter(|&(low, high)| self.cross(low, high)).try_for_each(|(low, high)| visit(low, high))
    }

    /// On which side of a line a point lies: `Greater` if the point is above.
    fn side(&self, line: usize, point: DVec2) -> Ordering {
        let (first, last) = ends(&self.parts[line]);
        orientation(first, last, point)
    }

    fn cross(&self, i: usize, j: usize) -> bool {
        let line = |i: usize| (self.parts[i].tail, self.parts[i].head);
        matches!(meet(line(i), line(j)), Some((Contact::Cross, _)))
    }

    /// The position of the lowest line that is not below the point.
    fn find(&self, point: DVec2) -> Position {
        let below = |line: usize| self.side(line, point) == Greater;
        let block = self.blocks.partition_point(|block| block.last().is_some_and(|&line| below(line)));
        (block, self.blocks.get(block).map_or(0, |lines| lines.partition_point(|&line| below(line))))
    }

    fn get(&self, (block, index): Position) -> Option<usize> {
        self.blocks.get(block)?.get(index).copied()
    }

    fn before(&self, (block, index): Position) -> Option<usize> {
        match index {
            0 => self.blocks.get(block.checked_sub(1)?)?.last().copied(),
            _ => self.get((block, index - 1)),
        }
    }

    fn insert(&mut self, (block, index): Position, line: usize) {
        if block == self.blocks.len() {
            self.blocks.push(vec![line]);
            return;
        }
        let lines = &mut self.blocks[block];
        lines.insert(index, line);
        if lines.len() > BLOCK {
            let upper = lines.split_off(BLOCK / 2);
            self.blocks.insert(block + 1, upper);
        }
    }

    fn remove(&mut self, (block, index): Position) {
        self.blocks[block].remove(index);
        if self.blocks[block].is_empty() {
            self.blocks.remove(block);
        }
    }
}
