//! The Euler characteristic of A ∩ (t-B), which the winding number of the kinetic convolution counts (memo fact 6).
//!
//! A line sweeps over X = A ∩ (t-B) from left to right (verticals count as leaning to the right). The characteristic of what
//! lies left of it grows by one where a part of X begins and falls by one where two strands of X join; where X ends
//! or splits it stays. So it is the number of beginnings less the number of joins:
//! - a boundary that turns from leftward to rightward at a convex place begins a part, if the place is inside the
//!   other region;
//! - one that turns from rightward to leftward at a concave place joins two strands, likewise;
//! - where boundaries cross X has a convex corner: it begins there if the boundary that leaves the other region runs
//!   leftward and the one that enters runs rightward.

use std::cmp::Ordering;
use std::sync::Arc;

use super::bounds::meet as meet_boxes;
use super::curve::Curve;
use super::inside::Winding;
use super::meet::{LIMIT, Meeting, meet};
use super::piece::Piece;
use super::precision::Precision;
use super::shape::{Shape, Side};
use super::spot::Spot;

/// Two regions, at most one of them unbounded, prepared for many questions.
pub struct Characteristic {
    a: Operand,
    b: Operand,
}

struct Operand {
    winding: Winding,
    curves: Vec<Arc<Curve>>,
    /// Whether each piece runs rightward.
    rightward: Vec<bool>,
    turns: Vec<Turn>,
}

/// A place where the boundary turns back in x.
struct Turn {
    /// The piece that starts there.
    curve: Arc<Curve>,
    convex: bool,
    /// Whether it turns from leftward to rightward.
    opens: bool,
}

impl Characteristic {
    /// Prepares two regions; `None` if the direction of a piece is not known.
    #[must_use]
    pub fn new(a: &Shape, b: &Shape) -> Option<Self> {
        Some(Self { a: Operand::new(a)?, b: Operand::new(b)? })
    }

    /// The Euler characteristic of A ∩ (t-B); `None` if boundaries touch or nearly do.
    #[must_use]
    pub fn at(&self, t: &Spot) -> Option<i32> {
        let mut sum = 0;
        for turn in self.a.turns.iter().filter(|turn| turn.convex == turn.opens) {
            sum += turn.step() * i32::from(self.b.winding.inside(|p| &t.at(p) - &turn.curve.at(p).from, LIMIT)?);
        }
        // Half a turn exchanges left and right and keeps what is convex.
        for turn in self.b.turns.iter().filter(|turn| turn.convex != turn.opens) {
            sum += turn.step() * i32::from(self.a.winding.inside(|p| &t.at(p) - &turn.curve.at(p).from, LIMIT)?);
        }
        let rough: Vec<Piece> = self.b.curves.iter().map(|curve| curve.rough().mirrored(&t.rough())).collect();
        for (i, first) in self.a.curves.iter().enumerate() {
            for (j, second) in self.b.curves.iter().enumerate() {
                if !meet_boxes(&first.rough().bounds(), &rough[j].bounds()) {
                    continue;
                }
                let count = beginnings(first, |p| second.at(p).mirrored(&t.at(p)), self.a.rightward[i])?;
                // Of pieces that run the same way nothing begins, but a touch leaves the answer open. Half a turn
                // exchanges the ways.
                sum += if self.a.rightward[i] == self.b.rightward[j] { count } else { 0 };
            }
        }
        Some(sum)
    }
}

/// How many of the crossings of two pieces, one rightward and one leftward, begin a part: those at which the rightward one
/// enters, from the right of the other to its left.
fn beginnings(first: &Curve, second: impl Fn(Precision) -> Piece, first_is_rightward: bool) -> Option<i32> {
    // Seen from the first piece, the second one goes to the left (`Greater`) or to the right.
    let wanted = if first_is_rightward { Ordering::Less } else { Ordering::Greater };
    for precision in LIMIT.up_to() {
        match meet(first.at(precision), &second(precision), precision) {
            Meeting::Apart => return Some(0),
            Meeting::Unclear => (),
            Meeting::Contacts { contacts, .. } => {
                let known: Option<Vec<Ordering>> = contacts.iter().map(|contact| contact.crossing).collect();
                match known {
                    Some(ways) => return Some(ways.iter().filter(|way| **way == wanted).count() as i32),
                    None if precision == LIMIT => return None,
                    None => (),
                }
            }
        }
    }
    None
}

impl Operand {
    fn new(shape: &Shape) -> Option<Self> {
        let mut turns = Vec::new();
        let (mut curves, mut rightward) = (Vec::new(), Vec::new());
        for ring in &shape.loops {
            let ways: Option<Vec<bool>> = ring.iter().map(|side| runs_rightward(&side.curve)).collect();
            let ways = ways?;
            for (i, side) in ring.iter().enumerate() {
                let before = (i + ring.len() - 1) % ring.len();
                if ways[before] != ways[i] {
                    let convex = is_convex(&ring[before], side)?;
                    turns.push(Turn { curve: Arc::clone(&side.curve), convex, opens: ways[i] });
                }
            }
            curves.extend(ring.iter().map(|side| Arc::clone(&side.curve)));
            rightward.extend(ways);
        }
        Some(Self { winding: Winding::new(shape), curves, rightward, turns })
    }
}

impl Turn {
    /// What it adds if it is one of those that count.
    fn step(&self) -> i32 {
        if self.convex { 1 } else { -1 }
    }
}

/// Whether a piece runs rightward; a vertical one does if it runs upward.
fn runs_rightward(curve: &Curve) -> Option<bool> {
    let sign = |of: fn(&Piece) -> Option<Ordering>| LIMIT.decide(|p| of(curve.at(p)));
    let way =
        sign(|piece| piece.chord().x.sign())?.then(sign(|piece| piece.chord().y.sign()).unwrap_or(Ordering::Equal));
    (way != Ordering::Equal).then_some(way.is_gt())
}

/// Whether the boundary turns left where one piece goes over into the next.
fn is_convex(before: &Side, after: &Side) -> Option<bool> {
    let turn = LIMIT.decide(|p| {
        let (before, after) = (before.curve.at(p), after.curve.at(p));
        before.tangent(&before.to).turn(&after.tangent(&after.from)).filter(|turn| turn.is_ne())
    });
    let circle = [after, before].iter().find_map(|side| side.curve.rough().circle.as_ref().map(|circle| circle.left));
    // No turn: where the tangent is vertical the boundary goes to the side of its circle.
    turn.map(Ordering::is_gt).or(circle)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plain::{Bend, Corner, PlainRegion};

    fn shape(loops: &[&[(f64, f64, f64)]], unbounded: bool) -> Shape {
        let corner = |&(x, y, bulge): &(f64, f64, f64)| Corner { x, y, bend: Bend::Bulge(bulge) };
        let loops = loops.iter().map(|ring| ring.iter().map(corner).collect()).collect();
        Shape::new(&PlainRegion { loops, unbounded }).expect("a region")
    }

    fn at(a: &Shape, b: &Shape, x: f64, y: f64) -> Option<i32> {
        Characteristic::new(a, b).expect("decided").at(&Spot::exact(x, y))
    }

    #[test]
    fn components_count_and_holes_count_against_them() {
        let disc = |r| shape(&[&[(r, 0.0, 1.0), (-r, 0.0, 1.0)]], false);
        let ring = shape(&[&[(3.0, 0.0, 1.0), (-3.0, 0.0, 1.0)], &[(1.0, 0.0, -1.0), (-1.0, 0.0, -1.0)]], false);
        let bar = shape(&[&[(-5.0, -0.25, 0.0), (5.0, -0.25, 0.0), (5.0, 0.25, 0.0), (-5.0, 0.25, 0.0)]], false);
        assert_eq!(at(&disc(1.0), &disc(0.5), 0.1, 0.2), Some(1));
        assert_eq!(at(&disc(1.0), &disc(0.5), 1.3, 0.2), Some(1));
        assert_eq!(at(&disc(1.0), &disc(0.5), 1.6, 0.2), Some(0));
        assert_eq!(at(&ring, &disc(2.0), 0.1, 0.0), Some(0));
        assert_eq!(at(&ring, &disc(0.5), 0.1, 0.0), Some(0));
        assert_eq!(at(&ring, &bar, 0.1, 0.2), Some(2));
        assert_eq!(at(&bar, &ring, 0.1, 0.2), Some(2));
        assert_eq!(at(&ring, &ring, 0.1, 0.2), Some(0));
    }

    #[test]
    fn complements_hold_what_does_not_fit() {
        let outside = shape(&[&[(1.0, 0.0, -1.0), (-1.0, 0.0, -1.0)]], true);
        let square = |s: f64| shape(&[&[(-s, -s, 0.0), (s, -s, 0.0), (s, s, 0.0), (-s, s, 0.0)]], false);
        assert_eq!(at(&outside, &square(0.5), 0.1, 0.05), Some(0));
        assert_eq!(at(&outside, &square(0.8), 0.01, 0.02), Some(4));
        assert_eq!(at(&outside, &square(2.0), 0.01, 0.02), Some(0));
        assert_eq!(at(&outside, &square(0.5), 3.0, 0.02), Some(1));
    }

    #[test]
    fn touching_boundaries_stay_open() {
        let square = shape(&[&[(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)]], false);
        assert_eq!(at(&square, &square, 0.5, 1.0), None);
    }
}
