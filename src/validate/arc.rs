//! How two parts of which one is curved meet, in floating point with a tolerance.
//!
//! Along one part the height over the circle or line of the other is a sine wave over at most a quarter turn, or a
//! parabola: it has at most one extremum, which bisection of its slope finds, and at most one zero on either side of it.
//! Zeros, the extremum and the tails of the parts are where they can meet; each that lies near both is reported as a
//! touch, and the caller decides whether it is a crossing ([`Touch::crosses`]).

use super::boundary::{Boundary, Part};
use super::touch::{Spot, Touch};
use glam::DVec2;

/// Points this many tolerances from the end of a part count as the end.
const SNAP: f64 = 16.0;

/// The touches of two parts; the ends of a stretch that they share are in [`overlap`].
pub fn touches(boundary: &Boundary, i: usize, j: usize) -> Vec<Touch> {
    let (p, q, tolerance) = (&boundary.parts[i], &boundary.parts[j], boundary.tolerance);
    let touch = |at, share_p, share_q, exact| Touch {
        at,
        spots: [snapped(boundary, i, share_p), snapped(boundary, j, share_q)],
        exact,
    };
    let common = p.tail == q.tail;
    let inner = meetings(p, q).map(|share| (p.point(share), share));
    let mut found: Vec<Touch> = inner
        .chain((!common).then_some((p.tail, 0.0)))
        .filter(|&(at, _)| q.is_near(at, tolerance))
        .map(|(at, share)| touch(at, share, q.share(at), false))
        .collect();
    if common || p.is_near(q.tail, tolerance) {
        found.push(touch(q.tail, if common { 0.0 } else { p.share(q.tail) }, 0.0, common));
    }
    found
}

/// A stretch that two parts clearly share, given by one of its points: two of their four ends lie on both parts, further
/// apart than [`stretch`], and so does the point between them.
pub fn overlap(boundary: &Boundary, i: usize, j: usize) -> Option<DVec2> {
    let (p, q, tolerance) = (&boundary.parts[i], &boundary.parts[j], boundary.tolerance);
    let own = [(p.tail, 0.0), (p.head, 1.0)].into_iter().filter(|&(end, _)| q.is_near(end, tolerance));
    let others = [q.tail, q.head].into_iter().filter(|&end| p.is_near(end, tolerance)).map(|end| (end, p.share(end)));
    let shares = own.chain(others).map(|(_, share)| share.clamp(0.0, 1.0));
    let (low, high) = shares.fold((1.0, 0.0), |(low, high), s| (f64::min(low, s), f64::max(high, s)));
    let middle = p.point((low + high) / 2.0);
    ((high - low) * p.length > stretch(boundary, i, j) && q.is_near(middle, tolerance)).then_some(middle)
}

/// The length over which two parts of different curvature may run together within the tolerance t: curves that touch
/// with curvatures k apart by k' keep within t for sqrt(2 t / k'), which is less than 64 sqrt(t / k) unless the curvatures
/// agree to one part in 2048.
pub fn stretch(boundary: &Boundary, i: usize, j: usize) -> f64 {
    let tolerance = boundary.tolerance;
    let size = boundary.size();
    let radius = boundary.parts[i].radius().min(boundary.parts[j].radius()).min(size);
    (64.0 * (tolerance * radius).sqrt()).max(SNAP * tolerance)
}

/// Whether the loop leads from one spot to the other within a length.
pub fn is_short(boundary: &Boundary, from: Spot, to: Spot, limit: f64) -> bool {
    let length = |part: usize| boundary.parts[part].length;
    let (mut way, mut part) = (-from.share * length(from.part), from.part);
    while part != to.part && way <= limit {
        way += length(part);
        part = boundary.next(part);
    }
    way + to.share * length(to.part) <= limit
}

fn snapped(boundary: &Boundary, part: usize, share: f64) -> Spot {
    let margin = SNAP * boundary.tolerance / boundary.parts[part].length;
    let share = match share {
        s if s <= margin => 0.0,
        s if s >= 1.0 - margin => 1.0,
        s => s,
    };
    Spot { part, share }
}

/// The shares of `p` at which its height over `q` is zero or extreme.
fn meetings(p: &Part, q: &Part) -> impl Iterator<Item = f64> {
    let height = |share| q.height(p.point(share));
    let slope = |share| q.slope(p.point(share), p.direction(share));
    let extremum = root(slope, 0.0, 1.0);
    let zeros = match extremum {
        None => [root(height, 0.0, 1.0), None],
        Some(share) => [root(height, 0.0, share), root(height, share, 1.0)],
    };
    zeros.into_iter().chain([extremum]).flatten()
}

/// A sign change of a function between `low` and `high`, if it has opposite signs there; by bisection.
fn root(function: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> Option<f64> {
    let (at_low, at_high) = (function(low), function(high));
    if !(at_low < 0.0 && at_high > 0.0 || at_low > 0.0 && at_high < 0.0) {
        return None;
    }
    // 2^-52 of the part: as fine as its points can be told apart.
    for _ in 0..52 {
        let middle = (low + high) / 2.0;
        if (function(middle) < 0.0) == (at_low < 0.0) { low = middle } else { high = middle }
    }
    Some((low + high) / 2.0)
}
