//! `i_curve:union` and `i_curve:i64`: the union of iCurve, of lines and arcs, in two widths of integers.
//!
//! It takes arcs as rational quadratic curves, lays a grid over the box of all of their whole circles, crosses chords of
//! bounded length in it, and puts the curves back between the crossings. Its arcs are taken as circle segments of the same
//! height over their chord.

use super::curves::Stretch;
use super::{EngineError, Loops, Peer, UNITES_ARCS, Way};
use arcsum::region::{Curve, Node};
use glam::DVec2;
use i_curve::float::arc::{Ellipse, RationalArc};
use i_curve::int::CurveInt;
use i_curve::{FillRule, FloatCurveOverlay, FloatCurvePath, FloatCurveSegment, FloatCurveShape};

/// The version of the crate.
const VERSION: &str = "0.2.1";

/// The union in the crate's default width.
pub const NARROW: Peer =
    Peer { name: "i_curve:union", version: VERSION, abilities: UNITES_ARCS, way: Way::Curves(unite::<i32>) };

/// With 64 bits.
pub const WIDE: Peer =
    Peer { name: "i_curve:i64", version: VERSION, abilities: UNITES_ARCS, way: Way::Curves(unite::<i64>) };

/// An arc that is no higher than this over its chord, in unit-box lengths, is given as a line: less than any of the grids
/// tells apart, while its whole circle would coarsen the grid.
const FLAT: f64 = 1.0 / (1_u64 << 60) as f64;

type Segment = FloatCurveSegment<[f64; 2]>;

fn unite<I: CurveInt>(cycles: &[Vec<Stretch>]) -> Result<Loops, EngineError> {
    let paths = cycles.iter().map(|cycle| given(cycle)).collect::<Result<Vec<_>, _>>()?;
    let shape = FloatCurveShape::try_new(paths).map_err(|error| EngineError::Invalid(error.to_string()))?;
    let overlay = FloatCurveOverlay::<[f64; 2], I>::try_from_subject(&shape)
        .map_err(|error| EngineError::Invalid(error.to_string()))?;
    let shapes = overlay.resolve_subject(FillRule::NonZero);
    shapes.into_iter().flatten().map(taken).collect()
}

/// A cycle as its path.
fn given(cycle: &[Stretch]) -> Result<FloatCurvePath<[f64; 2]>, EngineError> {
    let start = cycle[0].tail.to_array();
    FloatCurvePath::try_new(start, cycle.iter().map(segment).collect())
        .map_err(|error| EngineError::Invalid(error.to_string()))
}

fn segment(stretch: &Stretch) -> Segment {
    let Stretch { tail, head, delta } = *stretch;
    let chord = head - tail;
    if chord.length() * libm::tan(delta / 2.0).abs() <= 2.0 * FLAT {
        return Segment::Line { to: head.to_array() };
    }
    let (middle, left) = (tail + 0.5 * chord, 0.5 * chord.perp());
    let tangent = libm::tan(delta);
    let centre = middle + left / tangent;
    let radius = 0.5 * chord.length() / libm::sin(delta).abs();
    let out = tail - centre;
    let arc = RationalArc {
        ellipse: Ellipse { center: centre.to_array(), radius_x: radius, radius_y: radius, rotation: 0.0 },
        control_points: [tail, middle - tangent * left, head].map(|p| p.to_array()),
        weights: [1.0, libm::cos(delta), 1.0],
        start_angle: libm::atan2(out.y, out.x),
        sweep_angle: 2.0 * delta,
    };
    Segment::Arc { arc }
}

fn taken(path: FloatCurvePath<[f64; 2]>) -> Result<Vec<Node>, EngineError> {
    let (start, segments) = path.into_parts();
    let mut at = start;
    let mut nodes = Vec::with_capacity(segments.len());
    for segment in &segments {
        let curve = match segment {
            Segment::Line { .. } => Curve::Line,
            Segment::Arc { arc } => curve(arc),
            Segment::Quad { .. } | Segment::Cubic { .. } => {
                return Err(EngineError::Invalid("its answer has curves that are no arcs".into()));
            }
        };
        nodes.push(Node { x: at[0], y: at[1], curve });
        at = segment.end_point();
    }
    Ok(nodes)
}

/// The circle segment over the chord of a rational quadratic curve that is as high as the curve is halfway, w h / (1 + w)
/// for a control point at height h and the middle weight w relative to those of the ends.
fn curve(arc: &RationalArc<[f64; 2]>) -> Curve {
    let [tail, control, head] = arc.control_points.map(DVec2::from_array);
    let weight = arc.weights[1] / libm::sqrt(arc.weights[0] * arc.weights[2]);
    let chord = head - tail;
    let bulge = -2.0 * weight / (1.0 + weight) * chord.perp_dot(control - tail) / chord.length_squared();
    if bulge == 0.0 || !bulge.is_finite() { Curve::Line } else { Curve::Bulge(bulge) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn an_arc_comes_back_as_it_went(x in -1.0_f64..1.0, y in -1.0_f64..1.0, delta in -0.785_f64..0.785) {
            prop_assume!(x.abs() + y.abs() > 0.01 && delta.abs() > 1e-6);
            let stretch = Stretch { tail: DVec2::new(0.25, -0.5), head: DVec2::new(0.25 + x, y - 0.5), delta };
            let Segment::Arc { arc } = segment(&stretch) else { panic!("a line") };
            prop_assert!(arc.validate().is_ok() && arc.try_to_elliptic_arc(1e-6).is_some());
            let Curve::Bulge(bulge) = curve(&arc) else { panic!("a line") };
            prop_assert!((bulge - libm::tan(delta / 2.0)).abs() < 1e-14, "{bulge}");
        }
    }
}
