//! The cells that an engine tells apart, with points to test them at (memo F).
//!
//! For every trapezoid of the vertical decomposition of a cell: the middle of the vertical at its middle abscissa, which
//! lies in the cell, and, for free cells, its corners, which lie on the boundary. Points are those of the engine's own
//! frame, as it sees them: to round them to input units could move them out of a thin cell.
//!
//! Up to [`MOST`] trapezoids of free cells and as many of blocked ones are handed over, beyond that every so many of them;
//! of free cells of no more than [`SMALL`] trapezoids, where bubbles are, all.

use super::corners::Corners;
use arcsum::arrangement::trapezoid::Trapezoid;
use arcsum::sum::Sum;

/// Trapezoids of free cells, and of blocked ones, that are handed over without leaving any out.
const MOST: usize = 500;

/// Trapezoids of a small cell.
const SMALL: usize = 4;

/// Cells and their test points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cells {
    /// The origin of the points in unit-box lengths: the sum of these two.
    pub origin: [[f64; 2]; 2],
    /// The cells of which some trapezoid is handed over.
    pub cells: Vec<Cell>,
    /// Trapezoids that are not.
    pub left_out: u64,
}

/// A cell of the arrangement, its points in unit-box lengths from the origin.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cell {
    /// Whether the engine takes its points for free.
    pub free: bool,
    /// Points inside.
    pub inside: Vec<[f64; 2]>,
    /// Points on its boundary, as far as doubles tell.
    pub corners: Vec<[f64; 2]>,
}

/// The cells of a sum, the one far away last if it is handed over.
#[must_use]
pub fn cells(sum: &Sum) -> Cells {
    let unit = |frame: &arcsum::frame::Frame| [frame.shift.x, frame.shift.y].map(|c| frame.length_to_unit(c));
    let windings = &sum.arrangement.graph.windings;
    let mut found = vec![Cell::default(); windings.len()];
    for (cell, winding) in found.iter_mut().zip(windings) {
        cell.free = winding[0] == 0;
    }
    let (kept, corners) = (selected(sum), Corners::new(&sum.arrangement));
    for trapezoid in &kept {
        add(&mut found[trapezoid.face as usize], sum, &corners, trapezoid);
    }
    found.rotate_left(1.min(windings.len()));
    found.retain(|cell| !(cell.inside.is_empty() && cell.corners.is_empty()));
    let left_out = (sum.arrangement.trapezoids.len() - kept.len()) as u64;
    Cells { origin: [unit(&sum.frames.0), unit(&sum.frames.1)], cells: found, left_out }
}

/// The trapezoids that are handed over.
fn selected(sum: &Sum) -> Vec<Trapezoid> {
    let arrangement = &sum.arrangement;
    let mut sizes = vec![0_usize; arrangement.graph.windings.len()];
    for trapezoid in &arrangement.trapezoids {
        sizes[trapezoid.face as usize] += 1;
    }
    // Small free cells, other free ones, blocked ones.
    let mut groups: [Vec<Trapezoid>; 3] = Default::default();
    for trapezoid in &arrangement.trapezoids {
        let face = trapezoid.face as usize;
        let free = arrangement.graph.windings[face][0] == 0;
        groups[if !free { 2 } else { usize::from(sizes[face] > SMALL) }].push(*trapezoid);
    }
    let [small, free, blocked] = groups;
    let thin = |group: Vec<Trapezoid>| {
        let stride = group.len().div_ceil(MOST).max(1);
        group.into_iter().step_by(stride)
    };
    small.into_iter().chain(thin(free)).chain(thin(blocked)).collect()
}

/// Adds the test points of a trapezoid. One too thin for a double between its curves has no middle.
fn add(cell: &mut Cell, sum: &Sum, corners: &Corners, trapezoid: &Trapezoid) {
    let x = 0.5 * (trapezoid.from + trapezoid.to);
    let curves = [trapezoid.bottom, trapezoid.top].map(|curve| &sum.arrangement.graph.curves[curve as usize]);
    let [low, high] = curves.map(|curve| curve.y_at(x));
    let y = 0.5 * (low + high);
    if trapezoid.from < x && x < trapezoid.to && low < y && y < high {
        cell.inside.push([x, y]);
    }
    if cell.free {
        for corner in corners.of(trapezoid).map(|p| p.to_array()) {
            // Neighbours share corners.
            if !cell.corners.iter().rev().take(8).any(|known| *known == corner) {
                cell.corners.push(corner);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{polygon, rectangle, region};
    use arcsum::region::{Node, Region};
    use arcsum::sum::{Options, sum};

    fn square(side: f64) -> Vec<Node> {
        rectangle([5.0, 7.0], [5.0 + side, 7.0 + side]).iter().map(|&[x, y]| Node::line(x, y)).collect()
    }

    fn frame() -> Region {
        let hole = rectangle([5.5, 7.5], [7.5, 9.5]).iter().rev().map(|&[x, y]| Node::line(x, y)).collect();
        region(vec![square(3.0), hole])
    }

    #[test]
    fn a_hole_is_a_free_cell_with_points_in_it() {
        let sum = sum(&frame(), &polygon(&rectangle([0.0, 0.0], [1.0, 1.0])), &Options::default()).unwrap();
        let cells = cells(&sum);
        assert_eq!(cells.left_out, 0);
        let unit = 4.0;
        let place = |p: &[f64; 2]| [0, 1].map(|i| unit * (p[i] + cells.origin[0][i] + cells.origin[1][i]));
        // The hole of the sum is the square from (6.5, 8.5) to (7.5, 9.5).
        let in_hole = |p: [f64; 2]| 6.5 < p[0] && p[0] < 7.5 && 8.5 < p[1] && p[1] < 9.5;
        let holes: Vec<&Cell> =
            cells.cells.iter().filter(|c| c.free && c.inside.iter().all(|p| in_hole(place(p)))).collect();
        assert_eq!(holes.len(), 1, "{cells:?}");
        assert!(holes[0].corners.iter().map(place).all(|[x, y]| (x == 6.5 || x == 7.5) && (y == 8.5 || y == 9.5)));
        for blocked in cells.cells.iter().filter(|c| !c.free) {
            assert!(blocked.inside.iter().all(|p| !in_hole(place(p))) && blocked.corners.is_empty());
        }
        assert!(cells.cells.iter().any(|c| !c.free && !c.inside.is_empty()));
    }
}
