//! Which way loops run and how deep they lie: a loop inside an even number of others is an outer loop and must run
//! counter-clockwise, one inside an odd number is a hole and must run clockwise; the other way round when the region is
//! unbounded (memo A8).

use super::Invalid;
use super::boundary::{Boundary, Part};
use super::boxes::Tree;
use super::touch::Touch;
use crate::exact::orientation;
use glam::DVec2;
use std::cmp::Ordering::{Equal, Greater, Less};
use std::collections::HashMap;

/// Which loops run clockwise. Exact for loops of lines; a loop with curves must enclose more than its length times the
/// tolerance.
pub fn directions(boundary: &Boundary) -> Result<Vec<bool>, Invalid> {
    (0..boundary.loops.len())
        .map(|loop_index| {
            let parts = &boundary.parts[boundary.loops[loop_index].clone()];
            let clockwise =
                if parts.iter().all(Part::is_line) { runs_clockwise(parts) } else { turns_clockwise(parts, boundary) };
            clockwise.ok_or(Invalid::NoArea(loop_index))
        })
        .collect()
}

/// Whether a simple polygon runs clockwise, from its turn at the least vertex; `None` if all vertices are on a line.
fn runs_clockwise(parts: &[Part]) -> Option<bool> {
    let first = parts[0];
    if parts.iter().all(|part| orientation(first.tail, first.head, part.tail) == Equal) {
        return None;
    }
    let order = |p: DVec2, q: DVec2| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y));
    let least = (0..parts.len()).min_by(|&i, &j| order(parts[i].tail, parts[j].tail))?;
    let before = parts[(least + parts.len() - 1) % parts.len()].tail;
    Some(orientation(before, parts[least].tail, parts[least].head) == Less)
}

/// Whether a loop with curves runs clockwise, from its area; `None` if that is nothing within the tolerance.
fn turns_clockwise(parts: &[Part], boundary: &Boundary) -> Option<bool> {
    let origin = parts[0].tail;
    let area: f64 = parts.iter().map(|p| (p.tail - origin).perp_dot(p.head - origin) / 2.0 + p.cap()).sum();
    let length: f64 = parts.iter().map(|p| p.length).sum();
    (area.abs() > length * boundary.tolerance).then_some(area < 0.0)
}

/// How the loops of a region lie.
pub struct Nesting<'a> {
    boundary: &'a Boundary,
    tree: &'a Tree,
    clockwise: &'a [bool],
    touches: HashMap<usize, Vec<(Touch, bool)>>,
    depths: Vec<usize>,
    unbounded: bool,
}

impl<'a> Nesting<'a> {
    /// Finds the depths of all loops and checks that the loops run the right way.
    pub fn new(
        boundary: &'a Boundary,
        tree: &'a Tree,
        clockwise: &'a [bool],
        touches: &[Touch],
        unbounded: bool,
    ) -> Result<Self, Invalid> {
        let mut of_loop: HashMap<usize, Vec<(Touch, bool)>> = HashMap::new();
        for touch in touches {
            let [first, second] = touch.loops(boundary);
            of_loop.entry(first).or_default().push((*touch, true));
            of_loop.entry(second).or_default().push((*touch, false));
        }
        let mut nesting = Self { boundary, tree, clockwise, touches: of_loop, depths: Vec::new(), unbounded };
        for (loop_index, &clockwise) in clockwise.iter().enumerate() {
            let depth = nesting.around(loop_index).len();
            if clockwise != nesting.is_hole(depth) {
                return Err(Invalid::WrongOrientation { loop_index, depth, clockwise });
            }
            nesting.depths.push(depth);
        }
        Ok(nesting)
    }

    /// The connected part of the region that a loop bounds, by its outer loop; `None` for the unbounded part.
    pub fn component(&self, loop_index: usize) -> Option<usize> {
        let depth = self.depths[loop_index];
        if !self.is_hole(depth) {
            return Some(loop_index);
        }
        self.around(loop_index).into_iter().find(|&l| self.depths[l] + 1 == depth)
    }

    fn is_hole(&self, depth: usize) -> bool {
        (depth % 2 == 1) != self.unbounded
    }

    /// The loops that a loop lies in.
    fn around(&self, loop_index: usize) -> Vec<usize> {
        let none = Vec::new();
        let touches = self.touches.get(&loop_index).unwrap_or(&none);
        let parts = &self.boundary.parts[self.boundary.loops[loop_index].clone()];
        let touched = |point: DVec2| touches.iter().any(|(touch, _)| touch.at == point);
        let from = parts.iter().map(|part| part.tail).find(|&tail| !touched(tail)).unwrap_or(parts[0].tail);
        let mut crossed = Vec::new();
        self.tree.on_ray(from, &mut |index| {
            let part = &self.boundary.parts[index];
            if part.place.loop_index != loop_index && is_left(part, from) {
                crossed.push(part.place.loop_index);
            }
        });
        let mut inside = odd_ones(crossed);
        // Where even this vertex is a touch, the ray cannot tell; the arms there can.
        for (touch, swapped) in touches.iter().filter(|(touch, _)| touch.at == from) {
            let other = touch.loops(self.boundary)[usize::from(*swapped)];
            inside.retain(|&l| l != other);
            if touch.leaves_left(self.boundary, *swapped) != self.clockwise[other] {
                inside.push(other);
            }
        }
        inside
    }
}

/// The members that occur an odd number of times, each once.
fn odd_ones(mut members: Vec<usize>) -> Vec<usize> {
    members.sort_unstable();
    members.chunk_by(|a, b| a == b).filter(|equal| equal.len() % 2 == 1).map(|equal| equal[0]).collect()
}

/// Whether the ray from a point to the left crosses the part, the lower end belonging to it and the upper one not.
fn is_left(part: &Part, from: DVec2) -> bool {
    match (part.tail.y <= from.y, part.head.y <= from.y) {
        (true, false) => part.side(from) == Less,
        (false, true) => part.side(from) == Greater,
        _ => false,
    }
}
