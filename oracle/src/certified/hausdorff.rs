//! The certified region Hausdorff distance of two regions bounded by lines and circle segments (memo I6).
//!
//! The differences of the two regions are cut into trapezoids ([`super::slabs`]), and how far these reach from the other
//! region is bracketed ([`super::reach`]). As for polygons ([`crate::measure`]), only points of a difference have a positive
//! distance to the other region, it is the one to the other region's boundary, and the corners that give the lower bound
//! belong to the closed difference.
//!
//! `hi` is at most 1/32 or 2^-60 above `lo`, unless the search runs out of cuts; then the bracket is wider and still valid.

use std::sync::Arc;

use super::curve::Curve;
use super::meet::LIMIT;
use super::nearest::Nearest;
use super::piece::{Circle, Piece};
use super::reach::Reach;
use super::shape::Shape;
use super::slabs::{Layer, Parts, differences};
use super::strips::Span;
use super::vector::Vector;
use crate::error::OracleError;
use crate::measure::{Bracket, Direction};

/// A bracket is not refined further when it is this narrow.
const FLOOR: f64 = 1.0 / (1u64 << 60) as f64;

/// What the places where curves meet may hide ([`super::meet::CLUSTER`]), with room to spare.
const HIDDEN: f64 = 1.0 / (1u128 << 80) as f64;

/// A region as the pieces of its boundary in any order.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    /// Closed loops with the interior, the points of winding number other than 0, on the left.
    pub pieces: Vec<Span>,
    /// Whether everything far away belongs to the region.
    pub unbounded: bool,
}

impl From<&Shape> for Outline {
    fn from(shape: &Shape) -> Self {
        Self { pieces: shape.sides().map(|side| Span::from(&side.curve)).collect(), unbounded: shape.unbounded }
    }
}

/// A turn to the left about the origin, given by any vector of its direction.
#[derive(Clone, Copy)]
struct Turn {
    across: f64,
    up: f64,
    length: f64,
}

/// Turns that make most directions neither upright nor level: a flat arc is rarely upright in all of them.
const TURNS: [Turn; 2] = [Turn { across: 0.0, up: 1.0, length: 1.0 }, Turn { across: 4.0, up: 3.0, length: 5.0 }];

impl Turn {
    fn back(self) -> Self {
        Self { up: -self.up, ..self }
    }

    fn vector(self, v: &Vector) -> Vector {
        let x = &v.x * self.across - &v.y * self.up;
        let y = &v.x * self.up + &v.y * self.across;
        Vector { x: x / self.length, y: y / self.length }
    }

    fn piece(self, piece: &Piece) -> Piece {
        let circle = piece.circle.as_ref().map(|c| Circle { centre: self.vector(&c.centre), ..c.clone() });
        Piece { from: self.vector(&piece.from), to: self.vector(&piece.to), circle }
    }

    fn outline(self, outline: &Outline) -> Outline {
        let span = |span: &Span| {
            let curve = Arc::clone(&span.curve);
            let turned = Curve::new(move |precision| self.piece(curve.at(precision)));
            Span { curve: Arc::new(turned), ends: span.ends.each_ref().map(|end| self.vector(end)) }
        };
        Outline { pieces: outline.pieces.iter().flat_map(|piece| monotone(span(piece))).collect(), ..*outline }
    }

    fn found(self, mut found: Found) -> Found {
        if let Some(place) = &found.place {
            let place = self.vector(place);
            found.bracket.witness = place.nearest();
            found.place = Some(place);
        }
        found
    }
}

/// An arc of at most a quarter of a circle, cut where it passes one of the axis directions from the centre: the turned one of a
/// quadrant may do so.
fn monotone(span: Span) -> Vec<Span> {
    let axis = AXES.into_iter().find(|axis| {
        let piece = span.curve.at(LIMIT);
        piece.circle.as_ref().is_some_and(|circle| piece.spans(&extreme(circle, *axis)) == Some(true))
    });
    let (Some(axis), Some(circle)) = (axis, &span.curve.at(LIMIT).circle) else { return vec![span] };
    let (middle, [from, to]) = (extreme(circle, axis), span.ends.clone());
    let part = |second: bool, ends: [Vector; 2]| {
        let whole = Arc::clone(&span.curve);
        let curve = Curve::new(move |precision| {
            let mut piece = whole.at(precision).clone();
            let end = if second { &mut piece.from } else { &mut piece.to };
            piece.circle.iter().for_each(|circle| *end = extreme(circle, axis));
            piece
        });
        Span { curve: Arc::new(curve), ends }
    };
    vec![part(false, [from, middle.clone()]), part(true, [middle, to])]
}

/// The directions of the axes.
const AXES: [[f64; 2]; 4] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];

/// The point of a circle in the direction of an axis.
fn extreme(circle: &Circle, axis: [f64; 2]) -> Vector {
    let [x, y] = axis.map(|along| &circle.radius * along);
    Vector { x: &circle.centre.x + &x, y: &circle.centre.y + &y }
}

/// What was found about the distance of two regions.
#[derive(Clone, Debug)]
pub struct Found {
    /// The bracket.
    pub bracket: Bracket,
    /// Its witness, as finely as it is known.
    pub place: Option<Vector>,
}

/// A certified bracket of the distance between a result and the region it should be, in the units of their coordinates;
/// `None` if it is undecided how two of the curves meet. It is infinite if one region is unbounded or empty and the other
/// is not.
///
/// # Errors
/// [`OracleError::BadNumber`] for coordinates too large for doubles, [`OracleError::Inconsistent`] for boundaries that do
/// not close.
pub fn between(result: &Outline, truth: &Outline) -> Result<Option<Found>, OracleError> {
    let Some((mut best, mut blur)) = upright_between(result, truth)? else { return Ok(None) };
    // Where a flat arc is upright, much of it lies in one strip.
    for turn in TURNS {
        if blur <= FLOOR {
            break;
        }
        if let Some((found, less)) = upright_between(&turn.outline(result), &turn.outline(truth))?
            && less < blur
        {
            (best, blur) = (turn.back().found(found), less);
        }
    }
    Ok(Some(best))
}

/// The bracket from upright slabs, and how much of its width is due to the strips between them.
fn upright_between(result: &Outline, truth: &Outline) -> Result<Option<(Found, f64)>, OracleError> {
    let layers = [result, truth].map(|o| Layer { pieces: &o.pieces, base: i32::from(o.unbounded) });
    let Some(found) = differences(layers)? else { return Ok(None) };
    // A bounded region without any part of the plane to its edges is empty, an unbounded one the plane.
    let empty = [0, 1].map(|i| found.edges[i].is_empty() && layers[i].base == 0);
    if result.unbounded != truth.unbounded || empty[0] != empty[1] {
        let more = (result.unbounded && !truth.unbounded) || empty[1];
        let direction = if more { Direction::FromResult } else { Direction::FromSum };
        let witness = (f64::NAN, f64::NAN);
        let bracket = Bracket { lo: f64::INFINITY, hi: f64::INFINITY, direction, witness };
        return Ok(Some((Found { bracket, place: None }, 0.0)));
    }
    Ok(Some((bracket(&found)?, found.blur)))
}

/// The bracket over all trapezoids of both differences.
fn bracket(found: &Parts) -> Result<Found, OracleError> {
    let [of_result, of_truth] = &found.edges;
    let (to_truth, to_result) = (Nearest::new(of_truth)?, Nearest::new(of_result)?);
    let mut forth = Reach::new(&to_truth, &found.parts[0]);
    let mut back = Reach::new(&to_result, &found.parts[1]);
    let known = forth.reached().0.max(back.reached().0);
    let hi = forth.refine(known, FLOOR).max(back.refine(known, FLOOR));
    let (direction, search) =
        if forth.reached().0 >= back.reached().0 { (Direction::FromResult, forth) } else { (Direction::FromSum, back) };
    let (lo, place) = search.reached();
    let witness = place.map_or((f64::NAN, f64::NAN), Vector::nearest);
    let hidden = found.blur + HIDDEN;
    let bracket = Bracket { lo, hi: hi.max(lo), direction, witness }.widened(hidden);
    Ok(Found { bracket, place: place.cloned() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plain::{Bend, Corner, PlainRegion};

    fn region(corners: &[(f64, f64, f64)]) -> Outline {
        let corner = |&(x, y, bulge): &(f64, f64, f64)| Corner {
            x,
            y,
            bend: if bulge == 0.0 { Bend::Line } else { Bend::Bulge(bulge) },
        };
        let plain = PlainRegion { loops: vec![corners.iter().map(corner).collect()], unbounded: false };
        Outline::from(&Shape::new(&plain).expect("valid"))
    }

    fn disc(x: f64, radius: f64) -> Outline {
        region(&[(x - radius, 0.0, 1.0), (x + radius, 0.0, 1.0)])
    }

    fn measured(a: &Outline, b: &Outline) -> Bracket {
        between(a, b).expect("consistent").expect("decided").bracket
    }

    fn holds(bracket: &Bracket, truth: f64) {
        assert!(bracket.lo <= truth && truth <= bracket.hi, "{truth:e} in {bracket:?}");
        assert!(bracket.hi <= bracket.lo * 1.04 || bracket.hi - bracket.lo < 2f64.powi(-58), "{bracket:?}");
    }

    #[test]
    fn concentric_discs_differ_by_their_radii() {
        for k in [1, 3, 10, 30, 48] {
            let d = 2f64.powi(-k);
            holds(&measured(&disc(0.0, 1.0), &disc(0.0, 1.0 - d)), d);
            holds(&measured(&disc(0.0, 1.0 - d), &disc(0.0, 1.0)), d);
            holds(&measured(&disc(d, 1.0), &disc(0.0, 1.0)), d);
        }
        holds(&measured(&disc(0.0, 1.0), &disc(0.0, 1.0)), 0.0);
    }

    #[test]
    fn squares_moved_a_little() {
        let square =
            |x: f64, y: f64| region(&[(x, y, 0.0), (x + 1.0, y, 0.0), (x + 1.0, y + 1.0, 0.0), (x, y + 1.0, 0.0)]);
        for k in [2, 10, 30, 50] {
            let d = 2f64.powi(-k);
            holds(&measured(&square(d, 0.0), &square(0.0, 0.0)), d);
            holds(&measured(&square(d, d), &square(0.0, 0.0)), d * 2f64.sqrt());
        }
    }

    /// A sliver beside an upright arc with a radius of 2^51 and a sagitta of 2^-52: a strip at its leftmost point is much
    /// higher than wide, a level one is not.
    #[test]
    fn flat_upright_arcs_are_measured_lying_down() {
        let bulge = f64::from(-51).exp2();
        let straight = [(0.0, 2.0, 0.0), (0.0, -1.0, 0.0), (1.0, 0.0, 0.0)];
        let bent = [(0.0, 2.0, bulge), (0.0, -1.0, 0.0), (1.0, 0.0, 0.0)];
        let sagitta = 1.5 * bulge;
        holds(&measured(&region(&bent), &region(&straight)), sagitta);
        let level = |corners: [(f64, f64, f64); 3]| region(&corners.map(|(x, y, bulge)| (-y, x, bulge)));
        holds(&measured(&level(bent), &level(straight)), sagitta);
        let found = between(&region(&bent), &region(&straight)).expect("closed").expect("decided");
        assert!(found.bracket.witness.0.abs() < 1e-15 && (0.0..1.0).contains(&found.bracket.witness.1), "{found:?}");
    }

    /// Quarters of circles have their leftmost and rightmost points at other places when they are turned.
    #[test]
    fn discs_are_measured_askew() {
        for turn in TURNS {
            for d in [2, 20].map(|k| 2f64.powi(-k)) {
                let pair = [disc(0.0, 1.0), disc(0.0, 1.0 - d)].map(|outline| turn.outline(&outline));
                let (found, blur) = upright_between(&pair[0], &pair[1]).expect("closed").expect("decided");
                assert!(blur < FLOOR);
                holds(&found.bracket, d);
            }
        }
    }
}
