//! What happens inside a strip: upright curves, and how far it is from there to the slabs beside it.

use std::sync::Arc;

use rug::Float;

use super::curve::Curve;
use super::meet::LIMIT;
use super::piece::Piece;
use super::real::Real;
use super::strips::Strips;
use super::vector::Vector;

/// Strips narrower than two to this power hide nothing longer than two to the power of -70: between slabs wider than
/// 2^-88 lines are less steep than 2^90, and arcs deviate by no more than the root of twice the width.
const NARROW: i32 = -160;

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
    let stretch = |i: usize| Arc::new(upright(curve, [cuts[i].clone(), cuts[i + 1].clone()]));
    (0..good.len()).filter(|&i| good[i] && cuts[i].is_below(&cuts[i + 1])).map(stretch).collect()
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

/// How far a point of a curve in this strip may be from one beside the strip (0 for narrow strips, see [`NARROW`]), and the
/// length of upright curves that are so close to another that nothing of the region between them reaches out of the strip.
pub fn blur(strips: &Strips, curves: &[Arc<Curve>], strip: usize, before: &[usize], after: &[usize]) -> f64 {
    let [left, right] = strips.ends[strip].clone().map(Real::from);
    let uprights: Vec<usize> =
        strips.involved[strip].iter().copied().filter(|&curve| strips.spans[curve] == [strip; 2]).collect();
    let apart = |i: usize, j: usize| {
        let [p, q] = [i, j].map(|k| &curves[k].at(LIMIT).from.x);
        matches!((p - q).sign(), Some(order) if order.is_ne())
    };
    let mut blur: f64 = 0.0;
    for (k, &i) in uprights.iter().enumerate() {
        if uprights[..k].iter().any(|&j| apart(i, j)) {
            blur = blur.max(curves[i].rough().chord().length().hi());
        }
    }
    if (&right - &left).is_within(NARROW) {
        return blur;
    }
    let ordinate = |curve: usize, x: &Real, beside: bool, end: bool| {
        let piece = curves[curve].at(LIMIT);
        let rightward = runs_right(&curves[curve]);
        if beside {
            piece.ordinate(x)
        } else if rightward == end {
            piece.to.y.clone()
        } else {
            piece.from.y.clone()
        }
    };
    let mut ends: Vec<usize> = before.iter().chain(after).copied().collect();
    ends.sort_unstable();
    ends.dedup();
    for curve in ends {
        let (was, is) = (before.contains(&curve), after.contains(&curve));
        let low = ordinate(curve, &left, was, false);
        let high = ordinate(curve, &right, is, true);
        blur = blur.max((low - high).abs().hi());
    }
    blur
}
