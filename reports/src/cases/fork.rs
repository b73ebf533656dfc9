//! Forks (memo J5): pairs whose sum has a grid of (p^2-1)^2 small holes, the worst case of the field, also with the grid
//! covered by two thin triangles.
//!
//! P has coarse teeth, Q fine ones; the pitch of Q times p + 1 is the pitch of P. Both spines are on the left and both
//! bases at the bottom, so that spine plus tooth and base plus tooth stay clear of the grid.

use super::shape::{Point, lines, polygon, region};
use arcsum::region::Region;

/// The fork pair with p horizontal and p vertical teeth each: two polygons of 8p + 2 vertices.
#[must_use]
pub fn fork(p: u32) -> (Region, Region) {
    (polygon(&coarse(p)), polygon(&fine(p)))
}

/// The fork pair with a long thin triangle beside each fork; the sum of the triangles covers the sum of the forks.
#[must_use]
pub fn covered(p: u32) -> (Region, Region) {
    let flat = [[-3.0, -4.0], [37.0, -4.0], [-3.0, -3.9]];
    let upright = [[-2.0, -3.0], [-1.9, -3.0], [-2.0, 37.0]];
    (region(vec![lines(&coarse(p)), lines(&flat)]), region(vec![lines(&fine(p)), lines(&upright)]))
}

/// Pitch of the coarse teeth, pitch of the fine teeth, width of all teeth.
fn pitches(p: u32) -> (f64, f64, f64) {
    let coarse = 0.5 / f64::from(p);
    let fine = coarse / f64::from(p + 1);
    (coarse, fine, fine / 4.0)
}

fn coarse(p: u32) -> Vec<Point> {
    let (pitch, _, w) = pitches(p);
    let mut points = vec![[-w, -w]];
    let teeth = upward(p, pitch, w, 10.0);
    points.push([teeth[0][0], -w]);
    // The right side of the last tooth runs on into the base.
    points.extend(&teeth[1..]);
    points.push([0.0, 0.0]);
    points.extend(rightward(p, 12.0, pitch, w));
    let top = points.pop().map_or(0.0, |last| last[1]);
    points.push([-w, top]);
    points
}

fn fine(p: u32) -> Vec<Point> {
    let (_, pitch, w) = pitches(p);
    let bottom = -1.9;
    let mut points = vec![[-w, bottom]];
    points.extend(&rightward(p, bottom, pitch, w)[1..]);
    points.push([0.0, -w]);
    let teeth = upward(p, pitch, w, 8.0);
    points.push([teeth[0][0], -w]);
    points.extend(&teeth[1..]);
    points.push([-w, 0.0]);
    points
}

/// Vertical teeth on the line y = 0 from x = 6 on, walked from right to left: four corners a tooth.
fn upward(p: u32, pitch: f64, width: f64, tip: f64) -> Vec<Point> {
    let tooth = |i: u32| {
        let x = 6.0 + f64::from(i) * pitch;
        [[x + width, 0.0], [x + width, tip], [x, tip], [x, 0.0]]
    };
    (0..p).rev().flat_map(tooth).collect()
}

/// Horizontal teeth on the line x = 0 from y = `from` on, walked upwards: four corners a tooth.
fn rightward(p: u32, from: f64, pitch: f64, width: f64) -> Vec<Point> {
    let tooth = |i: u32| {
        let y = from + f64::from(i) * pitch;
        [[0.0, y], [10.0, y], [10.0, y + width], [0.0, y + width]]
    };
    (0..p).flat_map(tooth).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forks_have_the_papers_size() {
        for p in 1..=8 {
            let (a, b) = fork(p);
            assert_eq!((a.segments(), b.segments()), (8 * p as usize + 2, 8 * p as usize + 2));
        }
    }
}
