//! Minkowski sums by convolution and winding numbers (memo I2, A7, A8).
//!
//! An edge of one region is added to every vertex of the other at which the boundary turns past the edge's direction:
//! forward where the turn is to the left, backward where it is to the right. If directions are equal, a turn of A comes
//! first: an edge of A meets the turns of B in (lo, hi], an edge of B those of A in [lo, hi). These segments form closed
//! curves whose winding number around t is the Euler characteristic of A ∩ (t-B). Per pair of components, holes that
//! cannot matter are filled first; then the winding number is positive inside the sum and 0 outside.
//!
//! A segment at a right turn counts for winding numbers but has no piece of the sum's boundary on it (MS 5). Let p be
//! inside an edge of A (or with A and B exchanged) with normal n towards A, and v a vertex of B at which the boundary
//! turns right past the edge's direction. Of the two edges of B at v, one leads from v to points v+d with n·d < 0,
//! arbitrarily near: the leaving one unless it is parallel to the edge of A, the arriving one otherwise. Except for
//! finitely many p, A contains a half disc of some radius r around p, all p+x with n·x >= 0 and |x| <= r. So for |d| < r
//! and every u small enough, p+v+u is the sum of p+(u-d) in A and v+d in B: p+v is an interior point of the sum. Nothing
//! is used of B but that it contains its edges, so pinches do no harm.
//!
//! Of the other segments, what lies in the squares of a [`Cover`] has no boundary on it either and is not walked.

use std::cmp::Ordering;
use std::collections::HashMap;

use crate::arrange::boundaries;
use crate::cover::Cover;
use crate::curves::Curves;
use crate::error::{Budget, OracleError};
use crate::number::Number;
use crate::parts::{Ring, parts};
use crate::point::{Place, cross_sign, orient};
use crate::region::ExactRegion;

/// The closed, regularised Minkowski sum of two regions.
///
/// # Errors
/// [`OracleError::TooCostly`] beyond the budget; [`OracleError::Inconsistent`] if a winding number beside a walk is
/// negative or the boundary does not close up.
pub fn sum<Q: Number>(a: &ExactRegion<Q>, b: &ExactRegion<Q>, budget: Budget) -> Result<ExactRegion<Q>, OracleError> {
    sum_walking(Walked::Needed, a, b, budget)
}

/// [`sum`] with every segment walked from end to end: what the two shortcuts are tested against.
///
/// # Errors
/// As [`sum`].
pub fn unfiltered_sum<Q: Number>(
    a: &ExactRegion<Q>,
    b: &ExactRegion<Q>,
    budget: Budget,
) -> Result<ExactRegion<Q>, OracleError> {
    sum_walking(Walked::All, a, b, budget)
}

/// Which segments are walked.
#[derive(Clone, Copy, PartialEq)]
enum Walked {
    /// Those that may carry boundary of the sum, where they may.
    Needed,
    /// All of them.
    All,
}

fn sum_walking<Q: Number>(
    walked: Walked,
    a: &ExactRegion<Q>,
    b: &ExactRegion<Q>,
    budget: Budget,
) -> Result<ExactRegion<Q>, OracleError> {
    if a.is_empty() || b.is_empty() {
        return Ok(ExactRegion::empty());
    }
    if a.unbounded() && b.unbounded() {
        return Ok(ExactRegion::plane());
    }
    let (parts_a, parts_b) = (parts(a)?, parts(b)?);
    let mut curves = Curves::default();
    let mut base = 0;
    for part_a in &parts_a {
        for part_b in &parts_b {
            let rings_a: Vec<_> = part_a.rings_against(part_b).collect();
            let rings_b: Vec<_> = part_b.rings_against(part_a).collect();
            if rings_a.is_empty() || rings_b.is_empty() {
                // Every hole of an unbounded component is too small for the other one.
                return Ok(ExactRegion::plane());
            }
            base += i32::from(part_a.unbounded() || part_b.unbounded());
            for ring_a in &rings_a {
                rings_b.iter().try_for_each(|ring_b| convolve(&mut curves, walked, ring_a, ring_b, budget))?;
            }
        }
    }
    if walked == Walked::Needed
        && let Some(cover) = Cover::new(a, b, curves.len())
    {
        curves.expose(|tail, head| cover.exposed(tail, head));
    }
    let [edges, negative] = boundaries(&curves, [base], [|w| w[0] > 0, |w| w[0] < 0], budget)?;
    if !negative.is_empty() {
        return Err(OracleError::Inconsistent("a winding number of a convolution is negative"));
    }
    ExactRegion::from_edges(edges, base > 0)
}

/// Adds the convolution of two rings to the curves.
fn convolve<Q: Number>(
    curves: &mut Curves<Q>,
    walked: Walked,
    a: &Ring<Q>,
    b: &Ring<Q>,
    budget: Budget,
) -> Result<(), OracleError> {
    let mut numbers: HashMap<(usize, usize), usize> = HashMap::new();
    sum_segments(a, b, Ties::FIRST_A, |[from, to], forward| {
        let [from, to] = [from, to]
            .map(|(i, j)| *numbers.entry((i, j)).or_insert_with(|| curves.place(a[i].exact.plus(&b[j].exact))));
        let (tail, head) = if forward { (from, to) } else { (to, from) };
        if forward || walked == Walked::All {
            curves.segment(tail, head, 0);
        } else {
            curves.hidden_segment(tail, head, 0);
        }
        budget.check_segments(curves.len())
    })
}

/// Which ends of a turn belong to it, `[lo, hi]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ties {
    /// Of the turns of A, which the edges of B meet.
    pub of_a: [bool; 2],
    /// Of those of B.
    pub of_b: [bool; 2],
}

impl Ties {
    /// At equal directions a turn of A comes first: what closes the convolution (memo A7).
    pub const FIRST_A: Self = Self { of_a: [true, false], of_b: [false, true] };
    /// Both ends: an edge that has the direction of another one meets the turns at both ends of it (MS 3, Fig. 3a).
    pub const BOTH: Self = Self { of_a: [true; 2], of_b: [true; 2] };
}

/// Calls `each` with the sum segments of two rings: the places in A and in B at its ends, in the order of the edge, and
/// whether the boundary turns left there, so that the segment runs as the edge does.
pub(crate) fn sum_segments<Q: Number>(
    a: &Ring<Q>,
    b: &Ring<Q>,
    ties: Ties,
    mut each: impl FnMut([(usize, usize); 2], bool) -> Result<(), OracleError>,
) -> Result<(), OracleError> {
    let (turns_a, turns_b) = (turns(a), turns(b));
    for i in 0..a.len() {
        let next = (i + 1) % a.len();
        for (j, turn) in turns_b.iter().enumerate() {
            if turn.passes(&a[i], &a[next], ties.of_b) {
                each([(i, j), (next, j)], turn.left)?;
            }
        }
    }
    for j in 0..b.len() {
        let next = (j + 1) % b.len();
        for (i, turn) in turns_a.iter().enumerate() {
            if turn.passes(&b[j], &b[next], ties.of_a) {
                each([(i, j), (i, next)], turn.left)?;
            }
        }
    }
    Ok(())
}

/// The turn of a boundary at a vertex, by less than half a turn: the directions it sweeps, counter-clockwise from `lo`
/// to `hi`, each the direction between two places.
struct Turn<'a, Q> {
    lo: [&'a Place<Q>; 2],
    hi: [&'a Place<Q>; 2],
    left: bool,
}

/// The turns at the vertices of a ring. The rings of a normal region turn at every vertex.
fn turns<Q: Number>(ring: &Ring<Q>) -> Vec<Turn<'_, Q>> {
    let turn = |i: usize| {
        let (before, here, after) = (&ring[(i + ring.len() - 1) % ring.len()], &ring[i], &ring[(i + 1) % ring.len()]);
        let left = orient(before, here, after).is_gt();
        let (arriving, leaving) = ([before, here], [here, after]);
        let (lo, hi) = if left { (arriving, leaving) } else { (leaving, arriving) };
        Turn { lo, hi, left }
    };
    (0..ring.len()).map(turn).collect()
}

impl<Q: Number> Turn<'_, Q> {
    /// Whether the direction from tail to head lies between lo and hi, of which those count that are closed.
    fn passes(&self, tail: &Place<Q>, head: &Place<Q>, closed: [bool; 2]) -> bool {
        let beyond = |turn: Ordering, closed: bool| turn.is_gt() || (closed && turn.is_eq());
        beyond(cross_sign(self.lo[0], self.lo[1], tail, head), closed[0])
            && beyond(cross_sign(tail, head, self.hi[0], self.hi[1]), closed[1])
    }
}
