//! The order of chains from below to above, and by how much they run into each other (MS 4.2, step 3).
//!
//! Of two chains over a common abscissa one is above the other up to rounding; how far the lower one pokes through is the
//! greatest difference of their ordinates. On two spans it is at an end of the common range or where they are parallel.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use super::error::RealizeError;
use super::place::Placed;
use crate::certified::real::Real;

/// Ordinates of spans whose boxes are farther apart than this are not compared: no lift comes near it.
const APART: f64 = 1.0 / (1 << 20) as f64;

/// One chain below another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Below {
    /// The lower chain.
    pub lower: usize,
    /// The upper chain.
    pub upper: usize,
    /// The greatest amount by which the lower one is above the upper one: negative if it nowhere is. An upper bound, in
    /// the frame.
    pub excess: f64,
}

/// The differences of the ordinates of two chains: bounds of the greatest and the least.
#[derive(Clone, Copy)]
struct Range {
    most: f64,
    least: f64,
}

/// All pairs of chains over a common abscissa. `scale` is the length of the direction.
#[must_use]
pub fn relations(chains: &[Vec<Placed>], scale: &Real) -> Vec<Below> {
    let mut spans: Vec<(usize, &Placed, [f64; 4])> = Vec::new();
    for (index, chain) in chains.iter().enumerate() {
        spans.extend(chain.iter().map(|span| (index, span, span.bounds(scale))));
    }
    spans.sort_by(|a, b| a.2[0].total_cmp(&b.2[0]));
    let mut ranges: BTreeMap<(usize, usize), Range> = BTreeMap::new();
    for (i, (chain, span, bounds)) in spans.iter().enumerate() {
        for (other, second, second_bounds) in spans[i + 1..].iter().take_while(|(.., b)| b[0] <= bounds[2]) {
            let (key, pair, boxes) = match chain.cmp(other) {
                Ordering::Equal => continue,
                Ordering::Less => ((*chain, *other), [*span, *second], [bounds, second_bounds]),
                Ordering::Greater => ((*other, *chain), [*second, *span], [second_bounds, bounds]),
            };
            let Some(found) = compare(pair, boxes, scale) else { continue };
            let range = ranges.entry(key).or_insert(found);
            *range = Range { most: range.most.max(found.most), least: range.least.min(found.least) };
        }
    }
    let below = |((i, j), Range { most, least }): ((usize, usize), Range)| {
        if most >= -least {
            Below { lower: j, upper: i, excess: -least }
        } else {
            Below { lower: i, upper: j, excess: most }
        }
    };
    ranges.into_iter().map(below).collect()
}

/// The difference of two spans over their common abscissas, `None` if there are none.
fn compare(pair: [&Placed; 2], [a, b]: [&[f64; 4]; 2], scale: &Real) -> Option<Range> {
    if a[1] > b[3] + APART {
        return overlap(pair).map(|_| Range { most: a[1] - b[3], least: a[1] - b[3] });
    }
    if b[1] > a[3] + APART {
        return overlap(pair).map(|_| Range { most: a[3] - b[1], least: a[3] - b[1] });
    }
    let [left, right] = overlap(pair)?;
    let difference = |x: &Real| pair[0].ordinate(x, scale) - pair[1].ordinate(x, scale);
    let parallel = parallel(pair, &left, &right);
    let mut values = [&left, &right].into_iter().chain(&parallel).map(difference);
    let first = values.next()?;
    let (least, most) = values.fold((first.clone(), first), |(least, most), v| (least.min(&v), most.max(&v)));
    Some(Range { most: most.hi(), least: least.lo() })
}

/// The ends of the common range of abscissas, if there may be one: a single abscissa counts.
fn overlap(pair: [&Placed; 2]) -> Option<[Real; 2]> {
    let [a, b] = pair.map(|p| if p.rightward { [&p.from().x, &p.to().x] } else { [&p.to().x, &p.from().x] });
    let (left, right) = (a[0].max(b[0]), a[1].min(b[1]));
    (!right.is_below(&left)).then_some([left, right])
}

/// The abscissa in the range where two spans are parallel. Where the slopes cannot be told apart at an end, there is nothing to
/// find: over a stretch on which slopes agree to 2^-400, the difference of ordinates changes by less than 2^-150 of the
/// radii.
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
