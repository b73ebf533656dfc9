//! Edges of a loop with the normal angles at their ends, and the joints where one edge goes over into the next.
//!
//! A tangential joint is computed twice, once from each edge, and the two angles differ by rounding: of the formulas,
//! and of the coordinates, whose last place turns a chord of length L by up to about eps/L. Left alone, each would
//! become a turn of no meaning, or a sliver between an arc's end and an axis normal nearby (memo A1). So the end angles
//! of arcs adapt: to a neighbouring line, to an axis normal, or to a longer arc, in this order. The angle of a line
//! never changes.

use crate::angle::Ang;
use crate::arc::{Arc, ArcError, radius_of_bulge};
use crate::frame::Frame;
use crate::region::{Curve, Node};
use crate::robustness::{Robustness, Step};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, PI};

/// How far a change of an end angle may swing the other end of the arc, in the unit box: 4 eps. The arc itself then
/// moves by at most a quarter of that at each such end, the sagitta being L/2 tan(delta/2).
const SWING: f64 = 2.0 * f64::EPSILON;

/// A line or an arc of any sweep below 360 degrees, in units of the frame.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Edge {
    Line { tail: DVec2, head: DVec2, angle: Ang },
    Arc { arc: Arc, r: f64 },
}

/// An edge, and whether it was given as an arc but is a line in angles (memo A4, modification 1).
pub(crate) fn edge(from: &Node, to: &Node, frame: &Frame, robustness: Robustness) -> Result<(Edge, bool), ArcError> {
    let (tail, head) = (frame.to_unit(DVec2::new(from.x, from.y)), frame.to_unit(DVec2::new(to.x, to.y)));
    let (arc, r) = match from.curve {
        Curve::Radius(r) if r != 0.0 => {
            let r = frame.length_to_unit(r);
            (Arc::with_radius(tail, head, r)?, r)
        }
        Curve::Bulge(b) if b != 0.0 => (Arc::with_bulge(tail, head, b)?, radius_of_bulge(tail, head, b)?),
        _ => return Ok((line(tail, head, robustness)?, false)),
    };
    let arc = if robustness.takes(Step::Angles) {
        arc
    } else {
        arc.turned(arc.a().rounded_to_radians(), arc.b().rounded_to_radians())
    };
    if (arc.a() == arc.b() && arc.delta().abs() <= FRAC_PI_2) || !r.is_finite() {
        return Ok((line(tail, head, robustness)?, true));
    }
    Ok((Edge::Arc { arc, r }, false))
}

fn line(tail: DVec2, head: DVec2, robustness: Robustness) -> Result<Edge, ArcError> {
    let finite = tail.is_finite() && head.is_finite() && (head - tail).is_finite();
    let angle = Ang::of_line(tail, head).ok_or(if finite { ArcError::ZeroChord } else { ArcError::NotFinite })?;
    let angle = if robustness.takes(Step::Angles) { angle } else { angle.rounded_to_radians() };
    Ok(Edge::Line { tail, head, angle })
}

impl Edge {
    pub(crate) fn a(&self) -> Ang {
        match self {
            Self::Line { angle, .. } => *angle,
            Self::Arc { arc, .. } => arc.a(),
        }
    }

    pub(crate) fn b(&self) -> Ang {
        match self {
            Self::Line { angle, .. } => *angle,
            Self::Arc { arc, .. } => arc.b(),
        }
    }

    /// By how much an end angle may change: so that [`SWING`] holds, and by no more than an eighth of the sweep or of
    /// what it lacks of a full circle, so that the ends do not pass each other. Zero for a line.
    pub(crate) fn tolerance(&self) -> f64 {
        match self {
            Self::Line { .. } => 0.0,
            Self::Arc { arc, .. } => {
                let half = arc.delta().abs();
                (SWING / self.size()).min(half / 4.0).min((PI - half) / 4.0)
            }
        }
    }

    fn is_line(&self) -> bool {
        matches!(self, Self::Line { .. })
    }

    /// The chord, or the diameter if the arc is more than a half circle.
    fn size(&self) -> f64 {
        match self {
            Self::Line { tail, head, .. } => (head - tail).length(),
            Self::Arc { arc, r } if arc.delta().abs() > FRAC_PI_2 => 2.0 * r.abs(),
            Self::Arc { arc, .. } => (arc.head() - arc.tail()).length(),
        }
    }

    /// Where an end angle moves to within the tolerance: the leading angle, else an axis, else nowhere.
    fn moved(&self, end: Ang, lead: Option<Ang>) -> Ang {
        let tolerance = self.tolerance();
        lead.into_iter().chain(Ang::AXES).find(|&to| end.turn_to(to).abs() <= tolerance).unwrap_or(end)
    }

    fn set_a(&mut self, a: Ang) {
        if let Self::Arc { arc, .. } = self {
            *arc = arc.turned(a, arc.b());
        }
    }

    fn set_b(&mut self, b: Ang) {
        if let Self::Arc { arc, .. } = self {
            *arc = arc.turned(arc.a(), b);
        }
    }
}

/// Makes the angles at tangential joints agree, see the module. Returns how many end angles changed.
pub(crate) fn join(edges: &mut [Edge]) -> u32 {
    let before: Vec<(Ang, Ang)> = edges.iter().map(|e| (e.a(), e.b())).collect();
    for i in 0..edges.len() {
        let next = (i + 1) % edges.len();
        let (b, a) = agreed(&edges[i], &edges[next]);
        edges[i].set_b(b);
        edges[next].set_a(a);
    }
    edges.iter().zip(before).map(|(e, (a, b))| u32::from(e.a() != a) + u32::from(e.b() != b)).sum()
}

/// The angles for the end of the first edge and the start of the second. The line or the longer arc leads, as its angle
/// costs most to change; the other follows.
fn agreed(before: &Edge, after: &Edge) -> (Ang, Ang) {
    if before.is_line() || (!after.is_line() && before.size() >= after.size()) {
        let b = before.moved(before.b(), None);
        (b, after.moved(after.a(), Some(b)))
    } else {
        let a = after.moved(after.a(), None);
        (before.moved(before.b(), Some(a)), a)
    }
}
