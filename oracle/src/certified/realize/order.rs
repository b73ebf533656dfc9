//! The order of chains from below to above, and by how much they run into each other (MS 4.2, step 3).
//!
//! Of two chains over a common abscissa one is above the other on the stored boundary, up to rounding. How far the
//! lower one pokes through after step 2 is the greatest difference of their ordinates: on two spans it is at an end
//! of the common range or where they are parallel.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use super::error::RealizeError;
use super::path::Path;
use super::place::Placed;
use crate::certified::real::Real;

/// Ordinates of spans whose boxes are farther apart than this are not compared: no lift comes near it.
const APART: f64 = 1.0 / (1 << 20) as f64;

/// Chains nearer than this on the stored boundary touch there.
const TOUCH: f64 = 1.0 / (1u128 << 120) as f64;

/// A chain twice: after step 2 and on the stored boundary, span by span.
#[derive(Clone, Debug)]
pub struct Double {
    /// After step 2.
    pub placed: Vec<Placed>,
    /// On the stored boundary.
    pub stored: Vec<Path>,
    /// The chain before it in its loop.
    pub previous: usize,
    /// The chain after it.
    pub next: usize,
}

/// One chain below another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Below {
    /// The lower chain.
    pub lower: usize,
    /// The upper chain.
    pub upper: usize,
    /// The greatest amount by which the lower one is above the upper one after step 2: negative if it nowhere is. An
    /// upper bound, in the frame.
    pub excess: f64,
}

/// Bounds of the differences of the ordinates of two chains.
#[derive(Clone, Copy)]
struct Differences {
    /// Of the greatest and the least after step 2.
    placed: [f64; 2],
    /// Of the greatest and the least found on the stored boundary.
    stored: [f64; 2],
}

/// All pairs of chains over a common abscissa. `scale` is the length of the direction.
#[must_use]
pub fn relations(chains: &[Double], scale: &Real) -> Vec<Below> {
    let mut spans: Vec<(usize, usize, [f64; 4])> = Vec::new();
    for (index, chain) in chains.iter().enumerate() {
        spans.extend(chain.placed.iter().enumerate().map(|(i, span)| (index, i, span.path.bounds(scale))));
    }
    spans.sort_by(|a, b| a.2[0].total_cmp(&b.2[0]));
    let mut found: BTreeMap<(usize, usize), Differences> = BTreeMap::new();
    for (i, one) in spans.iter().enumerate() {
        for two in spans[i + 1..].iter().take_while(|two| two.2[0] <= one.2[2]).filter(|two| two.0 != one.0) {
            let (one, two) = if one.0 < two.0 { (one, two) } else { (two, one) };
            let Some(new) = compare(chains, [one, two], scale) else { continue };
            found.entry((one.0, two.0)).and_modify(|old| *old = old.with(new)).or_insert(new);
        }
    }
    found.into_iter().map(|((i, j), differences)| differences.relation(chains, i, j)).collect()
}

impl Differences {
    fn with(self, other: Self) -> Self {
        let join = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].min(b[1])];
        Self { placed: join(self.placed, other.placed), stored: join(self.stored, other.stored) }
    }

    fn relation(self, chains: &[Double], i: usize, j: usize) -> Below {
        let first_above = if self.stored[0].max(-self.stored[1]) > TOUCH {
            self.stored[0] >= -self.stored[1]
        } else {
            touch(chains, i, j)
        };
        if first_above {
            Below { lower: j, upper: i, excess: -self.placed[1] }
        } else {
            Below { lower: i, upper: j, excess: self.placed[0] }
        }
    }
}

/// Whether the first of two chains is to come above the second, when all they have in common is a point where one
/// ends on the left and the other on the right. All four chains that turn back there must agree, so it is decided by
/// the two turns.
fn touch(chains: &[Double], i: usize, j: usize) -> bool {
    let turn = |chain: usize, at_right: bool| {
        let rightward = chains[chain].stored[0].rightward;
        if rightward == at_right { chain } else { chains[chain].previous }
    };
    let middle = |chain: usize| {
        chains[chain].stored.iter().map(|path| path.from.x.mid() + path.to.x.mid()).sum::<f64>()
            / chains[chain].stored.len() as f64
    };
    let first_left = middle(i) < middle(j);
    (turn(i, first_left), i) > (turn(j, !first_left), j)
}

/// The differences of two spans, given by chain, place in the chain and box, over their common abscissas; `None` if
/// there are none.
fn compare(chains: &[Double], pair: [&(usize, usize, [f64; 4]); 2], scale: &Real) -> Option<Differences> {
    let boxes = pair.map(|(_, _, bounds)| *bounds);
    let placed = pair.map(|&(chain, i, _)| &chains[chain].placed[i]);
    let paths = placed.map(|p| &p.path);
    let plainly_share = boxes[0][2].min(boxes[1][2]) - boxes[0][0].max(boxes[1][0]) > APART;
    let apart = boxes_apart(boxes).or_else(|| if plainly_share { lines_apart(paths, boxes) } else { None });
    let apart = apart.map(|gap| Differences { placed: [gap; 2], stored: [gap; 2] });
    if apart.is_some() && plainly_share {
        return apart;
    }
    let [left, right] = overlap(paths)?;
    if apart.is_some() {
        return apart;
    }
    let stored = pair.map(|&(chain, i, _)| &chains[chain].stored[i]);
    let middle = (&left + &right) * 0.5;
    let along = parallel(placed, &left, &right);
    Some(Differences {
        placed: extremes(paths, [&left, &right].into_iter().chain(&along), scale)?,
        stored: extremes(stored, [&left, &middle, &right].into_iter(), scale)?,
    })
}

/// By how much all of one box is above the other, negative if it is below; `None` if it is not by much.
fn boxes_apart([a, b]: [[f64; 4]; 2]) -> Option<f64> {
    [a[1] - b[3], a[3] - b[1]].into_iter().zip([1.0, -1.0]).find(|(gap, sign)| gap * sign > APART).map(|(gap, _)| gap)
}

/// The same for two lines over the abscissas that they have in common. Doubles will do for lines that are wide enough: their
/// ordinates come out right to 2^-28.
fn lines_apart(paths: [&Path; 2], [a, b]: [[f64; 4]; 2]) -> Option<f64> {
    let are_wide = [a, b].iter().all(|bounds| bounds[2] - bounds[0] > APART);
    if !are_wide || paths.iter().any(|path| path.round.is_some()) {
        return None;
    }
    let [f, g] = paths.map(|path| {
        let [x0, y0, x1, y1] = [path.from.x.mid(), path.from.y.mid(), path.to.x.mid(), path.to.y.mid()];
        move |x: f64| y0 + (x - x0) / (x1 - x0) * (y1 - y0)
    });
    let [at_left, at_right] = [a[0].max(b[0]), a[2].min(b[2])].map(|x| f(x) - g(x));
    let gap = if at_left > 0.0 { at_left.min(at_right) - APART } else { at_left.max(at_right) + APART };
    (gap.abs() > APART && (gap > 0.0) == (at_left > 0.0)).then_some(gap)
}

/// The greatest and the least difference of the ordinates at some abscissas, rounded outwards.
fn extremes<'a>(pair: [&Path; 2], at: impl Iterator<Item = &'a Real>, scale: &Real) -> Option<[f64; 2]> {
    let mut values = at.map(|x| pair[0].ordinate(x, scale) - pair[1].ordinate(x, scale));
    let first = values.next()?;
    let (least, most) = values.fold((first.clone(), first), |(least, most), v| (least.min(&v), most.max(&v)));
    Some([most.hi(), least.lo()])
}

/// The ends of the common range of abscissas, if there may be one: a single abscissa counts.
fn overlap(pair: [&Path; 2]) -> Option<[Real; 2]> {
    let [a, b] = pair.map(Path::range);
    let (left, right) = (a[0].max(b[0]), a[1].min(b[1]));
    (!right.is_below(&left)).then_some([left, right])
}

/// The abscissa in the range where two spans are parallel. Where the slopes cannot be told apart at an end, there is
/// nothing to find: over a stretch on which slopes agree to 2^-400, the difference of ordinates changes by less than
/// 2^-150 of the radii.
fn parallel([a, b]: [&Placed; 2], left: &Real, right: &Real) -> Option<Real> {
    let [at_left, at_right] = [left, right].map(|x| a.slope(x) - b.slope(x));
    match (at_left.sign()?, at_right.sign()?) {
        (Ordering::Less, Ordering::Greater) | (Ordering::Greater, Ordering::Less) => {
            let part = &at_left / &(&at_left - &at_right);
            Some((left + &(part * (right - left))).max(left).min(right))
        }
        _ => None,
    }
}

/// The chains from below to above.
///
/// # Errors
/// [`RealizeError::Tangled`] if there is no such order.
pub fn sorted(count: usize, relations: &[Below]) -> Result<Vec<usize>, RealizeError> {
    let mut above: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut waiting = vec![0; count];
    for relation in relations {
        above[relation.lower].push(relation.upper);
        waiting[relation.upper] += 1;
    }
    let mut ready: BTreeSet<usize> = (0..count).filter(|&chain| waiting[chain] == 0).collect();
    let mut order = Vec::with_capacity(count);
    while let Some(chain) = ready.pop_first() {
        order.push(chain);
        for &upper in &above[chain] {
            waiting[upper] -= 1;
            if waiting[upper] == 0 {
                ready.insert(upper);
            }
        }
    }
    if order.len() == count { Ok(order) } else { Err(RealizeError::Tangled) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certified::precision::Precision;
    use crate::certified::realize::path::Round;
    use crate::certified::vector::Vector;
    use proptest::prelude::*;

    const FINE: Precision = Precision::LADDER[2];

    fn vector(x: f64, y: f64) -> Vector {
        Vector::new(x, y, FINE)
    }

    /// The upper arc of the unit circle between two abscissas, from right to left.
    fn arc(left: f64, right: f64) -> Placed {
        let at = |x: f64| Vector { x: vector(x, 0.0).x, y: (vector(1.0, 0.0).x - vector(x, 0.0).x.square()).sqrt() };
        let ends = [at(right), at(left)];
        let round = Some(Round { centre: vector(0.0, 0.0), radius: Real::new(1.0, FINE) });
        let path = Path { from: ends[0].clone(), to: ends[1].clone(), round, rightward: false };
        Placed { path, points: ends.to_vec(), normals: ends }
    }

    /// The line of this slope and ordinate at 0 between the same abscissas, from right to left.
    fn line(slope: f64, height: f64, left: f64, right: f64) -> Placed {
        let at = |x: f64| Vector { x: vector(x, 0.0).x, y: vector(x, 0.0).x * slope + height };
        let normal = vector(-slope, 1.0).unit();
        let path = Path { from: at(right), to: at(left), round: None, rightward: false };
        Placed { points: vec![at(right), at(left)], path, normals: [normal.clone(), normal] }
    }

    proptest! {
        #[test]
        fn lines_plainly_apart_are_so(
            slopes in (-50.0..50.0f64, -50.0..50.0f64), heights in (-1.0..1.0f64, -1.0..1.0f64),
            ends in (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64),
        ) {
            let one = line(slopes.0, heights.0, ends.0.min(ends.1), ends.0.max(ends.1));
            let two = line(slopes.1, heights.1, ends.2.min(ends.3), ends.2.max(ends.3));
            let (paths, scale) = ([&one.path, &two.path], Real::from(1.0));
            let (Some([left, right]), boxes) = (overlap(paths), paths.map(|path| path.bounds(&scale))) else { return Ok(()) };
            if let Some(gap) = lines_apart(paths, boxes) {
                let [most, least] = extremes(paths, [&left, &right].into_iter(), &scale).expect("values");
                prop_assert!(if gap > 0.0 { least > gap } else { most < gap }, "{gap} {least} {most}");
            }
        }

        #[test]
        fn an_arc_is_nearest_to_a_line_where_it_is_parallel(
            slope in -2.0..2.0f64, height in -1.0..3.0f64, ends in (-0.99..0.99f64, -0.99..0.99f64),
        ) {
            let (left, right) = (ends.0.min(ends.1), ends.0.max(ends.1));
            prop_assume!(right - left > 1e-3);
            let pair = [&line(slope, height, left, right), &arc(left, right)];
            let [x0, x1] = overlap(pair.map(|p| &p.path)).expect("one range");
            let along = parallel(pair, &x0, &x1);
            let scale = Real::from(1.0);
            let found = extremes(pair.map(|p| &p.path), [&x0, &x1].into_iter().chain(&along), &scale).expect("values");
            // The tangent of the circle with this slope touches it at -slope / h and has the ordinate h at 0.
            let h = slope.hypot(1.0);
            let inside = left < -slope / h && -slope / h < right;
            let at = |x: f64| height + slope * x - (1.0 - x * x).sqrt();
            let least = if inside { height - h } else { at(left).min(at(right)) };
            prop_assert!((found[1] - least).abs() < 1e-12 && (found[0] - at(left).max(at(right))).abs() < 1e-12);
        }
    }
}
