//! How far an arrangement is from one that curves near the given ones have (memo C4).
//!
//! Of an order from bottom to top: a pair that runs in the wrong order over an abscissa can be put right only if some point
//! there is within r of both curves, and the least such r counts. Over gentle slopes it is half the vertical difference; on
//! steep ones, where rounding of x alone makes that large, it is the distance that has to be moved. Of a vertex: its
//! distance from each curve that it lies on.

use crate::certified::precision::Precision;
use crate::certified::real::Real;
use crate::strand::{FINE, Strand};
use std::collections::HashMap;

/// A gap between neighbours: from one abscissa to another one curve runs right above another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Where it begins.
    pub from: f64,
    /// Where it ends, further right.
    pub to: f64,
    /// The curve below.
    pub bottom: usize,
    /// The curve above.
    pub top: usize,
}

/// A stretch over which one curve is taken to be below another, not necessarily next to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// The lower curve.
    pub low: usize,
    /// The upper one.
    pub high: usize,
}

/// The greatest perturbation found, a certified bracket, and where.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Greatest {
    /// The lower bound.
    pub lo: f64,
    /// The upper bound.
    pub hi: f64,
    /// The place of the lower bound.
    pub at: [f64; 2],
}

impl Greatest {
    /// The greater of both.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        let greater = if other.lo > self.lo { other } else { self };
        Self { hi: self.hi.max(other.hi), ..greater }
    }
}

/// The perturbation of the order that the gaps of a vertical decomposition tell. The first `clear` of each curve, measured
/// along x, is left out. Gaps name curves by index, never vertical ones.
#[must_use]
pub fn of_order(curves: &[Strand], gaps: &[Gap], clear: f64) -> Greatest {
    let mut greatest = Greatest::default();
    for stretch in stretches(gaps) {
        let (low, high) = (&curves[stretch.low], &curves[stretch.high]);
        if low.heights()[1] <= high.heights()[0] {
            continue;
        }
        let from = if clear > 0.0 { stretch.from.max(low.left[0].max(high.left[0]) + clear) } else { stretch.from };
        if from <= stretch.to {
            for x in [Some(from), Some(stretch.to), parallel(low, high, [from, stretch.to])].into_iter().flatten() {
                greatest = greatest.or(excess(low, high, x, greatest.lo));
            }
        }
    }
    greatest
}

/// The greatest distance of a point from the curve that it is said to lie on.
#[must_use]
pub fn of_vertices(curves: &[Strand], places: impl Iterator<Item = (usize, [f64; 2])>) -> Greatest {
    let mut greatest = Greatest::default();
    for (index, at) in places {
        let curve = &curves[index];
        if curve.left == at || curve.right == at {
            continue;
        }
        let off = curve.distance(at[0], &Real::new(at[1], FINE), FINE);
        greatest = greatest.or(Greatest { lo: off.lo().max(0.0), hi: off.hi(), at });
    }
    greatest
}

/// The stretches over which each pair of curves keeps its order.
#[must_use]
pub fn stretches(gaps: &[Gap]) -> Vec<Stretch> {
    let mut starts: Vec<&Gap> = gaps.iter().collect();
    let mut ends = starts.clone();
    starts.sort_by(|g, h| g.from.total_cmp(&h.from));
    ends.sort_by(|g, h| g.to.total_cmp(&h.to));
    let mut events: Vec<f64> = gaps.iter().flat_map(|gap| [gap.from, gap.to]).collect();
    events.sort_by(f64::total_cmp);
    events.dedup();
    let (mut starts, mut ends) = (starts.into_iter().peekable(), ends.into_iter().peekable());
    let (mut above, mut below) = (HashMap::new(), HashMap::new());
    let mut pairs = Pairs::default();
    for x in events {
        while let Some(gap) = ends.next_if(|gap| gap.to <= x) {
            above.remove(&gap.bottom);
            below.remove(&gap.top);
        }
        while let Some(gap) = starts.next_if(|gap| gap.from <= x) {
            above.insert(gap.bottom, gap.top);
            below.insert(gap.top, gap.bottom);
        }
        pairs.change(x, column(&above, &below));
    }
    pairs.done
}

/// The active curves from bottom to top.
fn column(above: &HashMap<usize, usize>, below: &HashMap<usize, usize>) -> Vec<usize> {
    let Some(&any) = above.keys().next() else { return Vec::new() };
    let lowest = std::iter::successors(Some(any), |curve| below.get(curve).copied()).last();
    std::iter::successors(lowest, |curve| above.get(curve).copied()).collect()
}

/// The pairs whose stretches are under way.
#[derive(Default)]
struct Pairs {
    column: Vec<usize>,
    since: HashMap<[usize; 2], f64>,
    done: Vec<Stretch>,
}

impl Pairs {
    /// From this abscissa on the column is another one.
    fn change(&mut self, x: f64, column: Vec<usize>) {
        let old = std::mem::replace(&mut self.column, column);
        let new = &self.column;
        let prefix = old.iter().zip(new).take_while(|(f, g)| f == g).count();
        let rest = old.len().min(new.len()) - prefix;
        let suffix = old.iter().rev().zip(new.iter().rev()).take(rest).take_while(|(f, g)| f == g).count();
        let (gone, come) = (&old[prefix..old.len() - suffix], &new[prefix..new.len() - suffix]);
        // Pairs of one curve that changed and another one: closed if they are not as they were, opened if they are new.
        for (i, &f) in gone.iter().enumerate() {
            let outside =
                old[..prefix].iter().map(|g| [*g, f]).chain(old[old.len() - suffix..].iter().map(|g| [f, *g]));
            let stays = come.contains(&f);
            let closed: Vec<[usize; 2]> = outside.filter(|_| !stays).collect();
            let inner = gone[i + 1..].iter().filter(|g| !in_order(come, f, **g)).map(|g| [f, *g]);
            for pair in closed.into_iter().chain(inner) {
                if let Some(from) = self.since.remove(&pair) {
                    self.done.push(Stretch { from, to: x, low: pair[0], high: pair[1] });
                }
            }
        }
        for (i, &f) in come.iter().enumerate() {
            let outside =
                new[..prefix].iter().map(|g| [*g, f]).chain(new[new.len() - suffix..].iter().map(|g| [f, *g]));
            let opened = outside.filter(|_| !gone.contains(&f));
            let inner = come[i + 1..].iter().filter(|g| !in_order(gone, f, **g)).map(|g| [f, *g]);
            for pair in opened.chain(inner) {
                self.since.insert(pair, x);
            }
        }
    }
}

/// Whether both are there, the first before the second.
fn in_order(list: &[usize], f: usize, g: usize) -> bool {
    let place = |curve| list.iter().position(|known| *known == curve);
    place(f).zip(place(g)).is_some_and(|(i, j)| i < j)
}

/// Where two curves run in parallel between two abscissas, if they do; there is one such place at most. The difference is
/// flat there, so it need not be known finely.
fn parallel(f: &Strand, g: &Strand, [from, to]: [f64; 2]) -> Option<f64> {
    if f.half_sweep == 0.0 && g.half_sweep == 0.0 {
        return None;
    }
    let steeper = |x: f64| {
        let ([fx, fy], [gx, gy]) = (f.direction(x), g.direction(x));
        gx * fy > fx * gy
    };
    let (mut low, mut high, first) = (from, to, steeper(from));
    if steeper(to) == first {
        return None;
    }
    for _ in 0..60 {
        let middle = low.midpoint(high);
        if steeper(middle) == first { low = middle } else { high = middle }
    }
    Some(low)
}

/// The least r such that a point over x is within r of both curves if the lower one is above the upper one, else 0. What is
/// no more than `known` is not looked at closely.
fn excess(low: &Strand, high: &Strand, x: f64, known: f64) -> Greatest {
    let [f, g] = [low, high].map(|curve| curve.height(x, Precision::DOUBLE));
    // What is not a number is not less either.
    if f.hi() <= g.lo() {
        return Greatest::default();
    }
    let [f, g] = [low, high].map(|curve| curve.height(x, FINE));
    let wrong = &f - &g;
    let place = |lo: f64, hi: f64| Greatest { lo, hi, at: [x, g.mid()] };
    if wrong.hi() <= 2.0 * known {
        return place(0.0, 0.5 * wrong.hi().max(0.0));
    }
    // The higher the point, the nearer to one curve and the farther from the other.
    let (mut from, mut to, mut found) = (0.0, 1.0, place(0.0, wrong.hi()));
    // On a steep curve what is wrong vertically is many times the distance.
    for _ in 0..150 {
        let part: f64 = 0.5 * (from + to);
        let y = &g + &(&wrong * &Real::new(part, FINE));
        let [p, q] = [low, high].map(|curve| curve.distance(x, &y, FINE));
        found = place(found.lo.max(p.lo().min(q.lo())), found.hi.min(p.hi().max(q.hi())));
        if found.hi - found.lo <= 1e-3 * found.hi {
            break;
        }
        if p.mid() > q.mid() { from = part } else { to = part }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(left: [f64; 2], right: [f64; 2]) -> Strand {
        Strand::new(left, right, 0.0)
    }

    fn gap(from: f64, to: f64, bottom: usize, top: usize) -> Gap {
        Gap { from, to, bottom, top }
    }

    /// Two lines that cross over 1; the order is kept up to 1.5.
    #[test]
    fn a_crossing_taken_late_counts_by_half_the_difference() {
        let curves = [line([0.0, 0.0], [2.0, 0.002]), line([0.0, 0.002], [2.0, 0.0])];
        let right = of_order(&curves, &[gap(0.0, 1.0, 0, 1), gap(1.0, 2.0, 1, 0)], 0.0);
        assert!(right.hi < 1e-18, "{right:?}");
        let late = of_order(&curves, &[gap(0.0, 1.5, 0, 1), gap(1.5, 2.0, 1, 0)], 0.0);
        assert!((late.lo - 0.0005).abs() < 1e-6 && late.hi < 1.01 * late.lo && late.at[0] == 1.5, "{late:?}");
    }

    #[test]
    fn steep_lines_count_by_distance() {
        let curves = [line([0.0, 0.0], [1e-3, 1.0]), line([1e-4, 0.0], [1.1e-3, 1.0])];
        let found = of_order(&curves, &[gap(1e-4, 1e-3, 0, 1)], 0.0);
        assert!((found.lo - 0.5e-4).abs() < 1e-6 && found.hi < 1.01 * found.lo, "{found:?}");
    }

    #[test]
    fn tails_can_be_left_out_and_a_pair_apart_in_the_list_counts() {
        let curves = [line([0.0, 1.0], [1.0, 0.0]), line([0.0, 2.0], [1.0, 2.0]), line([0.0, 0.5], [1.0, 0.5])];
        let gaps = [gap(0.0, 1.0, 0, 1), gap(0.0, 1.0, 1, 2)];
        let [all, clear] = [0.0, 0.75].map(|clear| of_order(&curves, &gaps, clear));
        assert!((all.lo - 0.75).abs() < 0.1 && clear.lo > 0.7, "{all:?} {clear:?}");
        let first = of_order(&curves, &[gap(0.0, 1.0, 0, 2)], 0.75);
        assert_eq!(first.hi, 0.0);
    }

    /// An arc over a chord bulges through a line between the ends; 0.1511352 is the tangent of half its half sweep.
    #[test]
    fn arcs_are_looked_at_where_they_are_parallel() {
        let arc = Strand::new([0.0, 0.0], [1.0, 1.0], -0.3);
        let found = of_order(&[arc, line([0.0, 0.0], [1.0, 1.0])], &[gap(0.0, 1.0, 0, 1)], 0.0);
        let sagitta = 0.5_f64.sqrt() * 0.151_135_2;
        assert!((found.lo - 0.5 * sagitta).abs() < 0.05 * sagitta && found.hi < 1.01 * found.lo, "{found:?}");
    }

    #[test]
    fn vertices_count_by_their_distance() {
        let curves = [line([0.0, 0.0], [4.0, 3.0])];
        let found = of_vertices(&curves, [(0, [0.0, 0.0]), (0, [1.0, 2.0])].into_iter());
        assert!((found.lo - 1.0).abs() < 1e-15 && found.at == [1.0, 2.0]);
    }

    #[test]
    fn stretches_begin_and_end_with_swaps_and_curves() {
        let gaps =
            [gap(0.0, 1.0, 0, 1), gap(0.0, 2.0, 1, 2), gap(1.0, 2.0, 0, 3), gap(1.0, 2.0, 3, 1), gap(2.0, 3.0, 1, 0)];
        let mut found = stretches(&gaps);
        found.sort_by_key(|s| (s.low, s.high));
        let stretch = |from, to, low, high| Stretch { from, to, low, high };
        let expected = [
            stretch(0.0, 2.0, 0, 1),
            stretch(0.0, 2.0, 0, 2),
            stretch(1.0, 2.0, 0, 3),
            stretch(2.0, 3.0, 1, 0),
            stretch(0.0, 2.0, 1, 2),
            stretch(1.0, 2.0, 3, 1),
            stretch(1.0, 2.0, 3, 2),
        ];
        assert_eq!(found, expected);
    }
}
