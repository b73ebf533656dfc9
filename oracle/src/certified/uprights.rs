//! What happens inside a strip: upright curves, and how far it is from there to the slabs beside it.

use std::sync::Arc;

use rug::Float;

use super::curve::Curve;
use super::meet::LIMIT;
use super::piece::Piece;
use super::real::Real;
use super::strips::Strips;
use super::vector::Vector;

/// Lengths below this are not worth being known any better.
const SHORT: f64 = 1.0 / (1u128 << 70) as f64;

/// The slab beside a strip.
pub struct Beside {
    /// The ordinates of its curves where it meets the strip, from bottom to top.
    pub ordinates: Vec<Real>,
    /// Whether the gaps belong to the region, one more than there are curves.
    pub inside: Vec<bool>,
}

impl Beside {
    /// Whether the gap at this ordinate, which is none of the curves', belongs to the region.
    fn contains(&self, y: &Real) -> bool {
        self.inside[self.ordinates.partition_point(|ordinate| ordinate.is_below(y))]
    }
}

/// The stretches of an upright curve that have a part of the region on their left or right, as curves of their own.
pub fn kept(curve: &Arc<Curve>, sides: &[Beside; 2]) -> Vec<Arc<Curve>> {
    let piece = curve.at(LIMIT);
    let (low, high) = if piece.from.y.mid() <= piece.to.y.mid() {
        (&piece.from.y, &piece.to.y)
    } else {
        (&piece.to.y, &piece.from.y)
    };
    let within = |y: &&Real| low.is_below(y) && y.is_below(high);
    let mut cuts: Vec<Real> = sides.iter().flat_map(|side| side.ordinates.iter().filter(within).cloned()).collect();
    cuts.extend([low.clone(), high.clone()]);
    cuts.sort_by(|a, b| a.mid().total_cmp(&b.mid()).then_with(|| (a - b).sign().unwrap_or(std::cmp::Ordering::Equal)));
    let good = |pair: &[Real]| {
        let middle = &(&pair[0] + &pair[1]) * 0.5;
        sides.iter().any(|side| side.contains(&middle))
    };
    let good: Vec<bool> = cuts.windows(2).map(|pair| !pair[0].is_below(&pair[1]) || good(pair)).collect();
    if good.iter().all(|&g| g) {
        return vec![curve.clone()];
    }
    let runs = good.chunk_by(|a, b| a == b).scan(0, |end, run| {
        let start = *end;
        *end += run.len();
        Some((run[0], start, *end))
    });
    runs.filter(|&(good, start, end)| good && cuts[start].is_below(&cuts[end]))
        .map(|(_, start, end)| Arc::new(upright(curve, [cuts[start].clone(), cuts[end].clone()])))
        .collect()
}

/// The stretch of an upright curve between two ordinates, as a line.
fn upright(curve: &Arc<Curve>, y: [Real; 2]) -> Curve {
    let x = curve.at(LIMIT).from.x.clone();
    segment(y.map(|y| Vector { x: x.clone(), y }))
}

/// The line between two points.
fn segment(ends: [Vector; 2]) -> Curve {
    Curve::new(move |precision| {
        let [from, to] = ends.each_ref().map(|end| Vector { x: end.x.rounded(precision), y: end.y.rounded(precision) });
        Piece { from, to, circle: None }
    })
}

/// Whether a curve that is not upright runs to the right.
pub fn runs_right(curve: &Curve) -> bool {
    curve.at(LIMIT).chord().x.is_positive()
}

/// The stretch of a curve between two abscissas.
pub fn clipped(curve: &Arc<Curve>, x: [Float; 2]) -> Curve {
    let curve = curve.clone();
    let rightward = runs_right(&curve);
    Curve::new(move |precision| {
        let piece = curve.at(precision);
        let [from, to] = x.each_ref().map(|x| {
            let x = Real::from(x.clone()).rounded(precision);
            Vector { y: piece.ordinate(&x), x }
        });
        let (from, to) = if rightward { (from, to) } else { (to, from) };
        Piece { from, to, circle: piece.circle.clone() }
    })
}

/// How far a point in this strip may be from a point of the same region beside it: the longest stretch of a curve in the
/// strip, and the height in which two upright curves of the same region are so close that nothing between them reaches out.
/// The curves from `second` on belong to the second region.
pub fn blur(
    strips: &Strips,
    curves: &[Arc<Curve>],
    second: usize,
    strip: usize,
    before: &[usize],
    after: &[usize],
) -> f64 {
    let upright = |&&curve: &&usize| strips.spans[curve] == [strip; 2];
    let uprights: Vec<usize> = strips.involved[strip].iter().filter(upright).copied().collect();
    let pairs = uprights.iter().enumerate().flat_map(|(k, &i)| uprights[..k].iter().map(move |&j| (i, j)));
    let of_one_region = pairs.filter(|&(i, j)| (i < second) == (j < second));
    let lost = of_one_region.map(|(i, j)| squeezed(&curves[i], &curves[j])).fold(0.0, f64::max);
    let width = strips.width(strip);
    let stretch = |&curve: &usize| {
        let bound = steepest(&curves[curve], width);
        if bound < SHORT { bound } else { rise(strips, curves, strip, curve) }
    };
    before.iter().chain(after).map(stretch).fold(lost, f64::max)
}

/// The height in which a region may lie between two upright curves of one strip: 0 if they have the same abscissa or are
/// one above the other.
fn squeezed(first: &Curve, second: &Curve) -> f64 {
    let [p, q] = [first, second].map(|curve| curve.at(LIMIT));
    if (&p.from.x - &q.from.x).sign().is_none_or(|order| order.is_eq()) {
        return 0.0;
    }
    let [(low, high), (bottom, top)] =
        [p, q].map(|piece| (piece.from.y.min(&piece.to.y), piece.from.y.max(&piece.to.y)));
    (high.min(&top) - low.max(&bottom)).hi().max(0.0)
}

/// A bound of the height of a stretch of a curve of this width.
fn steepest(curve: &Curve, width: f64) -> f64 {
    let piece = curve.rough();
    match &piece.circle {
        None => {
            let chord = curve.at(LIMIT).chord();
            ((chord.y / chord.x).abs() * width).hi()
        }
        Some(circle) => (circle.radius.clone() * 2.0 * width).sqrt().hi(),
    }
}

/// The height of the stretch of a curve in a strip.
fn rise(strips: &Strips, curves: &[Arc<Curve>], strip: usize, curve: usize) -> f64 {
    let [first, last] = strips.spans[curve];
    let piece = curves[curve].at(LIMIT);
    let (left, right) = if runs_right(&curves[curve]) { (&piece.from, &piece.to) } else { (&piece.to, &piece.from) };
    let [x0, x1] = strips.ends[strip].clone().map(Real::from);
    let low = if first == strip { left.y.clone() } else { piece.ordinate(&x0) };
    let high = if last == strip { right.y.clone() } else { piece.ordinate(&x1) };
    (low - high).abs().hi()
}
