//! The boundary of a union of convex polygons by brute force (memo I1): every edge of every piece is clipped against
//! every other piece, and what no piece covers on its right side is boundary. No sweep, no index, no arrangement.

use std::cell::OnceCell;
use std::cmp::Ordering;

use crate::arrange::Edge;
use crate::boxes::Extent;
use crate::error::{Budget, OracleError};
use crate::interval::Interval;
use crate::number::Number;
use crate::point::{Place, area_exact, area_interval, dot_sign, orient};
use crate::region::ring_edges;
use crate::trapezoid::Convex;

/// The boundary edges of the union of counter-clockwise convex polygons, the union on their left.
///
/// # Errors
/// [`OracleError::TooCostly`] beyond the budget.
pub fn boundary<Q: Number>(pieces: &[Convex<Q>], budget: Budget) -> Result<Vec<Edge<Q>>, OracleError> {
    budget.check_segments(pieces.iter().map(Vec::len).sum())?;
    let extents: Vec<Extent> = pieces.iter().filter_map(Extent::around).collect();
    let mut edges = Vec::new();
    let mut meetings = 0;
    for (own, piece) in pieces.iter().enumerate() {
        for (tail, head) in ring_edges(piece) {
            let Some(extent) = Extent::around([tail, head]) else { continue };
            let near = (0..pieces.len()).filter(|&other| other != own && extents[other].meets(&extent));
            let side = Side { tail, head };
            let mut covers = Vec::new();
            for other in near {
                meetings += 1;
                covers.extend(side.covered_by(&pieces[other], other < own));
                if covers.last().is_some_and(Cover::is_whole) {
                    break;
                }
            }
            budget.check_meetings(meetings)?;
            edges.extend(side.uncovered(covers));
        }
    }
    Ok(edges)
}

/// An edge of a piece, looked at from its right.
struct Side<'a, Q> {
    tail: &'a Place<Q>,
    head: &'a Place<Q>,
}

/// Where an edge is cut by the line through two places, or one of its ends: a parameter from 0 to 1.
struct Cut<'a, Q> {
    near: Interval,
    line: Option<[&'a Place<Q>; 2]>,
    exact: OnceCell<Q>,
}

/// The part of an edge whose right side a piece covers.
struct Cover<'a, Q> {
    from: Cut<'a, Q>,
    to: Cut<'a, Q>,
}

impl<Q> Cover<'_, Q> {
    fn is_whole(&self) -> bool {
        self.from.line.is_none() && self.to.line.is_none()
    }
}

impl<'a, Q: Number> Side<'a, Q> {
    /// The part of this edge whose right side lies in `piece`. Where an edge of the piece lies on this one in the same
    /// direction, its right side is outside of both; only the first piece may then report it, so to a piece that
    /// `precedes` the part counts as covered.
    fn covered_by(&self, piece: &'a Convex<Q>, precedes: bool) -> Option<Cover<'a, Q>> {
        let mut cover = Cover { from: Cut::end(0.0), to: Cut::end(1.0) };
        for (c, d) in ring_edges(piece) {
            match (orient(c, d, self.tail), orient(c, d, self.head)) {
                (Ordering::Equal, Ordering::Equal) => {
                    let opposite = dot_sign(c, d, self.tail, self.head).is_lt();
                    if !opposite && !precedes {
                        return None;
                    }
                }
                (Ordering::Less, Ordering::Greater) => {
                    let cut = self.cut(c, d);
                    if self.compare(&cut, &cover.from).is_gt() {
                        cover.from = cut;
                    }
                }
                (Ordering::Greater, Ordering::Less) => {
                    let cut = self.cut(c, d);
                    if self.compare(&cut, &cover.to).is_lt() {
                        cover.to = cut;
                    }
                }
                (Ordering::Less, _) | (_, Ordering::Less) => return None,
                _ => {}
            }
        }
        self.compare(&cover.from, &cover.to).is_lt().then_some(cover)
    }

    fn cut(&self, c: &'a Place<Q>, d: &'a Place<Q>) -> Cut<'a, Q> {
        let (from, to) = (area_interval(c, d, self.tail), area_interval(c, d, self.head));
        Cut { near: from / (from - to), line: Some([c, d]), exact: OnceCell::new() }
    }

    fn compare(&self, a: &Cut<'a, Q>, b: &Cut<'a, Q>) -> Ordering {
        a.near.compare(b.near).unwrap_or_else(|| self.parameter(a).cmp(self.parameter(b)))
    }

    fn parameter<'c>(&self, cut: &'c Cut<'a, Q>) -> &'c Q {
        cut.exact.get_or_init(|| match cut.line {
            None => Q::from_i64(cut.near.lo() as i64),
            Some([c, d]) => {
                let from = area_exact(&c.exact, &d.exact, &self.tail.exact);
                let to = area_exact(&c.exact, &d.exact, &self.head.exact);
                from.over(&from.minus(&to))
            }
        })
    }

    /// The parts of the edge that nothing covers.
    fn uncovered(&self, mut covers: Vec<Cover<'a, Q>>) -> Vec<Edge<Q>> {
        covers.sort_by(|a, b| a.from.near.lo().total_cmp(&b.from.near.lo()));
        if surely_whole(&covers) {
            return Vec::new();
        }
        covers.sort_by(|a, b| self.compare(&a.from, &b.from));
        let point = |cut: &Cut<'a, Q>| self.tail.exact.toward(&self.head.exact, self.parameter(cut));
        let mut parts = Vec::new();
        let mut reached = Cut::end(0.0);
        covers.push(Cover { from: Cut::end(1.0), to: Cut::end(1.0) });
        for cover in covers {
            if self.compare(&reached, &cover.from).is_lt() {
                parts.push((point(&reached), point(&cover.from)));
            }
            if self.compare(&reached, &cover.to).is_lt() {
                reached = cover.to;
            }
        }
        parts
    }
}

impl<Q> Cut<'_, Q> {
    /// One of the ends of the edge: parameter 0 or 1.
    fn end(parameter: f64) -> Self {
        Self { near: Interval::point(parameter), line: None, exact: OnceCell::new() }
    }
}

/// Whether the covers, sorted by their beginnings, leave no gap even where each is as short as its intervals allow. Most
/// edges end here, without exact arithmetic.
fn surely_whole<Q>(covers: &[Cover<'_, Q>]) -> bool {
    let mut reached = 0.0;
    for cover in covers {
        if cover.from.near.hi() <= reached && cover.to.near.lo() > reached {
            reached = cover.to.near.lo();
        }
    }
    reached >= 1.0
}
