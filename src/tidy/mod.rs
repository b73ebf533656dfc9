//! Tidying: results of the engine made fit to be operands again (memo D, the last two bullets; MS 8.1).
//!
//! The loops of a result may cross or fold by a rounding, and run through vertices a rounding apart. [`tidy`] draws what is
//! closer than a tolerance together and drops what then runs there and back, in this order: vertices are joined ([`weld`]),
//! edges are led through the vertices next to them ([`lead`]), opposite edges cancel and what is left falls into loops that
//! pass each vertex once ([`cancel`]), and edges that go on straight or on one circle become one ([`merge`]).
//!
//! No vertex is new but the middles of arcs beyond a half circle: those that stay keep their coordinates, and so do edges
//! with nothing close to them. The boundary moves by at most [`MOVES`] tolerances, so the region only changes within that
//! distance of its boundary: it gains nothing farther from the old region, and loses nothing deeper in it. What is thinner
//! than that may go altogether. Loops that are drawn together at several vertices may close a ring, which is no valid region
//! but can be summed. The tolerance is the least of [`TOLERANCES`] at which the loops come out simple enough to
//! be smoothed.

mod cancel;
mod edge;
mod fold;
mod lead;
mod merge;
mod weld;

use crate::arc::half_sweep_of_radius;
use crate::arrangement::cross::EPS;
use crate::frame::Frame;
use crate::region::{Curve, Node, Region};
use crate::smooth::Smooth;
use crate::validate::validate;
use edge::{Edge, Net};
use glam::DVec2;
use std::f64::consts::FRAC_PI_2;

/// The tolerances in units of eps times the unit box of the region, or times its greatest coordinate if that is more. The
/// least is what a crossing may be off by in a box of side 2 (memo C1), and leaves 41 bits after ten times [`MOVES`] of it.
/// The others are for results much smaller than the operands they come from.
pub const TOLERANCES: [f64; 4] = [16.0, 64.0, 256.0, 1024.0];

/// How many tolerances the boundary moves by at most. Ends move by one when joined, and an arc of up to a half circle moves
/// by sqrt 2 of what its ends do. Each of the [`lead::ROUNDS`] leads an edge through vertices within one, which moves a part
/// of an arc by sqrt 2 again and its sagitta by less than 0.7. Between edges that cancel lies up to 1, and merging moves by
/// 1/2: in all 1.42 + 4 * 2.12 + 1.5, which hardly ever add up.
pub const MOVES: f64 = 12.0;

/// The region without what is smaller than a rounding. See the module. Regions that are not finite come back as they are.
#[must_use]
pub fn tidy(region: &Region) -> Region {
    tidied(region).map_or_else(|| region.clone(), |(tidied, _)| tidied)
}

/// The same, with the tolerance that was used, in input units; `None` if no tolerance is enough.
#[must_use]
pub fn tidied(region: &Region) -> Option<(Region, f64)> {
    let finite = |n: &Node| n.x.is_finite() && n.y.is_finite();
    if !region.loops.iter().flatten().all(finite) {
        return None;
    }
    let frame = Frame::shared(&[region]);
    let net = net(region, &frame)?;
    let size = size(region, &frame);
    TOLERANCES.iter().find_map(|eps| {
        let tolerance = eps * EPS * size;
        let tidied = within(&net, tolerance, region.unbounded, &frame);
        let fit = Smooth::new(&tidied, &Frame::shared(&[&tidied])).is_ok();
        fit.then(|| (tidied, frame.length_to_input(tolerance)))
    })
}

/// Whether a region may make curls of the size of a rounding: it folds back on itself within the greatest tolerance, and
/// it is not valid. Two curls in opposite directions leave the turning number of a loop as it is, but not its sums: at
/// either one the whole other operand comes in once too often or too seldom.
#[must_use]
pub fn is_curled(region: &Region) -> bool {
    let frame = Frame::shared(&[region]);
    let tolerance = TOLERANCES[TOLERANCES.len() - 1] * EPS * size(region, &frame);
    net(region, &frame).is_some_and(|net| fold::folds(&net, tolerance)) && validate(region).is_err()
}

/// The greatest coordinate in the unit box of the region, and no less than that.
fn size(region: &Region, frame: &Frame) -> f64 {
    let farthest = region.loops.iter().flatten().map(|n| n.x.abs().max(n.y.abs())).fold(0.0, f64::max);
    frame.length_to_unit(farthest).max(1.0)
}

/// Tidies within a tolerance in the unit box.
fn within(net: &Net, tolerance: f64, unbounded: bool, frame: &Frame) -> Region {
    let net = weld::weld(net, tolerance);
    let net = lead::lead(net, tolerance);
    let net = merge::merge(cancel::cancel(net, tolerance), tolerance);
    let node = |e: &Edge| {
        let p = frame.to_input(net.points[e.tail as usize]);
        let bulge = libm::tan(0.5 * e.delta);
        Node { x: p.x, y: p.y, curve: if bulge == 0.0 { Curve::Line } else { Curve::Bulge(bulge) } }
    };
    let loops = net.loops.iter().map(|edges| edges.iter().map(node).collect()).collect();
    Region { name: None, loops, unbounded }
}

/// The edges of a region in the unit box, none longer than half a circle; `None` if one has no geometry.
fn net(region: &Region, frame: &Frame) -> Option<Net> {
    let mut net = Net::default();
    for nodes in region.loops.iter().filter(|nodes| !nodes.is_empty()) {
        let points: Vec<DVec2> = nodes.iter().map(|n| frame.to_unit(DVec2::new(n.x, n.y))).collect();
        let mut stops = Vec::with_capacity(nodes.len());
        for (i, node) in nodes.iter().enumerate() {
            let (tail, head) = (points[i], points[(i + 1) % points.len()]);
            let delta = half_sweep(node.curve, tail, head, frame)?;
            if delta.abs() <= HALF {
                stops.push((tail, delta));
            } else {
                let apex = tail.midpoint(head) - (head - tail).perp() * (0.5 * libm::tan(0.5 * delta));
                stops.extend([(tail, 0.5 * delta), (apex, 0.5 * delta)]);
            }
        }
        net.add(&stops);
    }
    Some(net)
}

/// Half a circle, with room for rounding.
const HALF: f64 = FRAC_PI_2 + 1e-9;

fn half_sweep(curve: Curve, tail: DVec2, head: DVec2, frame: &Frame) -> Option<f64> {
    match curve {
        Curve::Line => Some(0.0),
        Curve::Bulge(b) => b.is_finite().then(|| 2.0 * libm::atan(b)),
        Curve::Radius(_) if tail == head => Some(0.0),
        Curve::Radius(r) => half_sweep_of_radius(tail, head, frame.length_to_unit(r)).ok(),
    }
}
