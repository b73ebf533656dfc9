//! What one region has and another has not, or what they have in common, in trapezoids between two curves of their
//! boundaries.
//!
//! A brute-force vertical decomposition: in the slab between two strips ([`super::strips`]) the curves are in a fixed
//! vertical order, which changes from slab to slab only for the curves involved in the strip between them. Winding
//! numbers counted upward tell which gaps belong to a region. Curves that coincide leave gaps of no height, which are
//! skipped. What lies in the strips is not looked at: it is within [`Parts::blur`] of what lies beside them.

use std::cmp::Ordering;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use rug::Float;

use super::curve::Curve;
use super::meet::LIMIT;
use super::precision::Precision;
use super::real::Real;
use super::strips::{Span, Strips};
use super::uprights;
use crate::error::OracleError;

/// A part of the plane between two abscissas and two curves that do not cross there.
#[derive(Clone, Debug)]
pub struct Trapezoid {
    /// Left and right end.
    pub x: [Float; 2],
    /// The lower and the upper curve.
    pub walls: [Arc<Curve>; 2],
}

/// One of two regions.
#[derive(Clone, Copy)]
pub struct Layer<'a> {
    /// Its boundary: closed loops with the interior, the points of winding number other than 0, on the left.
    pub pieces: &'a [Span],
    /// The winding number far away.
    pub base: i32,
}

/// Parts of the plane that two regions tell apart.
pub struct Parts {
    /// Trapezoids that make up the first region without the second and the second without the first, or the intersection
    /// and nothing.
    pub parts: [Vec<Trapezoid>; 2],
    /// The curves of each region's boundary, without stretches that have no part of the region on either side.
    pub edges: [Vec<Arc<Curve>>; 2],
    /// How far a point of one region in a strip may be from one beside it.
    pub blur: f64,
}

/// The differences of two regions, `None` if it is undecided how two of their curves meet.
///
/// # Errors
/// [`OracleError::BadNumber`] for coordinates too large for doubles, [`OracleError::Inconsistent`] for loops that do not
/// close.
pub fn differences(layers: [Layer<'_>; 2]) -> Result<Option<Parts>, OracleError> {
    decompose(layers, |inside| (inside[0] != inside[1]).then_some(usize::from(inside[1])))
}

/// The intersection of two regions of which one is bounded, in the first part; `None` if it is undecided how two of their
/// curves meet.
///
/// # Errors
/// As [`differences`].
pub fn intersection(layers: [Layer<'_>; 2]) -> Result<Option<Parts>, OracleError> {
    decompose(layers, |inside| (inside[0] && inside[1]).then_some(0))
}

/// Which part a gap belongs to, given whether it is inside each region.
type Select = fn([bool; 2]) -> Option<usize>;

fn decompose(layers: [Layer<'_>; 2], select: Select) -> Result<Option<Parts>, OracleError> {
    let pieces: Vec<&Span> = layers.iter().flat_map(|layer| layer.pieces).collect();
    let curves: Vec<Arc<Curve>> = pieces.iter().map(|piece| Arc::clone(&piece.curve)).collect();
    let Some(strips) = Strips::new(&pieces)? else { return Ok(None) };
    let mut sweep = Sweep::new(&strips, &curves, layers, select);
    for strip in 0..strips.ends.len() {
        sweep.pass(strip)?;
    }
    Ok(Some(sweep.finish()))
}

/// The state of the decomposition while it goes from slab to slab.
struct Sweep<'a> {
    strips: &'a Strips,
    curves: &'a [Arc<Curve>],
    bases: [i32; 2],
    select: Select,
    /// Whether each curve runs to the right.
    rightward: Vec<bool>,
    /// Index of the first curve of the second region.
    second: usize,
    /// The curves over the current slab from bottom to top.
    order: Vec<usize>,
    /// Whether pairs of curves that have met in the order coincide.
    coincide: HashMap<(usize, usize), bool>,
    /// Trapezoids not yet closed: their part, lower and upper curve, and the strip they start at.
    open: HashMap<(usize, usize, usize), usize>,
    parts: [Vec<Trapezoid>; 2],
    /// For each curve, the runs of slabs, as first and last strip, where it bounds a part of its region.
    kept: Vec<Vec<[usize; 2]>>,
    uprights: Vec<(usize, Arc<Curve>)>,
    blur: f64,
}

impl<'a> Sweep<'a> {
    fn new(strips: &'a Strips, curves: &'a [Arc<Curve>], layers: [Layer<'_>; 2], select: Select) -> Self {
        Self {
            strips,
            curves,
            rightward: curves.iter().map(|curve| uprights::runs_right(curve)).collect(),
            bases: layers.map(|layer| layer.base),
            select,
            second: layers[0].pieces.len(),
            order: Vec::new(),
            coincide: HashMap::new(),
            open: HashMap::new(),
            parts: [Vec::new(), Vec::new()],
            kept: vec![Vec::new(); curves.len()],
            uprights: Vec::new(),
            blur: 0.0,
        }
    }

    fn layer(&self, curve: usize) -> usize {
        usize::from(curve >= self.second)
    }

    /// Goes from the slab before a strip to the slab after it.
    fn pass(&mut self, strip: usize) -> Result<(), OracleError> {
        let before = self.order.clone();
        let involved = &self.strips.involved[strip];
        self.order.retain(|curve| involved.binary_search(curve).is_err());
        if strip + 1 < self.strips.ends.len() {
            let x = self.strips.middle(strip);
            for &curve in involved {
                if self.strips.reaches_on(curve, strip) {
                    let place = self.order.partition_point(|&other| self.compare(other, curve, &x).is_lt());
                    self.order.insert(place, curve);
                }
            }
        }
        self.pass_uprights(strip, &before);
        self.blur = self.blur.max(uprights::blur(self.strips, self.curves, self.second, strip, &before, &self.order));
        self.regroup(strip)
    }

    /// Whether a curve is below another over an abscissa; equal if they coincide.
    fn compare(&self, below: usize, above: usize, x: &Real) -> Ordering {
        let decided = [Precision::DOUBLE, LIMIT].into_iter().find_map(|precision| {
            let x = x.rounded(precision);
            let [low, high] = [below, above].map(|curve| self.curves[curve].at(precision).ordinate(&x));
            (low - high).sign()
        });
        decided.unwrap_or(Ordering::Equal)
    }

    /// The winding numbers of both regions in the gaps from bottom to top, one more than there are curves.
    fn windings(&self, order: &[usize]) -> Vec<[i32; 2]> {
        let mut winding = self.bases;
        let step = |&curve: &usize| {
            winding[self.layer(curve)] += if self.rightward[curve] { 1 } else { -1 };
            winding
        };
        std::iter::once(self.bases).chain(order.iter().map(step).collect::<Vec<_>>()).collect()
    }

    /// Finds the gaps of the slab after a strip that are asked for, and closes the trapezoids that end.
    fn regroup(&mut self, strip: usize) -> Result<(), OracleError> {
        let windings = self.windings(&self.order);
        if windings.last() != Some(&self.bases) {
            return Err(OracleError::Inconsistent("the loops of a boundary do not close"));
        }
        let mut next = HashMap::new();
        let mut first = 0;
        for last in 0..self.order.len() {
            let upper = self.order.get(last + 1).copied();
            if upper.is_some_and(|upper| self.are_one(self.order[last], upper, strip)) {
                continue;
            }
            self.keep(first..last + 1, [windings[first], windings[last + 1]], strip);
            first = last + 1;
            let inside = windings[first].map(|winding| winding != 0);
            if let Some(upper) = upper
                && let Some(part) = (self.select)(inside)
            {
                let key = (part, self.order[last], upper);
                let start = self.open.remove(&key).unwrap_or(strip);
                next.insert(key, start);
            }
        }
        let mut ended: Vec<_> = std::mem::replace(&mut self.open, next).into_iter().collect();
        ended.sort_unstable();
        for ((part, lower, upper), start) in ended {
            let x = [self.strips.ends[start][1].clone(), self.strips.ends[strip][0].clone()];
            let walls = [lower, upper].map(|curve| self.curves[curve].clone());
            self.parts[part].push(Trapezoid { x, walls });
        }
        Ok(())
    }

    /// Whether two neighbours of the slab after a strip coincide.
    fn are_one(&mut self, lower: usize, upper: usize, strip: usize) -> bool {
        if let Some(&known) = self.coincide.get(&(lower, upper)) {
            return known;
        }
        let coincide = self.compare(lower, upper, &self.strips.middle(strip)).is_eq();
        self.coincide.insert((lower, upper), coincide);
        coincide
    }

    /// Adds the slab after a strip to the runs of coinciding curves, if there is a part of their region below or above.
    fn keep(&mut self, places: Range<usize>, around: [[i32; 2]; 2], strip: usize) {
        for place in places {
            let curve = self.order[place];
            let layer = self.layer(curve);
            if around.iter().all(|winding| winding[layer] == 0) {
                continue;
            }
            match self.kept[curve].last_mut() {
                Some(run) if run[1] == strip => run[1] = strip + 1,
                _ => self.kept[curve].push([strip, strip + 1]),
            }
        }
    }

    /// Keeps the stretches of the upright curves in a strip that have a part of their region on a side.
    fn pass_uprights(&mut self, strip: usize, before: &[usize]) {
        let strips = self.strips;
        let is_upright = |&&curve: &&usize| strips.spans[curve] == [strip; 2];
        let uprights: Vec<usize> = strips.involved[strip].iter().filter(is_upright).copied().collect();
        if uprights.is_empty() {
            return;
        }
        let windings = [before, &self.order].map(|order| self.windings(order));
        for curve in uprights {
            let layer = self.layer(curve);
            let [_, low, _, high] = self.curves[curve].rough().bounds();
            let sides = [(before, 0), (&self.order[..], 1)].map(|(order, side)| {
                let x = Real::from(strips.ends[strip][side].clone());
                let passing = self.passing(order, &x, [low, high]);
                let ordinate = |&other: &usize| self.curves[other].at(LIMIT).ordinate(&x);
                uprights::Beside {
                    ordinates: order[passing.clone()].iter().map(ordinate).collect(),
                    inside: windings[side][passing.start..=passing.end].iter().map(|w| w[layer] != 0).collect(),
                }
            });
            let stretches = uprights::kept(&self.curves[curve], &sides);
            self.uprights.extend(stretches.into_iter().map(|stretch| (layer, stretch)));
        }
    }

    /// The places in an order of those curves that may pass an abscissa between two ordinates.
    fn passing(&self, order: &[usize], x: &Real, [low, high]: [f64; 2]) -> Range<usize> {
        let x = x.rounded(Precision::DOUBLE);
        let ordinate = |curve: &usize| self.curves[*curve].rough().ordinate(&x);
        let start = order.partition_point(|curve| ordinate(curve).hi() < low);
        let count = order[start..]
            .partition_point(|curve| !matches!(ordinate(curve).lo().partial_cmp(&high), Some(Ordering::Greater)));
        start..start + count
    }

    fn finish(self) -> Parts {
        let mut edges = [Vec::new(), Vec::new()];
        for (i, runs) in self.kept.iter().enumerate() {
            let layer = usize::from(i >= self.second);
            let whole = self.strips.spans[i];
            for &run in runs {
                let curve = if run == whole {
                    self.curves[i].clone()
                } else {
                    let x = [self.strips.ends[run[0]][1].clone(), self.strips.ends[run[1]][0].clone()];
                    Arc::new(uprights::clipped(&self.curves[i], x))
                };
                edges[layer].push(curve);
            }
        }
        self.uprights.into_iter().for_each(|(layer, curve)| edges[layer].push(curve));
        Parts { parts: self.parts, edges, blur: self.blur }
    }
}
