//! Combs (memo J5): a bar with teeth, against a comb with teeth at right angles or against a regular polygon.

use super::place::quarter_turned;
use super::shape::{Point, polygon, regular};
use arcsum::region::Region;

/// Two combs of n teeth, the teeth of one at right angles to those of the other.
#[must_use]
pub fn combs(n: u32) -> (Region, Region) {
    let comb = polygon(&comb(n, &[10.0]));
    let other = quarter_turned(&comb);
    (comb, other)
}

/// A comb of n teeth of alternating heights and a regular polygon narrower than the gaps.
#[must_use]
pub fn comb_and_polygon(n: u32, corners: u32) -> (Region, Region) {
    (polygon(&comb(n, &[10.0, 25.0])), polygon(&regular(corners, 0.6, 0.1)))
}

/// Teeth of width 1 and pitch 2.5 on a bar of height 1; heights are taken in turn. 4n vertices.
fn comb(n: u32, heights: &[f64]) -> Vec<Point> {
    let mut points = vec![[0.0, -1.0], [2.5 * f64::from(n - 1) + 1.0, -1.0]];
    for i in (0..n).rev() {
        let x = 2.5 * f64::from(i);
        let tip = heights[i as usize % heights.len()];
        points.extend([[x + 1.0, 0.0], [x + 1.0, tip], [x, tip], [x, 0.0]]);
    }
    // The outer sides of the first and the last tooth run on into the bar.
    points.remove(2);
    points.pop();
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn combs_have_four_corners_a_tooth() {
        for n in 1..20 {
            let (a, b) = combs(n);
            assert_eq!((a.segments(), b.segments()), (4 * n as usize, 4 * n as usize));
        }
    }
}
