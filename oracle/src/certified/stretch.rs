//! Points of a curve by their progress along the chord, and the stretch between two of them.
//!
//! A point is named by the fraction t of the chord that its foot has passed. On a circle of radius r it lies off the chord
//! of length l by s = l² t (1-t) / (√(r² - (t-1/2)² l²) + √(r² - l²/4)), on the side away from the centre; no difference
//! cancels, so that flat arcs lose no digits.

use std::sync::Arc;

use rug::Float;
use rug::float::Round;

use super::curve::Curve;
use super::piece::Piece;
use super::precision::Precision;
use super::real::Real;
use super::spot::Spot;
use super::vector::Vector;
use crate::interval::Interval;

/// The point of a piece over this fraction of its chord, from 0 to 1.
#[must_use]
pub fn along(piece: &Piece, fraction: &Real) -> Vector {
    let chord = piece.chord();
    let foot = &piece.from + &(&chord * fraction);
    let Some(circle) = &piece.circle else { return foot };
    let one = Real::from(1.0);
    let (square, radius) = (chord.square(), circle.radius.square());
    let middle = fraction - 0.5;
    let roots = (&radius - &(middle.square() * &square)).sqrt() + (&radius - &(&square * 0.25)).sqrt();
    let rise = chord.length() * fraction * (one - fraction) / roots;
    let outward = if circle.left { -&chord.left() } else { chord.left() };
    &foot + &(&outward * &rise)
}

/// A fraction as an interval of this precision.
#[must_use]
pub fn fraction(exact: &Float, precision: Precision) -> Real {
    if precision == Precision::DOUBLE {
        return Real::Double(Interval::new(exact.to_f64_round(Round::Down), exact.to_f64_round(Round::Up)));
    }
    let round = |direction| Float::with_val_round(precision.bits(), exact, direction).0;
    Real::Long(Box::new([round(Round::Down), round(Round::Up)]))
}

/// The part of a curve between two fractions, on the same carrier; its ends are exact points of the curve, those of the
/// curve itself where a fraction is 0 or 1.
#[must_use]
pub fn stretch(whole: &Arc<Curve>, ends: [Float; 2]) -> Curve {
    let whole = Arc::clone(whole);
    Curve::new(move |precision| {
        let piece = whole.at(precision);
        let end = |exact: &Float| match exact {
            exact if exact.is_zero() => piece.from.clone(),
            exact if *exact == 1 => piece.to.clone(),
            exact => along(piece, &fraction(exact, precision)),
        };
        Piece { from: end(&ends[0]), to: end(&ends[1]), circle: piece.circle.clone() }
    })
}

/// A point right of a curve, nearer than `reach` to its point at a fraction. It is not straight to the right, so that it is
/// not in line with everything else where directions repeat.
#[must_use]
pub fn beside(curve: &Arc<Curve>, place: &Float, reach: f64) -> Spot {
    let (curve, place) = (Arc::clone(curve), place.clone());
    Spot::new(move |precision| {
        let piece = curve.at(precision);
        let point = along(piece, &fraction(&place, precision));
        let forward = piece.tangent(&point).unit();
        let step = &(&forward * &Real::from(0.375)) - &forward.left();
        &point + &(&step * &Real::from(0.5 * reach))
    })
}
