//! How far a convex piece is at most from the nearer one of two edges.
//!
//! The distances d and e to two edges are convex functions of the point, and so is every mean of them. Hence for any
//! weight w from 0 to 1
//!
//! min(d, e)  <=  w d + (1 - w) e  <=  max over corners v of w d(v) + (1 - w) e(v).
//!
//! The best weight balances two corners v and v' against each other: it solves a matrix game, and where d and e are linear,
//! the bound is attained between v and v'.

use crate::interval::Interval;

/// A bound for the distance to the nearer one of some edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// No point of the piece is farther from all edges.
    pub most: f64,
    /// Two corners and how far from the first to the second (0 to 1) the bound may be attained; `None` if at a corner.
    pub between: Option<(usize, usize, f64)>,
}

/// The bound from the distances of the corners to one edge.
#[must_use]
pub fn to_one(distances: &[Interval]) -> Bound {
    Bound { most: distances.iter().map(|d| d.hi()).fold(0.0, f64::max), between: None }
}

/// The best bound from the distances of the corners to two edges, one entry a corner.
#[must_use]
pub fn to_two(first: &[Interval], second: &[Interval]) -> Bound {
    let lines: Vec<(f64, f64)> = first.iter().zip(second).map(|(d, e)| (d.mid(), e.mid())).collect();
    let best = balances(&lines)
        .map(|balance| (lines.iter().map(|&line| balance.mean(line)).fold(0.0, f64::max), balance))
        .min_by(|a, b| a.0.total_cmp(&b.0));
    let Some((_, Balance { weight, between })) = best else { return Bound { most: f64::INFINITY, between: None } };
    let weight = Interval::point(weight);
    let rest = Interval::point(1.0) - weight;
    let mean = |(d, e): (&Interval, &Interval)| (weight * *d + rest * *e).hi();
    Bound { most: first.iter().zip(second).map(mean).fold(0.0, f64::max), between: Some(between) }
}

/// A weight at which two corners are equally far in the mean.
struct Balance {
    weight: f64,
    between: (usize, usize, f64),
}

impl Balance {
    fn mean(&self, (d, e): (f64, f64)) -> f64 {
        self.weight * d + (1.0 - self.weight) * e
    }
}

/// The balances of all corners nearer to the second edge against all that are nearer to the first.
fn balances(lines: &[(f64, f64)]) -> impl Iterator<Item = Balance> + '_ {
    let lead = |i: usize| lines[i].0 - lines[i].1;
    let pairs = (0..lines.len()).flat_map(|i| (0..lines.len()).map(move |j| (i, j)));
    pairs.filter(move |&(i, j)| lead(i) > 0.0 && lead(j) < 0.0).map(move |(i, j)| {
        let slope = lead(i) - lead(j);
        let weight = ((lines[j].1 - lines[i].1) / slope).clamp(0.0, 1.0);
        Balance { weight, between: (i, j, lead(i) / slope) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn points(values: &[f64]) -> Vec<Interval> {
        values.iter().map(|&x| Interval::point(x)).collect()
    }

    #[test]
    fn a_strip_between_two_lines_is_half_as_far() {
        // The corners of a unit square, the lines its lower and upper side.
        let bound = to_two(&points(&[0.0, 0.0, 1.0, 1.0]), &points(&[1.0, 1.0, 0.0, 0.0]));
        assert_eq!(bound.most, 0.5);
        assert!(bound.between.is_some_and(|(_, _, t)| t == 0.5));
    }

    #[test]
    fn a_sliver_along_two_edges_is_cut_where_they_meet() {
        // From 0 to 1 along edges that meet at 1/4.
        let bound = to_two(&points(&[0.0, 0.75]), &points(&[0.25, 0.0]));
        assert_eq!(bound.between, Some((1, 0, 0.75)));
        assert_eq!(bound.most, 0.1875);
    }

    #[test]
    fn an_edge_that_is_never_nearer_gives_nothing() {
        assert_eq!(to_two(&points(&[1.0, 2.0]), &points(&[2.0, 3.0])).most, f64::INFINITY);
    }

    proptest! {
        /// Linear distances along a segment: no point between its ends is farther from both than the bound.
        #[test]
        fn no_point_is_farther(ends in prop::array::uniform4(0.0..4.0f64), t in 0.0..1.0f64) {
            let [d0, e0, d1, e1] = ends;
            let bound = to_two(&points(&[d0, d1]), &points(&[e0, e1])).most;
            let at = |from: f64, to: f64| from + t * (to - from);
            prop_assert!(at(d0, d1).min(at(e0, e1)) <= bound + 1e-14, "{ends:?} {t} {bound}");
        }
    }
}
