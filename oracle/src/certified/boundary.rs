//! The boundary of the Minkowski sum of two regions, stretch by stretch (memo I4, brute-force exact boundary).
//!
//! Every sum curve is cut at its contacts with all others. Between two clusters of contacts the plane right of it is all
//! free or all inside the sum E, so one probe decides: a point right of the curve, nearer to it than every other curve.
//! Two shortcuts need no probe. The left of a curve is inside E, so a stretch is inside E next to a crossing where it
//! comes from or goes to the left of another curve, and where it runs along another curve of opposite direction.
//!
//! What happens within a cluster is not decided: there the boundary is known only to be within [`Boundary::blur`].

use std::cmp::Ordering;
use std::sync::Arc;

use rug::Float;

use super::curve::Curve;
use super::meet::{LIMIT, ZONE};
use super::membership::{Membership, State};
use super::precision::Precision;
use super::shape::Shape;
use super::spot::Spot;
use super::stretch::{along, beside, fraction, stretch};
use super::sums::{Sum, sums};
use super::vector::Vector;
use super::walk::{Cluster, OBSCURE, Walk, middle};
use crate::boxes::{Boxes, Extent};
use crate::error::{Budget, OracleError};

/// A stretch of the boundary of E, on one sum curve and between two clusters.
#[derive(Clone, Debug)]
pub struct Edge {
    /// Index of the sum curve.
    pub sum: usize,
    /// The stretch, E on its left. Its ends are points of the sum curve inside the clusters.
    pub curve: Arc<Curve>,
    /// Boxes around the clusters at its start and end.
    pub ends: [Vector; 2],
}

/// The boundary of a sum E.
#[derive(Clone, Debug, Default)]
pub struct Boundary {
    /// All sum curves.
    pub sums: Vec<Sum>,
    /// The stretches that are certainly boundary, each part of the boundary once.
    pub edges: Vec<Edge>,
    /// The stretches of which it is unknown whether they are boundary or inside E, or which parts of them: probes that
    /// could not be decided, and clusters longer than two to the power of [`OBSCURE`].
    pub undecided: Vec<Edge>,
    /// No other cluster is longer than this, in input units: how well the ends of edges are known, and how long the
    /// edges may be that are missing.
    pub blur: f64,
    /// What it took.
    pub effort: Effort,
}

/// The work for a boundary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Pairs of curves whose boxes meet, each counted from both sides.
    pub meetings: u64,
    /// Stretches between clusters.
    pub gaps: u64,
    /// Points whose membership was asked for.
    pub probes: u64,
    /// The most bits a contact needed.
    pub bits: u32,
}

/// The boundary of the sum of two regions; none if both are unbounded, as then the sum is the plane.
///
/// # Errors
/// [`OracleError::TooCostly`] beyond the budget; [`OracleError::BadNumber`] for regions too large to index.
pub fn boundary(a: &Shape, b: &Shape, budget: Budget) -> Result<Boundary, OracleError> {
    if a.unbounded && b.unbounded {
        return Ok(Boundary::default());
    }
    let sums = sums(a, b);
    budget.check_segments(sums.len())?;
    let curves: Vec<_> = sums.iter().map(|sum| Arc::clone(&sum.curve)).collect();
    let mut boundary = Boundary { sums, ..Boundary::default() };
    if curves.is_empty() {
        return Ok(boundary);
    }
    let field = Field::new(&curves)?;
    let membership = Membership::new(a, b);
    for index in 0..curves.len() {
        let others = field.near(curves[index].rough().bounds(), index);
        boundary.effort.meetings += others.len() as u64;
        budget.check_meetings(boundary.effort.meetings)?;
        let walk = Walk::new(&curves, index, &others);
        boundary.add(walk, &field, &membership);
    }
    Ok(boundary)
}

/// What lies right of a stretch between clusters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    /// The inside of E, or the stretch belongs to another curve with the same points.
    Ignored,
    /// The outside.
    Free,
    Undecided,
}

impl Boundary {
    /// Adds the stretches of a curve that belong to the boundary.
    fn add(&mut self, mut walk: Walk, field: &Field, membership: &Membership) {
        let clusters = std::mem::take(&mut walk.clusters);
        for cluster in clusters.iter().filter(|cluster| cluster.crossing().is_none()) {
            self.pass(&walk, cluster);
        }
        for pair in clusters.windows(2) {
            self.effort.gaps += 1;
            let side = self.right_of(&walk, [&pair[0], &pair[1]], field, membership);
            if side == Side::Ignored {
                continue;
            }
            let edge = self.edge(&mut walk, [&pair[0], &pair[1]]);
            if side == Side::Free { self.edges.push(edge) } else { self.undecided.push(edge) }
        }
        self.effort.bits = self.effort.bits.max(walk.finest.bits());
    }

    /// Notes the length of a cluster at which other curves may do more than cross.
    fn pass(&mut self, walk: &Walk, cluster: &Cluster) {
        let length = walk.length(cluster);
        if length < f64::from(OBSCURE).exp2() {
            self.blur = self.blur.max(length);
            return;
        }
        let curve = Arc::new(stretch(walk.curve(), [cluster.low.clone(), cluster.high.clone()]));
        self.undecided.push(Edge { sum: walk.index, curve, ends: [cluster.place(), cluster.place()] });
    }

    fn right_of(&mut self, walk: &Walk, ends: [&Cluster; 2], field: &Field, membership: &Membership) -> Side {
        let entered = ends[0].crossing() == Some(Ordering::Less);
        let left = ends[1].crossing() == Some(Ordering::Greater);
        if entered || left || is_doubled(walk, &middle(&ends[0].high, &ends[1].low)) {
            return Side::Ignored;
        }
        // Where one probe cannot be decided, as when edges coincide with others far away, another one may be.
        for part in [0.5, 0.375, 0.6875] {
            let place = Float::with_val(LIMIT.bits(), &ends[1].low - &ends[0].high) * part + &ends[0].high;
            let spot = field.probe(walk, &place);
            self.effort.probes += 1;
            match membership.state(&spot) {
                State::Blocked => return Side::Ignored,
                State::Free => return Side::Free,
                State::Undecided => {}
            }
        }
        Side::Undecided
    }

    /// The stretch between two clusters, which are made as small as can be.
    fn edge(&mut self, walk: &mut Walk, ends: [&Cluster; 2]) -> Edge {
        let ends = ends.map(|cluster| walk.refined(cluster));
        for cluster in &ends {
            self.blur = self.blur.max(walk.length(cluster));
        }
        let curve = Arc::new(stretch(walk.curve(), [ends[0].fraction(), ends[1].fraction()]));
        Edge { sum: walk.index, curve, ends: [ends[0].place(), ends[1].place()] }
    }
}

/// Whether at this fraction the curve runs along another one that makes it superfluous: one of opposite direction, as
/// then both sides are inside E, or one of the same direction that comes first.
fn is_doubled(walk: &Walk, place: &Float) -> bool {
    let curve = walk.curve();
    walk.copies.iter().any(|&other| {
        let copy = walk.other(other);
        let equal = match (&curve.rough().circle, &copy.rough().circle) {
            (Some(a), Some(b)) => a.left == b.left,
            _ => LIMIT.decide(|p| curve.at(p).chord().dot(&copy.at(p).chord()).sign()) == Some(Ordering::Greater),
        };
        let on_it = || LIMIT.decide(|p| copy.at(p).spans(&along(curve.at(p), &fraction(place, p))));
        (!equal || other < walk.index) && on_it() == Some(true)
    })
}

/// The curves and where they are.
struct Field<'a> {
    curves: &'a [Arc<Curve>],
    boxes: Boxes,
}

impl<'a> Field<'a> {
    fn new(curves: &'a [Arc<Curve>]) -> Result<Self, OracleError> {
        let extents: Vec<_> = curves.iter().map(|curve| Extent { ends: curve.rough().bounds() }).collect();
        Ok(Self { curves, boxes: Boxes::new(&extents)? })
    }

    /// The curves whose boxes come within the zone of this one, but for one of them.
    fn near(&self, [x0, y0, x1, y1]: [f64; 4], except: usize) -> Vec<usize> {
        let reach = f64::from(ZONE + 2).exp2();
        let ends = [(x0 - reach).next_down(), (y0 - reach).next_down(), (x1 + reach).next_up(), (y1 + reach).next_up()];
        let mut found = Vec::new();
        self.boxes.visit(&Extent { ends }, |other| found.push(other));
        found.retain(|&other| other != except);
        found
    }

    /// A point right of a curve at a fraction outside all clusters, with no curve in between and no other one as near.
    fn probe(&self, walk: &Walk, place: &Float) -> Spot {
        beside(walk.curve(), place, self.clearance(walk, place))
    }

    /// A distance from the point at a fraction within which no curve passes but those of the same carrier, no more than
    /// half the radius of the curve.
    fn clearance(&self, walk: &Walk, place: &Float) -> f64 {
        const WIDE: f64 = 1e-3;
        /// Below this doubles would not decide the probe.
        const NARROW: f64 = 1e-10;
        let piece = walk.curve().rough();
        let point = along(piece, &fraction(place, Precision::DOUBLE));
        let reach = [point.x.lo() - WIDE, point.y.lo() - WIDE, point.x.hi() + WIDE, point.y.hi() + WIDE];
        let others = self.near(reach, walk.index).into_iter().filter(|other| !walk.copies.contains(other));
        let nearest = others.map(|other| self.curves[other].rough().distance(&point).lo()).fold(WIDE, f64::min);
        let radius = piece.circle.as_ref().map_or(f64::INFINITY, |circle| circle.radius.lo());
        let clear = 0.5 * nearest.min(radius);
        if clear >= NARROW { clear } else { f64::from(ZONE).exp2() }
    }
}
