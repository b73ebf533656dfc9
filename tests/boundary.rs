//! What the boundary of a realization must be like: with the stored angles, simple, near another one.

use arcsum_oracle::certified::piece::Piece;
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::realize::plan::WORK;
use arcsum_oracle::certified::realize::{Angle, StoredPiece, StoredRegion, Up};
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::vector::Vector;
use rug::Float;
use std::cmp::Ordering;

use arcsum_oracle::precise::{PRECISION, big, pi, reduced};

/// Fine enough to tell everything here.
pub const FINE: Precision = Precision::LADDER[4];

fn long(x: &Real) -> Float {
    match x {
        Real::Long(bounds) => Float::with_val(PRECISION, &bounds[0]),
        Real::Double(interval) => big(interval.lo()),
    }
}

/// The angles of the rightward normals at the ends of a piece, by the arc tangent; one for a line.
fn normals(piece: &Piece) -> Vec<Float> {
    let angle = |x: &Real, y: &Real| long(y).atan2(&long(x));
    match &piece.circle {
        None => {
            let chord = piece.chord();
            vec![angle(&chord.y, &-&chord.x)]
        }
        Some(circle) => {
            let arm = |end: &Vector| if circle.left { end - &circle.centre } else { &circle.centre - end };
            [&piece.from, &piece.to].map(arm).iter().map(|v| angle(&v.x, &v.y)).collect()
        }
    }
}

fn value(angle: Angle) -> Float {
    pi() * angle.quarter / 2u32 + big(angle.offset)
}

/// Whether two angles agree to 2^-500 up to whole turns.
fn same(a: &Float, b: &Float) -> bool {
    let difference = reduced(&Float::with_val(PRECISION, a - b));
    difference.is_zero() || difference.get_exp().is_some_and(|e| e < -500)
}

fn occurrences(angle: &Float, among: &[Float]) -> usize {
    among.iter().filter(|other| same(angle, other)).count()
}

/// Whether every stored angle occurs on the boundary, as often as it is stored, and everything else is parallel to the
/// direction. Lines parallel to it may have become one connection.
#[must_use]
pub fn has_stored_angles(shape: &Shape, region: &StoredRegion, up: Up) -> bool {
    let found: Vec<Float> = shape.sides().flat_map(|side| normals(side.curve.at(FINE))).collect();
    let ends = |p: &StoredPiece| if p.is_line() { vec![p.start] } else { vec![p.start, p.end] };
    let stored: Vec<Angle> = region.loops.iter().flatten().flat_map(ends).collect();
    let wanted: Vec<Float> = stored.iter().map(|&angle| value(angle)).collect();
    let others: Vec<&Float> = found.iter().filter(|&angle| occurrences(angle, &wanted) == 0).collect();
    let parallel = |pair: &[&Float]| same(&(pair[0].clone() * 2u32), &(pair[1].clone() * 2u32));
    let occurs = |(&angle, wish): (&Angle, &Float)| {
        let along = up.normal(angle, WORK).y.sign() == Some(Ordering::Equal);
        occurrences(wish, &found) >= if along { 1 } else { occurrences(wish, &wanted) }
    };
    stored.iter().zip(&wanted).all(occurs) && others.windows(2).all(parallel)
}

/// The ordinate of a piece over an abscissa and whether it runs to the right there, in the frame of a direction;
/// `Err` if it is not certain whether the piece is there.
fn crossing(piece: &Piece, up: Up, x: &Real) -> Result<Option<(Real, bool)>, ()> {
    let [from, to] = [&piece.from, &piece.to].map(|p| up.to_frame(p));
    let sides = [(x - &from.x).sign().ok_or(())?, (&to.x - x).sign().ok_or(())?];
    if sides.contains(&Ordering::Equal) {
        return Err(());
    }
    if sides[0] != sides[1] {
        return Ok(None);
    }
    let rightward = from.x.is_below(&to.x);
    let y = match &piece.circle {
        None => &from.y + &((&to.y - &from.y) * (x - &from.x) / (&to.x - &from.x)),
        Some(circle) => {
            let centre = up.to_frame(&circle.centre);
            let height = (up.square(FINE) * circle.radius.square() - (x - &centre.x).square()).sqrt();
            if circle.left == rightward { &centre.y - &height } else { &centre.y + &height }
        }
    };
    Ok(Some((y, rightward)))
}

/// Whether a line along the direction enters and leaves the region by turns, with certain gaps. `None` if the line
/// passes too near to an end to tell what it crosses.
fn alternates(pieces: &[&Piece], unbounded: bool, up: Up, x: &Real) -> Option<bool> {
    let mut met = Vec::new();
    for piece in pieces {
        met.extend(crossing(piece, up, x).ok()?);
    }
    met.sort_by(|(a, _), (b, _)| {
        a.mid().total_cmp(&b.mid()).then(if a.is_below(b) { Ordering::Less } else { Ordering::Greater })
    });
    let ordered = met.windows(2).all(|pair| pair[0].0.is_below(&pair[1].0) && pair[0].1 != pair[1].1);
    let outer = met.first().is_none_or(|first| first.1 != unbounded) && met.len() % 2 == 0;
    Some(ordered && outer)
}

/// [`alternates`] next to every end, where chains cross if they do.
#[must_use]
pub fn is_simple(shape: &Shape, up: Up) -> bool {
    let pieces: Vec<&Piece> = shape.sides().map(|side| side.curve.at(FINE)).collect();
    let steps = [-30, -50, -53, -56, -60, -70].map(|k| 2.0_f64.powi(k));
    pieces.iter().all(|piece| {
        let x = up.to_frame(&piece.from).x;
        steps
            .iter()
            .flat_map(|h| [&x + *h, &x - *h])
            .all(|x| alternates(&pieces, shape.unbounded, up, &x) != Some(false))
    })
}

/// The end and the middle of a piece.
#[must_use]
pub fn samples(piece: &Piece) -> [Vector; 2] {
    let middle = &(&piece.from + &piece.to) * &Real::from(0.5);
    let middle = match &piece.circle {
        None => middle,
        Some(circle) => &circle.centre + &(&(&middle - &circle.centre).unit() * &circle.radius),
    };
    [piece.to.clone(), middle]
}

/// The greatest distance of the samples of one boundary from the other.
#[must_use]
pub fn away(from: &Shape, to: &Shape) -> f64 {
    let precision = Precision::LADDER[2];
    let pieces: Vec<&Piece> = to.sides().map(|side| side.curve.at(precision)).collect();
    let nearest = |p: &Vector| pieces.iter().map(|piece| piece.distance(p).hi()).fold(f64::INFINITY, f64::min);
    from.sides().flat_map(|side| samples(side.curve.at(precision))).map(|p| nearest(&p)).fold(0.0, f64::max)
}
