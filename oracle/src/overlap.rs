//! Whether A and t - B overlap, for polygons and in rational numbers: membership of t in the interior of the exact sum,
//! without the sum (memo I4).
//!
//! Where two edges cross properly the interiors overlap. If no two edges have a point in common, the regions overlap only if
//! one vertex of some loop lies inside the other region ([`crate::certified::membership`] has the proof). In between, where
//! edges only touch, the intersection is computed. A question costs one look into an index of A's edges for each edge of B, in
//! intervals; rational numbers are used where these do not decide.

use std::cmp::Ordering;
use std::sync::atomic::{AtomicUsize, Ordering as Memory};

use rug::Rational;

use crate::boolean::{Operation, combine};
use crate::boxes::{Boxes, Extent};
use crate::certified::membership::State;
use crate::error::OracleError;
use crate::interval::Interval;
use crate::locate::{Location, Locator};
use crate::point::{Place, Point, orient};
use crate::region::{ExactRegion, ring_edges};

type Edge = [Place<Rational>; 2];

/// Two polygons prepared for many questions.
pub struct Overlap {
    a: Operand,
    b: Operand,
    boxes: Option<Boxes>,
    /// The edge of B that crossed last: neighbouring questions often have the same answer for the same reason.
    crossed: AtomicUsize,
}

struct Operand {
    region: ExactRegion<Rational>,
    edges: Vec<Edge>,
    locator: Locator<Rational>,
}

/// How an edge lies to the other region's edges.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Meeting {
    Apart,
    Touch,
    Cross,
}

impl Overlap {
    /// Prepares two regions.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn new(a: ExactRegion<Rational>, b: ExactRegion<Rational>) -> Result<Self, OracleError> {
        let [a, b] = [Operand::new(a)?, Operand::new(b)?];
        let extents: Vec<Extent> = a.edges.iter().filter_map(Extent::around::<Rational>).collect();
        let boxes = if extents.is_empty() { None } else { Some(Boxes::new(&extents)?) };
        Ok(Self { a, b, boxes, crossed: AtomicUsize::new(0) })
    }

    /// How A and t - B lie to each other: blocked if their interiors overlap, free if they have no point in common, undecided
    /// if they only touch, so that t is not in the interior of the sum.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn state(&self, t: &Point<Rational>) -> Result<State, OracleError> {
        let (a, b) = (&self.a.region, &self.b.region);
        if a.is_empty() || b.is_empty() {
            return Ok(State::Free);
        }
        if a.unbounded() && b.unbounded() {
            return Ok(State::Blocked);
        }
        match self.meeting(&Place::from(t.clone())) {
            Meeting::Cross => Ok(State::Blocked),
            Meeting::Apart => Ok(if self.holds_a_vertex(t) { State::Blocked } else { State::Free }),
            Meeting::Touch => {
                let moved = b.scaled(&Rational::from(-1)).translated(t);
                let common = combine(Operation::Intersection, a, &moved)?;
                Ok(if common.is_empty() { State::Undecided } else { State::Blocked })
            }
        }
    }

    fn meeting(&self, t: &Place<Rational>) -> Meeting {
        let Some(boxes) = &self.boxes else { return Meeting::Apart };
        let (edges, last) = (&self.b.edges, self.crossed.load(Memory::Relaxed));
        let mut worst = Meeting::Apart;
        for i in std::iter::once(last.min(edges.len().saturating_sub(1))).chain(0..edges.len()) {
            let Some(edge) = edges.get(i) else { continue };
            worst = worst.max(self.meets(boxes, edge, t));
            if worst == Meeting::Cross {
                self.crossed.store(i, Memory::Relaxed);
                break;
            }
        }
        worst
    }

    /// How an edge of B, mirrored at t, lies to the edges of A.
    fn meets(&self, boxes: &Boxes, edge: &Edge, t: &Place<Rational>) -> Meeting {
        let ranges = edge.each_ref().map(|p| [t.x - p.x, t.y - p.y]);
        let lo = |i: usize| ranges[0][i].lo().min(ranges[1][i].lo());
        let hi = |i: usize| ranges[0][i].hi().max(ranges[1][i].hi());
        let mut found: Vec<usize> = Vec::new();
        boxes.visit(&Extent { ends: [lo(0), lo(1), hi(0), hi(1)] }, |i| found.push(i));
        let mut exact: Option<Edge> = None;
        let mut worst = Meeting::Apart;
        for i in found {
            let meeting = roughly(&self.a.edges[i], &ranges).unwrap_or_else(|| {
                let mirrored = || edge.each_ref().map(|p| Place::from(t.exact.minus(&p.exact)));
                exactly(&self.a.edges[i], exact.get_or_insert_with(mirrored))
            });
            worst = worst.max(meeting);
            if worst == Meeting::Cross {
                break;
            }
        }
        worst
    }

    /// Whether a vertex of a loop of one region lies inside the other one; no two edges meet.
    fn holds_a_vertex(&self, t: &Point<Rational>) -> bool {
        let inside = |operand: &Operand, other: &Operand| {
            let firsts = other.region.loops().iter().filter_map(|ring| ring.first());
            let mut mirrored = firsts.map(|p| Place::from(t.minus(p)));
            mirrored.any(|p| operand.locator.locate(&p) == Location::Inside)
        };
        inside(&self.a, &self.b) || inside(&self.b, &self.a)
    }
}

impl Operand {
    fn new(region: ExactRegion<Rational>) -> Result<Self, OracleError> {
        let places = region.places();
        let edges = places.iter().flat_map(|ring| ring_edges(ring).map(|(p, q)| [p.clone(), q.clone()])).collect();
        Ok(Self { edges, locator: Locator::new(&region)?, region })
    }
}

/// The same as [`exactly`] by intervals, if they tell.
fn roughly([p, q]: &Edge, [u, v]: &[[Interval; 2]; 2]) -> Option<Meeting> {
    let side = |[x, y]: &[Interval; 2]| ((q.x - p.x) * (*y - p.y) - (q.y - p.y) * (*x - p.x)).sign();
    let [su, sv] = [side(u)?, side(v)?];
    if su == sv && su != Ordering::Equal {
        return Some(Meeting::Apart);
    }
    let side = |c: &Place<Rational>| ((v[0] - u[0]) * (c.y - u[1]) - (v[1] - u[1]) * (c.x - u[0])).sign();
    let [sp, sq] = [side(p)?, side(q)?];
    if sp == sq && sp != Ordering::Equal {
        return Some(Meeting::Apart);
    }
    (![su, sv, sp, sq].contains(&Ordering::Equal)).then_some(Meeting::Cross)
}

fn exactly([p, q]: &Edge, [u, v]: &Edge) -> Meeting {
    let [su, sv, sp, sq] = [orient(p, q, u), orient(p, q, v), orient(u, v, p), orient(u, v, q)];
    let one_side = |s: Ordering, t: Ordering| s == t && s != Ordering::Equal;
    if one_side(su, sv) || one_side(sp, sq) {
        return Meeting::Apart;
    }
    if su == Ordering::Equal && sv == Ordering::Equal && are_apart([p, q], [u, v]) {
        return Meeting::Apart;
    }
    if [su, sv, sp, sq].contains(&Ordering::Equal) { Meeting::Touch } else { Meeting::Cross }
}

/// Whether collinear edges have no point in common.
fn are_apart(edge: [&Place<Rational>; 2], other: [&Place<Rational>; 2]) -> bool {
    let ends = |edge: [&Place<Rational>; 2]| {
        let [p, q] = edge.map(|place| (place.exact.x.clone(), place.exact.y.clone()));
        if p < q { [p, q] } else { [q, p] }
    };
    let ([low, high], [other_low, other_high]) = (ends(edge), ends(other));
    high < other_low || other_high < low
}
